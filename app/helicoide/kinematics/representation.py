"""Coordinates of an orientation, and how they change with an angular velocity: Euler angles, quaternion, θ n."""

from __future__ import annotations

import numpy as np

from helicoide.geometry import euler, rotation
from helicoide.kinematics.chain import Array
from helicoide.text import HelicoideError, Text

QUATERNION, ROTATION_VECTOR = "quaternion", "rotation vector"
REPRESENTATIONS = (QUATERNION, ROTATION_VECTOR, *euler.CONVENTIONS)
# Below this angle θ the difference in (1 − θ/2 cot θ/2)/θ² loses more digits than its series 1/12 + θ²/720 leaves out.
SMALL = 1e-2


def coordinates(R: Array, representation: str) -> Array:
    """The coordinates φ of a rotation matrix: (4,) of a quaternion wxyz with w ≥ 0, else (3,), rad.

    Args: R (3, 3). Raises HelicoideError for an unknown representation. Source: Vargas 2013, eq. 2.14.
    """
    _check(representation)
    if representation == QUATERNION:
        return rotation.from_matrix(R)
    if representation == ROTATION_VECTOR:
        return rotation.logarithm(R)
    return euler.angles(R, representation).values


def representation_jacobian(R: Array, representation: str) -> Array:
    """The matrix J_R of φ̇ = J_R(φ) ω at the coordinates that `coordinates` gives.

    Args: R (3, 3); ω in the base frame, rad/s. Returns (4, 3) for a quaternion, else (3, 3), with rows of NaN where
    Euler angles are singular. Raises HelicoideError for an unknown representation. Source: Vargas 2013, eq. 2.26.
    """
    phi = coordinates(R, representation)
    if representation == QUATERNION:
        return rotation.quaternion_jacobian(phi)
    if representation == ROTATION_VECTOR:
        return rotation_vector_jacobian(phi)
    return euler.jacobian(phi, representation)


def rotation_vector_jacobian(v: Array) -> Array:
    """The matrix of v̇ = J_R ω for the rotation vector v = θ n: J_R = I − ½ [v]ₓ + (1 − θ/2 cot θ/2)/θ² [v]ₓ².

    Args: v (3,), rad, θ < 2π; ω in the base frame, rad/s. Returns (3, 3).
    Source: Bullo and Murray 1995, inverse of the differential of exp.
    """
    K, theta = rotation.skew(v), float(np.linalg.norm(v))
    factor = 1 / 12 + theta**2 / 720 if theta < SMALL else (1 - theta / 2 / np.tan(theta / 2)) / theta**2
    return np.asarray(np.eye(3) - K / 2 + factor * K @ K)


def _check(representation: str) -> None:
    if representation not in REPRESENTATIONS:
        raise HelicoideError(
            Text(
                en="{given!r} is no representation of an orientation; there is: {valid}",
                pt_BR="{given!r} não é uma representação de orientação; existe: {valid}",
            ).format(given=representation, valid=", ".join(REPRESENTATIONS))
        )
