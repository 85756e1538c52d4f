"""Planes that confine the arm, distances from them, and how far a plane may be moved.

A plane is n·r = d with a unit normal towards the allowed side; the distance of a point is l = n·r − d. Distances are
taken from the joint centres and the tool; as links are straight, no other point of the chain is closer to a plane.
Source: Cerbaro 2022, §6.1; eqs. 18 and 20, with every normal turned inward.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kernels import kernel
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.text import Text, untranslated

# A plane is a ceiling if the z component of its inward normal is at most this.
DOWN = -np.sqrt(0.5)


@dataclass(frozen=True, eq=False)
class Plane:
    """One plane n·r = d: unit inward normal (3,) and offset, m, world frame."""

    normal: Array
    offset: float

    def foot(self, point: Array) -> Array:
        """The point of the plane nearest to a point (3,), m: r − (n·r − d) n."""
        return np.asarray(point - (self.normal @ point - self.offset) * self.normal)


DEFAULT_PANE_SIZE = (0.6, 0.6)


def pane_on_plane(
    plane: Plane, name: str, title: Text, centre: Array, size: tuple[float, float] = DEFAULT_PANE_SIZE
) -> PlanePane:
    """A movable pane on a plane, centred at the foot of a point (3,), m; size, m."""
    return PlanePane(name, title, plane.normal, plane.offset, frozen(plane.foot(centre)), size, movable=True)


@dataclass(frozen=True, eq=False)
class Planes:
    """k planes: unit inward normals (k, 3) and a point of each, the centre of its pane, (k, 3), m, world frame.

    panes: name and display of each plane; by default they are numbered. The normals and centres in the panes are the
    initial ones.
    """

    normals: Array
    centres: Array
    panes: tuple[PlanePane, ...] = ()

    def __post_init__(self) -> None:
        if len(self.panes) != len(self.normals):
            known = zip(self.normals, self.centres, strict=True)
            panes = (
                pane_on_plane(Plane(normal, float(normal @ centre)), str(k), untranslated(str(k)), centre)
                for k, (normal, centre) in enumerate(known, 1)
            )
            object.__setattr__(self, "panes", tuple(panes))

    @property
    def offsets(self) -> Array:
        """d = n·r of each plane, (k,), m."""
        return np.asarray(np.einsum("ij,ij->i", self.normals, self.centres))

    def with_plane(self, index: int, normal: Array, centre: Array) -> Planes:
        """The planes with one replaced; the normal is scaled to length one."""
        normals, centres = self.normals.copy(), self.centres.copy()
        normals[index], centres[index] = normal / np.linalg.norm(normal), centre
        return replace(self, normals=frozen(normals), centres=frozen(centres))

    def with_pane(self, pane: PlanePane) -> Planes:
        """The planes with one more; a plane of the same name is replaced."""
        rest = self.without(self.names.index(pane.name)) if pane.name in self.names else self
        return Planes(frozen([*rest.normals, pane.normal]), frozen([*rest.centres, pane.centre]), (*rest.panes, pane))

    def without(self, index: int) -> Planes:
        """The planes without one."""
        normals, centres = np.delete(self.normals, index, axis=0), np.delete(self.centres, index, axis=0)
        return Planes(frozen(normals), frozen(centres), (*self.panes[:index], *self.panes[index + 1 :]))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the planes."""
        return tuple(pane.name for pane in self.panes)


def planes_of(panes: tuple[PlanePane, ...]) -> Planes:
    """The planes of a robot's file; pane centres are projected onto their planes."""
    normals = np.array([pane.normal for pane in panes]).reshape(-1, 3)
    centres = np.array([pane.centre - (pane.normal @ pane.centre - pane.offset) * pane.normal for pane in panes])
    return Planes(frozen(normals), frozen(centres.reshape(-1, 3)), panes)


def planes_around(planes: Sequence[Plane], inside: Array) -> Planes:
    """Planes whose panes are centred at the feet of perpendiculars from a point inside, (3,), m."""
    normals = np.array([plane.normal for plane in planes]).reshape(-1, 3)
    centres = np.array([plane.foot(inside) for plane in planes]).reshape(-1, 3)
    return Planes(frozen(normals), frozen(centres))


def pane_axes(normal: Array) -> Array:
    """The axes of a pane, R_world_pane (3, 3): z along its normal (3,), x horizontal, or ⊥ y if z is near vertical."""
    z = normal / np.linalg.norm(normal)
    x = np.cross([0.0, 0.0, 1.0] if abs(z[2]) < 0.9 else [0.0, 1.0, 0.0], z)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def limited_plane_centre(normal: Array, centre: Array, points: Array, critical: float) -> Array:
    """The centre of a moved plane, limited so that the arm keeps its distance: c − max(0, δ − minⱼ n·(pⱼ − c)) n.

    Args: normal (3,), unit; centre (3,), m, requested; points (m, 3), m, of the arm; critical: δ, m. Returns (3,), m.
    """
    nearest = float(np.min((points - centre) @ normal))
    return centre - max(0.0, critical - nearest) * normal


@kernel
def signed_distances(normals: Array, offsets: Array, points: Array) -> Array:
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
