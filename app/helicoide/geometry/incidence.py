"""Incidence of points, lines and planes of Cl(0,3,1): join, meet, distances, angles, feet of perpendiculars."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031, Array

_WEIGHT = CL031.blade("e1e2e3")
_ORIGIN = rigid.point((0, 0, 0))


def join(*elements: Array) -> Array:
    """The element that all of these span, of unit size: a ∨ b/‖a ∨ b‖, ⋆(a ∨ b) = ⋆a ∧ ⋆b, from left to right.

    Points p, q give the line from p to q; points p, q, r the plane with n = (q − p)×(r − p)/‖·‖, which is
    −`rigid.plane_through`; a line of direction v and a point r the plane with n = v×(r − point of the line)/‖·‖.
    Elements (..., 16), of weight one. Degenerate input (equal or collinear points, a point on its line) gives the zero
    multivector. Source: Selig 2005, ch. 10; Cerbaro 2022, §5.2.4.
    """
    return reduce(_unit(CL031.regressive), elements)


def meet(*elements: Array) -> Array:
    """The intersection of the elements, of unit size: a ∧ b/‖a ∧ b‖, from left to right.

    Planes π1, π2 give the line of direction n1×n2/‖·‖; a line and a plane, or three planes, the point of weight one.
    Elements (..., 16), of unit size. Parallel ones meet at infinity (`is_finite` is false): the weight (e2e3, e3e1,
    e1e2 of a line, e1e2e3 of a point) is exactly zero, and for two of them the norm of the rest is their distance. If
    one lies in the other, the zero multivector is returned. Source: Selig 2005, ch. 10.
    """
    return reduce(_unit(CL031.outer), elements)


def is_finite(X: Array) -> NDArray[np.bool_]:
    """Whether a point, line or plane is finite: neither at infinity nor zero. X: (..., 16); returns (...)."""
    return np.asarray(np.any(rigid.null_part(X) != X, axis=-1))


def perpendicular_foot(point: Array, X: Array) -> Array:
    """Foot of the perpendicular from a point p on a line or plane X: (X ⌋ p) ∧ X, X ⌋ p being perpendicular to X.

    point: (..., 16); X: unit (..., 16); returns a point of weight one (..., 16).
    Source: Dorst, Fontijne & Mann 2007, §3.6 (projection).
    """
    return meet(CL031.left_contraction(X, point), X)


def point_line_distance(line: Array, point: Array) -> Array:
    """Distance of a point from a line, not negative: the norm of their join, l = ‖ℓ ∨ p‖ = ‖r×v − u‖.

    line: unit ℓ (..., 16); point: p (..., 16) of weight one; returns (...), m. Source: Selig 2005, ch. 10.
    """
    return CL031.norm(CL031.regressive(line, point))


def line_angle(line1: Array, line2: Array) -> Array:
    """Angle between the directions of two lines, in [0, π]: atan2(‖⟨ℓ1 ℓ2⟩₂‖, −⟨ℓ1 ℓ2⟩₀).

    line1, line2: unit (..., 16); returns (...), rad. −ℓ, a line reversed, turns φ into π − φ.
    Source: Selig 2005, ch. 10; Cerbaro 2022, eq. 17.
    """
    product = CL031.product(line1, line2)
    return np.asarray(np.arctan2(CL031.norm(CL031.grade(product, 2)), -product[..., 0]))


def line_distance(line1: Array, line2: Array) -> Array:
    """Shortest distance of two lines, not negative: l = |ℓ1 ∨ ℓ2|/‖⟨ℓ1 ℓ2⟩₂‖ = |v1·u2 + v2·u1|/‖v1×v2‖.

    For parallel lines, the distance of any point of one from the other. line1, line2: unit (..., 16); returns (...), m.
    Source: Selig 2005, ch. 10.
    """
    sine = CL031.norm(CL031.grade(CL031.product(line1, line2), 2))
    apart = np.asarray(point_line_distance(line2, perpendicular_foot(_ORIGIN, line1)))
    twist = np.abs(CL031.regressive(line1, line2)[..., 0])
    return np.asarray(np.divide(twist, sine, out=apart, where=sine > rigid.COLLINEAR))


def common_normal(line1: Array, line2: Array) -> tuple[Array, Array, Array]:
    """Common normal N of two lines and its feet: the planes Wᵢ = ℓᵢ ∨ n∞ give N = W1 ∧ W2, pᵢ = ℓᵢ ∧ Wⱼ.

    n∞ is the point at infinity of n = v1×v2, which is also the direction of N; both feet of intersecting lines are the
    intersection. For parallel lines N passes through the point of ℓ1 nearest to the origin, from ℓ1 to ℓ2; it is zero
    if the lines coincide. line1, line2: unit (..., 16); returns N, p1, p2, each (..., 16).
    Source: Selig 2005, ch. 10; Denavit & Hartenberg 1955 for its use.
    """
    across, _ = rigid.direction_and_moment(CL031.product(line1, line2))
    far = rigid.null_part(rigid.point(across))
    wall1, wall2 = join(line1, far), join(line2, far)
    skew = meet(wall1, wall2), meet(line1, wall2), meet(line2, wall1)
    start = perpendicular_foot(_ORIGIN, line1)
    end = perpendicular_foot(start, line2)
    parallel = _length(across) <= rigid.COLLINEAR
    normal, foot1, foot2 = (
        np.where(parallel, *pair) for pair in zip((join(start, end), start, end), skew, strict=True)
    )
    return normal, foot1, foot2


def line_plane_angle(line: Array, plane: Array) -> Array:
    """Angle of a line with a plane, in [−π/2, π/2], positive if it points to the side of the normal: sin φ = n·v.

    φ = atan2(ℓ ∧ π, ‖⟨ℓ π⟩₁‖). line: unit ℓ (..., 16); plane: unit π (..., 16); returns (...), rad.
    Source: Selig 2005, ch. 10.
    """
    product = CL031.product(line, plane)
    sine = product @ _WEIGHT
    return np.asarray(np.arctan2(sine, CL031.norm(CL031.grade(product, 1))))


def line_plane_distance(line: Array, plane: Array) -> Array:
    """Distance of a line from a parallel plane, positive on the side of the normal; 0 if they intersect.

    l = ½ ⋆(πp − pπ), p the point of the line nearest to the origin. line: unit ℓ (..., 16); plane: unit π (..., 16);
    returns (...), m. Source: Cerbaro 2022, eq. 20.
    """
    apart = rigid.point_plane_distance(plane, perpendicular_foot(_ORIGIN, line))
    return np.where(is_finite(meet(line, plane)), 0.0, apart)


def _unit(product: Callable[[Array, Array], Array]) -> Callable[[Array, Array], Array]:
    """The product scaled to unit size; a result no larger than rounding of its factors becomes exactly zero."""

    def scaled(a: Array, b: Array) -> Array:
        raw = product(a, b)
        size, far = CL031.norm(raw)[..., None], rigid.null_part(raw)
        noise = rigid.COLLINEAR * _length(a) * _length(b)
        # Only points have a signed weight; for lines and planes e1e2e3 is rounding noise.
        signed = np.where(2 * (raw @ _WEIGHT)[..., None] < -size, -size, size)
        at_infinity = np.where(_length(far) > noise, far, 0.0)
        return np.asarray(np.divide(raw, signed, out=at_infinity, where=size > noise))

    return scaled


def _length(a: Array) -> Array:
    """Root of the sum of the squares of all coefficients, shape (..., 1)."""
    return np.asarray(np.linalg.norm(a, axis=-1, keepdims=True))
