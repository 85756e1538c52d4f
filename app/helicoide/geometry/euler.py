"""Euler angles of every convention: twelve sequences of axes, each about the turned axes or about the fixed ones."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, reduce
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide.geometry import rotation
from helicoide.geometry.clifford import Array
from helicoide.text import HelicoideError, Text

SEQUENCES = tuple("".join(axes) for axes in product("xyz", repeat=3) if axes[0] != axes[1] != axes[2])
EXTRINSIC = "extrinsic "
# "zyx" is intrinsic, R = R_z R_y R_x; "extrinsic zyx" turns about the fixed axes, R = R_x R_y R_z.
CONVENTIONS = (*SEQUENCES, *(EXTRINSIC + sequence for sequence in SEQUENCES))
# What Cerbaro 2022, eqs. 53–55, calls Roll (about z), Pitch (about y) and Yaw (about x), in this order.
ROLL_PITCH_YAW = "zyx"
# Margin, rad, below which the first and last angle of a matrix with rounded entries are noise.
SINGULAR = 1e-13


@dataclass(frozen=True)
class EulerAngles:
    """Euler angles (..., 3), rad, and how far each set is from the singularity of its convention (...), rad."""

    values: Array
    singularity_margin: Array

    @property
    def singular(self) -> NDArray[np.bool_]:
        """Where the matrix determines only the sum or the difference of the first and last angle, shape (...)."""
        return np.asarray(self.singularity_margin < SINGULAR)


@dataclass(frozen=True)
class _Product:
    """The convention as R = R₁ R₂ R₃ about three axes of the frame: n₁, n₂, n₃ in rows, and the order of angles."""

    axes: Array
    order: slice

    @property
    def handedness(self) -> float:
        """n₃ · (n₁ × n₂): ±1 for three different axes, 0 where the first comes back."""
        first, second, third = self.axes
        return float(third @ np.cross(first, second))


@cache
def _product(convention: str) -> _Product:
    if convention not in CONVENTIONS:
        valid = ", ".join(SEQUENCES)
        raise HelicoideError(
            Text(
                en=f'"{convention}" is no convention of Euler angles; valid are {valid}, '
                f'and each with "{EXTRINSIC}" before it',
                pt_BR=f'"{convention}" não é uma convenção de ângulos de Euler; valem {valid}, '
                f'e cada uma com "{EXTRINSIC}" na frente',
            )
        )
    order = slice(None, None, -1 if convention.startswith(EXTRINSIC) else 1)
    return _Product(np.eye(3)[["xyz".index(axis) for axis in convention[-3:][order]]], order)


def _triad(first: Array, second: Array) -> Array:
    """Right-handed frame of two orthogonal axes, in columns."""
    return np.column_stack([first, second, np.cross(first, second)])


def euler_matrix(angles: ArrayLike, convention: str) -> Array:
    """Rotation matrix of Euler angles: intrinsic "ijk" R = R_i(φ₁) R_j(φ₂) R_k(φ₃), extrinsic R_k(φ₃) R_j(φ₂) R_i(φ₁).

    angles: (..., 3), rad, in the order of the convention's name; returns (..., 3, 3).
    Raises HelicoideError for an unknown convention. Source: Vargas 2013, eq. 2.8; Cerbaro 2022, eqs. 53–55 ("zyx").
    """
    return reduce(np.matmul, np.moveaxis(_factors(angles, _product(convention)), -3, 0))


def _factors(angles: ArrayLike, convention: _Product) -> Array:
    """R₁, R₂, R₃ of shape (..., 3, 3, 3)."""
    ordered = np.asarray(angles, dtype=float)[..., convention.order]
    return rotation.exponential(ordered[..., None] * convention.axes)


def euler_angles(R: Array, convention: str) -> EulerAngles:
    """Euler angles of a rotation matrix, with the distance to the singularity of the convention.

    M = [n₁ n₂ n₁×n₂]ᵀ R [n₃ n₂ n₃×n₂] = R_x(φ₁) R_y(β) R_x(φ₃), β = φ₂ + a constant. Singular is sin β = 0: φ₂ = ±π/2
    for three different axes, φ₂ = 0 or π where the first comes back. The margin is atan2(|sin β|, |cos β|).
    φ₂ is in [−π/2, π/2] for three different axes and in [0, π] where the first comes back; φ₁, φ₃ are in [−π, π].
    Where singular, the angle of the leftmost factor of the product R₁ R₂ R₃ is 0 (the first of an intrinsic, the last
    of an extrinsic convention) and that of the rightmost takes the whole turn: R is recovered, to 2 SINGULAR there and
    to rounding elsewhere.
    R: (..., 3, 3). Raises HelicoideError for an unknown convention. Source: Cerbaro 2022, eqs. 53–55, for "zyx".
    """
    factors = _product(convention)
    n1, n2, n3 = factors.axes
    M = _triad(n1, n2).T @ R @ _triad(n3, n2)
    side = -factors.handedness or 1.0
    sine, cosine = np.hypot(M[..., 1, 0], M[..., 2, 0]), M[..., 0, 0]
    margin = np.arctan2(sine, np.abs(cosine))
    first = np.where(margin < SINGULAR, 0.0, np.arctan2(side * M[..., 1, 0], -side * M[..., 2, 0]))
    second = np.arctan2(factors.handedness * cosine, sine) if factors.handedness else np.arctan2(sine, cosine)
    # the last angle is read after turning back by the first, as in rotation.roll_pitch_yaw_zyx
    row = np.cos(first)[..., None] * M[..., 1, :] + np.sin(first)[..., None] * M[..., 2, :]
    third = np.arctan2(-row[..., 2], row[..., 1])
    return EulerAngles(np.stack([first, second, third], axis=-1)[..., factors.order], margin)


def velocity_matrix(angles: ArrayLike, convention: str) -> Array:
    """Matrix E of the angular velocity of changing angles: ω = E φ̇, columns n₁, R₁ n₂, R₁ R₂ n₃: the turned axes.

    angles: (..., 3), rad; ω in the base frame, rad/s; returns (..., 3, 3).
    Raises HelicoideError for an unknown convention. Source: Vargas 2013, eq. 2.26, solved for ω.
    """
    factors = _product(convention)
    R1, R2, _ = np.moveaxis(_factors(angles, factors), -3, 0)
    n1, n2, n3 = factors.axes
    columns = [np.broadcast_to(n1, R1.shape[:-1]), R1 @ n2, R1 @ R2 @ n3]
    return np.stack(columns, axis=-1)[..., factors.order]


def velocity_determinant(angles: ArrayLike, convention: str) -> Array:
    """Determinant of E with ω = E φ̇, that is 1/det J_R: ±cos φ₂ for three different axes, else ±sin φ₂.

    Its size is the sine of the margin of `EulerAngles`, zero where the convention is singular.
    angles: (..., 3), rad; returns (...).
    Raises HelicoideError for an unknown convention. Source: Vargas 2013, eq. 2.26 (representation singularities).
    """
    first, second, third = np.moveaxis(velocity_matrix(angles, convention), -1, 0)
    return np.asarray(np.sum(first * np.cross(second, third), axis=-1))


def euler_jacobian(angles: ArrayLike, convention: str) -> Array:
    """Representation Jacobian: φ̇ = J_R(φ) ω, J_R = E⁻¹ with E of `velocity_matrix` and det J_R = 1/`determinant`.

    angles: (..., 3), rad; ω in the base frame, rad/s; returns (..., 3, 3). Where |det E| < SINGULAR the rows of the
    first and last angle are NaN, since no rate of theirs gives every ω; that of the second angle is always finite.
    Raises HelicoideError for an unknown convention. Source: Vargas 2013, eqs. 2.26–2.27; Cerbaro 2022, eq. 68.
    """
    e1, e2, e3 = np.moveaxis(velocity_matrix(angles, convention), -1, 0)
    det = np.sum(e1 * np.cross(e2, e3), axis=-1)[..., None]
    defined = np.where(np.abs(det) < SINGULAR, np.nan, det)
    return np.stack([np.cross(e2, e3) / defined, e2, np.cross(e1, e2) / defined], axis=-2)


def euler_angle_error(angles_target: ArrayLike, angles: ArrayLike) -> Array:
    """Error of Euler angles: e = φ_d − φ, each turned by whole turns into [−π, π].

    angles_target, angles: (..., 3), rad, of one convention; returns (..., 3), rad: rates of angles are to follow it,
    not an angular velocity (φ̇ = J_R ω leads from one to the other). The sources subtract without turning, which takes
    a target across ±π for a turn the long way round. Source: Vargas 2013, eq. 2.37; Cerbaro 2022, eq. 56.
    """
    difference = np.asarray(angles_target, dtype=float) - np.asarray(angles, dtype=float)
    return np.asarray(difference - 2 * np.pi * np.round(difference / (2 * np.pi)))
