"""Paths of the joints: a straight move, a spline through samples, and the tool as either carries it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.path import JointPath, lasting


@dataclass(frozen=True, eq=False)
class JointMove:
    """All joints evenly from one posture to another: q = q₀ + σ (q₁ − q₀), σ = s / T.

    Args: start, end (n,), rad or m; duration T, s.
    """

    start: Array
    end: Array
    duration: float

    def __post_init__(self) -> None:
        lasting(self.duration)

    @property
    def is_closed(self) -> bool:
        """Whether it stays in one posture."""
        return np.array_equal(self.start, self.end)

    @property
    def knots(self) -> Array:
        """Its ends, (2,), s."""
        return np.array([0.0, self.duration])

    def q(self, s: ArrayLike) -> Array:
        """Joint values (..., n), rad or m, at any array of parameters (...)."""
        share, way = np.asarray(s, dtype=float)[..., None] / self.duration, self.end - self.start
        # from the nearer end: so both are met exactly, and an arm that stays does not tremble
        return np.where(share < 0.5, self.start + share * way, self.end - (1 - share) * way)

    def rates(self, s: ArrayLike) -> Array:
        """dq/ds (..., n), rad/s or m/s: the same all the way."""
        return np.broadcast_to((self.end - self.start) / self.duration, (*np.shape(s), len(self.start)))

    def accelerations(self, s: ArrayLike) -> Array:
        """d²q/ds² (..., n), rad/s² or m/s²: none."""
        return np.zeros((*np.shape(s), len(self.start)))


@dataclass(frozen=True, eq=False)
class Carried:
    """The path of the tool while the joints go theirs: T = FK(q(s)), (v, ω) = J(q) dq/ds."""

    robot: Robot
    joints: JointPath

    @property
    def duration(self) -> float:
        """That of the joints' path, s."""
        return self.joints.duration

    @cached_property
    def is_closed(self) -> bool:
        """Whether the joints end where they begin."""
        return self.joints.is_closed

    def pose(self, s: float) -> Array:
        """T_world_tool (4, 4), m."""
        return tool_at(self.robot, self.joints.q(s))

    def twist(self, s: float) -> Array:
        """(v, ω) of the tool's point (6,), m/s and rad/s, world axes."""
        chain = self.robot.chain
        poses = link_poses(chain, frozen(self.joints.q(s)))
        point = (poses[-1] @ self.robot.T_link_tool)[:3, 3].copy()
        J = jacobian.geometric(poses, chain, jacobian.joint_axes(poses, chain), point, len(chain))
        return np.asarray(J @ self.joints.rates(s))


def tool_at(robot: Robot, q: Array) -> Array:
    """T_world_tool (4, 4), m, in a posture (n,)."""
    return np.asarray(link_poses(robot.chain, frozen(q))[-1] @ robot.T_link_tool)
