"""The PUMA 560: all eight postures, two shoulders × two elbows × the wrist and its flip."""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot, pi

import numpy as np
from numpy.typing import NDArray

from helicoide.ik.postures.branch import Answer, branch_of, check_pose, sentences
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="PUMA 560: eight postures", pt_BR="PUMA 560: oito posturas")
SOURCE = "Campos 1998, s.19–21 and s.55, after Craig, Introduction to Robotics"
RANK, OF_POINTS = 0, False
EQUATIONS = (
    r"K = \frac{p_x^2 + p_y^2 + p_z^2 - a_2^2 - a_3^2 - d_3^2 - d_4^2}{2 a_2}",
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) - \operatorname{Atan2}(d_3, \pm\sqrt{p_x^2 + p_y^2 - d_3^2})",
    r"\theta_3 = \operatorname{Atan2}(a_3, d_4) - \operatorname{Atan2}(K, \pm\sqrt{a_3^2 + d_4^2 - K^2})",
    r"\theta_{23} = \operatorname{Atan2}((-a_3 - a_2 c_3) p_z - u (d_4 - a_2 s_3),"
    r"\; (a_2 s_3 - d_4) p_z + (a_3 + a_2 c_3) u), \quad u = c_1 p_x + s_1 p_y",
    r"\theta_2 = \theta_{23} - \theta_3",
    r"\theta_4 = \operatorname{Atan2}(-r_{13} s_1 + r_{23} c_1,"
    r"\; -r_{13} c_1 c_{23} - r_{23} s_1 c_{23} + r_{33} s_{23})",
    r"s_5 = -r_{13} (c_1 c_{23} c_4 + s_1 s_4) - r_{23} (s_1 c_{23} c_4 - c_1 s_4) + r_{33} s_{23} c_4, \quad"
    r"c_5 = -r_{13} c_1 s_{23} - r_{23} s_1 s_{23} - r_{33} c_{23}",
    r"\theta_5 = \operatorname{Atan2}(s_5, c_5), \quad \theta_6 = \operatorname{Atan2}(s_6, c_6)",
    r"\theta_4' = \theta_4 + 180°, \quad \theta_5' = -\theta_5, \quad \theta_6' = \theta_6 + 180°",
)

# Modified rows without what is free: α, and which of a and d may differ from zero.
TWISTS = (0.0, -pi / 2, 0.0, -pi / 2, pi / 2, -pi / 2)
LENGTHS = ((False, False), (False, False), (True, True), (True, True), (False, False), (False, False))
SAME = 1e-9
# What rounding may take from a radicand, m²; the angle, rad, below which two postures are one; sines and, in m, lengths
# that count as zero.
ROUNDING, MERGED, FREE = 1e-12, 1e-6, 1e-10


def applies(robot: Robot) -> Text | None:
    """To arms whose modified DH rows are those of the PUMA, with any a₂ ≠ 0, a₃, d₃ and d₄."""
    rows = robot.dh.rows
    fits = (
        robot.dh.convention == "modified"
        and len(rows) == len(TWISTS)
        and all(abs(row.alpha - twist) < SAME for row, twist in zip(rows, TWISTS, strict=True))
        and all(
            (a or abs(row.a) < SAME) and (d or abs(row.d) < SAME) for row, (a, d) in zip(rows, LENGTHS, strict=True)
        )
        and rows[2].a > SAME
        and not any(joint.slides or joint.mimic for joint in robot.joints)
    )
    return (
        None
        if fits
        else Text(
            en="The form is for arms with the DH rows of the PUMA 560 (modified): α = 0, −90°, 0, −90°, 90°, −90°.",
            pt_BR="A forma vale para braços com as linhas DH modificadas do PUMA 560: α = 0, −90°, 0, −90°, 90°, −90°.",
        )
    )


def lengths_of(robot: Robot) -> Array:
    """a₂, a₃, d₃, d₄, (4,), m, of the robot's rows."""
    upper, fore = robot.dh.rows[2:4]
    return frozen([upper.a, fore.a, upper.d, fore.d])


@kernel
def is_folded(side: float, pz: float, d3: float) -> bool:
    """Whether the wrist centre is on the axis of the shoulder, by px² + py² − d₃², m², and pz, m: θ2 is then free."""
    return abs(pz) < FREE and side < FREE * (FREE + 2.0 * abs(d3))


@kernel
def postures(lengths: Array, T_base_wrist: Array, q: Array) -> tuple[Array, NDArray[np.bool_]]:
    """All θ (8, 6), rad, and which exist (8,): shoulder +, −, in each elbow +, −, in each the wrist and its flip.

    Of postures that are one the first counts. Where θ1, θ2 or θ4 is free, that of q is kept, and no wrist flipped.
    Args: lengths: a₂, a₃, d₃, d₄ (4,), m; T_base_wrist (4, 4), m, of DH frame 6; q (6,): DH angles now, rad.
    Source: Campos 1998, s.55, after Craig.
    """
    theta, exists = np.empty((8, 6)), np.zeros(8, np.bool_)
    a2, a3, d3, d4 = lengths[0], lengths[1], lengths[2], lengths[3]
    T = T_base_wrist
    px, py, pz, r13, r23, r33 = T[0, 3], T[1, 3], T[2, 3], T[0, 2], T[1, 2], T[2, 2]
    across, fore = px * px + py * py, a3 * a3 + d4 * d4
    K = (across + pz * pz - a2 * a2 - fore - d3 * d3) / (2 * a2)
    side, bend = across - d3 * d3, fore - K * K
    if side < -ROUNDING or bend < -ROUNDING:
        return theta, exists
    folded = is_folded(side, pz, d3)
    side, bend = (0.0, 0.0) if folded else (np.sqrt(max(side, 0.0)), np.sqrt(max(bend, 0.0)))
    heading, slant = np.arctan2(py, px), np.arctan2(a3, d4)
    over = across < FREE * FREE
    shoulders = 2 if side > MERGED * abs(d3) and not over else 1
    elbows = 2 if bend > MERGED * abs(K) else 1
    for shoulder in range(shoulders):
        theta1 = q[0] if over else heading - np.arctan2(d3, side if shoulder == 0 else -side)
        c1, s1 = np.cos(theta1), np.sin(theta1)
        u, along, beside = c1 * px + s1 * py, c1 * r13 + s1 * r23, c1 * r23 - s1 * r13
        for elbow in range(elbows):
            theta3 = slant - np.arctan2(K, bend if elbow == 0 else -bend)
            c3, s3 = np.cos(theta3), np.sin(theta3)
            y = (-a3 - a2 * c3) * pz - u * (d4 - a2 * s3)
            x = (a2 * s3 - d4) * pz + (a3 + a2 * c3) * u
            theta23 = q[1] + theta3 if folded else np.arctan2(y, x)
            c23, s23 = np.cos(theta23), np.sin(theta23)
            y, x = beside, r33 * s23 - along * c23
            s5, c5 = np.sqrt(x * x + y * y), -along * s23 - r33 * c23
            singular = s5 < FREE
            theta4 = q[3] if singular else np.arctan2(y, x)
            c4, s4 = (np.cos(theta4), np.sin(theta4)) if singular else (x / s5, y / s5)
            x11, x21 = c1 * T[0, 0] + s1 * T[1, 0], c1 * T[1, 0] - s1 * T[0, 0]
            s6 = -x21 * c4 - (x11 * c23 - T[2, 0] * s23) * s4
            c6 = ((x11 * c23 - T[2, 0] * s23) * c4 - x21 * s4) * c5 - (x11 * s23 + T[2, 0] * c23) * s5
            row = 4 * shoulder + 2 * elbow
            theta5, theta6 = np.arctan2(s5, c5), np.arctan2(s6, c6)
            theta[row, 0], theta[row, 1], theta[row, 2] = theta1, theta23 - theta3, theta3
            theta[row, 3], theta[row, 4], theta[row, 5] = theta4, theta5, theta6
            theta[row + 1, 0], theta[row + 1, 1], theta[row + 1, 2] = theta1, theta23 - theta3, theta3
            theta[row + 1, 3], theta[row + 1, 4], theta[row + 1, 5] = theta4 + np.pi, -theta5, theta6 + np.pi
            exists[row], exists[row + 1] = True, not singular
    return theta, exists


def solve(robot: Robot, T_world_tool: Array, q: Array) -> Answer:
    """Every posture for a tool pose (4, 4), m; q (6,), rad: kept where a joint is free.

    Raises HelicoideError for what is no pose, for another kind of arm, and unless q has six finite values.
    """
    if (reason := applies(robot)) is not None:
        raise HelicoideError(reason)
    goal, lengths, shifts = check_pose(T_world_tool), lengths_of(robot), np.array([row.theta for row in robot.dh.rows])
    T = np.linalg.inv(robot.dh.T_world_dh) @ goal @ np.linalg.inv(robot.dh.T_dh_tool)
    theta, exists = postures(lengths.copy(), T, robot.check_joints(q) + shifts)
    rows = np.flatnonzero(exists)
    branches = tuple(branch_of(robot, name(int(row), lengths[2]), theta[row] - shifts, goal) for row in rows)
    short = 0.0 if branches else beyond(lengths, T[:3, 3])
    free = _free(T, theta[rows], lengths)
    return Answer(
        branches=branches,
        T_world_goal=goal,
        words=sentences(
            COUNTED.format(n=len(rows)) if branches else _outside(lengths, short),
            *(FREE_WORDS[joint] for joint in free if joint in FREE_WORDS),
        ),
        short=short,
        free=free,
        values=tuple(_values(lengths, T, theta[row]) for row in rows),
    )


def name(row: int, d3: float) -> Text:
    """The posture in a row of `postures`: the upper arm passes the waist at d₃, to its left where that is positive."""
    left, up = (row < 4) == (d3 >= 0), (row < 4) == (row % 4 < 2)
    return NAME.format(shoulder=SHOULDER[left], elbow=ELBOW[up], wrist=WRIST[row % 2])


def beyond(lengths: Array, p: Array) -> float:
    """How far the wrist centre (3,), m, lies from where the arm brings it, m: a shell without a tube about the waist.

    √(px² + py²) ≥ |d₃| and |a₂ − ρ| ≤ √(|p|² − d₃²) ≤ a₂ + ρ with ρ² = a₃² + d₄². Source: Campos 1998, s.55 (ranges).
    """
    tube = abs(float(lengths[2]))
    inner, outer = wrist_range(lengths)
    out, up = hypot(p[0], p[1]), abs(p[2])
    size = hypot(out, up)
    onto = min(max(size, hypot(inner, tube)), hypot(outer, tube)) / size if size else 0.0
    if onto * out < tube or not size:
        return hypot(out - tube, up - min(max(up, inner), outer))
    return abs(onto - 1) * size


def wrist_range(lengths: Array) -> tuple[float, float]:
    """Least and largest distance of the wrist centre from the shoulder in the plane of the arm: |a₂ − ρ|, a₂ + ρ, m."""
    a2, rho = float(lengths[0]), hypot(lengths[1], lengths[3])
    return abs(a2 - rho), a2 + rho


def _free(T: Array, theta: Array, lengths: Array) -> tuple[int, ...]:
    """The joints that are not determined: of the waist or the shoulder below the wrist centre, of a singular wrist."""
    if not len(theta):
        return ()
    p = T[:3, 3]
    waist = hypot(p[0], p[1]) < FREE
    shoulder = is_folded(p[0] ** 2 + p[1] ** 2 - lengths[2] ** 2, p[2], lengths[2])
    wrist = np.abs(np.sin(theta[:, 4])).min() < FREE
    return tuple(joint for joint, free in ((0, waist), (1, shoulder), (3, wrist), (5, wrist)) if free)


def _values(lengths: Array, T: Array, theta: Array) -> Mapping[str, float]:
    """What the equations gave on the way to a posture, by symbol; m, m² and rad."""
    a2, a3, d3, d4 = map(float, lengths)
    px, py, pz = map(float, T[:3, 3])
    K = (px**2 + py**2 + pz**2 - a2**2 - a3**2 - d3**2 - d4**2) / (2 * a2)
    return {
        "p_x": px, "p_y": py, "p_z": pz, "K": K,
        "p_x² + p_y² − d_3²": px**2 + py**2 - d3**2, "a_3² + d_4² − K²": a3**2 + d4**2 - K**2,
        "u": float(np.cos(theta[0]) * px + np.sin(theta[0]) * py),
        **{f"θ_{joint + 1}": float(angle) for joint, angle in enumerate(theta)}, "θ_23": float(theta[1] + theta[2]),
    }  # fmt: skip


def _outside(lengths: Array, short: float) -> Text:
    inner, outer = wrist_range(lengths)
    return OUTSIDE.format(short=1000 * short, side=1000 * abs(lengths[2]), inner=1000 * inner, outer=1000 * outer)


NAME = Text(en="{shoulder}, {elbow}{wrist}", pt_BR="{shoulder}, {elbow}{wrist}")
SHOULDER = {
    True: Text(en="shoulder left", pt_BR="ombro à esquerda"),
    False: Text(en="shoulder right", pt_BR="ombro à direita"),
}
ELBOW = {
    True: Text(en="elbow up", pt_BR="cotovelo para cima"),
    False: Text(en="elbow down", pt_BR="cotovelo para baixo"),
}
WRIST = (Text(en="", pt_BR=""), Text(en=", wrist flipped", pt_BR=", punho virado"))
COUNTED = Text(
    en="Postures: {n}; shoulder left or right, elbow up or down, wrist flipped or not.",
    pt_BR="Posturas: {n}; ombro à esquerda ou à direita, cotovelo para cima ou para baixo, punho virado ou não.",
)
FREE_WORDS = {
    0: Text(
        en="The wrist centre is on the axis of the waist: joint 1 may take any value, and keeps its own.",
        pt_BR="O centro do punho está no eixo da cintura: a junta 1 aceita qualquer valor e mantém o atual.",
    ),
    1: Text(
        en="The wrist centre is on the axis of the shoulder: joint 2 may take any value, and keeps its own.",
        pt_BR="O centro do punho está no eixo do ombro: a junta 2 aceita qualquer valor e mantém o atual.",
    ),
    3: Text(
        en="The wrist is singular: joints 4 and 6 turn about one line, so only both together count; "
        "joint 4 keeps its value.",
        pt_BR="O punho está singular: as juntas 4 e 6 giram em torno da mesma reta e só o conjunto importa; "
        "a junta 4 mantém o valor atual.",
    ),
}
OUTSIDE = Text(
    en="Out of reach by {short:.3g} mm: the arm brings the wrist centre to {inner:.4g} … {outer:.4g} mm from the "
    "shoulder in its plane, and no nearer than {side:.4g} mm to the axis of the waist.",
    pt_BR="Fora de alcance por {short:.3g} mm: o braço leva o centro do punho de {inner:.4g} a {outer:.4g} mm do "
    "ombro, no plano do braço, e a não menos de {side:.4g} mm do eixo da cintura.",
)
