"""The eleven trajectories of Vargas 2013, App. C: sines and constant velocities along each axis."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import cos, pi, sin
from types import MappingProxyType

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.trajectory.path import checked_duration

# The unit of trajectories 1 to 5, in which the planar arm is 4 long, and of 6 to 11, m.
LENGTH, CM = 1.0, 0.01
UPRIGHT = frozen(np.eye(3))


@dataclass(frozen=True)
class Wave:
    """a sin(ω t + φ), or a cos(ω t + φ): a in the unit of its trajectory, ω in rad/s, φ in rad."""

    amplitude: float
    rate: float
    phase: float = 0.0
    is_cosine: bool = False

    def at(self, t: float) -> float:
        """Value at time t."""
        return self.amplitude * (cos if self.is_cosine else sin)(self.rate * t + self.phase)

    def slope(self, t: float) -> float:
        """Derivative at time t, 1/s."""
        angle = self.rate * t + self.phase
        return self.amplitude * self.rate * (-sin(angle) if self.is_cosine else cos(angle))


@dataclass(frozen=True)
class Coordinate:
    """A coordinate by time: x = x₀ + v t + Σ waves, in the unit of its trajectory."""

    start: float = 0.0
    speed: float = 0.0
    waves: tuple[Wave, ...] = ()

    def at(self, t: float) -> float:
        """x."""
        return self.start + self.speed * t + sum(wave.at(t) for wave in self.waves)

    def rate(self, t: float) -> float:
        """ẋ, 1/s."""
        return self.speed + sum(wave.slope(t) for wave in self.waves)


@dataclass(frozen=True, eq=False)
class VargasTrajectory:
    """A trajectory with the numbers of the source; `unit`: their unit of length, m.

    R_world_target (3, 3): orientation of the tool, if the simulations with this trajectory state one; duration, s: one
    period, or the value of the source.
    """

    x: Coordinate
    y: Coordinate
    z: Coordinate
    unit: float
    duration: float
    R_world_target: Array = field(default_factory=lambda: UPRIGHT)

    def __post_init__(self) -> None:
        checked_duration(self.duration)

    @property
    def is_closed(self) -> bool:
        """Whether it is periodic, that is, without constant velocities."""
        return not any(each.speed for each in (self.x, self.y, self.z))

    def point(self, s: float) -> Array:
        """Position of the target, (3,), m."""
        return self.unit * np.array([self.x.at(s), self.y.at(s), self.z.at(s)])

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = self.R_world_target, self.point(s)
        return T

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes; ω = 0."""
        return np.append(self.unit * np.array([self.x.rate(s), self.y.rate(s), self.z.rate(s)]), np.zeros(3))


def _sine(amplitude: float, rate: float, around: float = 0.0) -> Coordinate:
    return Coordinate(around, waves=(Wave(amplitude, rate),))


def _cosine(amplitude: float, rate: float) -> Coordinate:
    return Coordinate(waves=(Wave(amplitude, rate, is_cosine=True),))


def _two_sines(phase: float, around: float) -> Coordinate:
    """7.5 (sin(0.1π t + φ) + sin(0.15π t + φ)) about a middle: both axes of trajectory 9."""
    return Coordinate(around, waves=(Wave(7.5, 0.1 * pi, phase), Wave(7.5, 0.15 * pi, phase)))


AT_0 = Coordinate()
_WIDE, _HIGH = _cosine(0.5, 0.2), _sine(7.5, 0.1 * pi)
_SLOW = 2 * pi / 0.2
_OVAL = _cosine(7.0, 0.2)

# By number (Vargas 2013, App. C). The tool is turned by R_y(π/2) on 10 and by R_y(π) on 11 (Sims. 3 and 14).
VARGAS: Mapping[int, VargasTrajectory] = MappingProxyType(
    {
        1: VargasTrajectory(_sine(0.5, 0.4, 2.0), _WIDE, AT_0, LENGTH, _SLOW),
        2: VargasTrajectory(_sine(0.5, 0.2, 2.5), _WIDE, AT_0, LENGTH, _SLOW),
        3: VargasTrajectory(Coordinate(2.26, -1 / 11), Coordinate(3.23, -1 / 8), AT_0, LENGTH, 40.0),
        4: VargasTrajectory(AT_0, Coordinate(4.0, -1 / 8), AT_0, LENGTH, 40.0),
        5: VargasTrajectory(_sine(0.5, 0.4, 2.0), Coordinate(1.0), AT_0, LENGTH, _SLOW / 2),
        6: VargasTrajectory(_sine(5.0, 0.2 * pi, 45.86), _HIGH, AT_0, CM, 20.0),
        7: VargasTrajectory(AT_0, _sine(5.0, 0.2 * pi), _sine(7.5, 0.1 * pi, 53.86), CM, 20.0),
        8: VargasTrajectory(_sine(5.0, 0.2 * pi, 63.36), _HIGH, AT_0, CM, 20.0),
        9: VargasTrajectory(Coordinate(60.0), _two_sines(0.0, 5.0), _two_sines(1.6, 0.0), CM, 40.0),
        10: VargasTrajectory(
            _sine(14.6, 0.2, 15.5), _OVAL, Coordinate(20.0), CM, _SLOW, frozen([[0, 0, 1], [0, 1, 0], [-1, 0, 0]])
        ),
        11: VargasTrajectory(
            _sine(14.6, 0.2, 30.5), _OVAL, Coordinate(20.0), CM, _SLOW, frozen(np.diag([-1.0, 1.0, -1.0]))
        ),
    }
)
