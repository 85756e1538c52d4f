"""The transpose of the Jacobian: every joint gives way as if the wish were a force that pulls at the tool."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.method import OneOf, Promise, Quantity, Solution, Task
from helicoide.text import Text

TITLE = Text(en="Jacobian transpose", pt_BR="transposta do jacobiano")
SOURCE = "Wolovich and Elliott 1984; the best α: Buss 2004; Vargas 2013, §1.2"
EQUATION = (
    r"\dot q = \alpha J^T \nu, \quad \alpha = \min\left("
    r"\frac{\langle \nu, J J^T \nu \rangle}{\langle J J^T \nu, J J^T \nu \rangle}, \alpha_{max}\right)"
)
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {"α": Text(en="step α of this instant", pt_BR="passo α deste instante")}


@dataclass(frozen=True)
class Options:
    """step: how α is chosen. alpha: α itself, or the largest that the best step may take.

    A task with one gain Λ = λI that stands still is stable in small motions for dt λ < 2 with the best step, which
    brings α J Jᵀν as near to ν as α can, and for dt λ α σ₁² < 2 with a constant α, σ₁ the largest singular value of J,
    about 1 to 2.5 in units of the reach: at 50 ms and λ = 5 up to about α = 1.2.
    """

    step: Annotated[
        str,
        OneOf(
            Text(en="choice of α", pt_BR="escolha de α"),
            {
                "best": Text(en="best at every instant", pt_BR="o melhor a cada instante"),
                "constant": Text(en="constant", pt_BR="constante"),
            },
        ),
    ] = "best"
    alpha: Annotated[
        float,
        Quantity(Text(en="α, or its maximum", pt_BR="α, ou seu máximo"), 0.01, 30.0, decades=True),
    ] = 10.0


def applies(task: Task) -> Text | None:
    """To every task."""
    return None


def start(task: Task, options: Options) -> None:
    """Nothing is remembered."""


def best(J: Array, rate: Array) -> float:
    """The α that brings α J Jᵀν nearest to ν: ⟨ν, JJᵀν⟩/⟨JJᵀν, JJᵀν⟩, infinite where Jᵀν is lost. Source: Buss 2004."""
    turned = J @ (J.T @ rate)
    size = float(turned @ turned)
    return float(rate @ turned) / size if size > 0 else np.inf


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = α Jᵀν."""
    alpha = min(best(task.J, task.rate), options.alpha) if options.step == "best" else options.alpha
    B = alpha * task.J.T
    return Solution(B @ task.rate, {"α": alpha}, inverse=B), None
