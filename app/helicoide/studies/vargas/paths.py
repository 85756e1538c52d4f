"""The trajectories of Vargas 2013, App. C, as the studies follow them: place and velocity at t, s, in its own units.

1: Sims. 1, 2, 15 and 16. 2: Sim. 4. 3: Sim. 5, a line 0.072 from the origin at 25.5 s. 4: Sims. 6 and 7, from the
border of the workspace through the origin, which it meets at 32 s. 5: Fig. 4.42. 7: Sims. 11 and 11b, through the axis
of the waist, where the shoulder is singular, every 5 s.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from helicoide.arrays import Array
from helicoide.trajectory.vargas import VARGAS

Vector = tuple[float, float, float]
PathFunction = Callable[[float], tuple[Vector, Vector]]


def _path(number: int) -> PathFunction:
    """A trajectory by its number, in the unit of the source."""
    x, y, z = VARGAS[number].x, VARGAS[number].y, VARGAS[number].z
    return lambda t: ((x.at(t), y.at(t), z.at(t)), (x.rate(t), y.rate(t), z.rate(t)))


path_1, path_2, path_3, path_4, path_5 = (_path(number) for number in range(1, 6))
path_6, path_7, path_8, path_10, path_11 = (_path(number) for number in (6, 7, 8, 10, 11))


def sped_up(path: PathFunction, times: float) -> PathFunction:
    """The same path, traversed `times` as fast."""

    def at(t: float) -> tuple[Vector, Vector]:
        x, (a, b, c) = path(times * t)
        return x, (times * a, times * b, times * c)

    return at


def path_points(path: PathFunction, t: Array) -> Array:
    """The points (k, 3) of a trajectory at times t (k,), s."""
    return np.array([path(now)[0] for now in t])
