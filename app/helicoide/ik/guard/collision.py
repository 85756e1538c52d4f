"""Clearances: the distances left between monitored points and planes, and between pairs of capsules.

Capsules are the bodies of the arm and the obstacles. The distance of two capsules is that of their axes less both
radii. The closest points of the two axes are the witnesses; with q the distance changes as between these,
ḋ = nᵀ (J_a − J_b) q̇. A clearance is a distance less the smallest one allowed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.packed import (
    CRITICAL,
    GUARDED,
    LEAST,
    LINK,
    OFFSET,
    SETTING,
    At,
    PlacedArm,
    array_parts,
    place_links,
)
from helicoide.ik.guard.rows import FAR, Vector, add_point, at_row, unmoved_rows
from helicoide.kernels import kernel, kernel_into

# Columns of a watched clearance: its number and its value, m; then of a point and a plane their rows in `points` and in
# the arm, of a pair the parameters s and t of its witnesses.
NUMBER, LEFT, POINT, PLANE, WATCHED = range(5)
S, T = POINT, PLANE


class Watched(NamedTuple):
    """The clearances that are watched in a tick, as those that may limit it.

    points (p, 4): the points of the arm, m, world, and `rows.FAR`; near (w, 4): the clearances before the step, and
    after (w, 4): after a tried one, with the columns named above.
    """

    points: Array
    near: Array
    after: Array


class Witnesses(NamedTuple):
    """Two points on the axes of a pair of bodies: the row of the pair in the arm, and s and t of `closest_shares`."""

    pair: int
    s: float
    t: float


@kernel_into
def inner(a: Vector, b: Vector) -> float:
    """a·b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel_into
def point_between(a: Vector, b: Vector, s: float) -> Vector:
    """a + s b."""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@kernel_into
def closest_shares(a: Vector, b: Vector, c: Vector, d: Vector) -> tuple[float, float]:
    """s and t of the closest points of two segments, a + s (b − a) and c + t (d − c), 0 ≤ s, t ≤ 1.

    Args: ends, m; a segment may be a point. Source: Ericson 2005, Real-Time Collision Detection, §5.1.9.
    """
    u, v, w = point_between(b, a, -1.0), point_between(d, c, -1.0), point_between(a, c, -1.0)
    uu, vv, uv, uw, vw = inner(u, u), inner(v, v), inner(u, v), inner(u, w), inner(v, w)
    if uu <= 0.0 and vv <= 0.0:
        return 0.0, 0.0
    if uu <= 0.0:
        return 0.0, min(max(vw / vv, 0.0), 1.0)
    if vv <= 0.0:
        return min(max(-uw / uu, 0.0), 1.0), 0.0
    across = uu * vv - uv * uv
    s = min(max((uv * vw - uw * vv) / across, 0.0), 1.0) if across > 1e-12 * uu * vv else 0.0
    t = (uv * s + vw) / vv
    if t < 0.0:
        return min(max(-uw / uu, 0.0), 1.0), 0.0
    if t > 1.0:
        return min(max((uv - uw) / uu, 0.0), 1.0), 1.0
    return s, t


@kernel_into
def place_bodies(placed: PlacedArm, points: Array) -> None:
    """Write the points of an arm, m, world, into points (p, 4)."""
    arm, at, _, poses, _ = placed
    for j in range(points.shape[0]):
        x, y, z = at_row(arm, at.points + j)
        pose = poses[int(arm[at.points + j, LINK])]
        for a in range(3):
            points[j, a] = pose[a, 0] * x + pose[a, 1] * y + pose[a, 2] * z + pose[a, 3]


@kernel_into
def body_ends(arm: Array, pair: int, points: Array) -> tuple[Vector, Vector, Vector, Vector]:
    """The axis ends of the two bodies of a pair, a row of the arm, m, world."""
    return (
        at_row(points, int(arm[pair, 0])),
        at_row(points, int(arm[pair, 1])),
        at_row(points, int(arm[pair, 2])),
        at_row(points, int(arm[pair, 3])),
    )


@kernel_into
def witness_distance(arm: Array, points: Array, witnesses: Witnesses) -> tuple[float, Vector]:
    """The distance of two witnesses, m, and the vector from the second to the first; points (p, 4), m, world."""
    a, b, c, d = body_ends(arm, witnesses.pair, points)
    first = point_between(a, point_between(b, a, -1.0), witnesses.s)
    second = point_between(c, point_between(d, c, -1.0), witnesses.t)
    way = point_between(first, second, -1.0)
    return float(np.sqrt(inner(way, way))), way


@kernel_into
def gap(arm: Array, pair: int, points: Array) -> tuple[float, Witnesses]:
    """The clearance of a pair, a row of the arm, m, and its witnesses, the closest points; points (p, 4), m, world."""
    a, b, c, d = body_ends(arm, pair, points)
    s, t = closest_shares(a, b, c, d)
    witnesses = Witnesses(pair, s, t)
    return witness_distance(arm, points, witnesses)[0] - arm[pair, LEAST], witnesses


@kernel_into
def height(arm: Array, plane: int, points: Array, point: int) -> float:
    """The clearance of a point from a plane, a row of the arm, m; points (p, 4)."""
    over = arm[plane, 0] * points[point, 0] + arm[plane, 1] * points[point, 1] + arm[plane, 2] * points[point, 2]
    return float(over - arm[plane, OFFSET] - arm[SETTING, CRITICAL])


@kernel
def clearances(arm: Array, q: Array) -> Array:
    """All clearances of a posture: monitored points to planes, point after point, then the pairs of bodies.

    Args: arm of `packing.packed`; q (n,), rad or m. Returns (g k + b,), m.
    """
    at = array_parts(arm)
    poses, axes, points = np.empty((at.m + 1, 4, 4)), np.empty((at.m, 3)), np.empty((at.planes - at.points, 4))
    placed = PlacedArm(arm, at, q, poses, axes)
    place_links(placed)
    place_bodies(placed, points)
    every, number = np.empty(at.clearances), 0
    for point in range(int(arm[SETTING, GUARDED])):
        for plane in range(at.planes, at.pairs):
            every[number] = height(arm, plane, points, point)
            number += 1
    for pair in range(at.pairs, at.end):
        every[number] = gap(arm, pair, points)[0]
        number += 1
    return every


@kernel_into
def watch(placed: PlacedArm, watched: Watched, dt: float, ways: Array) -> int:
    """Find the clearances that can limit this tick: those that are not beyond `rows.FAR`.

    Writes the points and, into as many rows of `near` as there may be clearances, those found; returns their number.
    Args: ways (m + 1, 4): temporary values of `unmoved_rows`.
    """
    (arm, at, _, _, _), (points, near, _) = placed, watched
    number, count = 0, 0
    place_bodies(placed, points)
    unmoved_rows(placed, points, dt, ways)
    for point in range(int(arm[SETTING, GUARDED])):
        for plane in range(at.planes, at.pairs):
            room = height(arm, plane, points, point)
            if not room > points[point, FAR]:
                near[count, NUMBER], near[count, LEFT] = number, room
                near[count, POINT], near[count, PLANE] = point, plane
                count += 1
            number += 1
    for pair in range(at.pairs, at.end):
        room, nearest = gap(arm, pair, points)
        a, b, c, d = int(arm[pair, 0]), int(arm[pair, 1]), int(arm[pair, 2]), int(arm[pair, 3])
        if not room > max(points[a, FAR], points[b, FAR]) + max(points[c, FAR], points[d, FAR]):
            near[count, NUMBER], near[count, LEFT] = number, room
            near[count, S], near[count, T] = nearest.s, nearest.t
            count += 1
        number += 1
    return count


@kernel_into
def measure_clearances(tried: PlacedArm, watched: Watched) -> None:
    """Write the points and the watched clearances after a tried step."""
    (arm, at, _, _, _), (points, near, after) = tried, watched
    place_bodies(tried, points)
    for j in range(near.shape[0]):
        number = int(near[j, NUMBER])
        if number < at.by_planes:
            after[j, LEFT] = height(arm, int(near[j, PLANE]), points, int(near[j, POINT]))
        else:
            after[j, LEFT], nearest = gap(arm, at.pairs + number - at.by_planes, points)
            after[j, S], after[j, T] = nearest.s, nearest.t


@kernel_into
def between_bodies(at: At, near: Array) -> int:
    """The number of watched clearances near (w, 4) between two bodies; they come last."""
    count = 0
    for j in range(near.shape[0]):
        count += near[j, NUMBER] >= at.by_planes
    return count


@kernel_into
def witness_row(row: Array, placed: PlacedArm, points: Array, witnesses: Witnesses) -> float:
    """Write a row (n,): the gradient in q of the distance of two witnesses of a pair. Returns the clearance, m.

    A joint before both bodies moves them together. One that moves both ends of a body moves its witness as a point of
    the link. One that moves only the end b moves the witness a + t (b − a) by t times the motion of b.
    Args: points (p, 4), m, world. The row is zero where the witnesses coincide.
    """
    (arm, at, _, _, _), (pair, s, t) = placed, witnesses
    length, way = witness_distance(arm, points, witnesses)
    for i in range(at.n):
        row[i] = 0.0
    first = at.m
    for end in range(4):
        first = min(first, int(arm[at.points + int(arm[pair, end]), LINK]))
    for body in range(2 if length > 1e-9 else 0):
        a, b, share = int(arm[pair, 2 * body]), int(arm[pair, 2 * body + 1]), t if body else s
        link_a, link_b = int(arm[at.points + a, LINK]), int(arm[at.points + b, LINK])
        both, beyond = min(link_a, link_b), max(link_a, link_b)
        normal = point_between((0.0, 0.0, 0.0), way, (-1.0 if body else 1.0) / length)
        witness = point_between(at_row(points, a), point_between(at_row(points, b), at_row(points, a), -1.0), share)
        add_point(row, normal, witness, first, both, placed)
        if both < beyond:
            lever, tip = (share, b) if link_b > link_a else (1.0 - share, a)
            part = point_between((0.0, 0.0, 0.0), normal, lever)
            add_point(row, part, at_row(points, tip), both, beyond, placed)
    return float(length - arm[pair, LEAST])
