"""The Motoman L-3 and similar arms: five joints, four postures; the tool points within the plane of the arm."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, cos, pi, sin

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families import elbow
from helicoide.ik.families.elbow_turret import ElbowTurret, elbow_turret
from helicoide.ik.families.pointing import Pointing
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found, Words, stacked_postures
from helicoide.ik.postures.branch import check_pose, sentences, wrap
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="Motoman L-3 family", pt_BR="família do Motoman L-3")
SOURCE = "Campos 1998, Cinemática inversa de manipuladores, s.36 and s.55; after Craig, Introduction to Robotics, ch. 4"
RANK, OF_POINTS = 0, False
EQUATIONS = (
    r"M = \frac{(-p_y,\, p_x,\, 0)}{\sqrt{p_x^2 + p_y^2}},\quad K = \frac{M \times \hat Z}{|M \times \hat Z|}",
    r"\hat Z' = K \times M,\quad \cos\theta = \hat Z \cdot \hat Z',\quad \sin\theta = (\hat Z \times \hat Z') \cdot K",
    r"\hat Y' = \cos\theta\,\hat Y + \sin\theta\,(K \times \hat Y) + (1 - \cos\theta)(K \cdot \hat Y) K,\quad"
    r" \hat X' = \hat Y' \times \hat Z'",
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) \;[+\,180^\circ],\quad u = c_1 p_x + s_1 p_y",
    r"\theta_5 = \operatorname{Atan2}(r_{21} c_1 - r_{11} s_1,\; r_{22} c_1 - r_{12} s_1)",
    r"a = \operatorname{Atan2}(r_{13} c_1 + r_{23} s_1,\; r_{33})",
    r"c_3 = \frac{u^2 + p_z^2 - L_2^2 - L_3^2}{2 L_2 L_3}",
    r"s_3 = \pm\sqrt{1 - c_3^2},\quad \theta_3 = \operatorname{Atan2}(s_3, c_3)",
    r"\theta_2 = -\operatorname{Atan2}(p_z, u) - \operatorname{Atan2}(L_3 s_3, L_2 + L_3 c_3)",
    r"\theta_4 = a - \theta_2 - \theta_3",
)


_ELSE = Text(
    en="This form needs five revolute joints: shoulder, elbow and wrist pitch with parallel axes, a waist axis that "
    "the shoulder axis crosses, and a wrist roll axis that crosses the pitch axis and carries the end effector.",
    pt_BR="Esta forma exige cinco juntas de revolução: ombro, cotovelo e arfagem do punho com eixos paralelos, um "
    "eixo da cintura que o do ombro cruza, e um eixo de rolagem que cruza o da arfagem e leva o efetuador.",
)
_SIDES = (Text(en="front, {elbow}", pt_BR="à frente, {elbow}"), Text(en="back, {elbow}", pt_BR="para trás, {elbow}"))
_FOUR = Text(
    en="Four postures: to the front or to the back, elbow up or elbow down.",
    pt_BR="Quatro posturas: à frente ou para trás, cotovelo para cima ou para baixo.",
)
_TWO = Text(
    en="Two postures: the wrist is on the boundary of the workspace.",
    pt_BR="Duas posturas: o punho está na borda do espaço de trabalho.",
)
_FREE = Text(
    en="The end effector is vertical on the waist axis: θ₁ is arbitrary and keeps its value.",
    pt_BR="O efetuador está na vertical sobre o eixo da cintura: θ₁ é arbitrário e mantém o valor.",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return _ELSE if elbow_turret(robot) is None else None


def pointed(robot: Robot, T_world_tool: Array, q: Array) -> Pointing:
    """The steps of the projection of a pose (4, 4), m, in the base frame: M, K, Ẑ', θ and the rotated orientation.

    q (5,), rad: θ₁ defines the plane of the arm if the pose does not. Raises HelicoideError if the form does not apply
    or if T_world_tool is not a pose. Source: Campos 1998, s.36 and s.55; Craig, ch. 4.
    """
    if (arm := elbow_turret(robot)) is None:
        raise HelicoideError(_ELSE)
    return arm.turret.pointed(check_pose(T_world_tool), float(robot.check_joints(q)[0]))[0]


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m, after its pointing axis is rotated into the plane of the arm.

    q (5,), rad: θ₁ is kept where the tool is vertical on the waist axis, θ₂ where equal links fold onto the shoulder.
    Raises HelicoideError if the form does not apply or if T_world_tool is not a pose. Source: Campos 1998, s.36, s.55;
    Craig.
    """
    if (arm := elbow_turret(robot)) is None:
        raise HelicoideError(_ELSE)
    goal = subspace.project_to_subspace(robot, T_world_tool, q)
    T = np.linalg.inv(arm.T_world_base) @ goal.T_world_goal @ np.linalg.inv(arm.T_wrist_tool)
    r = float(np.linalg.norm(T[:3, 3]))
    M, free = arm.turret.normal(arm.turret.seen(goal.T_world_goal), float(q[0]))
    heading, kept = atan2(-M[0], M[1]), float(arm.signs[1] * q[1] + arm.shifts[1])
    found = [(side, steps) for side in (0, 1) for steps in _steps(arm.links, T, heading + side * pi, kept)]
    p_x, p_y, p_z = map(float, T[:3, 3])
    start = {"θ": pointed(robot, T_world_tool, q).angle, "p_x": p_x, "p_y": p_y, "p_z": p_z}
    told = Words(
        names=[_name(arm, side, steps) for side, steps in found],
        words=sentences(
            goal.words, arm.links.words(r) or (_TWO if arm.links.on_edge(r) else _FOUR), _FREE if free else None
        ),
        values=[{**start, **steps} for _, steps in found] or [{**start, "c₃": elbow.cosine_of_elbow(r, 0, arm.links)}],
        free=tuple(joint for joint, is_free in ((0, free), (1, arm.links.at_centre(r))) if is_free),
    )
    rows = stacked_postures([_joints(arm, steps) for _, steps in found], 5)
    return Found(rows, goal.T_world_goal, told, goal.moved, goal.turned, short=arm.links.beyond(r))


def _steps(links: elbow.Annulus, T: Array, theta1: float, kept: float) -> list[dict[str, float]]:
    """The steps by symbol for one θ₁, rad, and a pose of the wrist (4, 4), m, in the order of the source.

    (u, −p_z) is the end point of a planar arm with the angles θ₂ and θ₃. kept: θ₂, rad, where it is free.
    """
    c1, s1, R = cos(theta1), sin(theta1), T[:3, :3]
    u = float(c1 * T[0, 3] + s1 * T[1, 3])
    theta5 = float(np.arctan2(R[1, 0] * c1 - R[0, 0] * s1, R[1, 1] * c1 - R[0, 1] * s1))
    a = float(np.arctan2(R[0, 2] * c1 + R[1, 2] * s1, R[2, 2]))
    start = {"θ₁": float(wrap(theta1)), "u": u, "θ₅": theta5, "a": a}
    return [
        {
            **start,
            "c₃": two.c2,
            "s₃": two.s2,
            "θ₃": two.theta2,
            "θ₂": two.theta1,
            "θ₄": float(wrap(a - two.theta1 - two.theta2)),
        }
        for two in (posture.algebraic for posture in elbow.elbow_postures(u, -float(T[2, 3]), links, kept))
    ]


def _joints(arm: ElbowTurret, steps: Mapping[str, float]) -> Array:
    theta = np.array([steps[symbol] for symbol in ("θ₁", "θ₂", "θ₃", "θ₄", "θ₅")])
    return np.asarray(arm.signs * (theta - arm.shifts))


def _name(arm: ElbowTurret, side: int, steps: Mapping[str, float]) -> Text:
    """Front if the wrist lies before the waist, u > 0; up if the elbow lies above the line from shoulder to wrist."""
    front = steps["u"] > 0 if abs(steps["u"]) > arm.turret.over else side == 0
    if steps["s₃"] == 0:
        bend = elbow.STRETCHED if steps["c₃"] > 0 else elbow.FOLDED
    else:
        bend = elbow.UP if (steps["s₃"] > 0) == front else elbow.DOWN
    return _SIDES[0 if front else 1].format(elbow=bend)
