"""The postures of a closed form as a `Found`: for the projected goal, each once, with intermediate values."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found, Words, stacked_postures
from helicoide.ik.postures.branch import sentences, wrap
from helicoide.ik.postures.numeric import POSTURE
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Joint values (n,), rad, and the intermediate values of the equations, by symbol.
Steps = tuple[Array, Mapping[str, float]]
MERGED, LOWERED = 1e-6, "₁₂₃₄₅₆"  # postures that differ by less than this in every joint are equal, rad

COUNTED = Text(en="Postures: {n}.", pt_BR="Posturas: {n}.")
OUTSIDE = Text(en="Out of reach by {short:.1f} mm.", pt_BR="Fora do alcance por {short:.1f} mm.")


def distinct_branches(
    robot: Robot, T_world_tool: Array, q: Array, formulation: Callable[[Array, Array], Iterable[Steps]]
) -> Found:
    """The postures that `road` yields for a tool pose, each once.

    Args: T_world_tool (4, 4), m: projected to the subspace of the arm first; q (n,), rad: kept where a joint is free;
    road: a closed form, as a function of the projected pose and q. Raises HelicoideError for an invalid pose or q.
    """
    now = robot.check_joints(q)
    goal = subspace.project_to_subspace(robot, T_world_tool, now)
    found: list[Steps] = []
    for theta, values in formulation(goal.T_world_goal, now):
        if not any(np.abs(wrap(theta - other)).max() < MERGED for other, _ in found):
            found.append((theta, values))
    short = 0.0 if found else subspace.distance_beyond(robot, goal.T_world_goal, now)
    told = Words(
        names=[POSTURE.format(n=n + 1) for n in range(len(found))],
        words=sentences(goal.words, COUNTED.format(n=len(found)) if found else OUTSIDE.format(short=1000 * short)),
        values=[values for _, values in found],
    )
    rows = stacked_postures([theta for theta, _ in found], len(now))
    return Found(rows, goal.T_world_goal, told, goal.moved, goal.turned, short)


def theta(*angles: float, **steps: float) -> Steps:
    """Joint values wrapped into (−π, π], rad, and by symbol the intermediate values and these angles."""
    joints = wrap(angles)
    return joints, {**steps, **{f"θ{LOWERED[i]}": float(angle) for i, angle in enumerate(joints)}}
