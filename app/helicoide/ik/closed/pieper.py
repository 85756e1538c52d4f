"""Six revolute joints with a spherical wrist, last or first: every posture, by Pieper's polynomial of degree 4."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import cos, sin

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.pieper_arm import Arm, arm_of, pieper_distance_beyond
from helicoide.ik.families.pieper_postures import (
    ACCEPTED,
    ARM,
    FLIPPED,
    LOOSE,
    SHOULDER,
    WAIST,
    WRIST,
    pieper_joint_values,
    wrist_pose,
)
from helicoide.ik.families.polish import polisher
from helicoide.ik.postures.answer import Found
from helicoide.ik.postures.branch import sentences
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="spherical wrist: Pieper's solution", pt_BR="punho esférico: solução de Pieper")
SOURCE = "Pieper 1968; Campos 1998, s.26, after Craig, Introduction to Robotics"
RANK, OF_POINTS = 1, False
EQUATIONS = (
    r"f_1 = a_3 c_3 + d_4 s\alpha_3 s_3 + a_2",
    r"f_2 = a_3 c\alpha_2 s_3 - d_4 s\alpha_3 c\alpha_2 c_3 - d_4 s\alpha_2 c\alpha_3 - d_3 s\alpha_2",
    r"f_3 = a_3 s\alpha_2 s_3 - d_4 s\alpha_3 s\alpha_2 c_3 + d_4 c\alpha_2 c\alpha_3 + d_3 c\alpha_2",
    r"k_1 = f_1, \quad k_2 = -f_2, \quad k_3 = f_1^2 + f_2^2 + f_3^2 + a_1^2 + d_2^2 + 2 d_2 f_3, \quad"
    r"k_4 = (f_3 + d_2) c\alpha_1",
    r"r = p_x^2 + p_y^2 + p_z^2 = 2 a_1 (k_1 c_2 + k_2 s_2) + k_3, \quad"
    r"z = p_z = s\alpha_1 (k_1 s_2 - k_2 c_2) + k_4",
    r"a_1 = 0: r = k_3; \quad s\alpha_1 = 0: z = k_4; \quad"
    r"a_1 s\alpha_1 \ne 0: \frac{(r - k_3)^2}{4 a_1^2} + \frac{(z - k_4)^2}{s^2\alpha_1} = k_1^2 + k_2^2",
    r"g_1 = c_2 f_1 - s_2 f_2 + a_1, \quad g_2 = c\alpha_1 (s_2 f_1 + c_2 f_2) - s\alpha_1 (f_3 + d_2), \quad"
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) - \operatorname{Atan2}(g_2, g_1)",
    r"c_5 = \frac{c\alpha_4 c\alpha_5 - m_{33}}{s\alpha_4 s\alpha_5}, \quad M = R_x(\alpha_3)^T ({}^0_3 R)^T R",
    r"R_z(\theta_4) R_x(\alpha_4) R_z(\theta_5) R_x(\alpha_5) R_z(\theta_6) = M",
)


def applies(robot: Robot) -> Text | None:
    """Applies to six revolute joints: the last or first three axes meet at a point, the other joints position it."""
    arm = arm_of(robot)
    return arm if isinstance(arm, Text) else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m, refined by Newton's method and verified by forward kinematics.

    q (6,), rad: a joint that the pose leaves free keeps its value. Raises HelicoideError if the form does not apply.
    """
    if isinstance(arm := arm_of(robot), Text):
        raise HelicoideError(arm)
    rows = pieper_joint_values(arm.packed, polisher(robot), T_world_tool, q)
    told = PieperPostures(arm, T_world_tool, rows)
    return Found(rows, T_world_tool, told, short=0.0 if len(rows) else told.short)


@dataclass(eq=False)  # a frozen instance takes four times as long to create, a noticeable delay
class PieperPostures:
    """Names, sentences and intermediate values for the postures in the rows of `pieper_joint_values`."""

    arm: Arm
    T_world_tool: Array
    rows: Array

    @cached_property
    def names(self) -> Sequence[Text]:
        """The name of each posture."""
        return [(FLIPPED_POSTURE if row[FLIPPED] else POSTURE).format(n=int(row[ARM])) for row in self.rows]

    @cached_property
    def words(self) -> Text:
        """The number of postures or the distance of the goal from the workspace, and which joints are free."""
        count, joints = len(self.rows), ", ".join(str(joint + 1) for joint in self.free)
        short = 0.0 if count else self.short
        return sentences(
            COUNTED.format(n=count) if count else OUTSIDE.format(short=1000 * short) if short > ACCEPTED else TURNED,
            KEPT.format(joints=joints) if joints else None,
        )

    @cached_property
    def values(self) -> Sequence[Mapping[str, float]]:
        """Intermediate values of the equations for each posture, by symbol."""
        return [_values(self.arm, self.T, self.arm.turned(row[:6]) + self.arm.shifts) for row in self.rows]

    @cached_property
    def free(self) -> tuple[int, ...]:
        """The joints that are not determined."""
        loose = int(np.bitwise_or.reduce(self.rows[:, LOOSE].astype(int)))
        joints = (0,) * bool(loose & WAIST) + (1,) * bool(loose & SHOULDER) + (3, 5) * bool(loose & WRIST)
        return tuple(sorted(5 - joint if self.arm.backwards else joint for joint in joints))

    @cached_property
    def short(self) -> float:
        """Distance of the wrist centre from its workspace, m."""
        return pieper_distance_beyond(self.arm, self.T[:3, 3])

    @cached_property
    def T(self) -> Array:
        """The pose of the wrist, (4, 4), m."""
        return wrist_pose(self.arm.packed[0], self.T_world_tool)


def _values(arm: Arm, T: Array, theta: Array) -> Mapping[str, float]:
    """Intermediate values of the equations for a posture θ (6,), rad, by symbol; m, m² and rad."""
    _, theta2, theta3, *_ = map(float, theta)
    f1, f2, f3 = map(float, arm.f @ [1, cos(theta3), sin(theta3)])
    ca1, sa1, c2, s2 = cos(arm.alpha[0]), sin(arm.alpha[0]), cos(theta2), sin(theta2)
    return {
        "r": float(T[:3, 3] @ T[:3, 3]), "z": float(T[2, 3]), "f_1": f1, "f_2": f2, "f_3": f3,
        "g_1": c2 * f1 - s2 * f2 + arm.a[0], "g_2": ca1 * (s2 * f1 + c2 * f2) - sa1 * (f3 + arm.d[1]),
        **{f"θ_{i + 1}": float(angle) for i, angle in enumerate(theta)},
    }  # fmt: skip


POSTURE = Text(en="arm posture {n}", pt_BR="postura {n} do braço")
FLIPPED_POSTURE = Text(en="arm posture {n}, wrist flipped", pt_BR="postura {n} do braço, punho virado")
COUNTED = Text(
    en="Postures: {n}; each arm posture with the wrist flipped or not.",
    pt_BR="Posturas: {n}; cada postura do braço com o punho virado ou não.",
)
OUTSIDE = Text(
    en="Out of reach: the wrist centre is {short:.3g} mm outside its workspace.",
    pt_BR="Fora do alcance: o centro do punho fica {short:.3g} mm fora do seu espaço de trabalho.",
)
TURNED = Text(
    en="The wrist centre reaches its position, but the wrist cannot take this orientation there.",
    pt_BR="O centro do punho alcança a sua posição, mas ali o punho não assume esta orientação.",
)
KEPT = Text(
    en="Singular: the goal does not determine joints {joints}; an arbitrary joint keeps its value.",
    pt_BR="Singular: o alvo não determina as juntas {joints}; uma junta arbitrária mantém o valor.",
)
