"""A second arm, or obstacles that may move: a Gaussian cost around each of their points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.arm_points import PER_LINK, WATCHED, watched
from helicoide.ik.method import Quantity
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="second arm or obstacles", pt_BR="segundo braço ou obstáculos")
SOURCE = "Vargas 2013, eq. 4.74 and figs. 4.43–4.44, without ∂f/∂t as there"
EQUATION = r"f = \alpha \sum_j \sum_k e^{-\|p_j - o_k\|^2 / \rho^2}"
AUGMENTS = True


@dataclass(frozen=True)
class Options:
    """weight: α; radius: ρ of each Gaussian, ℓ; where: which points p_j of the arm; per_link: how many per link."""

    weight: Annotated[float, Quantity(Text(en="weight α", pt_BR="peso α"), 0.0, 50.0, "1/s")] = 5.0
    radius: Annotated[float, Quantity(Text(en="radius ρ", pt_BR="raio ρ"), 0.01, 1.0, "mm", 1)] = 0.1
    where: Annotated[str, WATCHED] = "links"
    per_link: Annotated[int, PER_LINK] = 4


def applies(robot: Robot) -> Text | None:
    """Applies to every robot."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = α Σⱼₖ exp(−‖pⱼ − oₖ‖²/ρ²), ∂f/∂q = −(2α/ρ²) Σⱼₖ exp(−‖pⱼ − oₖ‖²/ρ²) (pⱼ − oₖ)ᵀ J_pj.

    oₖ: the points `posture.others`.
    """
    points, J = watched(problem.robot, options.where, round(options.per_link)).moving(problem, posture.poses)
    offsets = points[:, None] - posture.others / problem.length
    hills = options.weight * np.exp(-np.square(offsets).sum(axis=2) / options.radius**2)
    pull = np.einsum("jk,jka->ja", hills, offsets)
    return Cost(float(hills.sum()), -2 / options.radius**2 * np.einsum("ja,jan->n", pull, J))
