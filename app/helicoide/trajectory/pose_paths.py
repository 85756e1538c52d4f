"""Interpolation between two poses: a straight line with slerp, or one screw motion."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import motor, rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.trajectory.path import checked_duration


@dataclass(frozen=True, eq=False)
class PosePath:
    """A path between two poses T_world_start, T_world_end (4, 4), m; duration T, s."""

    T_world_start: Array
    T_world_end: Array
    duration: float

    def __post_init__(self) -> None:
        checked_duration(self.duration)

    @property
    def is_closed(self) -> bool:
        """Whether it ends in the pose in which it begins."""
        return np.array_equal(self.T_world_start, self.T_world_end)


@dataclass(frozen=True, eq=False)
class LinePath(PosePath):
    """Straight line with rotation at constant velocity (slerp): p = p₀ + σ (p₁ − p₀), R = R₀ exp(σ [w]ₓ), σ = s / T.

    w = log(R₀ᵀ R₁), ‖w‖ ≤ π.
    """

    @cached_property
    def rotation(self) -> Array:
        """Rotation vector w from start to end, in the axes of the start, (3,), rad."""
        return rotation.logarithm(self.T_world_start[:3, :3].T @ self.T_world_end[:3, :3])

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        share = s / self.duration
        T = np.eye(4)
        T[:3, :3] = self.T_world_start[:3, :3] @ rotation.exponential(share * self.rotation)
        T[:3, 3] = (1 - share) * self.T_world_start[:3, 3] + share * self.T_world_end[:3, 3]
        return T

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's origin (6,), m/s and rad/s, world axes; constant: ω = R₀ w / T."""
        way = self.T_world_end[:3, 3] - self.T_world_start[:3, 3]
        return np.append(way, self.T_world_start[:3, :3] @ self.rotation) / self.duration


@dataclass(frozen=True, eq=False)
class ScrewPath(PosePath):
    """Screw motion with rotation by at most π (ScLERP): M = M₀ exp(σ log(M₀* M₁)), σ = s / T.

    Source: Kavan et al. 2008.
    """

    @cached_property
    def start(self) -> Array:
        """M₀ (16,)."""
        return rigid.motor_from_pose(self.T_world_start)

    @cached_property
    def log(self) -> Array:
        """log(M₀* M₁) (16,), in the axes of the start: v + εu, half the rotation and half the motion of its origin."""
        return motor.log(CL031.product(CL031.conjugate(self.start), rigid.motor_from_pose(self.T_world_end)))

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        share = np.asarray(s / self.duration)
        return rigid.pose_from_motor(CL031.product(self.start, motor.exp(share * self.log)))

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes: 2 (R u, R v) / T, constant in its own axes."""
        R = self.pose(s)[:3, :3]
        v, u = rigid.direction_and_moment(self.log)
        return np.append(R @ u, R @ v) * (2 / self.duration)
