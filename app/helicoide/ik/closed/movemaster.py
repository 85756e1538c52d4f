"""The Movemaster and similar arms: four postures, waist to the front or to the back, elbow up or down."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families import elbow
from helicoide.ik.families.frames import first_four, pose_rows
from helicoide.ik.families.movemaster_arm import (
    BACK,
    BEND,
    FREE_SHOULDER,
    FREE_WAIST,
    LINKS,
    SIGNS,
    TURNED,
    Side,
    movemaster_joint_values,
    seen,
    side_of,
)
from helicoide.ik.families.two_links import elbows
from helicoide.ik.postures.answer import Found
from helicoide.ik.postures.branch import sentences, wrap
from helicoide.ik.postures.subspace import Projection
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="Movemaster family", pt_BR="família do Movemaster")
SOURCE = "Cerbaro 2022, tabs. 6 and 8 (geometry); Campos 1998, s.36 and s.44–55 (plane of the arm, elbow)"
RANK, OF_POINTS = 0, False
EQUATIONS = (
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) \;[+\,180^\circ], \quad u = c_1 p_x + s_1 p_y",
    r"\zeta_P = u - i p_z, \quad e^{i\alpha} = \frac{\zeta_{\hat Z}}{\zeta_{\hat Z}(0)}, \quad"
    r"\alpha = \theta_2 + \theta_3 + \theta_4",
    r"\zeta_W = \zeta_P - l_3 e^{i\alpha} - \zeta_S = l_1 e^{i\theta_2} + l_2 e^{i(\theta_2 + \theta_3)}",
    r"\cos(\theta_3 + \delta) = \frac{|\zeta_W|^2 - |l_1|^2 - |l_2|^2}{2 |l_1| |l_2|}, \quad"
    r"\delta = \arg \frac{l_2}{l_1}",
    r"\theta_2 = \arg \frac{\zeta_W}{l_1 + l_2 e^{i\theta_3}}, \quad \theta_4 = \alpha - \theta_2 - \theta_3",
    r"R_{\hat Z}(\theta_5) = R_y(\alpha)^T R_z(\theta_1)^T R R_0^T",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return ELSE if side_of(robot) is None else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m, after its pointing axis is rotated into the plane of the arm.

    q (5,), rad: θ₁ is kept where the tool is vertical on the waist axis, θ₂ where equal links fold onto the shoulder.
    Raises HelicoideError if the form does not apply.
    """
    if (arm := side_of(robot)) is None:
        raise HelicoideError(ELSE)
    rows, goal, noted = movemaster_joint_values(arm.packed, T_world_tool, q)
    told = MovemasterPostures(arm, goal, rows, noted, float(q[0]))
    return Found(
        rows, goal, told, turned=float(noted[TURNED]), short=0.0 if len(rows) else arm.links.beyond(told.nearer)
    )


@dataclass(eq=False)  # a frozen instance takes four times as long to create, a noticeable delay
class MovemasterPostures:
    """Names, sentences and intermediate values for the postures that `movemaster_joint_values` found.

    T_world_goal (4, 4), m: the pose after its rotation into the plane of the arm; rows, noted: results of
    `movemaster_joint_values`; theta1: the current θ₁, rad, which defines the plane of the arm if the goal does not.
    """

    arm: Side
    T_world_goal: Array
    rows: Array
    noted: Array
    theta1: float

    @cached_property
    def names(self) -> Sequence[Text]:
        """The name of each posture."""
        return [
            SIDES[int(row[BACK])].format(elbow=elbow.UP if up else elbow.DOWN)
            for row, (_, _, wrist) in zip(self.rows, self._seen(self.rows[:, 0]), strict=True)
            for up in [(row[BEND] > 0) == (wrist.real >= 0)]
        ]

    @cached_property
    def words(self) -> Text:
        """The number of postures or the distance of the goal from the workspace, and which joints are free."""
        return sentences(
            Projection(self.T_world_goal, 0.0, float(self.noted[TURNED])).words,
            COUNTED.format(n=len(self.rows)) if len(self.rows) else self.arm.links.words(self.nearer),
            OVER if 0 in self.free else None,
            FOLDED if 1 in self.free else None,
        )

    @cached_property
    def values(self) -> Sequence[Mapping[str, float]]:
        """Intermediate values of the equations for each posture, by symbol."""
        return list(self._values())

    @property
    def free(self) -> tuple[int, ...]:
        """The joints that are not determined."""
        return (0,) * bool(self.noted[FREE_WAIST]) + (1,) * bool(self.noted[FREE_SHOULDER])

    @property
    def nearer(self) -> float:
        """Distance from the shoulder to the wrist, m, for the waist direction that comes nearer to the workspace."""
        M, _ = self.arm.turret.normal(self.T, self.theta1)
        heading = float(np.arctan2(-M[0], M[1]))
        sizes = [abs(wrist) for _, _, wrist in self._seen([heading, heading + pi])]
        return min(sizes, key=self.arm.links.beyond)

    @cached_property
    def T(self) -> Array:
        """The goal in the base frame, (4, 4), m."""
        return self.arm.turret.seen(self.T_world_goal)

    def _seen(self, headings: Sequence[float] | Array) -> Iterator[tuple[complex, float, complex]]:
        return (seen(self.arm.packed, pose_rows(self.T), float(theta1)) for theta1 in headings)

    def _values(self) -> Iterator[Mapping[str, float]]:
        """`values` in m and rad; θ₂, θ₃ and θ₄ about the y axis of the base."""
        for row, (zeta, alpha, wrist) in zip(self.rows, self._seen(self.rows[:, 0]), strict=True):
            theta = row[:5] * [1.0, *self.arm.packed[SIGNS, :3], 1.0]
            _, cosine, _ = elbows(wrist, first_four(self.arm.packed[LINKS]), elbow.EDGE)
            yield {
                "u": zeta.real, "p_z": -zeta.imag, "α": alpha, "u_W": wrist.real, "z_W": -wrist.imag,
                "cos(θ₃ + δ)": cosine, **{f"θ{'₁₂₃₄₅'[i]}": float(wrap(theta[i])) for i in range(5)},
                "bend": float(row[BEND]),
            }  # fmt: skip


SIDES = (
    Text(en="waist to the front, {elbow}", pt_BR="cintura de frente, {elbow}"),
    Text(en="waist to the back, {elbow}", pt_BR="cintura para trás, {elbow}"),
)
ELSE = Text(
    en="This form needs five revolute joints: a waist; shoulder, elbow and wrist pitch with parallel axes "
    "perpendicular to it; a wrist roll that carries the end effector in the plane of the arm.",
    pt_BR="Esta forma exige cinco juntas de revolução: cintura; ombro, cotovelo e arfagem do punho com eixos "
    "paralelos, perpendiculares a ela; e uma rolagem que leva o efetuador no plano do braço.",
)
COUNTED = Text(
    en="Postures: {n}; waist to the front or to the back, elbow up or down.",
    pt_BR="Posturas: {n}; cintura de frente ou para trás, cotovelo para cima ou para baixo.",
)
OVER = Text(
    en="The end effector is vertical on the waist axis: θ₁ is arbitrary and keeps its value.",
    pt_BR="O efetuador está na vertical sobre o eixo da cintura: θ₁ é arbitrário e mantém o valor.",
)
FOLDED = Text(
    en="The wrist is on the shoulder axis: θ₂ is arbitrary and keeps its value.",
    pt_BR="O punho está sobre o eixo do ombro: θ₂ é arbitrário e mantém o valor.",
)
