"""How secondary objectives move the joints: in the null space of the task, or as an additional row of it.

Null space: q̇₀ = −k₀ ∂f/∂q, projected by `clik.solve_with_null_space`; the task is not affected. Row: J₊ = [J; ∂f/∂q],
ν₊ = [ν; −f]; where not all rows can be met, the task is not met exactly. Several objectives are summed into one f.
Source: Cerbaro 2022, eqs. 9–10; Vargas 2013, eqs. 4.69–4.72.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import NullSpaceVelocity, TaskError, TaskFunction
from helicoide.ik.objective import NOBODY, Cost, Objective, Posture, posture_at
from helicoide.text import HelicoideError, Text

Chosen = Sequence[tuple[Objective, Any]]
Others = Callable[[float], Array]


def nobody(t: float) -> Array:
    """No points of a second arm, at any t."""
    return NOBODY


def total(problem: Problem, chosen: Chosen, at: Posture) -> Cost:
    """f = Σ fᵢ and its gradient; chosen: objectives, each with its options."""
    costs = [objective.cost(problem, at, options) for objective, options in chosen]
    return Cost(sum(cost.value for cost in costs), sum((cost.gradient for cost in costs), np.zeros(len(at.q))))


def push(problem: Problem, chosen: Chosen, gains: Array | float, others: Others = nobody) -> NullSpaceVelocity:
    """q̇₀ = −K₀ ∂f/∂q as a function of q and t, for the null space in `clik.closed_loop`.

    gains: k₀, 1/s, one for all joints, or (n,) for the diagonal of K₀; others: points of a second arm at t, (k, 3), m.
    Source: Cerbaro 2022, eq. 10 (w = −f) and §4.5.
    """
    return lambda q, t: -gains * total(problem, chosen, posture_at(problem, q, others(t))).gradient


def augmented(problem: Problem, chosen: Chosen, aiming: TaskFunction, others: Others = nobody) -> TaskFunction:
    """The task with an additional row that asks for ḟ = −f: J₊ = [J; ∂f/∂q], ν₊ = [ẋ_d + Λ e; −f].

    The gain on f is 1 for every Λ: −f is a feedforward, and the error of the row is zero. The weights within f set its
    priority. Raises HelicoideError for an objective that does not tend to zero (`AUGMENTS`).
    Source: Vargas 2013, eqs. 4.69–4.72 (ẋ_d for x_d).
    """
    for objective, _ in chosen:
        if not objective.AUGMENTS:
            raise HelicoideError(_NOT_A_ROW.format(title=objective.TITLE))

    def with_row(q: Array, t: float) -> TaskError:
        aim, cost = aiming(q, t), total(problem, chosen, posture_at(problem, q, others(t)))
        return TaskError(
            np.vstack([aim.J, cost.gradient]), np.append(aim.error, 0.0), np.append(aim.feedforward, -cost.value)
        )

    return with_row


_NOT_A_ROW = Text(
    en="“{title}” is not zero at its minimum, so it cannot be a task row; use it in the null space.",
    pt_BR="“{title}” não é zero no mínimo, por isso não pode ser uma linha da tarefa; use-o no espaço nulo.",
)
