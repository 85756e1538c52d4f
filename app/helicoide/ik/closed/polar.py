"""The polar arm: a revolute joint and a slide. Its position determines its orientation."""

from __future__ import annotations

from math import atan2, hypot

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.polar_arm import polar_arm
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found, Words
from helicoide.ik.postures.branch import sentences
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="polar arm", pt_BR="braço polar")
SOURCE = "Campos 1998, Cinemática inversa de manipuladores, s.31–34"
RANK, OF_POINTS = 0, True
EQUATIONS = (
    r"\rho = \sqrt{x^2 + y^2}",
    r"{}^0_2T = \begin{bmatrix} y/\rho & 0 & x/\rho & x \\ -x/\rho & 0 & y/\rho & y \\ 0 & -1 & 0 & 0 \\"
    r" 0 & 0 & 0 & 1 \end{bmatrix}",
    r"\theta_1 = \operatorname{Atan2}(-x, y)",
    r"d_2 = \rho",
)
# Below this distance from the axis, m, θ₁ is undefined.
ON_AXIS = subspace.NOTHING

_NAME = Text(en="extended", pt_BR="estendido")
_DRAWN_IN = Text(en="retracted onto the axis", pt_BR="recolhido até o eixo")
_ONE = Text(
    en="One posture: the prismatic joint points at the goal.",
    pt_BR="Uma postura: a junta prismática aponta para o alvo.",
)
_UNDEFINED = Text(
    en="ρ = 0: the goal is on the axis of joint 1: θ₁ is arbitrary and keeps its value.",
    pt_BR="ρ = 0: o alvo está sobre o eixo da junta 1: θ₁ é arbitrário e mantém o valor.",
)
_STROKE = Text(
    en="Out of reach: the prismatic joint would be {far:.3g} mm beyond its stroke.",
    pt_BR="Fora do alcance: a junta prismática passaria {far:.3g} mm do seu curso.",
)
_ELSE = Text(
    en="This form needs a revolute joint and a prismatic joint perpendicular to its axis.",
    pt_BR="Esta forma exige uma junta de revolução e uma prismática perpendicular ao eixo dela.",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return _ELSE if polar_arm(robot) is None else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """The posture for the (x, y) of a tool pose (4, 4), m. q (2,), rad and m: θ₁ is kept at ρ = 0.

    Raises HelicoideError if the form does not apply or if T_world_tool is not a pose. Source: Campos 1998, s.31–34.
    """
    if (arm := polar_arm(robot)) is None:
        raise HelicoideError(_ELSE)
    goal = subspace.project_to_subspace(robot, T_world_tool, q)
    x, y = arm.place(goal.T_world_goal)
    rho = hypot(x, y)
    on_axis = rho < ON_AXIS
    theta1 = float(q[0]) if on_axis else atan2(-x, y)
    slide = rho - arm.stretch
    beyond = max(slide - robot.upper[1], robot.lower[1] - slide)
    stroke = _STROKE.format(far=1000 * beyond) if beyond > ON_AXIS else None
    told = Words(
        names=(_DRAWN_IN if on_axis else _NAME,),
        words=sentences(goal.words, _UNDEFINED if on_axis else _ONE, stroke),
        values=({"x": x, "y": y, "ρ": rho, "θ₁": theta1, "d₂": rho},),
        free=(0,) if on_axis else (),
    )
    return Found(np.array([[theta1, slide]]), goal.T_world_goal, told, goal.moved, goal.turned)
