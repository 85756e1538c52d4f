"""Postures that a road of inverse kinematics comes to, as an answer: projected first, each once, with its steps."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found, Said, rows_of
from helicoide.ik.postures.branch import sentences, wrap
from helicoide.ik.postures.numeric import POSTURE
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Joint values (n,), rad, and what the equations gave on the way to them, by symbol.
Steps = tuple[Array, Mapping[str, float]]
MERGED, LOWERED = 1e-6, "₁₂₃₄₅₆"  # postures closer than this in every joint are one, rad

COUNTED = Text(en="Postures: {n}.", pt_BR="Posturas: {n}.")
OUTSIDE = Text(en="Out of reach by {short:.3g} mm.", pt_BR="Fora de alcance por {short:.3g} mm.")


def listed(robot: Robot, T_world_tool: Array, q: Array, road: Callable[[Array, Array], Iterable[Steps]]) -> Found:
    """What a road finds, which takes a pose of the arm's subspace (4, 4), m, and q (n,), rad, kept where it is free.

    Raises HelicoideError for what is no pose and for a wrong q.
    """
    now = robot.check_joints(q)
    goal = subspace.project(robot, T_world_tool, now)
    found: list[Steps] = []
    for theta, values in road(goal.T_world_goal, now):
        if not any(np.abs(wrap(theta - other)).max() < MERGED for other, _ in found):
            found.append((theta, values))
    short = 0.0 if found else subspace.beyond(robot, goal.T_world_goal, now)
    told = Said(
        names=[POSTURE.format(n=n + 1) for n in range(len(found))],
        words=sentences(goal.words, COUNTED.format(n=len(found)) if found else OUTSIDE.format(short=1000 * short)),
        values=[values for _, values in found],
    )
    rows = rows_of([theta for theta, _ in found], len(now))
    return Found(rows, goal.T_world_goal, told, goal.moved, goal.turned, short)


def theta(*angles: float, **steps: float) -> Steps:
    """Joint values, rad, and by symbol the steps on the way and the angles themselves, wrapped into (−π, π]."""
    joints = wrap(angles)
    return joints, {**steps, **{f"θ{LOWERED[i]}": float(angle) for i, angle in enumerate(joints)}}
