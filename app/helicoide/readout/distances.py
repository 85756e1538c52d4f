"""Distances of the monitored points to the planes."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement import Zone
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.ik import Contact
from helicoide.state import State


def plane_distances(state: State) -> Array:
    """Distance of every monitored point to every plane, (m, k), m."""
    return distances_of(state, state.monitored_points)


def distances_of(state: State, points: Array) -> Array:
    """Distance of every point (m, 3), m, to every plane of the state, (m, k), m."""
    planes = state.problem.planes
    return np.asarray(points @ planes.normals.T - planes.offsets)


def nearest_point_and_plane(state: State) -> Contact:
    """The monitored point and the plane with the smallest distance to each other."""
    table = plane_distances(state)
    point, plane = np.unravel_index(np.argmin(table), table.shape)
    return Contact(int(plane), int(point))


def zones(state: State) -> tuple[Zone, ...]:
    """The zone of each plane, given by the monitored point nearest to it."""
    return tuple(state.problem.zones.zone_of(float(least)) for least in plane_distances(state).min(axis=0))


def distance_product(state: State, point: int, plane: int) -> Array:
    """πp − pπ = 2 l e1e2e3e of a monitored point and a plane, (16,), m. Source: Cerbaro 2022, eq. 19."""
    pi = rigid.plane(state.problem.planes.normals[plane], state.problem.planes.offsets[plane])
    p = rigid.point(state.monitored_points[point])
    return np.subtract(CL031.product(pi, p), CL031.product(p, pi))
