"""Time scaling: the share σ of a path as a function of the share u of the time, and paths with a time scaling."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.trajectory.path import Path, SmoothJointPath, checked_duration

AnyPath = TypeVar("AnyPath", Path, SmoothJointPath)
# Shares of time in the table that inverts a law.
_TABLE = np.linspace(0, 1, 2001)


class TimeScaling(Protocol):
    """A time scaling: σ(0) = 0, σ(1) = 1, σ is monotonic."""

    @property
    def corners(self) -> tuple[float, ...]:
        """Shares of time, from 0 to 1, between which σ is smooth."""

    def at(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        """σ, dσ/du and d²σ/du² at any array of shares of time u in [0, 1], each (...)."""


@dataclass(frozen=True)
class ConstantSpeed:
    """Constant speed, σ = u: it starts and stops with a jump of velocity."""

    @property
    def corners(self) -> tuple[float, ...]:
        """Its ends."""
        return 0.0, 1.0

    def at(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        """σ = u and its derivatives."""
        share = np.asarray(u, dtype=float)
        return share, np.ones_like(share), np.zeros_like(share)


@dataclass(frozen=True)
class TrapezoidalVelocity:
    """Trapezoidal velocity, with constant acceleration and deceleration: σ' = k min(u, β, 1 − u), k = 1/(β (1 − β)).

    ramp: β, the share of time for acceleration, and also for deceleration, at most one half.
    """

    ramp: float

    @property
    def corners(self) -> tuple[float, ...]:
        """Its ends, and those of the ramps."""
        return 0.0, self.ramp, 1 - self.ramp, 1.0

    def at(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        """σ and its derivatives; at a corner those of the following piece."""
        share, b = np.asarray(u, dtype=float), self.ramp
        k = 1 / (b * (1 - b))
        left, rising, even = 1 - share, share < b, share < 1 - b
        so_far = np.where(rising, k * share**2 / 2, np.where(even, k * b * (share - b / 2), 1 - k * left**2 / 2))
        speed = k * np.minimum(np.minimum(share, left), b)
        return so_far, speed, k * np.where(rising, 1.0, np.where(even, 0.0, -1.0))


@dataclass(frozen=True)
class MinimumJerk:
    """Minimum jerk from rest to rest: σ = 10 u³ − 15 u⁴ + 6 u⁵. Source: Flash and Hogan 1985."""

    @property
    def corners(self) -> tuple[float, ...]:
        """Its ends."""
        return 0.0, 1.0

    def at(self, u: ArrayLike) -> tuple[Array, Array, Array]:
        """σ and its derivatives, 30 u² (1 − u)² and 60 u (1 − u) (1 − 2u)."""
        x = np.asarray(u, dtype=float)
        y = 1 - x
        return x**3 * (10 - 15 * x + 6 * x**2), 30 * (x * y) ** 2, 60 * x * y * (y - x)


@dataclass(frozen=True, eq=False)
class ScaledPath(Generic[AnyPath]):
    """A path under a time scaling: s = L σ(t / T), L the duration of the path, T its own, s."""

    path: AnyPath
    law: TimeScaling
    duration: float

    def __post_init__(self) -> None:
        checked_duration(self.duration)

    @property
    def is_closed(self) -> bool:
        """Whether the path is."""
        return self.path.is_closed

    def parameter_at(self, t: ArrayLike) -> tuple[Array, Array, Array]:
        """Parameter of the path, and its first and second time derivatives, at times t (...), s, clipped to [0, T]."""
        length, duration = self.path.duration, self.duration
        share, rate, change = self.law.at(np.clip(np.asarray(t, dtype=float) / duration, 0.0, 1.0))
        return length * share, rate * (length / duration), change * (length / duration**2)


@dataclass(frozen=True, eq=False)
class TimedPath(ScaledPath[Path]):
    """A path of the target under a time scaling."""

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        along, _, _ = self.parameter_at(s)
        return self.path.pose(float(along))

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes."""
        along, rate, _ = self.parameter_at(s)
        return np.asarray(rate * self.path.twist(float(along)))


@dataclass(frozen=True, eq=False)
class TimedJoints(ScaledPath[SmoothJointPath]):
    """A path of the joints under a time scaling: q̇ = q' ṡ, q̈ = q' s̈ + q'' ṡ²."""

    @property
    def knots(self) -> Array:
        """Times at which the acceleration may have a kink or a jump, s: corners of the law and knots of the path."""
        passes = np.interp(self.path.knots / self.path.duration, self.law.at(_TABLE)[0], _TABLE)
        return self.duration * np.unique(np.append(passes, self.law.corners))

    def q(self, s: ArrayLike) -> Array:
        """Joint values (..., n), rad or m."""
        along, _, _ = self.parameter_at(s)
        return self.path.q(along)

    def rates(self, s: ArrayLike) -> Array:
        """dq/dt (..., n), rad/s or m/s."""
        along, rate, _ = self.parameter_at(s)
        return np.asarray(rate[..., None] * self.path.rates(along))

    def accelerations(self, s: ArrayLike) -> Array:
        """d²q/dt² (..., n), rad/s² or m/s²."""
        along, rate, change = self.parameter_at(s)
        first, second = self.path.rates(along), self.path.accelerations(along)
        return np.asarray(change[..., None] * first + rate[..., None] ** 2 * second)
