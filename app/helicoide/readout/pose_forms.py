"""One pose in all its forms: quaternion, dual quaternion, matrix, screw and Euler angles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import euler, motor, rigid, rotation
from helicoide.geometry.euler import EulerAngles
from helicoide.geometry.motor import ScrewDisplacement

# Nearer than this to a singularity of the convention, rad, small rotations change the angles much: a warning is shown.
NEAR_SINGULAR = np.radians(5.0)


@dataclass(frozen=True, eq=False)
class PoseForms:
    """A pose T_world_frame (4, 4), m, in other forms.

    quaternion: wxyz with w ≥ 0; dual_quaternion (8,): 1, i, j, k, ε, iε, jε, kε, m; euler: by the chosen convention.
    """

    matrix: Array
    quaternion: Array
    dual_quaternion: Array
    screw: ScrewDisplacement
    euler: EulerAngles

    @property
    def half_angle(self) -> float:
        """Half the angle of rotation, rad, 0 to π/2: w is its cosine, and (x, y, z) has its sine as length."""
        return float(np.arctan2(np.linalg.norm(self.quaternion[1:]), self.quaternion[0]))

    @property
    def near_singular(self) -> bool:
        """Whether the Euler angles are near a singularity of their convention."""
        return bool(self.euler.singularity_margin < NEAR_SINGULAR)


def forms_of_pose(T: Array, convention: str) -> PoseForms:
    """All forms of a pose (4, 4), m. Raises HelicoideError for an unknown convention of Euler angles."""
    M = rigid.motor_from_pose(T)
    return PoseForms(
        T,
        rotation.from_matrix(T[:3, :3]),
        rigid.dual_quaternion(M),
        motor.screw_from_motor(M),
        euler.euler_angles(T[:3, :3], convention),
    )
