"""Joint limits by gains that grow: each time a joint is stopped at its limit, its objective pulls it harder.

Source: Cerbaro 2022, §4.5, Algorithm 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import LoopStep, TaskFunction, solve_with_null_space, task_from
from helicoide.ik.method import Method
from helicoide.ik.secondary import Chosen, Others, nobody, push

GROWTH = 1.01


def clipped(q: Array, lower: Array, upper: Array, gains: Array, growth: float = GROWTH) -> tuple[Array, Array]:
    """Joints outside their limits are put on them, and their gains grow: qᵢ ← limit, k₀ᵢ ← 1.01 k₀ᵢ.

    Args: q, lower, upper (n,), rad or m; gains: k₀ (n,), the diagonal of K₀; growth: 1 leaves them. Returns q and k₀.
    Source: Cerbaro 2022, Algorithm 1; the gains only grow, as there.
    """
    outside = (q < lower) | (q > upper)
    return np.clip(q, lower, upper), np.where(outside, growth * gains, gains)


@dataclass(frozen=True, eq=False)
class LimitGainMemory:
    """What a run remembers: k₀ (n,), 1/s, and what its method does."""

    gains: Array
    method: Any = None


def loop_with_limit_gains(
    problem: Problem,
    method: Method,
    options: Any,
    aiming: TaskFunction,
    gains: Array | float,
    chosen: Chosen,
    memory: LimitGainMemory,
    q: Array,
    dt: float,
    others: Others = nobody,
    growth: float = GROWTH,
) -> Iterator[LoopStep]:
    """`clik.followed` with the objectives in the null space and Algorithm 1 after each step: q̇₀ = −diag(k₀) ∂f/∂q.

    memory: what to begin with, and in each moment what there is after it; chosen and others as in `secondary.push`;
    growth as in `clipped`.
    """
    t, k0, of_method = 0.0, memory.gains, memory.method
    while True:
        aim = aiming(q, t)
        task = task_from(aim, gains, q, dt)
        if of_method is None:
            of_method = method.start(task, options)
        pushed = push(problem, chosen, k0, others)(q, t)
        solution, of_method = solve_with_null_space(problem, method, task, of_method, options, pushed)
        moved = q + problem.joint_units * solution.rates * dt
        moved, k0 = clipped(moved, problem.limits.lower, problem.limits.upper, k0, growth)
        yield LoopStep(t, q, aim, solution, LimitGainMemory(k0, of_method))
        q = moved
        t += dt
