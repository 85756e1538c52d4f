"""Obstacles of the arm, and how far a point can be moved before it meets them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen

LOOKED_AT = 1e-3
ON_AXIS = 8


@dataclass(frozen=True, eq=False)
class Obstacles:
    """k obstacles, all capsules: the points within a radius (k,), m, of the segment between two points.

    ends (k, 2, 3), m, world frame; the two ends of a sphere coincide.
    """

    ends: Array = field(default_factory=lambda: frozen(np.zeros((0, 2, 3))))
    radii: Array = field(default_factory=lambda: frozen(np.zeros(0)))

    @property
    def points(self) -> Array:
        """Points on their axes, (m, 3), m: the centre of a sphere, `ON_AXIS` points of any other capsule."""
        shares = np.linspace(0.0, 1.0, ON_AXIS)[:, None]
        axes = [start[None] if (start == end).all() else start + shares * (end - start) for start, end in self.ends]
        return np.concatenate([np.zeros((0, 3)), *axes])

    def with_capsule(self, start: ArrayLike, end: ArrayLike, radius: float) -> Obstacles:
        """The obstacles with one more capsule, from start to end (3,), m."""
        return Obstacles(frozen([*self.ends, np.array([start, end])]), frozen([*self.radii, radius]))

    def with_sphere(self, centre: ArrayLike, radius: float) -> Obstacles:
        """The obstacles with one more sphere around centre (3,), m."""
        return self.with_capsule(centre, centre, radius)

    def replaced(self, index: int, centre: ArrayLike, radius: float) -> Obstacles:
        """The obstacles with one replaced by a sphere around centre (3,), m."""
        ends, radii = self.ends.copy(), self.radii.copy()
        ends[index], radii[index] = centre, radius
        return Obstacles(frozen(ends), frozen(radii))

    def without(self, index: int) -> Obstacles:
        """The obstacles without one."""
        return Obstacles(frozen(np.delete(self.ends, index, axis=0)), frozen(np.delete(self.radii, index)))


def from_pieces(points: Array, ends: Array) -> Array:
    """Distances of points (m, 3) from segments (k, 2, 3): (m, k), m."""
    start, along = ends[:, 0], ends[:, 1] - ends[:, 0]
    square = np.maximum(np.einsum("ka,ka->k", along, along), 1e-30)
    offsets = points[:, None] - start
    share = np.clip(np.einsum("mka,ka->mk", offsets, along) / square, 0.0, 1.0)
    return np.asarray(np.linalg.norm(offsets - share[..., None] * along, axis=2))


def last_clear(start: Array, asked: Array, ends: Array, apart: Array) -> Array:
    """The last point on the straight line from start to asked, (3,), m, before an obstacle is too close.

    The line is sampled in steps of at most `LOOKED_AT`. Args: ends (k, 2, 3), m: axes of the obstacles; apart (k,), m:
    the clearance from each axis, reduced if the start is closer.
    """
    steps = 1 + int(np.ceil(np.linalg.norm(asked - start) / LOOKED_AT))
    way = start + np.linspace(0.0, 1.0, steps + 1)[:, None] * (asked - start)
    found = from_pieces(way, ends)
    blocked = (found < np.minimum(apart, found[0] - 1e-9)).any(axis=1)
    return np.asarray(way[int(blocked.argmax()) - 1] if blocked.any() else asked)
