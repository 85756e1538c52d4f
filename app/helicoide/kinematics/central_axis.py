"""The central axis of a twist or a wrench: the line along which it is a screw."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array

# Below this ratio of |s| ℓ to |m| the axis may be 10 000 ℓ away: a twist counts as a translation, a wrench as a torque.
FREE = 1e-4


@dataclass(frozen=True, eq=False)
class CentralAxis:
    """A line with a pitch: point (3,), m, the one nearest to where the moment was taken; direction (3,), a unit vector.

    size: |s|; along: the part of the moment along the axis; pitch: their ratio along/|s|, m, infinite without s.
    """

    point: Array
    direction: Array
    size: float
    along: float
    pitch: float


def central_axis(s: Array, m: Array, point: Array, length: float) -> CentralAxis | None:
    """The axis on which the moment is parallel to s: r = p + s × m/|s|², h = s·m/|s|²; None if both are zero.

    Args: s (3,): ω of a twist, rad/s, or the force of a wrench, N; m (3,): v at the point, m/s, or the moment about it,
    N·m; point p (3,), m; length ℓ, m: the size of the arm, to say when s counts as zero.
    Source: Poinsot 1803; Murray, Li and Sastry 1994, §2.5.
    """
    size, moment = float(np.linalg.norm(s)), float(np.linalg.norm(m))
    if size * length <= FREE * moment:
        return CentralAxis(point, m / moment, 0.0, moment, np.inf) if moment > 0.0 else None
    along = float(s @ m) / size
    return CentralAxis(point + np.cross(s, m) / size**2, s / size, size, along, along / size)
