"""Planar arms with three joints: two postures for a point and an orientation."""

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

TITLE = Text(en="planar arm with three joints", pt_BR="braço planar de três juntas")
SOURCE = "Campos 1998, Cinemática inversa de manipuladores, s.38–54"
RANK, OF_POINTS = 0, False
EQUATIONS = (
    r"c_\varphi = c_{123},\quad s_\varphi = s_{123}",
    r"x = l_1 c_1 + l_2 c_{12},\quad y = l_1 s_1 + l_2 s_{12}",
    r"c_2 = \frac{x^2 + y^2 - l_1^2 - l_2^2}{2 l_1 l_2}",
    r"s_2 = \pm\sqrt{1 - c_2^2},\quad \theta_2 = \operatorname{Atan2}(s_2, c_2)",
    r"k_1 = l_1 + l_2 c_2,\quad k_2 = l_2 s_2",
    r"r = \sqrt{k_1^2 + k_2^2},\quad \gamma = \operatorname{Atan2}(k_2, k_1)",
    r"\theta_1 = \operatorname{Atan2}(y, x) - \gamma",
    r"\beta = \operatorname{Atan2}(y, x),\quad \cos\psi = \frac{x^2 + y^2 + l_1^2 - l_2^2}{2 l_1 \sqrt{x^2 + y^2}}",
    r"\theta_1 = \beta + \psi \;(\theta_2 < 0),\quad \theta_1 = \beta - \psi \;(\theta_2 > 0)",
    r"\theta_3 = \varphi - \theta_1 - \theta_2",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    arm = planar(robot, 3)
    return arm if isinstance(arm, Text) else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m, projected to the plane of the arm.

    The frame {E} on the third axis has (x, y, φ). q (n,), rad: θ₁ is kept where {E} leaves it free.
    Raises HelicoideError if the form does not apply or if T_world_tool is not a pose. Source: Campos 1998, s.38–54.
    """
    if isinstance(arm := planar(robot, 3), Text):
        raise HelicoideError(arm)
    goal = subspace.project_to_subspace(robot, T_world_tool, q)
    x, y, phi = arm.end(goal.T_world_goal)
    found = elbow.elbow_postures(x, y, arm.links, kept=float(arm.angles(q)[0]))
    thetas = [_with_wrist(one.algebraic, phi) for one in found]
    start = {"x": x, "y": y, "φ": phi}
    r = hypot(x, y)
    told = Words(
        names=[one.name for one in found],
        words=sentences(goal.words, arm.links.words(r) or elbow.free_or_edge(x, y, arm.links) or _TWO),
        values=[{**start, **one.values, "θ₃": float(theta[2])} for one, theta in zip(found, thetas, strict=True)]
        or [{**start, "c₂": elbow.cosine_of_elbow(x, y, arm.links)}],
        free=(0,) if arm.links.at_centre(r) else (),
    )
    rows = stacked_postures([arm.joints(theta) for theta in thetas], 3)
    return Found(rows, goal.T_world_goal, told, goal.moved, goal.turned, short=arm.links.beyond(r))


def _with_wrist(two: elbow.Algebraic, phi: float) -> Array:
    """(θ₁, θ₂, θ₃), rad, with θ₃ = φ − θ₁ − θ₂. Source: Campos 1998, s.49."""
    return np.array([two.theta1, two.theta2, float(wrap(phi - two.theta1 - two.theta2))])


_TWO = Text(
    en="Two postures for the same pose: elbow up and elbow down.",
    pt_BR="Duas posturas para a mesma pose: cotovelo para cima e cotovelo para baixo.",
)
