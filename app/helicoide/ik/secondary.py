"""How secondary objectives move the joints: in the null space of the task, or as one more row of it.

Null space: q̇₀ = −k₀ ∂f/∂q, which `clik.answered` projects; it never disturbs the task. Row: J₊ = [J; ∂f/∂q],
ν₊ = [ν; −f]; the task gives way where it has to. Several objectives are summed into one f.
Source: Cerbaro 2022, eqs. 9–10; Vargas 2013, eqs. 4.69–4.72.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import TaskError, TaskFunction
from helicoide.ik.objective import NOBODY, Cost, Objective, Posture, posture
from helicoide.text import HelicoideError, Text

Chosen = Sequence[tuple[Objective, Any]]
Others = Callable[[float], Array]


def nobody(t: float) -> Array:
    """The points of a second arm where there is none."""
    return NOBODY


def total(problem: Problem, chosen: Chosen, at: Posture) -> Cost:
    """f = Σ fᵢ and its gradient; chosen: objectives, each with its options."""
    costs = [objective.cost(problem, at, options) for objective, options in chosen]
    return Cost(sum(cost.value for cost in costs), sum((cost.gradient for cost in costs), np.zeros(len(at.q))))


def push(
    problem: Problem, chosen: Chosen, gains: Array | float, others: Others = nobody
) -> Callable[[Array, float], Array]:
    """What `clik.followed` adds in the null space: q̇₀ = −K₀ ∂f/∂q.

    gains: k₀, 1/s, one for all joints, or (n,) for the diagonal of K₀; others: points of a second arm at t, (k, 3), m.
    Source: Cerbaro 2022, eq. 10 (w = −f) and §4.5.
    """
    return lambda q, t: -gains * total(problem, chosen, posture(problem, q, others(t))).gradient


def augmented(problem: Problem, chosen: Chosen, aiming: TaskFunction, others: Others = nobody) -> TaskFunction:
    """The aim with one row more, which asks for ḟ = −f: J₊ = [J; ∂f/∂q], ν₊ = [ẋ_d + Λ e; −f].

    The gain on f is one whatever Λ is: −f stands with the velocities and the row has no error; priority is set by the
    weights within f. Raises HelicoideError where an objective is not one to be driven to zero.
    Source: Vargas 2013, eqs. 4.69–4.72 (ẋ_d for x_d).
    """
    for objective, _ in chosen:
        if not objective.AUGMENTS:
            raise HelicoideError(_NOT_A_ROW.format(title=objective.TITLE))

    def with_row(q: Array, t: float) -> TaskError:
        aim, cost = aiming(q, t), total(problem, chosen, posture(problem, q, others(t)))
        return TaskError(
            np.vstack([aim.J, cost.gradient]), np.append(aim.error, 0.0), np.append(aim.feedforward, -cost.value)
        )

    return with_row


_NOT_A_ROW = Text(
    en="“{title}” cannot be a row of the task, since it does not come to rest at zero; use it in the null space.",
    pt_BR="“{title}” não pode ser uma linha da tarefa, pois não repousa em zero; use-o no espaço nulo.",
)
