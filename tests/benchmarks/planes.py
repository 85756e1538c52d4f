"""Finding a wall in a cloud of 300,000 points."""

from __future__ import annotations

from time import perf_counter

import numpy as np
from tests.benchmarks.report import p50, spread, verdict

from helicoide.arrays import Array
from helicoide.perception.planes import FoundPlane, find_plane

TITLE = "A wall in 300,000 points with 2 mm of noise, beside outliers and another wall"
POINTS, TIMES = 300_000, 15
GOAL = 1.0
DOWN, INSIDE = np.array([0.0, 0, -1]), np.array([0.52, 0.0, 0.23])


def _cloud(share: float) -> Array:
    """A ceiling that holds so much of the points; the rest is half a side wall, half anywhere."""
    rng = np.random.default_rng(0)
    points = rng.uniform([0.1, -0.3, 0.0], [0.9, 0.3, 0.63], (POINTS, 3))
    kinds = rng.random(POINTS)
    ceiling, wall = kinds < share, kinds > (1 + share) / 2
    points[ceiling, 2] = 0.63 + 0.05 * points[ceiling, 0] + 0.002 * rng.normal(size=ceiling.sum())
    points[wall, 1] = 0.3 + 0.002 * rng.normal(size=wall.sum())
    return points


def _seconds(points: Array, seed: int) -> float:
    begun = perf_counter()
    answer = find_plane(points, DOWN, INSIDE, seed=seed)
    took = perf_counter() - begun
    assert isinstance(answer, FoundPlane), answer
    return took


def run() -> None:
    slowest = 0.0
    for share in (0.7, 0.4, 0.1):
        points = _cloud(share)
        _seconds(points, 0)
        took = [_seconds(points, seed) for seed in range(TIMES)]
        spread(f"find, {100 * share:.0f} % on the wall", took, "s", 90)
        slowest = max(slowest, p50(took))
    verdict("slowest p50 of find", slowest, GOAL, " s")
