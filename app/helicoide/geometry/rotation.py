"""Rotations as unit quaternions wxyz (Hamilton, active), as matrices and as roll, pitch and yaw of the sources."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from helicoide.geometry.clifford import QUATERNIONS, Array
from helicoide.text import HelicoideError, Text

_PURE = np.eye(3, 4, k=1)


def multiply(p: Array, q: Array) -> Array:
    """Compose two rotations, q first: the product p q with i² = j² = k² = ijk = −1.

    p, q: quaternions (..., 4). Source: Cerbaro 2022, eqs. 76–77.
    """
    return QUATERNIONS.product(p, q)


def conjugate(q: Array) -> Array:
    """Inverse of a unit quaternion: q* = w − x i − y j − z k, shape (..., 4). Source: Cerbaro 2022, eqs. 78, 85."""
    return QUATERNIONS.conjugate(q)


def rotate(q: Array, v: ArrayLike) -> Array:
    """Rotate vectors by a unit quaternion: v' = q v q*.

    q: (..., 4); v: (..., 3), any unit. Source: Cerbaro 2022, eq. 89.
    """
    return multiply(multiply(q, np.asarray(v, dtype=float) @ _PURE), conjugate(q))[..., 1:]


def _length(v: Array) -> Array:
    """‖v‖ of shape (..., 1), without underflow or overflow of the squares."""
    return np.asarray(np.hypot.reduce(v, axis=-1, keepdims=True))


def unit_vector(v: ArrayLike) -> Array:
    """Unit vectors v/‖v‖, shape (..., 3). Raises HelicoideError for a zero or infinite vector."""
    vector = np.asarray(v, dtype=float)
    length = _length(vector)
    directed = np.isfinite(length) & (length > 0)
    if not np.all(directed):
        first = vector[~directed[..., 0]][0].tolist()
        raise HelicoideError(
            Text(
                en=f"{first} has no direction: an axis needs finite components, not all zero",
                pt_BR=f"{first} não tem direção: um eixo precisa de componentes finitas, não todas nulas",
            )
        )
    return np.asarray(vector / length)


def hemisphere_sign(q: Array) -> Array:
    """Sign ±1 that makes the first non-zero component of q positive, so that q and −q give the same quaternion.

    sgn(w), else sgn(x), sgn(y), sgn(z). q: (..., 4); returns ±1 of shape (..., 1).
    """
    first = np.argmax(q != 0, axis=-1, keepdims=True)
    return np.where(np.take_along_axis(q, first, axis=-1) < 0, -1.0, 1.0)


def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Array:
    """Quaternion of a rotation about an axis: q = cos(θ/2) + sin(θ/2) (n_x i + n_y j + n_z k), n = axis/‖axis‖.

    axis: (..., 3); angle: (...), rad; returns (..., 4). Raises HelicoideError for a zero axis.
    Source: Cerbaro 2022, eq. 88.
    """
    half = np.asarray(angle, dtype=float)[..., None] / 2
    return np.asarray(np.cos(half) * np.eye(4)[0] + np.sin(half) * (unit_vector(axis) @ _PURE))


def skew(v: ArrayLike) -> Array:
    """Matrix of the cross product with v: [v]ₓ u = v × u.

    v: (..., 3); returns (..., 3, 3). Source: Coutinho 2015, eqs. A.1–A.4.
    """
    x, y, z = np.moveaxis(np.asarray(v, dtype=float), -1, 0)
    zero = np.zeros_like(x)
    return np.moveaxis(np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]), (0, 1), (-2, -1))


def from_rotation_vector(v: ArrayLike) -> Array:
    """Quaternion of a rotation vector θ n: q = cos(θ/2) + sin(θ/2)/θ (v_x i + v_y j + v_z k), θ = ‖v‖.

    v: (..., 3), rad; returns (..., 4). Exact at θ = 0. Source: Cerbaro 2022, eq. 88.
    """
    vector = np.asarray(v, dtype=float)
    half = _length(vector) / 2
    return np.asarray(np.cos(half) * np.eye(4)[0] + _sinc(half) / 2 * (vector @ _PURE))


def exponential(v: ArrayLike) -> Array:
    """Matrix of a rotation vector θ n: exp([v]ₓ) = I + sin θ/θ [v]ₓ + (1 − cos θ)/θ² [v]ₓ², θ = ‖v‖.

    v: (..., 3), rad; returns (..., 3, 3). Exact at θ = 0. Source: Rodrigues' formula, Coutinho 2015, eq. 2.7.
    """
    K, theta = skew(v), _length(np.asarray(v, dtype=float))[..., None]
    return np.asarray(np.eye(3) + _sinc(theta) * K + _sinc(theta / 2) ** 2 / 2 * (K @ K))


def _sinc(x: Array) -> Array:
    """sin x / x, which is 1 at 0."""
    return np.divide(np.sin(x), x, out=np.ones_like(x), where=x != 0)


def from_matrix(R: Array) -> Array:
    """Quaternion of a rotation matrix, w ≥ 0: a row of 4 q qᵀ, which is linear in R, divided by its length.

    R: (..., 3, 3); returns (..., 4). The row with the largest diagonal entry is used, so nothing cancels near θ = π.
    Source: Shepperd 1978.
    """
    if R.ndim == 2:
        return np.array(_single_from_matrix(R.tolist()))
    outer = np.moveaxis(np.array(_four_q_q_transposed(np.moveaxis(R, (-2, -1), (0, 1)))), (0, 1), (-2, -1))
    largest = np.argmax(np.diagonal(outer, axis1=-2, axis2=-1), axis=-1)[..., None, None]
    row = np.take_along_axis(outer, largest, axis=-2)[..., 0, :]
    q = row / np.sqrt((row * row).sum(axis=-1, keepdims=True))
    return np.asarray(q * hemisphere_sign(q))


def _single_from_matrix(R: list[list[float]]) -> list[float]:
    """The quaternion of one matrix, in Python floats, which are ten times as fast as arrays here."""
    outer = _four_q_q_transposed(R)
    row = outer[max(range(4), key=lambda i: outer[i][i])]
    length = math.copysign(math.hypot(*row), next((entry for entry in row if entry != 0), 1.0))
    return [entry / length for entry in row]


def _four_q_q_transposed(R: Any) -> list[list[Any]]:
    """The entries 4 w², 4 w x, … as sums of the entries of R: nine numbers, or nine arrays."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    return [
        [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
    ]


def to_matrix(q: Array) -> Array:
    """Rotation matrix of a non-zero quaternion: its columns are q i q*/‖q‖², q j q*/‖q‖², q k q*/‖q‖².

    q: (..., 4); returns (..., 3, 3). Source: Cerbaro 2022, eq. 89.
    """
    squared_length = np.sum(q * q, axis=-1)[..., None, None]
    return np.asarray(np.swapaxes(rotate(q[..., None, :], np.eye(3)), -2, -1) / squared_length)


def rotation_vector(q: Array) -> Array:
    """Rotation vector of a quaternion, of the rotation by at most π: θ n, θ = 2 atan2(‖v‖, |w|), v the vector part.

    q: (..., 4), unit; returns (..., 3), rad. Exact at θ = 0 and π. Source: Cerbaro 2022, eq. 88, solved for θ n.
    """
    q = q * hemisphere_sign(q)
    length = _length(q[..., 1:])
    angle = 2 * np.arctan2(length, q[..., :1])
    return np.asarray(q[..., 1:] * np.divide(angle, length, out=np.full_like(angle, 2.0), where=length > 0))


def logarithm(R: Array) -> Array:
    """Rotation vector of a matrix: v with exp([v]ₓ) = R and ‖v‖ ≤ π.

    R: (..., 3, 3); returns (..., 3), rad. Exact at θ = 0 and π. Source: Coutinho 2015, eq. 2.7, solved for v.
    """
    return rotation_vector(from_matrix(R))


def axis_angle(q: Array) -> tuple[Array, Array]:
    """Axis n, ‖n‖ = 1, and angle θ in [0, π] of a quaternion; the axis of the identity is (0, 0, 1).

    q: (..., 4), unit; returns (..., 3) and (...), rad. Source: Cerbaro 2022, eq. 88, solved for n and θ.
    """
    q = q * hemisphere_sign(q)
    length = _length(q[..., 1:])
    axis = unit_vector(np.where(length > 0, q[..., 1:], np.eye(3)[2]))
    return axis, np.asarray(2 * np.arctan2(length[..., 0], q[..., 0]))


def quaternion_jacobian(q: Array) -> Array:
    """Representation Jacobian of a quaternion: q̇ = J_R ω with η̇ = −½ εᵀω, ε̇ = ½ (η I − [ε]ₓ) ω, that is ½ ω q.

    q = (η, ε): (..., 4), unit; ω in the base frame, rad/s; returns (..., 4, 3). J_RᵀJ_R = ¼ I: never singular.
    Source: Vargas 2013, eqs. 2.45–2.46.
    """
    return np.swapaxes(multiply(_PURE, q[..., None, :]), -2, -1) / 2


def quaternion_jacobian_body(q: Array) -> Array:
    """Representation Jacobian for ω in the body frame: η̇ = −½ εᵀω, ε̇ = ½ (η I + [ε]ₓ) ω, that is ½ q ω.

    q = (η, ε): (..., 4), unit; ω in the body frame, rad/s; returns (..., 4, 3). Source: Coutinho 2015, eq. 2.64.
    """
    return np.swapaxes(multiply(q[..., None, :], _PURE), -2, -1) / 2


def orientation_error(q_target: Array, q: Array) -> Array:
    """Rotation vector from q to q_target, ‖θ n‖ ≤ π: that of q_target q⁻¹.

    q_target, q: unit quaternions (..., 4) in one frame; returns (..., 3), rad, in that frame.
    Source: Cerbaro 2022, eq. 91; its eq. 92 keeps sin(θ/2) n instead of θ n.
    """
    return rotation_vector(multiply(q_target, conjugate(q)))


def quaternion_error(q_target: Array, q: Array) -> Array:
    """Vector part of Δq = q_target q⁻¹ with θ ≤ π, sin(θ/2) n: Δε, or −Δε if Δη < 0.

    Δη = η_d η + ε_dᵀε, Δε = η ε_d − η_d ε − ε_d × ε. With ω = K Δε in the base frame the angle obeys
    tan(θ/4) = tan(θ₀/4) e^{−Kt/2}; without the change of sign Δη = −1 would be a second equilibrium.
    q_target, q: unit quaternions (..., 4) in one frame; returns (..., 3), in that (the base) frame.
    Source: Vargas 2013, eqs. 2.41–2.46; Cerbaro 2022, eqs. 91–92.
    """
    return _shorter_vector_part(multiply(q_target, conjugate(q)))


def quaternion_error_body(q_target: Array, q: Array) -> Array:
    """The same error in the body frame, for a body velocity ω = K Δε: vector part of Δq = q⁻¹ q_target.

    It is Rᵀ times the error in the base frame. q_target, q: unit quaternions (..., 4) in one frame; returns (..., 3).
    Source: Coutinho 2015, eqs. 2.62–2.66, which uses the error in the base frame for a body velocity and so fails.
    """
    return _shorter_vector_part(multiply(conjugate(q), q_target))


def _shorter_vector_part(q: Array) -> Array:
    """sin(θ/2) n of a quaternion, with θ ≤ π."""
    return np.asarray((q * hemisphere_sign(q))[..., 1:])


def roll_pitch_yaw_zyx(R: Array) -> Array:
    """Angles (φ, ϑ, ψ) with R = R_z(φ) R_y(ϑ) R_x(ψ): the source's Roll is about z, its Yaw about x.

    φ = atan2(a₂₁, a₁₁), ϑ = atan2(−a₃₁, √(a₃₂² + a₃₃²)), ψ = atan2(a₃₂, a₃₃).
    R: (..., 3, 3); returns (..., 3), rad. ψ is computed from R_z(−φ) R: the same angle, but one that also reproduces R
    at ϑ = ±π/2, where only φ ∓ ψ is determined. Source: Cerbaro 2022, eqs. 53–55.
    """
    roll = np.arctan2(R[..., 1, 0], R[..., 0, 0])
    pitch = np.arctan2(-R[..., 2, 0], np.hypot(R[..., 2, 1], R[..., 2, 2]))
    s, c = np.sin(roll), np.cos(roll)
    yaw = np.arctan2(s * R[..., 0, 2] - c * R[..., 1, 2], c * R[..., 1, 1] - s * R[..., 0, 1])
    return np.stack([roll, pitch, yaw], axis=-1)


def roll_pitch_yaw_of_quaternion(q: Array) -> Array:
    """The same angles (φ, ϑ, ψ) of a quaternion w + x i + y j + z k.

    φ = atan2(2(wz + xy), 1 − 2(y² + z²)), ϑ = asin(2(wy − zx)), ψ = atan2(2(wx + yz), 1 − 2(x² + y²)), read from
    the matrix, which keeps ϑ exact at ±π/2. q: (..., 4); returns (..., 3), rad.
    Source: Cerbaro 2022, eq. 90 corrected: as printed, 2 asin(x, y, z) holds for rotations about one coordinate axis.
    """
    return roll_pitch_yaw_zyx(to_matrix(q))
