"""The way through taught waypoints, or along a path in the least time, worked out before it is gone."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import FollowPath
from helicoide.foresight import lived
from helicoide.ik.controller import Controller
from helicoide.ik.joints_along import joints_along
from helicoide.kinematics.robot import Robot
from helicoide.state import State, Update, with_command
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.program import gripper_commands, program_legs, program_path
from helicoide.trajectory.spline import JointSpline
from helicoide.trajectory.time_optimal import time_optimal_timing
from helicoide.trajectory.waypoints import MOVE_TYPES

# Of an arm whose file gives no acceleration: full speed in a quarter of a second.
GENTLE = 4.0
TITLE = Text(en="Going through the waypoints", pt_BR="Percorrendo os pontos ensinados")
NONE = Text(en="There are no waypoints to go through yet.", pt_BR="Ainda não há pontos a percorrer.")
BLOCKED = Text(
    en="The arm cannot come to waypoint {name} by: {way}. Choose another way, or a point between.",
    pt_BR="O braço não chega ao ponto {name} por: {way}. Escolha outra maneira, ou um ponto intermediário.",
)
FASTEST = Text(
    en="Along the path in the least time, at most {mm:.1f} mm beside it",
    pt_BR="Na trajetória no menor tempo, a no máximo {mm:.1f} mm dela",
)
# The path is first followed slowly, in so many seconds and steps of so many s, after so many steps to come there; every
# so many steps are a knot.
SLOWLY, STEP, COMING, KNOT = 30.0, 0.02, 500, 10


def replay_through(state: State) -> Update:
    """The wish to go through the waypoints from where the arm is, or to say why that is not possible."""
    robot = state.robot
    if not state.taught.waypoints:
        return gate.say(NONE)
    try:
        ways = list(
            program_legs(
                state.taught, state.arm.q, partial(joints_along, robot), state.taught.shape, _acceleration(robot)
            )
        )
    except HelicoideError as refusal:
        return gate.say(refusal.text)
    blocked = next((leg.waypoint for leg in ways if leg.blocked), None)
    if blocked is not None:
        return gate.say(BLOCKED.format(name=blocked.name, way=MOVE_TYPES[blocked.move_type]))
    path = program_path(ways)
    return gate.say(NONE) if path is None else gate.replay(path, TITLE, tuple(gripper_commands(ways)))


def along_fastest(state: State) -> Update:
    """The wish to follow the path of the course in the least time, as the arm can, or to say why that is not possible.

    How the joints go is what the guarded step makes of the path when it is followed slowly, so that it keeps every
    limit and plane; then time is scaled, evenly at no time: an even start would be a jump.
    """
    if state.arm.parked:  # there it would not move, and never come to the end
        return gate.say(gate.PARKED)
    rows, beside = _followed(state)
    shape = "trapezoid" if state.request.path_choice.shape == "constant speed" else state.request.path_choice.shape
    along = JointSpline(np.linspace(0.0, SLOWLY, len(rows)), rows)
    try:
        path = time_optimal_timing(along, shape, state.robot.speed, _acceleration(state.robot))
    except HelicoideError as refusal:
        return gate.say(refusal.text)
    return gate.replay(path, FASTEST.format(mm=1000 * beside))


def _followed(state: State) -> tuple[Array, float]:
    """The joints at even places of the path, (k, n), and how far the tool was beside it at most, m.

    The arm first comes to rest where the path begins, or as near to that as it can.
    """
    path = gate.path_of(state.robot, replace(state.request.path_choice, shape="constant speed", duration=SLOWLY))
    state = with_command(
        replace(state, request=replace(state.request, controller=Controller()), compared=None),
        FollowPath(path, 0.0, playing=False),
    )
    for _ in range(COMING):
        state = lived(state, STEP)
    state = replace(state, request=replace(state.request, command=FollowPath(path, 0.0, playing=True, arrived=True)))
    rows, beside = [state.arm.q], 0.0
    while isinstance(state.request.command, FollowPath) and state.request.command.playing:
        s = state.request.command.s
        state = lived(state, STEP)
        if state.request.path_s < s:  # a closed path begins again
            break
        rows.append(state.arm.q)
        beside = max(beside, float(np.linalg.norm(state.T_world_tool[:3, 3] - path.pose(s)[:3, 3])))
    return np.array(rows[::KNOT]), beside


def _acceleration(robot: Robot) -> Array:
    return np.where(np.isfinite(robot.acceleration), robot.acceleration, GENTLE * robot.speed)
