"""The nearest orientation of a hand that can only point within the vertical plane of its arm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.geometry import rotation
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


def turned_into_plane(R: Array, hand: Array, M: Array, up: Array) -> Pointing:
    """The smallest turn that brings the direction Ẑ = R·hand into the plane across M: K = M × Ẑ / |M × Ẑ|, Ẑ' = K × M.

    cos θ = Ẑ·Ẑ', sin θ = (Ẑ × Ẑ')·K; each axis follows: v' = cos θ v + sin θ K × v + (1 − cos θ)(K·v) K (Rodrigues).
    Where Ẑ lies along M every direction of the plane is as near; the horizontal one is taken, K = −up.
    Args: R (3, 3); hand: the pointing direction in the frame of R, (3,), unit; M, up (3,), unit, M across up.
    Source: Campos 1998, s.36 and s.55; Craig, Introduction to Robotics, ch. 4.
    """
    Z = R @ hand
    K = np.cross(M, Z)
    K = -up if np.linalg.norm(K) < ACROSS else rotation.unit(K - (K @ M) * M)
    pointed = np.cross(K, M)
    cosine, sine = float(Z @ pointed), float(np.cross(Z, pointed) @ K)
    return Pointing(M, K, pointed, cosine, sine, _rodrigues(K, cosine, sine) @ R)


def _rodrigues(K: Array, cosine: float, sine: float) -> Array:
    return np.asarray(cosine * np.eye(3) + sine * rotation.skew(K) + (1 - cosine) * np.outer(K, K))
