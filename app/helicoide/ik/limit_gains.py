"""Joint limits by growing gains: each time a joint is clipped to its limit, its gain in the null space grows.

Source: Cerbaro 2022, §4.5, Algorithm 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import ControlLaw, LoopStep, TaskFunction, solve_with_null_space
from helicoide.ik.secondary import Chosen, push

GROWTH = 1.01


def clipped(q: Array, lower: Array, upper: Array, gains: Array, growth: float = GROWTH) -> tuple[Array, Array]:
    """Clip the joints to their limits and increase the gains of those outside: qᵢ ← limit, k₀ᵢ ← 1.01 k₀ᵢ.

    Args: q, lower, upper (n,), rad or m; gains: k₀ (n,), the diagonal of K₀; growth: the factor, 1 for constant gains.
    Returns q and k₀. Source: Cerbaro 2022, Algorithm 1; the gains never decrease there either.
    """
    outside = (q < lower) | (q > upper)
    return np.clip(q, lower, upper), np.where(outside, growth * gains, gains)


@dataclass(frozen=True, eq=False)
class GrowingObjective:
    """The objectives whose gains Algorithm 1 increases: each with its options; growth as in `clipped`."""

    chosen: Chosen
    growth: float = GROWTH


@dataclass(frozen=True, eq=False)
class LimitGainMemory:
    """Memory of the loop: k₀ (n,), 1/s, and the memory of the method."""

    gains: Array
    method: Any = None


def loop_with_limit_gains(
    problem: Problem,
    law: ControlLaw,
    objective: GrowingObjective,
    aiming: TaskFunction,
    q: Array,
    memory: LimitGainMemory,
) -> Iterator[LoopStep]:
    """`clik.closed_loop` with the objectives in the null space, q̇₀ = −diag(k₀) ∂f/∂q, and Algorithm 1 after each step.

    memory: the initial one; each `LoopStep` has the one after it.
    """
    t, k0, of_method = 0.0, memory.gains, memory.method
    while True:
        aim = aiming(q, t)
        pushed = push(problem, objective.chosen, k0)(q, t)
        solution, of_method = solve_with_null_space(problem, law.inverse, law.task(aim, q), of_method, pushed)
        moved = q + problem.joint_units * solution.rates * law.dt
        moved, k0 = clipped(moved, problem.limits.lower, problem.limits.upper, k0, objective.growth)
        yield LoopStep(t, q, aim, solution, LimitGainMemory(k0, of_method))
        q = moved
        t += law.dt
