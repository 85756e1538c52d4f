"""Searches from postures that are spread evenly over the joints' ranges: kernels.

The postures follow from their numbers, so that the same question always has the same answer. Shapes are not checked.
"""

from __future__ import annotations

import numpy as np

from helicoide.ik.postures.descent import LOWER, STRIDE, UPPER, descend, held, memory_of, settle
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array


@kernel
def draw(ranges: Array, number: int, q: Array) -> None:
    """Write the posture of a number: spread evenly, one number after another, over the ranges of all joints.

    Source: Roberts 2018, The unreasonable effectiveness of quasirandom sequences (an additive recurrence).
    """
    for i in range(q.shape[0]):
        share = 0.5 + number * ranges[i, STRIDE]
        q[i] = ranges[i, LOWER] + (share - np.floor(share)) * (ranges[i, UPPER] - ranges[i, LOWER])


@kernel
def begin(ranges: Array, start: Array, q: Array) -> None:
    """Write the posture nearest to `start` that keeps the limits."""
    for i in range(q.shape[0]):
        q[i] = held(ranges, i, start[i])


@kernel
def search(
    arm: Array,
    ranges: Array,
    goal: Array,
    start: Array,
    weights: tuple[float, float],
    tolerances: tuple[float, float],
    iterations: int,
    searches: int,
) -> Array:
    """The first posture found: one search from `start`, the others from drawn postures, always the same ones.

    Args: arm of `tool.packed`; ranges (n, 6); goal (4, 4), m; start (n,), rad or m; weights: 1/ℓ and 1, or 0 for the
    position alone; tolerances, m and rad. Returns in one array q (n,), what is missed, m, and turned, rad (infinite
    where nothing was found), the steps of all searches, and their number.
    """
    n = start.shape[0]
    answer, memory = np.empty(n + 4), memory_of(n)
    q, total = answer[:n], 0
    begin(ranges, start, q)
    for number in range(1, searches + 1):
        steps, missed, turned = descend(arm, ranges, goal, weights, tolerances, iterations, q, memory)
        total += abs(steps)
        if missed < np.inf or number == searches:
            answer[n], answer[n + 1], answer[n + 2], answer[n + 3] = missed, turned, total, number
            break
        draw(ranges, number, q)
    return answer


@kernel
def approach(
    arm: Array, ranges: Array, goal: Array, start: Array, weights: tuple[float, float], iterations: int, searches: int
) -> Array:
    """The posture (n,) whose tool comes nearest to a goal in the sense of e², of several searches as in `search`."""
    n = start.shape[0]
    q, trial, best, memory = np.empty(n), np.empty(n), np.empty(n), memory_of(n)
    least = np.inf
    begin(ranges, start, q)
    for number in range(1, searches + 1):
        left = settle(arm, ranges, goal, weights, iterations, q, trial, memory)
        if left < 0.999999 * least:
            best[:], least = q, left
        draw(ranges, number, q)
    return best
