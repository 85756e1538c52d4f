"""Distances between capsules: the bodies of the arm, one against another and against what stands in the way.

The gap between two capsules is the distance of their axes less both radii; it is least between one pair of points, the
witnesses, and changes with q as the distance of these: ḋ = nᵀ (J_a − J_b) q̇.
"""

from __future__ import annotations

import numpy as np

from helicoide.ik.rows import Indices, Pairs, add_point
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain


@kernel
def closest_shares(a: Array, b: Array, c: Array, d: Array) -> tuple[float, float]:
    """Where two straight pieces are nearest: a + s (b − a) and c + t (d − c), 0 ≤ s, t ≤ 1.

    Args: ends (3,), m; a piece may be a point. Source: Ericson 2005, Real-Time Collision Detection, §5.1.9.
    """
    uu = vv = uv = uw = vw = 0.0
    for k in range(3):
        u, v, w = b[k] - a[k], d[k] - c[k], a[k] - c[k]
        uu, vv, uv, uw, vw = uu + u * u, vv + v * v, uv + u * v, uw + u * w, vw + v * w
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
def apart(points: Array, pairs: Pairs, pair: int, s: float, t: float, normal: Array) -> float:
    """How far the points at s and t of a pair are from being too near, m; fills the normal (3,), second body to first.

    Args: points (m, 3), m, world. The normal is zero where the two coincide.
    """
    _, corners, least = pairs
    a, b, c, d = corners[pair]
    for k in range(3):
        normal[k] = (1.0 - s) * points[a, k] + s * points[b, k] - (1.0 - t) * points[c, k] - t * points[d, k]
    length = np.sqrt(normal[0] ** 2 + normal[1] ** 2 + normal[2] ** 2)
    for k in range(3):
        normal[k] = normal[k] / length if length > 1e-9 else 0.0
    return float(length - least[pair])


@kernel
def gaps(points: Array, pairs: Pairs, left: Array, shares: Array) -> None:
    """Fill what is left of the distance of every pair, the end of left, m, and its witnesses, (p, 2).

    Args: points (m, 3), m, world.
    """
    corners = pairs[1]
    p = corners.shape[0]
    normal = np.empty(3)
    for i in range(p):
        a, b, c, d = corners[i]
        s, t = closest_shares(points[a], points[b], points[c], points[d])
        shares[i, 0], shares[i, 1] = s, t
        left[left.shape[0] - p + i] = apart(points, pairs, i, s, t, normal)


@kernel
def witness_row(
    row: Array, points: Array, links: Indices, pairs: Pairs, pair: int, shares: Array, poses: Array, chain: Chain,
    axes: Array,
) -> float:  # fmt: skip
    """Fill the row (n,) by which the distance of two witnesses of a pair changes with q; gives what is left of it, m.

    Args: points (m, 3), m, world, on links (m,); shares (2,); poses (j + 1, 4, 4); axes (j, 3) of `joint_axes`.
    """
    normal, corners = np.empty(3), pairs[1][pair]
    left = apart(points, pairs, pair, shares[0], shares[1], normal)
    row[:] = 0.0
    for k in range(4):
        share = shares[k // 2] if k % 2 else 1.0 - shares[k // 2]
        factor = share if k < 2 else -share
        add_point(row, factor, normal, poses, chain, axes, points[corners[k]], links[corners[k]])
    return left
