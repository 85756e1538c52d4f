"""A motion along a path in the least time, computed before it is played."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import FollowPath
from helicoide.foresight import advance_with_search
from helicoide.gate.running import acceleration
from helicoide.ik.controller import Controller
from helicoide.state import State, Update, with_command
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.spline import JointSpline
from helicoide.trajectory.time_optimal import time_optimal_timing

FASTEST = Text(
    en="Time-optimal path, at most {mm:.1f} mm of deviation",
    pt_BR="Trajetória de tempo mínimo, com desvio de no máximo {mm:.1f} mm",
)
# The path is first followed slowly: its duration, s; the step, s; steps to reach its start; steps from knot to knot.
SLOWLY, STEP, COMING, KNOT = 30.0, 0.02, 500, 10


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
        path = time_optimal_timing(along, shape, state.robot.speed, acceleration(state.robot))
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
