"""Three parallel axes, as in the UR family: eight postures from two shoulders × two elbows × two wrists."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import cos, sin

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.frames import first_four
from helicoide.ik.families.parallel_arm import (
    AHEAD,
    ALONG,
    ASIDE,
    FOURTH,
    HAND,
    LINKS,
    SETTING,
    SHOULDER,
    THIRD,
    WAIST,
    ending,
    parallel_arm,
)
from helicoide.ik.families.parallel_postures import (
    FLIPPED,
    FREE_SHOULDER,
    FREE_WAIST,
    FREE_WRIST,
    LEFT,
    LOOSE,
    UP,
    centre_from_waist,
    parallel_joint_values,
    rotated,
    triple,
)
from helicoide.ik.families.two_links import elbows
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found
from helicoide.ik.postures.branch import sentences, wrap
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="three parallel axes: eight postures", pt_BR="três eixos paralelos: oito posturas")
SOURCE = (
    "Pieper 1968 (three parallel axes); Hawkins 2013, Analytic inverse kinematics for the Universal Robots UR-5/UR-10 "
    "arms; Elias and Wen 2022, IK-Geo (by the axes, at any angles)"
)
RANK, OF_POINTS = 1, False
EQUATIONS = (
    r"W = \hat s_5 \cap \hat s_6, \quad v = T W_T - p_1, \quad h \parallel \hat s_2, \hat s_3, \hat s_4",
    r"h \cdot R_1^T v = h \cdot (W - p_1): \quad"
    r"\theta_1 = \operatorname{Atan2}(B, A) \pm \operatorname{Atan2}(\sqrt{A^2 + B^2 - C^2}, C)",
    r"A = h \cdot v - (\hat s_1 \cdot h)(\hat s_1 \cdot v), \quad B = (\hat s_1 \times h) \cdot v, \quad"
    r"C = h \cdot (W - p_1) - (\hat s_1 \cdot h)(\hat s_1 \cdot v)",
    r"u = R^T R_1 h, \quad h \cdot R_5 \hat s_6 = \hat s_6 \cdot u \;\Rightarrow\; \theta_5",
    r"R_6 u = R_5^T h: \quad \theta_6 = \operatorname{Atan2}(\hat s_6 \cdot (u \times R_5^T h),"
    r"\; u \cdot R_5^T h - (\hat s_6 \cdot u)(\hat s_6 \cdot R_5^T h))",
    r"R_h(\varphi) = R_1^T R R_6^T R_5^T, \quad \varphi = \theta_2 + \theta_3 + \theta_4",
    r"\zeta = \zeta_v - \zeta_S - l_3 e^{i\varphi} = l_1 e^{i\theta_2} + l_2 e^{i(\theta_2 + \theta_3)}",
    r"\cos(\theta_3 + \delta) = \frac{|\zeta|^2 - |l_1|^2 - |l_2|^2}{2 |l_1| |l_2|}, \quad"
    r"\theta_2 = \arg \frac{\zeta}{l_1 + l_2 e^{i\theta_3}}, \quad \theta_4 = \varphi - \theta_2 - \theta_3",
)


def applies(robot: Robot) -> Text | None:
    """Applies to six revolute joints: axes 2, 3 and 4 parallel, axis 1 not parallel to them, axes 5 and 6 meet."""
    return ELSE if parallel_arm(robot) is None else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m, refined by Newton's method and verified by forward kinematics.

    q (6,), rad: a joint that the pose leaves free keeps its value. Raises HelicoideError if the form does not apply.
    """
    if (arm := parallel_arm(robot)) is None:
        raise HelicoideError(ELSE)
    rows = parallel_joint_values(arm, T_world_tool, q)
    short = 0.0 if len(rows) else subspace.distance_beyond(robot, T_world_tool, q)
    return Found(rows, T_world_tool, ParallelAxesPostures(arm, T_world_tool, rows, short), short=short)


@dataclass(eq=False)  # a frozen instance takes four times as long to create, a noticeable delay
class ParallelAxesPostures:
    """Names, sentences and intermediate values for the postures in the rows of `parallel_joint_values`."""

    arm: Array
    T_world_tool: Array
    rows: Array
    short: float

    @cached_property
    def names(self) -> Sequence[Text]:
        """The name of each posture."""
        return [
            NAME.format(shoulder=SIDES[bool(row[LEFT])], elbow=ELBOWS[bool(row[UP])], wrist=WRISTS[bool(row[FLIPPED])])
            for row in self.rows
        ]

    @cached_property
    def words(self) -> Text:
        """The number of postures or the distance of the goal from the workspace, and which joints are free."""
        count = len(self.rows)
        said = OUTSIDE.format(short=1000 * self.short) if self.short else TURNED
        return sentences(COUNTED.format(n=count) if count else said, *(FREE_WORDS[joint] for joint in self.free))

    @cached_property
    def values(self) -> Sequence[Mapping[str, float]]:
        """Intermediate values of the equations for each posture, by symbol."""
        return list(self._values())

    @cached_property
    def free(self) -> tuple[int, ...]:
        """The joints that are not determined."""
        loose = int(np.bitwise_or.reduce(self.rows[:, LOOSE].astype(int)))
        return (0,) * bool(loose & FREE_WAIST) + (1,) * bool(loose & FREE_SHOULDER) + (5,) * bool(loose & FREE_WRIST)

    def _values(self) -> Iterator[Mapping[str, float]]:
        """`values` in m and rad; θ₃ and θ₄ about h."""
        arm = self.arm
        v = centre_from_waist(arm, self.T_world_tool)
        for row in self.rows:
            theta = row[:6] * [1.0, 1.0, arm[SETTING, THIRD], arm[SETTING, FOURTH], 1.0, 1.0]
            turn = cos(theta[0]), sin(theta[0])
            h, x = (np.array(rotated(triple(arm[WAIST]), turn, triple(arm[axis]))) for axis in (ALONG, AHEAD))
            phi = float(theta[1:4].sum())
            seen = complex(x @ v, np.cross(h, x) @ v)
            wrist = complex(seen - ending(arm, SHOULDER) - ending(arm, HAND) * np.exp(1j * phi))
            _, cosine, _ = elbows(wrist, first_four(arm[LINKS]), 0.0)
            yield {
                "h · (W − p₁)": float(arm[SETTING, ASIDE]), "u": seen.real, "φ": float(wrap(phi)), "u_W": wrist.real,
                "z_W": -wrist.imag, "cos(θ₃ + δ)": cosine,
                **{f"θ{'₁₂₃₄₅₆'[i]}": float(wrap(angle)) for i, angle in enumerate(theta)},
            }  # fmt: skip


NAME = Text(en="{shoulder}, {elbow}{wrist}", pt_BR="{shoulder}, {elbow}{wrist}")
SIDES = {
    True: Text(en="shoulder left", pt_BR="ombro à esquerda"),
    False: Text(en="shoulder right", pt_BR="ombro à direita"),
}
ELBOWS = {
    True: Text(en="elbow up", pt_BR="cotovelo para cima"),
    False: Text(en="elbow down", pt_BR="cotovelo para baixo"),
}
WRISTS = {False: Text(en="", pt_BR=""), True: Text(en=", wrist flipped", pt_BR=", punho virado")}
COUNTED = Text(
    en="Postures: {n}; shoulder left or right, elbow up or down, wrist flipped or not.",
    pt_BR="Posturas: {n}; ombro à esquerda ou à direita, cotovelo para cima ou para baixo, punho virado ou não.",
)
OUTSIDE = Text(
    en="Out of reach by {short:.1f} mm, in any orientation.",
    pt_BR="Fora do alcance por {short:.1f} mm, em qualquer orientação.",
)
TURNED = Text(
    en="The end effector reaches this position, but not in this orientation.",
    pt_BR="O efetuador alcança esta posição, mas não com esta orientação.",
)
FREE_WORDS = {
    0: Text(
        en="The wrist is on the waist axis: joint 1 is arbitrary and keeps its value.",
        pt_BR="O punho está sobre o eixo da cintura: a junta 1 é arbitrária e mantém o valor.",
    ),
    1: Text(
        en="The arm is folded onto its shoulder: joint 2 is arbitrary and keeps its value.",
        pt_BR="O braço está dobrado sobre o ombro: a junta 2 é arbitrária e mantém o valor.",
    ),
    5: Text(
        en="The wrist is singular: the axis of joint 6 is parallel to those of joints 2, 3 and 4; joint 6 keeps its "
        "value.",
        pt_BR="O punho está singular: o eixo da junta 6 é paralelo aos das juntas 2, 3 e 4; a junta 6 mantém o valor.",
    ),
}
ELSE = Text(
    en="This form needs six revolute joints: axes 2, 3 and 4 parallel to each other and not to axis 1, and axes 5 and "
    "6 intersecting.",
    pt_BR="Esta forma exige seis juntas de revolução: eixos 2, 3 e 4 paralelos entre si e não ao eixo 1, e eixos 5 e "
    "6 que se cruzam.",
)
