"""The trajectories of Vargas 2013, App. C: position and velocity at t, s; in lengths of the arm (1 to 5) or cm."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin

import numpy as np

from helicoide.kinematics.chain import Array

Vector = tuple[float, float, float]
Path = Callable[[float], tuple[Vector, Vector]]


def path_1(t: float) -> tuple[Vector, Vector]:
    """Sims. 1, 2, 15 and 16."""
    return (2 + 0.5 * sin(0.4 * t), 0.5 * cos(0.2 * t), 0), (0.2 * cos(0.4 * t), -0.1 * sin(0.2 * t), 0)


def path_2(t: float) -> tuple[Vector, Vector]:
    """Sim. 4."""
    return (2.5 + 0.5 * sin(0.2 * t), 0.5 * cos(0.2 * t), 0), (0.1 * cos(0.2 * t), -0.1 * sin(0.2 * t), 0)


def path_3(t: float) -> tuple[Vector, Vector]:
    """Sim. 5: a straight line, 0.072 from the origin at 25.5 s."""
    return (2.26 - t / 11, 3.23 - t / 8, 0), (-1 / 11, -1 / 8, 0)


def path_4(t: float) -> tuple[Vector, Vector]:
    """Sims. 6 and 7: from the border of the workspace through the origin, which it meets at 32 s."""
    return (0, 4 - t / 8, 0), (0, -1 / 8, 0)


def path_5(t: float) -> tuple[Vector, Vector]:
    """Fig. 4.42."""
    return (2 + 0.5 * sin(0.4 * t), 1, 0), (0.2 * cos(0.4 * t), 0, 0)


def _swept(across: float, along: float) -> Path:
    """Trajectories 6 and 8: (a + 5 sin 0.2πt, 7.5 sin 0.1πt) in two axes."""
    return lambda t: (
        (5 * sin(0.2 * pi * t) + across, 7.5 * sin(0.1 * pi * t), along),
        (pi * cos(0.2 * pi * t), 0.75 * pi * cos(0.1 * pi * t), 0),
    )


path_6, path_8 = _swept(45.86, 0), _swept(63.36, 0)


def path_7(t: float) -> tuple[Vector, Vector]:
    """Sims. 11 and 11b: through the axis of the waist, where the shoulder is singular, every 5 s."""
    return (0, 5 * sin(0.2 * pi * t), 7.5 * sin(0.1 * pi * t) + 53.86), (
        0,
        pi * cos(0.2 * pi * t),
        0.75 * pi * cos(0.1 * pi * t),
    )


def _ellipse(centre: float) -> Path:
    """Trajectories 10 and 11."""
    return lambda t: (
        (14.6 * sin(0.2 * t) + centre, 7 * cos(0.2 * t), 20),
        (2.92 * cos(0.2 * t), -1.4 * sin(0.2 * t), 0),
    )


path_10, path_11 = _ellipse(15.5), _ellipse(30.5)


def faster(path: Path, times: float) -> Path:
    """The same way at a multiple of the speed."""

    def at(t: float) -> tuple[Vector, Vector]:
        x, (a, b, c) = path(times * t)
        return x, (times * a, times * b, times * c)

    return at


def places(path: Path, t: Array) -> Array:
    """The points of a trajectory at the instants t (k,), (k, 3)."""
    return np.array([path(now)[0] for now in t])
