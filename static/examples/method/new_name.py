"""A new method, to be changed: damped least squares with a constant damping."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.method import Promise, Quantity, Solution, Task
from helicoide.text import Text

TITLE = Text(en="new method (new_name)", pt_BR="método novo (new_name)")
SOURCE = "author, year, equation; or that it is your own"
EQUATION = r"\dot q = J^T (J J^T + \lambda^2 I)^{-1} \nu"
REMEMBERS: Text | None = None
PROMISES: frozenset[Promise] = frozenset({Promise.CONVERGES, Promise.BOUNDED})
FIGURES: Mapping[str, Text] = {}


@dataclass(frozen=True)
class Options:
    """damping: λ, in units of ℓ per radian."""

    damping: Annotated[
        float, Quantity(Text(en="damping λ", pt_BR="amortecimento λ"), 1e-3, 1.0, "mm/rad", lengths=1, decades=True)
    ] = 0.05


def applies(task: Task) -> Text | None:
    """To every task."""
    return None


def start(task: Task, options: Options) -> None:
    """Nothing is remembered."""


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = Jᵀ (J Jᵀ + λ² I)⁻¹ ν."""
    J = task.J
    B = J.T @ np.linalg.inv(J @ J.T + options.damping**2 * np.eye(len(J)))
    return Solution(B @ task.rate, inverse=B), None
