"""The polar arm: a turret and a slide; its position forces its orientation."""

from __future__ import annotations

from math import atan2, hypot

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.families.polar_arm import polar_arm
from helicoide.ik.postures import subspace
from helicoide.ik.postures.answer import Found, Said
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
# Nearer to the axis than this, m, no direction leads to the point.
ON_AXIS = subspace.NOTHING

_NAME = Text(en="drawn out", pt_BR="estendido")
_DRAWN_IN = Text(en="drawn in onto the axis", pt_BR="recolhido até o eixo")
_ONE = Text(en="One posture: the slide points at the goal.", pt_BR="Uma postura: o deslizador aponta para o alvo.")
_UNDEFINED = Text(
    en="ρ = 0: the goal lies on the axis of the turret, where every θ₁ serves; the present one is kept.",
    pt_BR="ρ = 0: o alvo está sobre o eixo da torre, onde qualquer θ₁ serve; mantém-se o atual.",
)
_STROKE = Text(
    en="The slide would have to be {far:.3g} mm beyond its stroke.",
    pt_BR="O deslizador teria de passar {far:.3g} mm do seu curso.",
)
_ELSE = Text(
    en="This form is for a turning joint and a slide that leads straight out from its axis.",
    pt_BR="Esta forma vale para uma junta de revolução e um deslizador que sai em linha reta do eixo dela.",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return _ELSE if polar_arm(robot) is None else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """The posture for a tool pose (4, 4), m, of which (x, y) is kept; q (2,), rad and m: θ₁ is kept at ρ = 0.

    Raises HelicoideError for a robot of another kind and for what is no pose. Source: Campos 1998, s.31–34.
    """
    if (arm := polar_arm(robot)) is None:
        raise HelicoideError(_ELSE)
    goal = subspace.project(robot, T_world_tool, q)
    x, y = arm.place(goal.T_world_goal)
    rho = hypot(x, y)
    on_axis = rho < ON_AXIS
    theta1 = float(q[0]) if on_axis else atan2(-x, y)
    slide = rho - arm.stretch
    beyond = max(slide - robot.upper[1], robot.lower[1] - slide)
    stroke = _STROKE.format(far=1000 * beyond) if beyond > ON_AXIS else None
    told = Said(
        names=(_DRAWN_IN if on_axis else _NAME,),
        words=sentences(goal.words, _UNDEFINED if on_axis else _ONE, stroke),
        values=({"x": x, "y": y, "ρ": rho, "θ₁": theta1, "d₂": rho},),
        free=(0,) if on_axis else (),
    )
    return Found(np.array([[theta1, slide]]), goal.T_world_goal, told, goal.moved, goal.turned)
