"""A steep barrier at joint limits: a cost near zero inside the limits that grows fast beyond them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from helicoide.ik import Problem
from helicoide.ik.method import Quantity
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="barrier at joint limits", pt_BR="barreira nos limites de junta")
SOURCE = "Vargas 2013, eq. 4.73"
EQUATION = r"f = \alpha \sum_i \left(\frac{q_i - q_{id}}{\zeta_i}\right)^{2k}"
AUGMENTS = True


@dataclass(frozen=True)
class Options:
    """weight: α; steepness: k; share: ζᵢ divided by half the range of joint i. q_id is the middle of that range."""

    weight: Annotated[float, Quantity(Text(en="weight α", pt_BR="peso α"), 0.0, 50.0, "1/s")] = 5.0
    steepness: Annotated[int, Quantity(Text(en="steepness k", pt_BR="inclinação k"), 1, 20)] = 10
    share: Annotated[float, Quantity(Text(en="share of the range", pt_BR="fração da faixa"), 0.1, 1.0)] = 1.0


def applies(robot: Robot) -> Text | None:
    """Applies to every robot: all joints have limits."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = α Σ ((qᵢ − q_id)/ζᵢ)²ᵏ, ∂f/∂qᵢ = (2kα/ζᵢ) ((qᵢ − q_id)/ζᵢ)²ᵏ⁻¹."""
    limits, power = problem.limits, 2 * round(options.steepness)
    zeta = options.share * (limits.upper - limits.lower) / 2
    off = (posture.q - (limits.lower + limits.upper) / 2) / zeta
    f = options.weight * float((off**power).sum())
    return Cost(f, problem.joint_units * options.weight * power / zeta * off ** (power - 1))
