"""The nearest orientation of a hand that can only point within the vertical plane of its arm."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array

# A hand counts as pointing straight out of the plane where the sine to its normal is below this.
ACROSS = 1e-8


@dataclass(frozen=True, eq=False)
class Pointing:
    """How a hand is turned into the plane of the arm; vectors (3,) and R (3, 3) in one frame, angle in rad.

    M: normal of the plane; K: axis of the turn; Z: where the hand then points; cosine and sine of the angle; R: the
    turned orientation.
    """

    M: Array
    K: Array
    Z: Array
    cosine: float
    sine: float
    R: Array

    @property
    def angle(self) -> float:
        """The angle of the turn about K, rad: |θ| = asin|M·Ẑ|."""
        return float(np.arctan2(self.sine, self.cosine))


def turned_into_plane(T: Array, hand: Array, M: Array) -> Pointing:
    """How a tool (4, 4), m, seen from the base, is turned into the plane across M (3,), horizontal and unit.

    hand: the pointing direction in the frame of the tool, (3,), unit.
    """
    K, Z, cosine, sine, R = into_plane(np.ascontiguousarray(T), hand, M)
    return Pointing(M, K, Z, cosine, sine, R)


@kernel
def into_plane(T: Array, hand: Array, M: Array) -> tuple[Array, Array, float, float, Array]:
    """The smallest turn that brings the direction Ẑ = R·hand into the plane across M: K = M × Ẑ / |M × Ẑ|, Ẑ' = K × M.

    cos θ = Ẑ·Ẑ', sin θ = (Ẑ × Ẑ')·K; each axis follows: v' = cos θ v + sin θ K × v + (1 − cos θ)(K·v) K (Rodrigues).
    Where Ẑ lies along M every direction of the plane is as near; the horizontal one is taken, K down.
    Args: T (4, 4), m; hand, M (3,). Returns K, Ẑ', cos θ, sin θ and the turned orientation (3, 3).
    Source: Campos 1998, s.36 and s.55; Craig, Introduction to Robotics, ch. 4.
    """
    K, Z, R = np.empty(3), np.empty(3), np.empty((3, 3))
    x, y, z = (
        T[0, 0] * hand[0] + T[0, 1] * hand[1] + T[0, 2] * hand[2],
        T[1, 0] * hand[0] + T[1, 1] * hand[1] + T[1, 2] * hand[2],
        T[2, 0] * hand[0] + T[2, 1] * hand[1] + T[2, 2] * hand[2],
    )
    kx, ky, kz = M[1] * z - M[2] * y, M[2] * x - M[0] * z, M[0] * y - M[1] * x
    size = sqrt(kx * kx + ky * ky + kz * kz)
    if size < ACROSS:
        kx, ky, kz, size = 0.0, 0.0, -1.0, 1.0
    kx, ky, kz = kx / size, ky / size, kz / size
    px, py, pz = ky * M[2] - kz * M[1], kz * M[0] - kx * M[2], kx * M[1] - ky * M[0]
    cosine = x * px + y * py + z * pz
    sine = kx * (y * pz - z * py) + ky * (z * px - x * pz) + kz * (x * py - y * px)
    K[0], K[1], K[2], Z[0], Z[1], Z[2] = kx, ky, kz, px, py, pz
    for j in range(3):
        x, y, z = T[0, j], T[1, j], T[2, j]
        along = (1.0 - cosine) * (kx * x + ky * y + kz * z)
        R[0, j] = cosine * x + sine * (ky * z - kz * y) + along * kx
        R[1, j] = cosine * y + sine * (kz * x - kx * z) + along * ky
        R[2, j] = cosine * z + sine * (kx * y - ky * x) + along * kz
    return K, Z, cosine, sine, R
