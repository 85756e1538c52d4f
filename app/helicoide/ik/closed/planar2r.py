"""Planar arms with two joints: two postures for a point, each with its own orientation."""

from __future__ import annotations

from math import hypot

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families import elbow
from helicoide.ik.families.planar import planar
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found, Words, stacked_postures
from helicoide.ik.postures.branch import sentences, wrap
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="planar arm with two joints", pt_BR="braço planar de duas juntas")
SOURCE = "Campos 1998, Cinemática inversa de manipuladores, s.8–12, s.44–48 and s.52–54"
RANK, OF_POINTS = 0, True
EQUATIONS = (
    r"x = l_1 c_1 + l_2 c_{12},\quad y = l_1 s_1 + l_2 s_{12}",
    r"c_2 = \frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}",
    r"s_2 = \pm\sqrt{1 - c_2^2},\quad \theta_2 = \operatorname{Atan2}(s_2, c_2)",
    r"k_1 = l_1 + l_2 c_2,\quad k_2 = l_2 s_2",
    r"r = \sqrt{k_1^2 + k_2^2},\quad \gamma = \operatorname{Atan2}(k_2, k_1)",
    r"\theta_1 = \operatorname{Atan2}(y, x) - \gamma",
    r"\beta = \operatorname{Atan2}(y, x),\quad \cos\psi = \frac{x^2 + y^2 + l_1^2 - l_2^2}{2 l_1 \sqrt{x^2 + y^2}}",
    r"\theta_1 = \beta + \psi \;(\theta_2 < 0),\quad \theta_1 = \beta - \psi \;(\theta_2 > 0)",
    r"\varphi = \theta_1 + \theta_2",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    arm = planar(robot, 2)
    return arm if isinstance(arm, Text) else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for the position of a tool pose (4, 4), m. q (n,), rad: θ₁ is kept where the position is at axis 1.

    The orientation is not asked for: the goal takes φ = θ₁ + θ₂ of the nearer posture.
    Raises HelicoideError if the form does not apply or if T_world_tool is not a pose.
    Source: Campos 1998, s.8–12, s.44–54.
    """
    if isinstance(arm := planar(robot, 2), Text):
        raise HelicoideError(arm)
    goal = subspace.project_to_subspace(robot, T_world_tool, q)
    x, y, _ = arm.end(goal.T_world_goal)
    found = elbow.elbow_postures(x, y, arm.links, kept=float(arm.angles(q)[0]))
    thetas = [np.array([one.algebraic.theta1, one.algebraic.theta2]) for one in found]
    start = {"x": x, "y": y}
    values = [{**start, **one.values, "φ": float(wrap(theta.sum()))} for one, theta in zip(found, thetas, strict=True)]
    r = hypot(x, y)
    told = Words(
        names=[one.name for one in found],
        words=sentences(goal.words, arm.links.words(r) or elbow.free_or_edge(x, y, arm.links) or _orientations(values)),
        values=values or [{**start, "c₂": elbow.cosine_of_elbow(x, y, arm.links)}],
        free=(0,) if arm.links.at_centre(r) else (),
    )
    rows = stacked_postures([arm.joints(theta) for theta in thetas], 2)
    return Found(rows, goal.T_world_goal, told, goal.moved, goal.turned, short=arm.links.beyond(r))


def _orientations(values: list[dict[str, float]]) -> Text:
    first, second = (np.degrees(one["φ"]) for one in values)
    return Text(
        en="Two postures, each with an orientation of its own: φ = {first:.1f}° and {second:.1f}°.",
        pt_BR="Duas posturas, cada uma com a sua orientação: φ = {first:.1f}° e {second:.1f}°.",
    ).format(first=first, second=second)
