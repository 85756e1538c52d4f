"""Inverse transforms of the DH rows: the entries of (⁰A₁)⁻¹ T = ¹A₅ give one unknown after another.

For arms with the DH rows of the Movemaster; `puma560` uses the same method for the PUMA.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, hypot, pi, sin, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.elbow import Annulus
from helicoide.ik.families.listed import Steps, distinct_branches, theta
from helicoide.ik.families.turret import turret
from helicoide.ik.postures.answer import Found
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="inverse transforms, row by row", pt_BR="transformadas inversas, linha a linha")
SOURCE = "Campos 1998, s.37 (names the family); Paul 1981, Robot manipulators; Cerbaro 2022, tab. 6 (the rows)"
RANK, OF_POINTS = 3, False
EQUATIONS = (
    r"({}^0A_1)^{-1}\,T = {}^1A_5,\; [3,4]:\; s_1 p_x - c_1 p_y = 0,\quad"
    r" \theta_1 = \operatorname{Atan2}(p_y, p_x) \;[+\,180^\circ]",
    r"[1,3], [2,3]:\; s_{234} = c_1 a_x + s_1 a_y,\quad c_{234} = -a_z",
    r"[3,1], [3,2]:\; s_5 = s_1 n_x - c_1 n_y,\quad c_5 = s_1 o_x - c_1 o_y",
    r"[1,4], [2,4]:\; w_x = c_1 p_x + s_1 p_y - a_1 - d_5 s_{234} = a_2 c_2 + a_3 c_{23},\quad"
    r" w_y = p_z - d_1 + d_5 c_{234} = a_2 s_2 + a_3 s_{23}",
    r"c_3 = \frac{w_x^2 + w_y^2 - a_2^2 - a_3^2}{2 a_2 a_3},\quad s_3 = \pm\sqrt{1 - c_3^2}",
    r"\theta_2 = \operatorname{Atan2}(w_y, w_x) - \operatorname{Atan2}(a_3 s_3, a_2 + a_3 c_3),\quad"
    r" \theta_4 = \theta_{234} - \theta_2 - \theta_3",
)
TWISTS = (pi / 2, 0.0, 0.0, pi / 2, 0.0)
SAME = 1e-9

_ELSE = Text(
    en="This form needs the DH rows of the Movemaster (standard): α = 90°, 0, 0, 90°, 0 and only the lengths d₁, a₁, "
    "a₂, a₃, d₅.",
    pt_BR="Esta forma exige as linhas DH do Movemaster (padrão): α = 90°, 0, 0, 90°, 0 e só os comprimentos d₁, a₁, "
    "a₂, a₃ e d₅.",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    rows = robot.dh.rows
    fits = (
        robot.dh.convention == "standard"
        and turret(robot) is not None
        and all(abs(row.alpha - twist) < SAME for row, twist in zip(rows, TWISTS, strict=True))
        and max(abs(length) for length in (rows[3].a, rows[4].a, *(row.d for row in rows[1:4]))) < SAME
        and min(rows[1].a, rows[2].a) > SAME
    )
    return None if fits else _ELSE


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m. q (5,), rad: a joint that the pose leaves free keeps its value.

    Raises HelicoideError if T_world_tool is not a pose or if the form does not apply.
    """
    if (reason := applies(robot)) is not None:
        raise HelicoideError(reason)
    return distinct_branches(robot, T_world_tool, q, lambda T, now: _postures(robot, T, now))


def _postures(robot: Robot, T_world_tool: Array, q: Array) -> Iterator[Steps]:
    """The steps of `EQUATIONS` for a pose that the arm can take; n, o, a, p are the columns of T."""
    shifts = np.array([row.theta for row in robot.dh.rows])
    (d1, a1), (_, a2), (_, a3), _, (d5, _) = ((row.d, row.a) for row in robot.dh.rows)
    T = np.linalg.inv(robot.dh.T_world_dh) @ T_world_tool @ np.linalg.inv(robot.dh.T_dh_tool)
    n, o, a, p = (T[:3, k] for k in range(4))
    links, over = Annulus(a2, a3), SAME * robot.reach
    heading = atan2(p[1], p[0]) if hypot(p[0], p[1]) > over else atan2(a[1], a[0])
    if max(hypot(p[0], p[1]) - over, hypot(a[0], a[1]) - SAME) < 0:
        heading = float(q[0] + shifts[0])
    for theta1 in (heading, heading + pi):
        c1, s1 = cos(theta1), sin(theta1)
        s234, c234 = c1 * a[0] + s1 * a[1], -a[2]
        theta5 = atan2(s1 * n[0] - c1 * n[1], s1 * o[0] - c1 * o[1])
        w_x, w_y = c1 * p[0] + s1 * p[1] - a1 - d5 * s234, p[2] - d1 + d5 * c234
        r = hypot(w_x, w_y)
        for sign in links.elbows(r):
            c3 = min(max((r * r - a2 * a2 - a3 * a3) / (2 * a2 * a3), -1.0), 1.0)
            theta3 = atan2(sign * sqrt(1 - c3 * c3), c3)
            theta2 = atan2(w_y, w_x) - atan2(a3 * sin(theta3), a2 + a3 * c3)
            if links.at_centre(r):
                theta2 = float(q[1] + shifts[1])
            theta4 = atan2(s234, c234) - theta2 - theta3
            joints = np.array([theta1, theta2, theta3, theta4, theta5]) - shifts
            yield theta(*joints, s_234=float(s234), c_234=float(c234), w_x=float(w_x), w_y=float(w_y), c_3=c3)
