"""Motions through taught waypoints, or along a path in the least time, computed before they are played."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import FollowPath
from helicoide.foresight import advance_with_search
from helicoide.ik.controller import Controller
from helicoide.ik.joints_along import joints_along
from helicoide.kinematics.robot import Robot
from helicoide.state import State, Update, with_command
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.program import gripper_commands, program_legs, program_path
from helicoide.trajectory.spline import JointSpline
from helicoide.trajectory.time_optimal import time_optimal_timing
from helicoide.trajectory.waypoints import MOVE_TYPES

# 1/s: an arm whose file gives no acceleration reaches full speed in a quarter of a second.
GENTLE = 4.0
TITLE = Text(en="Running the waypoints", pt_BR="Executando os pontos")
NONE = Text(en="There are no waypoints yet.", pt_BR="Ainda não há pontos.")
BLOCKED = Text(
    en="The arm cannot reach waypoint {name} by {way}. Choose another move type or add a waypoint before it.",
    pt_BR="O braço não chega ao ponto {name} por {way}. Escolha outro tipo de movimento ou adicione um ponto antes "
    "dele.",
)
FASTEST = Text(
    en="Time-optimal path, at most {mm:.1f} mm of deviation",
    pt_BR="Trajetória de tempo mínimo, com desvio de no máximo {mm:.1f} mm",
)
# The path is first followed slowly: its duration, s; the step, s; steps to reach its start; steps from knot to knot.
SLOWLY, STEP, COMING, KNOT = 30.0, 0.02, 500, 10


def replay_through(state: State) -> Update:
    """The update that follows the waypoints from the current posture, or says why that is not possible."""
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
    """The update that follows the chosen path in the least time, or says why that is not possible.

    The guarded step first follows the path slowly, so that the joints keep every limit and plane. Then time along this
    joint path is scaled. A trapezoid replaces constant speed, which would begin with a jump of the velocity.
    """
    if state.arm.parked:  # a parked arm would not move, and never reach the end
        return gate.say(gate.PARKED)
    rows, beside = _along(state)
    shape = "trapezoid" if state.request.path_choice.shape == "constant speed" else state.request.path_choice.shape
    along = JointSpline(np.linspace(0.0, SLOWLY, len(rows)), rows)
    try:
        path = time_optimal_timing(along, shape, state.robot.speed, _acceleration(state.robot))
    except HelicoideError as refusal:
        return gate.say(refusal.text)
    return gate.replay(path, FASTEST.format(mm=1000 * beside))


def _along(state: State) -> tuple[Array, float]:
    """Joint values (k, n), rad or m, at equal steps of the path, and the largest distance of the tool from it, m.

    The arm first moves to the start of the path, or as near to it as it can.
    """
    path = gate.path_of(state.robot, replace(state.request.path_choice, shape="constant speed", duration=SLOWLY))
    state = with_command(
        replace(state, request=replace(state.request, controller=Controller()), compared=None),
        FollowPath(path, 0.0, playing=False),
    )
    for _ in range(COMING):
        state = advance_with_search(state, STEP)
    state = replace(state, request=replace(state.request, command=FollowPath(path, 0.0, playing=True, arrived=True)))
    rows, beside = [state.arm.q], 0.0
    while isinstance(state.request.command, FollowPath) and state.request.command.playing:
        s = state.request.command.s
        state = advance_with_search(state, STEP)
        if state.request.path_s < s:  # a closed path begins again
            break
        rows.append(state.arm.q)
        beside = max(beside, float(np.linalg.norm(state.T_world_tool[:3, 3] - path.pose(s)[:3, 3])))
    return np.array(rows[::KNOT]), beside


def _acceleration(robot: Robot) -> Array:
    return np.where(np.isfinite(robot.acceleration), robot.acceleration, GENTLE * robot.speed)
