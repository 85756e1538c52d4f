"""The PUMA 560: eight postures from two shoulders × two elbows × two wrists."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from math import hypot

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.puma_arm import (
    FREE,
    NUMBER,
    Puma,
    is_folded,
    puma,
    puma_distance_beyond,
    puma_joint_values,
    wrist_range,
)
from helicoide.ik.postures.answer import Found
from helicoide.ik.postures.branch import sentences
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


def applies(robot: Robot) -> Text | None:
    """Applies to arms whose modified DH rows are those of the PUMA, with any a₂ ≠ 0, a₃, d₃ and d₄."""
    return ELSE if puma(robot) is None else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m. q (6,), rad: a joint that the pose leaves free keeps its value.

    Raises HelicoideError if the form does not apply.
    """
    if (arm := puma(robot)) is None:
        raise HelicoideError(ELSE)
    rows = puma_joint_values(arm.packed, T_world_tool, q)
    told = PumaPostures(arm, T_world_tool, rows)
    return Found(rows, T_world_tool, told, short=0.0 if len(rows) else told.short)


@dataclass(eq=False)  # a frozen instance takes four times as long to create, a noticeable delay
class PumaPostures:
    """Names, sentences and intermediate values for the postures in the rows of `puma_joint_values`."""

    arm: Puma
    T_world_tool: Array
    rows: Array

    @cached_property
    def names(self) -> Sequence[Text]:
        """The name of each posture."""
        every = names(bool(self.arm.lengths[2] >= 0))
        return [every[int(row)] for row in self.rows[:, NUMBER]]

    @cached_property
    def words(self) -> Text:
        """The number of postures or the distance of the goal from the workspace, and which joints are free."""
        return sentences(
            COUNTED.format(n=len(self.rows)) if len(self.rows) else _outside(self.arm.lengths, self.short),
            *(FREE_WORDS[joint] for joint in self.free if joint in FREE_WORDS),
        )

    @cached_property
    def values(self) -> Sequence[Mapping[str, float]]:
        """Intermediate values of the equations for each posture, by symbol."""
        return [_values(self.arm.lengths, self.T, theta) for theta in self.theta]

    @cached_property
    def free(self) -> tuple[int, ...]:
        """The joints that are not determined."""
        return _free(self.T, self.theta, self.arm.lengths)

    @property
    def short(self) -> float:
        """Distance of the wrist centre from its workspace, m."""
        return puma_distance_beyond(self.arm.lengths, self.T[:3, 3])

    @property
    def theta(self) -> Array:
        """θ of the postures, (k, 6), rad."""
        return np.asarray(self.rows[:, :6] + self.arm.shifts)

    @cached_property
    def T(self) -> Array:
        """The pose of the wrist in the base frame of the DH rows, (4, 4), m."""
        return np.asarray(self.arm.frames[0] @ self.T_world_tool @ self.arm.frames[1])


@cache
def names(passes_left: bool) -> tuple[Text, ...]:
    """The names of the eight postures by their number in `puma_joint_values`. passes_left: d₃ ≥ 0, see `puma_arm`."""
    left_and_up = [((row < 4) == passes_left, (row < 4) == (row % 4 < 2)) for row in range(8)]
    return tuple(
        NAME.format(shoulder=SHOULDER[left], elbow=ELBOW[up], wrist=WRIST[row % 2])
        for row, (left, up) in enumerate(left_and_up)
    )


def _free(T: Array, theta: Array, lengths: Array) -> tuple[int, ...]:
    """The joints that are not determined: 1 or 2 with the wrist centre on its axis, 4 and 6 at a singular wrist."""
    if not len(theta):
        return ()
    p = T[:3, 3]
    waist = hypot(p[0], p[1]) < FREE
    shoulder = is_folded(p[0] ** 2 + p[1] ** 2 - lengths[2] ** 2, p[2], lengths[2])
    wrist = np.abs(np.sin(theta[:, 4])).min() < FREE
    return tuple(joint for joint, free in ((0, waist), (1, shoulder), (3, wrist), (5, wrist)) if free)


def _values(lengths: Array, T: Array, theta: Array) -> Mapping[str, float]:
    """Intermediate values of the equations for a posture, by symbol; m, m² and rad."""
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


ELSE = Text(
    en="This form needs the DH rows of the PUMA 560 (modified): α = 0, −90°, 0, −90°, 90°, −90°.",
    pt_BR="Esta forma exige as linhas DH modificadas do PUMA 560: α = 0, −90°, 0, −90°, 90°, −90°.",
)
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
        en="The wrist centre is on the waist axis: joint 1 is arbitrary and keeps its value.",
        pt_BR="O centro do punho está no eixo da cintura: a junta 1 é arbitrária e mantém o valor.",
    ),
    1: Text(
        en="The wrist centre is on the shoulder axis: joint 2 is arbitrary and keeps its value.",
        pt_BR="O centro do punho está no eixo do ombro: a junta 2 é arbitrária e mantém o valor.",
    ),
    3: Text(
        en="The wrist is singular: the axes of joints 4 and 6 coincide; joint 4 keeps its value.",
        pt_BR="O punho está singular: os eixos das juntas 4 e 6 coincidem; a junta 4 mantém o valor.",
    ),
}
OUTSIDE = Text(
    en="Out of reach by {short:.1f} mm: the wrist centre reaches {inner:.1f} … {outer:.1f} mm from the shoulder in "
    "the plane of the arm, and at least {side:.1f} mm from the waist axis.",
    pt_BR="Fora do alcance por {short:.1f} mm: o centro do punho alcança de {inner:.1f} a {outer:.1f} mm do ombro, no "
    "plano do braço, e no mínimo {side:.1f} mm do eixo da cintura.",
)
