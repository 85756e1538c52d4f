"""The filtered inverse of the normal equations: Θ_P follows the inverse of JᵀJ, and q̇ = Θ_P Jᵀ ν."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.filtered_inverse import Step, Update
from helicoide.ik.method import Promise, Quantity, Solution, Task
from helicoide.ik.methods import filtered
from helicoide.ik.methods.filtered import STARTS, STEPS, UPDATES, Memory
from helicoide.text import Text

TITLE = Text(en="filtered inverse of JᵀJ", pt_BR="inversa filtrada de JᵀJ")
SOURCE = "Vargas 2013, ch. 5, future work (a)"
EQUATION = (
    r"\dot q = \Theta_P J^T \nu, \quad P = J^T J, \quad "
    r"\dot\Theta_P = -\gamma \left(P (P\Theta_P - I) + (\Theta_P P - I) P\right)"
)
REMEMBERS: Text | None = Text(en="the filtered inverse Θ_P of JᵀJ", pt_BR="a inversa filtrada Θ_P de JᵀJ")
PROMISES: frozenset[Promise] = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {
    "V_c": filtered.FIGURES["V_c"],
    "‖Θ‖": Text(en="norm of Θ_P", pt_BR="norma de Θ_P"),
    "dt_max": filtered.FIGURES["dt_max"],
}


@dataclass(frozen=True)
class Options:
    """gain: γ, in units of rad⁴/(ℓ⁴ s). A direction with singular value σ converges with time constant 1/(2γσ⁴), s.

    update, step, start: see their choices.
    """

    gain: Annotated[
        float,
        Quantity(Text(en="update gain γ", pt_BR="ganho γ"), 1.0, 1e8, "1/s", decades=True),
    ] = 1000.0
    update: Annotated[Update, UPDATES] = "composite"
    step: Annotated[Step, STEPS] = "exact"
    start: Annotated[str, STARTS] = "zero"


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> Memory:
    """Θ_P(0), (n, n): zero, or 0.1 in every entry."""
    return filtered.start(normal(task), law(options))


def normal(task: Task) -> Task:
    """The task with J replaced by P = JᵀJ, (n, n), which Θ_P inverts."""
    return replace(task, J=np.asarray(task.J.T @ task.J))


def law(options: Options) -> filtered.Options:
    """These options as those of `filtered`, which updates Θ_P."""
    return filtered.Options(options.gain, options.update, options.step, options.start)


def step(problem: Problem, task: Task, memory: Memory, options: Options) -> tuple[Solution, Memory]:
    """q̇ = Θ_P Jᵀ ν with the present Θ_P; then Θ_P is updated."""
    known, of_law = normal(task), law(options)
    memory = filtered.recalled(known, memory, of_law)
    B = memory.Theta @ task.J.T
    figures = filtered.figures(known, memory.Theta, of_law)
    return Solution(B @ task.rate, figures, B), filtered.updated(known, memory, of_law)
