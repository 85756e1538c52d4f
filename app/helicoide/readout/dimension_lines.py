"""The shortest lines from the arm to its planes and obstacles, as a drawing would dimension them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import Zone
from helicoide.readout.distances import plane_distances
from helicoide.state import State

ROUNDING = 1e-6  # m: a body that is stopped at the least clearance is there up to this


@dataclass(frozen=True, eq=False)
class DimensionLines:
    """Lines (k, 2, 3), m, from the arm to a plane or an obstacle, their signed lengths (k,), m, and their zones.

    First the planes in their order, then the obstacles in theirs. A length is negative where the arm is beyond the
    plane or inside the obstacle. A line to an obstacle is critical at the least clearance of bodies, else free.
    """

    ends: Array
    lengths: Array
    zones: tuple[Zone, ...]


@lru_cache(maxsize=4)
def dimension_lines(state: State) -> DimensionLines:
    """For each plane the monitored point nearest to it; for each obstacle the nearest body of the arm.

    Without planes while the arm is parked. Cached, as all windows share it.
    """
    to_planes, heights = _to_planes(state)
    to_obstacles, gaps = _to_obstacles(state)
    zones, least = state.problem.zones, state.problem.zones.body_clearance + ROUNDING
    return DimensionLines(
        frozen(np.concatenate([to_planes, to_obstacles])),
        frozen(np.concatenate([heights, gaps])),
        (
            *(zones.zone_of(height) for height in heights.tolist()),
            *(Zone.CRITICAL if gap <= least else Zone.FREE for gap in gaps.tolist()),
        ),
    )


def _to_planes(state: State) -> tuple[Array, Array]:
    planes = state.problem.planes
    if state.arm.parked or not len(planes.normals):
        return np.zeros((0, 2, 3)), np.zeros(0)
    table = plane_distances(state)
    nearest = table.argmin(axis=0)
    heights = table[nearest, np.arange(table.shape[1])]
    points = state.monitored_points[nearest]
    return np.stack([points, points - heights[:, None] * planes.normals], axis=1), heights


def _to_obstacles(state: State) -> tuple[Array, Array]:
    """Between the surfaces of the nearest pairs of capsules."""
    moving = [body for body in state.robot.bodies if max(body.links) > 0]
    obstacles = state.problem.obstacles
    count = len(obstacles.radii)
    if not moving or not count:
        return np.zeros((0, 2, 3)), np.zeros(0)
    axes = np.array([body.axis_at(state.arm.poses) for body in moving])
    radii = np.array([body.radius for body in moving])
    pairs = np.array([(i, j) for i in range(len(moving)) for j in range(count)])
    witnesses = closest_points(axes[pairs[:, 0]], obstacles.ends[pairs[:, 1]])
    way = witnesses[:, 1] - witnesses[:, 0]
    apart = np.linalg.norm(way, axis=1)
    gaps = (apart - radii[pairs[:, 0]] - obstacles.radii[pairs[:, 1]]).reshape(len(moving), count)
    chosen = gaps.argmin(axis=0) * count + np.arange(count)
    along = way[chosen] / np.maximum(apart[chosen], 1e-12)[:, None]
    starts = witnesses[chosen, 0] + radii[pairs[chosen, 0]][:, None] * along
    ends = witnesses[chosen, 1] - obstacles.radii[:, None] * along
    return np.stack([starts, ends], axis=1), gaps.min(axis=0)


def closest_points(a: Array, b: Array) -> Array:
    """The closest points of segments a and b, pair by pair: (k, 2, 3), m.

    Args: a, b (k, 2, 3), m; a segment may be a point. Source: Ericson 2005, Real-Time Collision Detection, §5.1.9.
    """
    u, v, w = a[:, 1] - a[:, 0], b[:, 1] - b[:, 0], a[:, 0] - b[:, 0]
    uu, vv, uv, uw, vw = (np.einsum("ka,ka->k", x, y) for x, y in ((u, u), (v, v), (u, v), (u, w), (v, w)))
    across = uu * vv - uv * uv
    crossing = across > 1e-12 * uu * vv
    s = np.clip(np.where(crossing, (uv * vw - uw * vv) / np.where(crossing, across, 1.0), 0.0), 0.0, 1.0)
    t = np.clip((uv * s + vw) / np.where(vv > 0.0, vv, 1.0), 0.0, 1.0)
    s = np.clip((uv * t - uw) / np.where(uu > 0.0, uu, 1.0), 0.0, 1.0)
    return np.stack([a[:, 0] + s[:, None] * u, b[:, 0] + t[:, None] * v], axis=1)
