"""A joint move, and the tool pose in a posture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.path import checked_duration


@dataclass(frozen=True, eq=False)
class JointMove:
    """Joint move: all joints at constant velocity from one posture to another, q = q₀ + σ (q₁ − q₀), σ = s / T.

    Args: start, end (n,), rad or m; duration T, s.
    """

    start: Array
    end: Array
    duration: float

    def __post_init__(self) -> None:
        checked_duration(self.duration)

    @property
    def is_closed(self) -> bool:
        """Whether it ends in the posture where it begins."""
        return np.array_equal(self.start, self.end)

    @property
    def knots(self) -> Array:
        """Its ends, (2,), s."""
        return np.array([0.0, self.duration])

    def q(self, s: ArrayLike) -> Array:
        """Joint values (..., n), rad or m, at any array of parameters (...)."""
        share, way = np.asarray(s, dtype=float)[..., None] / self.duration, self.end - self.start
        # from the nearer end, so that both ends are exact and a move without motion is constant
        return np.where(share < 0.5, self.start + share * way, self.end - (1 - share) * way)

    def rates(self, s: ArrayLike) -> Array:
        """dq/ds (..., n), rad/s or m/s: constant."""
        return np.broadcast_to((self.end - self.start) / self.duration, (*np.shape(s), len(self.start)))

    def accelerations(self, s: ArrayLike) -> Array:
        """d²q/ds² (..., n), rad/s² or m/s²: zero."""
        return np.zeros((*np.shape(s), len(self.start)))


def tool_pose_in(robot: Robot, q: Array) -> Array:
    """T_world_tool (4, 4), m, for joint values q (n,), rad or m."""
    return np.asarray(link_poses(robot.chain, frozen(q))[-1] @ robot.T_link_tool)
