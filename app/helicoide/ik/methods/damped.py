"""Damped least squares with constant damping: a compromise between the asked velocity and small joint velocities."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.method import Promise, Quantity, Solution, Task
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.text import Text

TITLE = Text(en="damped least squares", pt_BR="mínimos quadrados amortecidos")
SOURCE = "Cerbaro 2022, eq. 71; Vargas 2013, eqs. 3.10–3.14; Coutinho 2015, eq. 3.46"
EQUATION = r"\dot q = J^T (J J^T + \lambda^2 I)^{-1} \nu"
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {}


@dataclass(frozen=True)
class Options:
    """damping: λ, in units of ℓ per radian."""

    damping: Annotated[
        float, Quantity(Text(en="damping λ", pt_BR="amortecimento λ"), 1e-4, 1.0, "mm/rad", lengths=1, decades=True)
    ] = 0.02


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> None:
    """This method has no memory."""


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = Σ σᵢ/(σᵢ² + λ²) vᵢ uᵢᵀ ν, which minimizes ‖ν − J q̇‖² + λ² ‖q̇‖².

    Singular values below the rank tolerance count as zero.
    """
    U, sigma, Vt = np.linalg.svd(task.J, full_matrices=False)
    sigma = np.where(sigma > RANK_TOLERANCE * sigma[0], sigma, 0.0)
    B = Vt.T * (sigma / (sigma**2 + options.damping**2)) @ U.T
    return Solution(B @ task.rate, inverse=B), None
