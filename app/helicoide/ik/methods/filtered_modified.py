"""The modified filtered inverse: J q̇ never opposes the asked velocity, and unreachable directions are left out."""

from __future__ import annotations

from collections.abc import Mapping

from helicoide.ik import Problem
from helicoide.ik.method import Promise, Solution, Task
from helicoide.ik.methods import filtered
from helicoide.ik.methods.filtered import Memory, Options, applies, start
from helicoide.text import Text

__all__ = ["Options", "applies", "start", "step"]

TITLE = Text(en="modified filtered inverse", pt_BR="inversa filtrada modificada")
SOURCE = "Vargas 2013, §4.6, eqs. 4.64–4.68"
EQUATION = (
    r"\dot q = \Theta \Theta^T J^T \nu, \quad "
    r"\dot\Theta = -\gamma \left(J^T (J\Theta - I) + (\Theta J - I) J^T\right)"
)
REMEMBERS = filtered.REMEMBERS
PROMISES = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = filtered.FIGURES


def step(problem: Problem, task: Task, memory: Memory, options: Options) -> tuple[Solution, Memory]:
    """q̇ = Θ Θᵀ Jᵀ ν. Then J q̇ = M ν with M = (JΘ)(JΘ)ᵀ ≥ 0, so the error of a fixed target does not grow."""
    memory = filtered.recalled(task, memory, options)
    Theta = memory.Theta
    B = Theta @ Theta.T @ task.J.T
    figures = filtered.figures(task, Theta, options)
    return Solution(B @ task.rate, figures, B), filtered.updated(task, memory, options)
