"""Rotations as unit quaternions wxyz (Hamilton, active), as matrices and as the angles of the sources."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.geometry.clifford import Algebra, Array
from helicoide.text import HelicoideError, Text

# Hamilton's quaternions with i = e1, j = e2, k = e1e2, so that the blades stand in the order w, x, y, z.
QUATERNIONS = Algebra(0, 2, 0)
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


def unit(v: ArrayLike) -> Array:
    """Scale vectors to length one: v/‖v‖, shape (..., 3). Raises HelicoideError for a vector without direction."""
    vector = np.asarray(v, dtype=float)
    length = np.linalg.norm(vector, axis=-1, keepdims=True)
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


def hemisphere(q: Array) -> Array:
    """Sign that makes the first non-zero component of q positive, of two opposite quaternions always the same one.

    sgn(w), else sgn(x), sgn(y), sgn(z). q: (..., 4); returns ±1 of shape (..., 1).
    """
    first = np.argmax(q != 0, axis=-1, keepdims=True)
    return np.where(np.take_along_axis(q, first, axis=-1) < 0, -1.0, 1.0)


def from_axis_angle(axis: ArrayLike, angle: ArrayLike) -> Array:
    """Quaternion of a turn about an axis: q = cos(θ/2) + sin(θ/2) (n_x i + n_y j + n_z k), n = axis/‖axis‖.

    axis: (..., 3); angle: (...), rad; returns (..., 4). Raises HelicoideError for a zero axis.
    Source: Cerbaro 2022, eq. 88.
    """
    half = np.asarray(angle, dtype=float)[..., None] / 2
    return np.asarray(np.cos(half) * np.eye(4)[0] + np.sin(half) * (unit(axis) @ _PURE))


def from_matrix(R: Array) -> Array:
    """Quaternion of a rotation matrix, w ≥ 0: a row of 4 q qᵀ, which is linear in R, divided by its length.

    R: (..., 3, 3); returns (..., 4). The row of the largest component is taken, so nothing cancels near θ = π.
    Source: Shepperd 1978.
    """
    outer = np.moveaxis(np.array(_four_q_q_transposed(R)), (0, 1), (-2, -1))
    largest = np.argmax(np.diagonal(outer, axis1=-2, axis2=-1), axis=-1)[..., None, None]
    row = np.take_along_axis(outer, largest, axis=-2)[..., 0, :]
    q = row / np.linalg.norm(row, axis=-1, keepdims=True)
    return np.asarray(q * hemisphere(q))


def _four_q_q_transposed(R: Array) -> list[list[Array]]:
    """The entries 4 w², 4 w x, … as sums of the entries of R."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = np.moveaxis(R, (-2, -1), (0, 1))
    return [
        [1 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz],
    ]


def to_matrix(q: Array) -> Array:
    """Rotation matrix of a quaternion of any length but zero: its columns are q i q*/‖q‖², q j q*/‖q‖², q k q*/‖q‖².

    q: (..., 4); returns (..., 3, 3). Source: Cerbaro 2022, eq. 89.
    """
    squared_length = np.sum(q * q, axis=-1)[..., None, None]
    return np.asarray(np.swapaxes(rotate(q[..., None, :], np.eye(3)), -2, -1) / squared_length)


def rotation_vector(q: Array) -> Array:
    """Axis times angle of the shorter turn: θ n, θ = 2 atan2(‖v‖, |w|) in [0, π], v the vector part.

    q: (..., 4), unit; returns (..., 3), rad. Exact at θ = 0 and π. Source: Cerbaro 2022, eq. 88, solved for θ n.
    """
    q = q * hemisphere(q)
    length = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(length, q[..., :1])
    return np.asarray(q[..., 1:] * np.divide(angle, length, out=np.full_like(angle, 2.0), where=length > 0))


def orientation_error(q_target: Array, q: Array) -> Array:
    """Rotation vector that brings q to q_target by the shorter way: θ n of q_target q⁻¹.

    q_target, q: unit quaternions (..., 4) in one frame; returns (..., 3), rad, in that frame.
    Source: Cerbaro 2022, eq. 91; its eq. 92 keeps sin(θ/2) n instead of θ n.
    """
    return rotation_vector(multiply(q_target, conjugate(q)))


def roll_pitch_yaw_zyx(R: Array) -> Array:
    """Angles (φ, ϑ, ψ) with R = R_z(φ) R_y(ϑ) R_x(ψ): the source's Roll is about z, its Yaw about x.

    φ = atan2(a₂₁, a₁₁), ϑ = atan2(−a₃₁, √(a₃₂² + a₃₃²)), ψ = atan2(a₃₂, a₃₃).
    R: (..., 3, 3); returns (..., 3), rad. ψ is read after turning back by φ, which is the same angle but also
    gives R back at ϑ = ±π/2, where only φ ∓ ψ is determined. Source: Cerbaro 2022, eqs. 53–55.
    """
    roll = np.arctan2(R[..., 1, 0], R[..., 0, 0])
    pitch = np.arctan2(-R[..., 2, 0], np.hypot(R[..., 2, 1], R[..., 2, 2]))
    s, c = np.sin(roll), np.cos(roll)
    yaw = np.arctan2(s * R[..., 0, 2] - c * R[..., 1, 2], c * R[..., 1, 1] - s * R[..., 0, 1])
    return np.stack([roll, pitch, yaw], axis=-1)
