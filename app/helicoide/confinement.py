"""Planes that confine the arm: distances, zones, and how far a plane may be moved.

A plane is n·r = d with a unit normal that points to the allowed side; the distance of a point is l = n·r − d.
The points watched are the joint centres and the tool; links are straight, so no other point of the chain comes closer
to a plane than these. Source: Cerbaro 2022, §6.1; normals and signs as in the digest of eq. 36 (corrected).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum

import numpy as np
from numpy.typing import ArrayLike

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Pane

LOOKED_AT = 1e-3
ON_AXIS = 8


class Zone(Enum):
    """How near a point is to a plane."""

    FREE = "free"
    WARNING = "warning"
    CRITICAL = "critical"


@dataclass(frozen=True)
class Zones:
    """Distances in m: no guarded point comes closer to a plane than `critical`; from `warning` on the arm is said to be
    near. `between`: what stays free between two bodies, measured from surface to surface.
    """

    critical: float = 0.080
    warning: float = 0.110
    between: float = 0.010

    def of(self, distance: float) -> Zone:
        """The zone of a distance in m; what is held at the critical distance counts as critical."""
        if distance <= self.critical + 1e-6:
            return Zone.CRITICAL
        return Zone.WARNING if distance < self.warning else Zone.FREE


@dataclass(frozen=True, eq=False)
class Planes:
    """k planes: unit inward normals (k, 3) and a point of each, the centre of its pane, (k, 3) m, world frame."""

    normals: Array
    centres: Array

    @property
    def offsets(self) -> Array:
        """d = n·r of each plane, (k,), m."""
        return np.asarray(np.einsum("ij,ij->i", self.normals, self.centres))

    def moved(self, index: int, normal: Array, centre: Array) -> Planes:
        """The same planes with one replaced; the normal is made a unit vector."""
        normals, centres = self.normals.copy(), self.centres.copy()
        normals[index], centres[index] = normal / np.linalg.norm(normal), centre
        return replace(self, normals=frozen(normals), centres=frozen(centres))


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
        shares = np.linspace(0.0, 1.0, ON_AXIS)[:, None]
        axes = [start[None] if (start == end).all() else start + shares * (end - start) for start, end in self.ends]
        return np.concatenate([np.zeros((0, 3)), *axes])

    def with_capsule(self, start: ArrayLike, end: ArrayLike, radius: float) -> Obstacles:
        """The same obstacles and one more, from start to end (3,), m."""
        return Obstacles(frozen([*self.ends, np.array([start, end])]), frozen([*self.radii, radius]))

    def with_sphere(self, centre: ArrayLike, radius: float) -> Obstacles:
        """The same obstacles and a sphere around centre (3,), m."""
        return self.with_capsule(centre, centre, radius)

    def replaced(self, index: int, centre: ArrayLike, radius: float) -> Obstacles:
        """The same obstacles, one of them a sphere around centre (3,), m, from now on."""
        ends, radii = self.ends.copy(), self.radii.copy()
        ends[index], radii[index] = centre, radius
        return Obstacles(frozen(ends), frozen(radii))

    def without(self, index: int) -> Obstacles:
        """The same obstacles but one."""
        return Obstacles(frozen(np.delete(self.ends, index, axis=0)), frozen(np.delete(self.radii, index)))


def planes_of(panes: tuple[Pane, ...]) -> Planes:
    """The planes that a robot's file gives; pane centres are dropped onto their planes exactly."""
    normals = np.array([pane.normal for pane in panes]).reshape(-1, 3)
    centres = np.array([pane.centre - (pane.normal @ pane.centre - pane.offset) * pane.normal for pane in panes])
    return Planes(frozen(normals), frozen(centres.reshape(-1, 3)))


def stopped_at_arm(normal: Array, centre: Array, points: Array, critical: float) -> Array:
    """Where the centre of a plane that is moved comes to rest: c − max(0, δ − minⱼ n·(pⱼ − c)) n.

    Args: normal (3,), unit; centre (3,), m, as asked; points (m, 3), m, of the arm; critical: δ, m. Returns (3,), m.
    """
    nearest = float(np.min((points - centre) @ normal))
    return centre - max(0.0, critical - nearest) * normal


def from_pieces(points: Array, ends: Array) -> Array:
    """Distances of points (m, 3) from straight pieces (k, 2, 3): (m, k), m."""
    start, along = ends[:, 0], ends[:, 1] - ends[:, 0]
    square = np.maximum(np.einsum("ka,ka->k", along, along), 1e-30)
    offsets = points[:, None] - start
    share = np.clip(np.einsum("mka,ka->mk", offsets, along) / square, 0.0, 1.0)
    return np.asarray(np.linalg.norm(offsets - share[..., None] * along, axis=2))


def last_clear(start: Array, asked: Array, ends: Array, apart: Array) -> Array:
    """Where a point that is moved straight from start to asked, (3,), m, comes to rest before bodies in its way.

    The way is looked at in steps of at most `LOOKED_AT`. Args: ends (k, 2, 3), m: the axes of the bodies; apart (k,),
    m: the distance to be kept from each, unless it is nearer than that at the start.
    """
    steps = 1 + int(np.ceil(np.linalg.norm(asked - start) / LOOKED_AT))
    way = start + np.linspace(0.0, 1.0, steps + 1)[:, None] * (asked - start)
    found = from_pieces(way, ends)
    blocked = (found < np.minimum(apart, found[0] - 1e-9)).any(axis=1)
    return np.asarray(way[int(blocked.argmax()) - 1] if blocked.any() else asked)


@kernel
def distances(normals: Array, offsets: Array, points: Array) -> Array:
    """Signed distances l = n·r − d of every point to every plane.

    Args: normals (k, 3); offsets (k,), m; points (m, 3), m. Returns (m, k), m. Source: Cerbaro 2022, eq. 20.
    """
    table = np.empty((points.shape[0], normals.shape[0]))
    for j in range(points.shape[0]):
        for k in range(normals.shape[0]):
            table[j, k] = (
                normals[k, 0] * points[j, 0] + normals[k, 1] * points[j, 1] + normals[k, 2] * points[j, 2] - offsets[k]
            )
    return table
