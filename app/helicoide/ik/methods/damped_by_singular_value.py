"""Damping for each singular value: only the directions that the arm is about to lose are slowed down."""

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

TITLE = Text(en="damped by singular value", pt_BR="amortecida por valor singular")
SOURCE = "Maciejewski and Klein 1988 (one direction at a time); Chiaverini 1997 (growth of the damping)"
EQUATION = (
    r"\dot q = \sum_i \frac{\sigma_i}{\sigma_i^2 + \lambda_i^2} v_i u_i^T \nu, \quad "
    r"\lambda_i^2 = \lambda_{max}^2 \left(1 - \sigma_i^2/\varepsilon^2\right) \text{ for } \sigma_i < \varepsilon"
)
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {
    "σₚ": Text(en="smallest singular value σₚ", pt_BR="menor valor singular σₚ"),
    "λₚ": Text(en="its damping λₚ", pt_BR="seu amortecimento λₚ"),
    "damped": Text(en="directions that are damped", pt_BR="direções amortecidas"),
}


@dataclass(frozen=True)
class Options:
    """threshold: ε, and damping: λ_max, both in units of ℓ per radian, as the singular values are."""

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
    """To every task."""
    return None


def start(task: Task, options: Options) -> None:
    """Nothing is remembered."""


def dampings(sigma: Array, options: Options) -> Array:
    """λᵢ² = λ_max² (1 − σᵢ²/ε²) below ε, 0 above. Source: Chiaverini 1997, for each σᵢ by itself."""
    return options.damping**2 * np.maximum(0.0, 1 - (sigma / options.threshold) ** 2)


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = Σ σᵢ/(σᵢ² + λᵢ²) vᵢ uᵢᵀ ν."""
    U, sigma, Vt = np.linalg.svd(task.J, full_matrices=False)
    sigma = np.where(
        sigma > RANK_TOLERANCE * sigma[0], sigma, 0.0
    )  # rounding must not lead out of an exact singularity
    squares = dampings(sigma, options)
    B = Vt.T * (sigma / (sigma**2 + squares)) @ U.T
    figures = {"σₚ": float(sigma[-1]), "λₚ": float(np.sqrt(squares[-1])), "damped": float(np.sum(squares > 0))}
    return Solution(B @ task.rate, figures, inverse=B), None
