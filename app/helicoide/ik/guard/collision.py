"""What is left until something is too near: guarded points to planes, capsules to capsules.

Capsules are the bodies of the arm, one against another and against what stands in the way.

The gap between two capsules is the distance of their axes less both radii; it is least between one pair of points, the
witnesses, and changes with q as the distance of these: ḋ = nᵀ (J_a − J_b) q̇.
"""

from __future__ import annotations

import numpy as np

from helicoide.ik.guard.rows import Arm, Guard, Indices, Pairs, PlaneArrays, Vector, add_point, at, unfelt
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain
from helicoide.kinematics.forward import carried_points


@kernel
def inner(a: Vector, b: Vector) -> float:
    """a·b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def along(a: Vector, b: Vector, s: float) -> Vector:
    """a + s b."""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@kernel
def closest_shares(a: Vector, b: Vector, c: Vector, d: Vector) -> tuple[float, float]:
    """Where two straight pieces are nearest: a + s (b − a) and c + t (d − c), 0 ≤ s, t ≤ 1.

    Args: ends, m; a piece may be a point. Source: Ericson 2005, Real-Time Collision Detection, §5.1.9.
    """
    u, v, w = along(b, a, -1.0), along(d, c, -1.0), along(a, c, -1.0)
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


@kernel
def apart(points: Array, corners: Indices, pair: int, s: float, t: float) -> tuple[float, Vector]:
    """How far the points at s and t of the axes of a pair are apart, m, and the way to the first, not yet a unit.

    Args: points (m, 3), m, world; corners (p, 4).
    """
    a, b = at(points, corners[pair, 0]), at(points, corners[pair, 1])
    c, d = at(points, corners[pair, 2]), at(points, corners[pair, 3])
    way = along(along(a, along(b, a, -1.0), s), along(c, along(d, c, -1.0), t), -1.0)
    return float(np.sqrt(inner(way, way))), way


@kernel
def gap(points: Array, corners: Indices, pair: int) -> tuple[float, float, float]:
    """The distance of the axes of a pair, m, and where its witnesses are.

    Args: points (m, 3), m, world; corners (p, 4).
    """
    a, b = at(points, corners[pair, 0]), at(points, corners[pair, 1])
    c, d = at(points, corners[pair, 2]), at(points, corners[pair, 3])
    s, t = closest_shares(a, b, c, d)
    return apart(points, corners, pair, s, t)[0], s, t


@kernel
def clearances(poses: Array, arm: Arm, planes: PlaneArrays, pairs: Pairs) -> tuple[Array, Array, Array]:
    """All that is left: guarded points to planes, point after point, then the pairs of bodies.

    Args: poses (j + 1, 4, 4) of `link_poses`. Returns (g k + p,), m; the shares of the witnesses (p, 2); and the points
    where they are (m, 3), m.
    """
    (normals, offsets, critical), (guarded, corners, least) = planes, pairs
    points, first = carried_points(poses, arm[1], arm[2]), guarded * normals.shape[0]
    left, shares = np.empty(first + corners.shape[0]), np.empty((corners.shape[0], 2))
    for r in range(first):
        p = r % normals.shape[0]
        left[r] = inner(at(normals, p), at(points, r // normals.shape[0])) - offsets[p] - critical
    for i in range(corners.shape[0]):
        length, shares[i, 0], shares[i, 1] = gap(points, corners, i)
        left[first + i] = length - least[i]
    return left, shares, points


@kernel
def watch(guard: Guard, poses: Array, dt: float) -> tuple[Indices, Array, Array]:
    """Which clearances can hold this tick: all but those with more room than the arm could take in it.

    Returns their numbers (w,); what is left, m, and the shares of the witnesses, (w, 3); and the points (m, 3), m.
    """
    chain, local, links = guard[0]
    normals, offsets, critical = guard[2]
    guarded, corners, least = guard[3]
    k, count = normals.shape[0], 0
    total = guarded * k + corners.shape[0]
    watched, near = np.empty(total, dtype=np.int64), np.empty((total, 3))
    if total == 0:
        return watched, near, near
    points = carried_points(poses, local, links)
    far = unfelt(chain, links, guard[1][2], guard[1][3], guard[5], poses, points, dt)
    for r in range(guarded):
        for p in range(k):
            left = inner(at(normals, p), at(points, r)) - offsets[p] - critical
            if not left > far[r]:
                watched[count], near[count, 0], near[count, 1], near[count, 2] = r * k + p, left, 0.0, 0.0
                count += 1
    for i in range(corners.shape[0]):
        length, s, t = gap(points, corners, i)
        a, b, c, d = corners[i, 0], corners[i, 1], corners[i, 2], corners[i, 3]
        if not length - least[i] > max(far[a], far[b]) + max(far[c], far[d]):
            watched[count], near[count, 0], near[count, 1], near[count, 2] = guarded * k + i, length - least[i], s, t
            count += 1
    return watched[:count], near[:count], points


@kernel
def measured(guard: Guard, poses: Array, watched: Indices) -> Array:
    """What is left of the watched clearances, m, and the shares of the witnesses, (w, 3)."""
    near = np.zeros((watched.shape[0], 3))
    if watched.shape[0] > 0:
        normals, offsets, critical = guard[2]
        guarded, corners, least = guard[3]
        points, k = carried_points(poses, guard[0][1], guard[0][2]), normals.shape[0]
        for j in range(watched.shape[0]):
            pair = watched[j] - guarded * k
            if pair < 0:
                p = watched[j] % k
                near[j, 0] = inner(at(normals, p), at(points, watched[j] // k)) - offsets[p] - critical
            else:
                length, near[j, 1], near[j, 2] = gap(points, corners, pair)
                near[j, 0] = length - least[pair]
    return near


@kernel
def between_bodies(guard: Guard, watched: Indices) -> int:
    """How many of the watched clearances, the last ones, are between two bodies."""
    first, count = guard[3][0] * guard[2][0].shape[0], 0
    for j in range(watched.shape[0]):
        count += watched[j] >= first
    return count


@kernel
def witness_row(
    rows: Array, which: int, points: Array, links: Indices, pairs: Pairs, pair: int, s: float, t: float, poses: Array,
    chain: Chain, axes: Array,
) -> float:  # fmt: skip
    """Fill one of rows (m, n), by which the distance of two witnesses of a pair changes with q; gives what is left, m.

    Args: points (m, 3), m, world, on links (m,); s, t: where the witnesses are; poses (j + 1, 4, 4); axes (j, 3) of
    `joint_axes`. The row is zero where the two coincide.
    """
    _, corners, least = pairs
    length, way = apart(points, corners, pair, s, t)
    for i in range(rows.shape[1]):
        rows[which, i] = 0.0
    for end in range(2 if length > 1e-9 else 0):
        a, b, share = corners[pair, 2 * end], corners[pair, 2 * end + 1], t if end else s
        normal = along((0.0, 0.0, 0.0), way, (-1.0 if end else 1.0) / length)
        start, whole = at(points, a), along(at(points, b), at(points, a), -1.0)
        if links[a] == links[b]:
            add_point(rows, which, normal, along(start, whole, share), links[a], poses, chain, axes)
        else:
            add_point(rows, which, along(normal, normal, -share), start, links[a], poses, chain, axes)
            add_point(rows, which, along(normal, normal, share - 1.0), at(points, b), links[b], poses, chain, axes)
    return float(length - least[pair])
