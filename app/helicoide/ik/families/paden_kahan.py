"""The three subproblems of Paden and Kahan: the angles that rotate a point to a point, or to a distance.

Inverse kinematics by screws is reduced to them: a rotation does not move a point of its axis, so it drops out of a
product applied to that point.
Source: Paden 1986, Kinematics and control of robot manipulators; Kahan 1983, Lectures on computational aspects of
geometry; Murray, Li and Sastry 1994, A mathematical introduction to robotic manipulation, §3.2.
"""

from __future__ import annotations

from math import atan2, sqrt
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.chain import Joint

# The fraction of its largest value by which a radicand may be negative, and up to which two solutions are one; a
# length, m, that counts as zero.
ROUNDING, NONE = 1e-12, 1e-10


class Axis(NamedTuple):
    """An axis of rotation: its direction (3,), unit, and one of its points (3,), m."""

    direction: Array
    point: Array


def axis_of(joint: Joint) -> Axis:
    """The axis of a joint at q = 0."""
    return Axis(joint.direction, joint.point)


def _across(axis: Axis, p: Array) -> Array:
    """The perpendicular (3,), m, from the axis to a point."""
    u = p - axis.point
    return np.asarray(u - (axis.direction @ u) * axis.direction)


def turn_to(axis: Axis, p: Array, q: Array, kept: float) -> float:
    """Subproblem 1, e^(ξ̂θ) p = q: θ = Atan2(wᵀ(u' × v'), u'ᵀ v'), u' = u − w wᵀu, u = p − r, and v' of v = q − r.

    Args: p, q (3,), m, equally far from the axis and along it, which is not checked; kept: θ, rad, where they lie on
    the axis and every θ is a solution. Source: Murray, Li and Sastry 1994, §3.2, subproblem 1.
    """
    u, v = _across(axis, p), _across(axis, q)
    if min(np.linalg.norm(u), np.linalg.norm(v)) < NONE:
        return kept
    return atan2(axis.direction @ np.cross(u, v), u @ v)


def angles_to_point(
    first: Axis, second: Axis, p: Array, q: Array, kept: tuple[float, float]
) -> list[tuple[float, float]]:
    """Subproblem 2, e^(ξ̂₁θ₁) e^(ξ̂₂θ₂) p = q, for axes that cross at the point r of the first: no, one or two solutions.

    Both circles pass through c = r + α w₁ + β w₂ ± γ w₁ × w₂: α = (w₁ᵀw₂ w₂ᵀu − w₁ᵀv) / ((w₁ᵀw₂)² − 1),
    β = (w₁ᵀw₂ w₁ᵀv − w₂ᵀu) / ((w₁ᵀw₂)² − 1), γ² = (‖u‖² − α² − β² − 2αβ w₁ᵀw₂) / ‖w₁ × w₂‖². Then subproblem 1
    solves e^(ξ̂₂θ₂) p = c and e^(ξ̂₁θ₁) c = q.
    Args: as in `turn_to`; kept (2,), rad. Source: Murray, Li and Sastry 1994, §3.2, subproblem 2.
    """
    w1, w2, r = first.direction, second.direction, first.point
    u, v, normal, cosine = p - r, q - r, np.cross(w1, w2), float(w1 @ w2)
    alpha = (cosine * (w2 @ u) - w1 @ v) / (cosine**2 - 1)
    beta = (cosine * (w1 @ v) - w2 @ u) / (cosine**2 - 1)
    radicand = float(u @ u - alpha**2 - beta**2 - 2 * alpha * beta * cosine)
    return [
        (turn_to(first, c, q, kept[0]), turn_to(second, p, c, kept[1]))
        for root in _roots(radicand, float(u @ u))
        for c in [r + alpha * w1 + beta * w2 + root * normal / np.linalg.norm(normal)]
    ]


def angles_to_distance(axis: Axis, p: Array, q: Array, distance: float, kept: float) -> list[float]:
    """Subproblem 3, ‖q − e^(ξ̂θ) p‖ = δ: θ = θ₀ ± acos((‖u'‖² + ‖v'‖² − δ'²) / (2 ‖u'‖ ‖v'‖)), no, one or two.

    θ₀ is the angle from u' to v' as in subproblem 1, and δ'² = δ² − (wᵀ(p − q))².
    Args: p, q (3,), m; distance: δ, m; kept: θ, rad, where p or q lies on the axis.
    Source: Murray, Li and Sastry 1994, §3.2, subproblem 3.
    """
    u, v = _across(axis, p), _across(axis, q)
    size = 2 * float(np.linalg.norm(u) * np.linalg.norm(v))
    along = float(axis.direction @ (p - q))
    if size < NONE**2:
        return [kept]
    middle = turn_to(axis, p, q, kept)
    cosine = float(u @ u + v @ v - distance**2 + along**2) / size
    return [middle + atan2(root, cosine) for root in _roots(1 - cosine**2, 1.0)]


def _roots(radicand: float, largest: float) -> tuple[float, ...]:
    """±√x: both, one if they are equal up to rounding, none if x is negative."""
    if radicand < -ROUNDING * largest:
        return ()
    root = sqrt(max(radicand, 0.0))
    return (root, -root) if radicand > ROUNDING * largest else (0.0,)
