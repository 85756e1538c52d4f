"""The interface of a secondary objective: a cost of the posture and its gradient."""

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
    """The posture of the arm, and the points beside it.

    q (n,), rad or m; poses (m + 1, 4, 4) of `forward.link_poses`; others (k, 3), m: points of a second arm or of
    obstacles.
    """

    q: Array
    poses: Array
    others: Array = field(default_factory=lambda: NOBODY)


def posture_at(problem: Problem, q: Array, others: Array = NOBODY) -> Posture:
    """The posture of the arm at q (n,), rad or m."""
    return Posture(q, link_poses(problem.robot.chain, q), others)


@dataclass(frozen=True, eq=False)
class Cost:
    """f, to be minimised, and its gradient ∂f/∂q (n,), both dimensionless.

    Lengths are divided by the characteristic length ℓ, and a prismatic joint is measured in ℓ, as in `method.Task`:
    ḟ = gradient · q̇ with the q̇ of a `method.Solution`.
    """

    value: float
    gradient: Array


class Objective(Protocol):
    """A module of `ik/objectives/`.

    EQUATION: of f, in TeX. AUGMENTS: whether f ≥ 0, with f ≈ 0 wherever the objective is met. Then f → 0 can be an
    additional row of the task; otherwise the objective acts only in the null space.
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
