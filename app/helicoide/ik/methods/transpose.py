"""The Jacobian transpose: each joint velocity is proportional to the torque that a force ν on the tool would cause."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.method import OneOf, Promise, Quantity, Solution, Task
from helicoide.text import Text

TITLE = Text(en="Jacobian transpose", pt_BR="transposta da jacobiana")
SOURCE = "Wolovich and Elliott 1984; the best α: Buss 2004; Vargas 2013, §1.2"
EQUATION = (
    r"\dot q = \alpha J^T \nu, \quad \alpha = \min\left("
    r"\frac{\langle \nu, J J^T \nu \rangle}{\langle J J^T \nu, J J^T \nu \rangle}, \alpha_{max}\right)"
)
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {"α": Text(en="current step α", pt_BR="passo α atual")}


@dataclass(frozen=True)
class Options:
    """step: how α is chosen. alpha: the constant α, or the upper bound of the best α.

    For a fixed target and a gain Λ = λI, small motions are stable for dt λ < 2 with the best α, which minimizes
    ‖ν − α J Jᵀν‖. With a constant α they are stable for dt λ α σ₁² < 2. σ₁ is the largest singular value of J, about
    1 to 2.5 if lengths are divided by the reach: with dt = 50 ms and λ = 5 1/s, α may be up to about 1.2.
    """

    step: Annotated[
        str,
        OneOf(
            Text(en="choice of α", pt_BR="escolha de α"),
            {
                "best": Text(en="optimal at every step", pt_BR="ótimo a cada passo"),
                "constant": Text(en="constant", pt_BR="constante"),
            },
        ),
    ] = "best"
    alpha: Annotated[
        float,
        Quantity(Text(en="α, or its maximum", pt_BR="α, ou seu máximo"), 0.01, 30.0, decades=True),
    ] = 10.0


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> None:
    """This method has no memory."""


def best(J: Array, rate: Array) -> float:
    """The α that minimizes ‖ν − α J Jᵀν‖: ⟨ν, JJᵀν⟩/⟨JJᵀν, JJᵀν⟩, infinite where JJᵀν = 0. Source: Buss 2004."""
    turned = J @ (J.T @ rate)
    size = float(turned @ turned)
    return float(rate @ turned) / size if size > 0 else np.inf


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = α Jᵀν."""
    alpha = min(best(task.J, task.rate), options.alpha) if options.step == "best" else options.alpha
    B = alpha * task.J.T
    return Solution(B @ task.rate, {"α": alpha}, inverse=B), None
