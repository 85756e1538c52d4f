"""Bodies in the arm's way, and how far something may be moved before it meets them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen

PATH_STEP = 1e-3
AXIS_POINTS = 8


@dataclass(frozen=True, eq=False)
class Obstacles:
    """k bodies in the way, capsules: all points within a radius (k,), m, of the straight piece between two points.

    ends (k, 2, 3), m, world frame; a sphere has both ends in its centre.
    """

    ends: Array = field(default_factory=lambda: frozen(np.zeros((0, 2, 3))))
    radii: Array = field(default_factory=lambda: frozen(np.zeros(0)))

    @property
    def points(self) -> Array:
        """Points on their axes, (m, 3), m: the centre of a sphere, `ON_AXIS` of another capsule."""
        shares = np.linspace(0.0, 1.0, AXIS_POINTS)[:, None]
        axes = [start[None] if (start == end).all() else start + shares * (end - start) for start, end in self.ends]
        return np.concatenate([np.zeros((0, 3)), *axes])

    def with_capsule(self, start: ArrayLike, end: ArrayLike, radius: float) -> Obstacles:
        """The same obstacles and one more, from start to end (3,), m."""
        return Obstacles(frozen([*self.ends, np.array([start, end])]), frozen([*self.radii, radius]))

    def with_sphere(self, centre: ArrayLike, radius: float) -> Obstacles:
        """The same obstacles and a sphere around centre (3,), m."""
        return self.with_capsule(centre, centre, radius)

    def with_sphere_at(self, index: int, centre: ArrayLike, radius: float) -> Obstacles:
        """The same obstacles, one of them a sphere around centre (3,), m, from now on."""
        ends, radii = self.ends.copy(), self.radii.copy()
        ends[index], radii[index] = centre, radius
        return Obstacles(frozen(ends), frozen(radii))

    def without(self, index: int) -> Obstacles:
        """The same obstacles but one."""
        return Obstacles(frozen(np.delete(self.ends, index, axis=0)), frozen(np.delete(self.radii, index)))


def segment_distances(points: Array, ends: Array) -> Array:
    """Distances of points (m, 3) from straight pieces (k, 2, 3): (m, k), m."""
    start, along = ends[:, 0], ends[:, 1] - ends[:, 0]
    square = np.maximum(np.einsum("ka,ka->k", along, along), 1e-30)
    offsets = points[:, None] - start
    share = np.clip(np.einsum("mka,ka->mk", offsets, along) / square, 0.0, 1.0)
    return np.asarray(np.linalg.norm(offsets - share[..., None] * along, axis=2))


def last_free_point(start: Array, requested: Array, ends: Array, clearances: Array) -> Array:
    """Where a point that is moved straight from start to asked, (3,), m, comes to rest before bodies in its way.

    The way is looked at in steps of at most `PATH_STEP`. Args: ends (k, 2, 3), m: the axes of the bodies; clearances
    (k,), m: the distance to be kept from each, unless it is nearer than that at the start.
    """
    steps = 1 + int(np.ceil(np.linalg.norm(requested - start) / PATH_STEP))
    way = start + np.linspace(0.0, 1.0, steps + 1)[:, None] * (requested - start)
    found = segment_distances(way, ends)
    blocked = (found < np.minimum(clearances, found[0] - 1e-9)).any(axis=1)
    return np.asarray(way[int(blocked.argmax()) - 1] if blocked.any() else requested)
