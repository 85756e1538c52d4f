"""What a secondary objective is: a cost of the posture, and how it changes with the joints."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import Problem
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

NOBODY = frozen(np.empty((0, 3)))


@dataclass(frozen=True, eq=False)
class Posture:
    """How the arm stands, and what stands beside it.

    q (n,), rad or m; poses (m + 1, 4, 4) of `forward.link_poses`; others (k, 3), m: points of a second arm, or of what
    else stands there.
    """

    q: Array
    poses: Array
    others: Array = field(default_factory=lambda: NOBODY)


def posture(problem: Problem, q: Array, others: Array = NOBODY) -> Posture:
    """The posture of the arm at q (n,), rad or m."""
    return Posture(q, link_poses(problem.robot.chain, q), others)


@dataclass(frozen=True, eq=False)
class Cost:
    """f, the smaller the better, and its gradient ∂f/∂q (n,), both without lengths.

    Lengths are divided by the characteristic length ℓ and a joint that slides is measured in ℓ, as in `method.Task`:
    ḟ = gradient · q̇ with the rates of a `method.Solution`.
    """

    value: float
    gradient: Array


class Objective(Protocol):
    """A module of `ik/objectives/`.

    EQUATION: of f, in TeX. AUGMENTS: whether f ≥ 0 and as good as zero wherever nothing is amiss; then f → 0 can be
    asked for as one more row of the task, else the objective moves the joints in the null space only.
    """

    TITLE: Text
    SOURCE: str
    EQUATION: str
    AUGMENTS: bool
    Options: type

    def applies(self, robot: Robot) -> Text | None:
        """Why the objective does not apply to a robot; None where it does."""

    def cost(self, problem: Problem, posture: Posture, options: Any) -> Cost:
        """f and ∂f/∂q of a posture."""
