"""Points, lines, planes and rigid motions as multivectors of Cl(0,3,1)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.geometry import rotation
from helicoide.geometry.clifford import CL031, Array

# Below this sine, points count as collinear and directions as parallel, since their plane would be rounding noise.
COLLINEAR = 1e-9


def _rows(*names: str) -> Array:
    """A matrix with one blade per row; coefficients @ matrix is a multivector."""
    return np.array([CL031.blade(name) for name in names])


_NULL = CL031.blade("e")
_VECTOR = _rows("e1", "e2", "e3")
_TURN = _rows("e2e3", "e3e1", "e1e2")
_SHIFT = _rows("e1e", "e2e", "e3e")
_PLACE = _rows("e2e3e", "e3e1e", "e1e2e")
_WEIGHT = CL031.blade("e1e2e3")
_SCALAR = CL031.blade("1")
_VOLUME = CL031.blade("e1e2e3e")
_ROTOR = np.vstack([_SCALAR, _TURN])
_DUAL_QUATERNION = np.vstack([_ROTOR, -_VOLUME, _SHIFT])
_HAS_NULL = np.array([3 in blade for blade in CL031.blades])


def null_part(a: Array) -> Array:
    """The blades with e: the moment of a line, the offset of a plane, the coordinates of a point.

    By itself it is an element at infinity: a line with moment u, or a point in the direction (x, y, z).
    a: (..., 16). Source: Cerbaro 2022, eqs. 16–18.
    """
    return np.where(_HAS_NULL, a, 0.0)


def null_negated(a: Array) -> Array:
    """The multivector with e replaced by −e: the blades with e are negated. a: (..., 16)."""
    return np.where(_HAS_NULL, -a, a)


def dual_conjugate(a: Array) -> Array:
    """Clifford conjugate followed by e → −e: h† = g* + ½ g* t e for a motor h = g + ½ t g e.

    It moves the even points 1 + x e1e + y e2e + z e3e by h X h†; points, lines and planes here move by h X h*.
    a: (..., 16). Source: Cerbaro 2022, eq. 101, which prints it with the star of eq. 75.
    """
    return null_negated(CL031.conjugate(a))


def hodge(a: Array) -> Array:
    """Hodge star: the linear map with b (⋆b) = e1e2e3e for each of the 16 blades b.

    a: (..., 16). Source: Cerbaro 2022, §5.2.4.
    """
    return CL031.hodge(a)


def point(xyz: ArrayLike) -> Array:
    """Point p = e1e2e3 + x e2e3e + y e3e1e + z e1e2e.

    xyz: (..., 3), m; returns (..., 16). Source: Cerbaro 2022, eq. 16.
    """
    return np.asarray(_WEIGHT + np.asarray(xyz, dtype=float) @ _PLACE)


def coordinates(point: Array) -> Array:
    """Coordinates (x, y, z) of a point: the blades with e over the weight of e1e2e3, which must not be zero.

    point: (..., 16); returns (..., 3), m. Source: Cerbaro 2022, eq. 16.
    """
    return np.asarray(point @ _PLACE.T / (point @ _WEIGHT)[..., None])


def line(direction: ArrayLike, through: ArrayLike) -> Array:
    """Line ℓ = v_x e2e3 + v_y e3e1 + v_z e1e2 + u_x e1e + u_y e2e + u_z e3e with the moment u = r × v.

    direction: v (..., 3), of length one; through: any point r of the line (..., 3), m; returns (..., 16).
    −ℓ is the line reversed. Source: Cerbaro 2022, eq. 17.
    """
    v, r = np.asarray(direction, dtype=float), np.asarray(through, dtype=float)
    return np.asarray(v @ _TURN) + np.asarray(np.cross(r, v) @ _SHIFT)


def direction_and_moment(line: Array) -> tuple[Array, Array]:
    """Direction v and moment u = r × v of a line (..., 16), each (..., 3). Source: Cerbaro 2022, eq. 17."""
    return np.asarray(line @ _TURN.T), np.asarray(line @ _SHIFT.T)


def plane(normal: ArrayLike, offset: ArrayLike) -> Array:
    """Plane n·r = d: π = n_x e1 + n_y e2 + n_z e3 + d e.

    normal: n (..., 3), of length one; offset: d (...), m; returns (..., 16). −π is the plane with its faces swapped.
    Source: Cerbaro 2022, eq. 18.
    """
    return np.asarray(np.asarray(normal, dtype=float) @ _VECTOR + np.asarray(offset, dtype=float)[..., None] * _NULL)


def normal_and_offset(plane: Array) -> tuple[Array, Array]:
    """Normal n (..., 3) and offset d (...) of a plane (..., 16). Source: Cerbaro 2022, eq. 18."""
    return np.asarray(plane @ _VECTOR.T), np.asarray(plane @ _NULL)


def rotor(axis: ArrayLike, angle: ArrayLike) -> Array:
    """Rotation about an axis through the origin: g = cos(φ/2) + sin(φ/2) (n_x e2e3 + n_y e3e1 + n_z e1e2).

    axis: (..., 3), n = axis/‖axis‖; angle: φ (...), rad; returns (..., 16). Raises HelicoideError for a zero axis.
    Source: Cerbaro 2022, eq. 98.
    """
    return np.asarray(rotation.from_axis_angle(axis, angle) @ _ROTOR)


def translator(t: ArrayLike) -> Array:
    """Translation 1 + ½ t e with t = t_x e1 + t_y e2 + t_z e3.

    t: (..., 3), m; returns (..., 16). Source: Cerbaro 2022, eqs. 96, 99.
    """
    return np.asarray(_SCALAR + np.asarray(t, dtype=float) @ _SHIFT / 2)


def screw_motor(direction: ArrayLike, through: ArrayLike, angle: ArrayLike, pitch: ArrayLike = 0.0) -> Array:
    """Rotation by +θ about a line L with translation hθ along it: M = (1 + ½ hθ v e) exp(θL/2).

    exp(θL/2) = cos θ/2 + L sin θ/2.
    direction: v (..., 3), any length; through: a point of the axis (..., 3), m; angle: θ (...), rad;
    pitch: h (...), m/rad; returns (..., 16). Raises HelicoideError for a zero direction.
    The sign is that of the sources' lines; modern Cl(3,0,1) writes exp(−θL/2). Source: Cerbaro 2022, eqs. 17, 96–98.
    """
    v = rotation.unit_vector(direction)
    theta = np.asarray(angle, dtype=float)[..., None]
    turn = np.cos(theta / 2) * _SCALAR + np.sin(theta / 2) * line(v, through)
    return CL031.product(translator(np.asarray(pitch, dtype=float)[..., None] * theta * v), turn)


def motor_from_pose(T: Array) -> Array:
    """Motor of a homogeneous matrix: h = g + ½ t g e = (1 + ½ t e) g, with the canonical sign.

    T: T_a_b (..., 4, 4), m; returns M_a_b (..., 16). Valid for a rotation by π too. Source: Cerbaro 2022, eq. 96.
    """
    return CL031.product(translator(T[..., :3, 3]), rotation.from_matrix(T[..., :3, :3]) @ _ROTOR)


def pose_from_motor(M: Array) -> Array:
    """Homogeneous matrix of a motor: R from the rotor part g, t from the coefficients of 2 (dual part) g* = t e.

    M: M_a_b (..., 16), of any norm but zero; returns T_a_b (..., 4, 4), m. Source: Cerbaro 2022, eqs. 96, 102.
    """
    q = M @ _ROTOR.T
    shift = 2 * CL031.product(null_part(M), CL031.conjugate(q @ _ROTOR))
    T = np.zeros((*M.shape[:-1], 4, 4))
    T[..., :3, :3] = rotation.to_matrix(q)
    T[..., :3, 3] = shift @ _SHIFT.T / np.sum(q * q, axis=-1, keepdims=True)
    T[..., 3, 3] = 1.0
    return T


def move(M: Array, X: Array) -> Array:
    """Move points, lines or planes: X_a = M_a_b X_b (M_a_b)*, with the Clifford conjugate.

    M: unit motor (..., 16); X: (..., 16). Source: Cerbaro 2022, eq. 95 as corrected for points, lines and planes.
    """
    return CL031.sandwich(M, X)


def canonical(M: Array) -> Array:
    """The one of M and −M, which represent the same pose, with a positive scalar part.

    If the scalar is zero, the first non-zero of e2e3, e3e1, e1e2 is positive. M: (..., 16).
    Source: Cerbaro 2022, eq. 98.
    """
    return np.asarray(M * rotation.hemisphere_sign(M @ _ROTOR.T))


def point_plane_distance(plane: Array, point: Array) -> Array:
    """Signed distance of a point from a plane, positive on the side of the normal: l = ½ ⋆(πp − pπ) = n·r − d.

    plane: π (..., 16), unit normal; point: p (..., 16) of weight one; returns (...), m.
    Source: Cerbaro 2022, eqs. 19–20.
    """
    commutator = CL031.product(plane, point) - CL031.product(point, plane)
    return np.asarray(hodge(commutator) @ _SCALAR / 2)


def plane_through(p1: Array, p2: Array, p3: Array) -> Array:
    """Plane through three points: π = ⋆σ/√((⋆σ)(⋆σ)*), σ = Σ ± (⋆pᵢ)(⋆pⱼ)(⋆pₖ) over the six orders = 6 ⋆p1 ∧ ⋆p2 ∧ ⋆p3.

    p1, p2, p3: points (..., 16) of weight one; returns (..., 16) with n = −(p2 − p1) × (p3 − p1)/‖·‖, and swaps sides
    with any two points. Collinear points give σ = 0 and have no plane: the zero multivector is returned.
    Source: Cerbaro 2022, eqs. 25–26.
    """
    # Differences do not change the antisymmetric σ, and avoid cancellation when the points are close together.
    sigma = 6 * CL031.outer(CL031.outer(hodge(p1), hodge(p2 - p1)), hodge(p3 - p1))
    length = np.linalg.norm(hodge(sigma) @ _VECTOR.T, axis=-1)[..., None]
    longest = np.maximum(np.maximum(_squared_length(p2 - p1), _squared_length(p3 - p2)), _squared_length(p1 - p3))
    spans = length > 6 * COLLINEAR * longest
    return np.asarray(np.divide(hodge(sigma), length, out=np.zeros_like(sigma), where=spans))


def _squared_length(edge: Array) -> Array:
    """Squared length of the difference of two points, shape (..., 1)."""
    return np.asarray(np.sum((edge @ _PLACE.T) ** 2, axis=-1, keepdims=True))


def dual_quaternion(M: Array) -> Array:
    """Coefficients 1, i, j, k, ε, iε, jε, kε of a motor: i = e2e3, j = e3e1, k = e1e2, ε = −e1e2e3e, iε = e1e, …

    M: (..., 16); returns (..., 8). Source: Cerbaro 2022, Appendix F (dictionary).
    """
    return np.asarray(M @ _DUAL_QUATERNION.T)


def motor_from_dual_quaternion(coefficients: Array) -> Array:
    """Motor of the coefficients 1, i, j, k, ε, iε, jε, kε, inverse of `dual_quaternion`.

    coefficients: (..., 8); returns (..., 16). Source: Cerbaro 2022, Appendix F (dictionary).
    """
    return np.asarray(coefficients @ _DUAL_QUATERNION)
