"""Distance from joint limits: every joint is moved towards the middle of its range."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.ik import Problem
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="distance to joint limits", pt_BR="distância aos limites de junta")
SOURCE = "Cerbaro 2022, eqs. 12 and 14 (2n, which is 6 for three joints)"
EQUATION = r"f = \frac{1}{2n} \sum_i \left(\frac{q_i - \bar q_i}{q_{iM} - q_{im}}\right)^2"
AUGMENTS = False


@dataclass(frozen=True)
class Options:
    """This objective has no options."""


def applies(robot: Robot) -> Text | None:
    """Applies to every robot: all joints have limits."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = 1/(2n) Σ ((qᵢ − q̄ᵢ)/(q_iM − q_im))², ∂f/∂qᵢ = (qᵢ − q̄ᵢ)/(n (q_iM − q_im)²)."""
    limits = problem.limits
    span = limits.upper - limits.lower
    off = (posture.q - (limits.lower + limits.upper) / 2) / span
    return Cost(float(off @ off) / (2 * len(off)), problem.joint_units * off / (len(off) * span))
