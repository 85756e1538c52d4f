"""A slab between two parallel planes: the cost is near zero inside it and grows fast beyond its faces."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.arm_points import PER_LINK, WATCHED, watched
from helicoide.ik.method import Quantity
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="slab between two planes", pt_BR="faixa entre dois planos")
SOURCE = "after Vargas 2013, eq. 4.73, for the coordinate across a plane"
EQUATION = r"f = \alpha \sum_j (s_j / \zeta)^{2k}, \quad s_j = n^T p_j - d"
AUGMENTS = True


@dataclass(frozen=True)
class Options:
    """weight: α; steepness: k; azimuth, elevation: of the normal n, rad; offset: d of the middle plane, ℓ, base frame.

    half: ζ, half the thickness, ℓ; where: which points p_j of the arm count; per_link: how many on each link.
    """

    weight: Annotated[float, Quantity(Text(en="weight α", pt_BR="peso α"), 0.0, 50.0, "1/s")] = 5.0
    steepness: Annotated[int, Quantity(Text(en="steepness k", pt_BR="inclinação k"), 1, 20)] = 10
    azimuth: Annotated[
        float, Quantity(Text(en="azimuth of the normal", pt_BR="azimute da normal"), -3.1416, 3.1416, "rad")
    ] = 0.0
    elevation: Annotated[
        float, Quantity(Text(en="elevation of the normal", pt_BR="elevação da normal"), -1.5708, 1.5708, "rad")
    ] = 1.5708
    offset: Annotated[float, Quantity(Text(en="middle plane d", pt_BR="plano médio d"), -1.5, 1.5, "mm", 1)] = 0.5
    half: Annotated[float, Quantity(Text(en="half thickness ζ", pt_BR="meia espessura ζ"), 0.01, 1.0, "mm", 1)] = 0.5
    where: Annotated[str, WATCHED] = "tool"
    per_link: Annotated[int, PER_LINK] = 1


def applies(robot: Robot) -> Text | None:
    """Applies to every robot."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = α Σⱼ (sⱼ/ζ)²ᵏ, ∂f/∂q = (2kα/ζ) Σⱼ (sⱼ/ζ)²ᵏ⁻¹ nᵀ J_pj."""
    points, J = watched(problem.robot, options.where, round(options.per_link)).moving(problem, posture.poses)
    across = cos(options.elevation)
    normal = np.array([across * cos(options.azimuth), across * sin(options.azimuth), sin(options.elevation)])
    s, power = (points @ normal - options.offset) / options.half, 2 * round(options.steepness)
    slope = options.weight * power / options.half * s ** (power - 1)
    return Cost(options.weight * float((s**power).sum()), np.einsum("j,jan,a->n", slope, J, normal))
