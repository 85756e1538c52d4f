"""Inverse kinematics: what an arm may do (Problem), where a wish leads (Goal), and the guarded step that gets there."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from helicoide.confinement import Planes, Zones
from helicoide.kinematics.chain import Array, Chain, frozen
from helicoide.kinematics.robot import Robot

NOTICEABLE = 0.02


@dataclass(frozen=True, eq=False)
class Limits:
    """Joint limits, (n,) each: lower and upper, rad; speed, rad/s."""

    lower: Array
    upper: Array
    speed: Array


@dataclass(frozen=True, eq=False)
class Problem:
    """What an arm may do here: its geometry, its limits, the planes around it.

    scale: the characteristic length ℓ, m, where it is not the arm's reach: weights, gains and damping depend on it.
    """

    robot: Robot
    limits: Limits
    planes: Planes
    zones: Zones = field(default_factory=Zones)
    scale: float | None = None

    @property
    def length(self) -> float:
        """The characteristic length ℓ, m."""
        return self.robot.reach if self.scale is None else self.scale

    @cached_property
    def joint_units(self) -> Array:
        """What a rate without unit stands for in each joint, (n,): 1 rad, or ℓ where it slides."""
        return frozen([self.length if joint.slides else 1.0 for joint in self.robot.variables])

    @cached_property
    def arm(self) -> tuple[Chain, Array, NDArray[np.int64]]:
        """Moving axes, guarded points, links that carry them: what the kernels know of the robot."""
        return self.robot.chain, self.robot.guarded_points, self.robot.guarded_joints

    @cached_property
    def limit_arrays(self) -> tuple[Array, Array, Array]:
        """Lower, upper and speed, for the kernels."""
        return self.limits.lower, self.limits.upper, self.limits.speed

    @cached_property
    def plane_arrays(self) -> tuple[Array, Array, float]:
        """Normals, offsets and the critical distance, for the kernels."""
        return self.planes.normals, frozen(self.planes.offsets), self.zones.critical


@dataclass(frozen=True)
class Contact:
    """A guarded point held at the critical distance by a plane; numbers as in the robot and its planes."""

    plane: int
    point: int


@dataclass(frozen=True)
class AtLimit:
    """A joint held by its position limit."""

    joint: int


Reason = Contact | AtLimit


def reasons(problem: Problem, q: Array, multipliers: Array, pull: float) -> tuple[Reason, ...]:
    """What held a guarded step back at q: planes first, then joint limits, the hardest of each kind first.

    A row that carries less than `NOTICEABLE` of the task's pull does not count: a stretched arm rests on the limit of
    its elbow without being held by it.
    """
    n, k = len(q), len(problem.planes.normals)
    order = [int(row) for row in np.argsort(-multipliers) if multipliers[row] > NOTICEABLE * pull]
    contacts = [Contact((row - 2 * n) % k, (row - 2 * n) // k) for row in order if row >= 2 * n]
    room = np.concatenate((q - problem.limits.lower, problem.limits.upper - q))
    return (*contacts, *(AtLimit(row % n) for row in order if row < 2 * n and room[row] < 1e-4))
