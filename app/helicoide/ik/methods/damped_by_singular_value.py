"""Damping for each singular value: only directions with a small singular value are slowed down."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.method import Promise, Quantity, Solution, Task
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.text import Text

TITLE = Text(en="DLS, singular-value-based damping", pt_BR="MQA, amortecimento pelo valor singular")
SOURCE = "Maciejewski and Klein 1988 (one direction at a time); Chiaverini 1997 (growth of the damping)"
EQUATION = (
    r"\dot q = \sum_i \frac{\sigma_i}{\sigma_i^2 + \lambda_i^2} v_i u_i^T \nu, \quad "
    r"\lambda_i^2 = \lambda_{max}^2 \left(1 - \sigma_i^2/\varepsilon^2\right), \quad \sigma_i < \varepsilon"
)
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {
    "σₚ": Text(en="smallest singular value σₚ", pt_BR="menor valor singular σₚ"),
    "λₚ": Text(en="damping λₚ", pt_BR="amortecimento λₚ"),
    "damped": Text(en="damped directions", pt_BR="direções amortecidas"),
}


@dataclass(frozen=True)
class Options:
    """threshold: ε; damping: λ_max. Both have the unit of the singular values, ℓ per radian."""

    threshold: Annotated[
        float, Quantity(Text(en="threshold ε", pt_BR="limiar ε"), 1e-3, 1.0, "mm/rad", lengths=1, decades=True)
    ] = 0.05
    damping: Annotated[
        float,
        Quantity(
            Text(en="largest damping λ", pt_BR="maior amortecimento λ"), 1e-4, 1.0, "mm/rad", lengths=1, decades=True
        ),
    ] = 0.03


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> None:
    """This method has no memory."""


def dampings(sigma: Array, options: Options) -> Array:
    """λᵢ² = λ_max² (1 − σᵢ²/ε²) below ε, 0 above. Source: Chiaverini 1997, applied to each σᵢ separately."""
    return options.damping**2 * np.maximum(0.0, 1 - (sigma / options.threshold) ** 2)


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = Σ σᵢ/(σᵢ² + λᵢ²) vᵢ uᵢᵀ ν."""
    U, sigma, Vt = np.linalg.svd(task.J, full_matrices=False)
    # Without this, rounding errors could move the arm out of an exact singularity.
    sigma = np.where(sigma > RANK_TOLERANCE * sigma[0], sigma, 0.0)
    squares = dampings(sigma, options)
    B = Vt.T * (sigma / (sigma**2 + squares)) @ U.T
    figures = {"σₚ": float(sigma[-1]), "λₚ": float(np.sqrt(squares[-1])), "damped": float(np.sum(squares > 0))}
    return Solution(B @ task.rate, figures, inverse=B), None
