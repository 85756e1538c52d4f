"""The paths of the source's simulations and of its first experiment: S1 to S4 and E1.

From its start T_0 = (p_0, R_0) the tool moves by d(t) in the axes of T_0 and rotates by φ(t) about its x axis:
T_d = (p_0 + R_0 d, R_0 Rot(x, φ)). Source: Coutinho 2015, §4.1, §4.2.1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import cos, pi, sin
from types import MappingProxyType

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.rcm.follow import RcmReference
from helicoide.ik.rcm.passage import SLIT, TROCAR

A = 0.03
OMEGA = 2 * pi / 200
# Sampling time of the experiment, s: 5000 samples took 45 s.
SAMPLE = 0.009
# A path is closed if the entries of its first and last pose differ by less than this, m for the position.
CLOSES = 1e-9


@dataclass(frozen=True, eq=False)
class Way:
    """A point of a path: d and ḋ (3,), m and m/s; turn, turn_rate: φ and φ̇, rad and rad/s; v_rd (2,), m/s."""

    d: tuple[float, float, float] = (0.0, 0.0, 0.0)
    d_rate: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turn: float = 0.0
    turn_rate: float = 0.0
    entry_rate: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, eq=False)
class RcmPath:
    """A path of the source as a function of time, its duration, s, and the forbidden directions `across`, (r, 3)."""

    way: Callable[[float], Way]
    duration: float
    across: Array

    def task(self, T_world_start: Array) -> Callable[[float], RcmReference]:
        """The reference as a function of time, s, for a tool that starts at T_0 (4, 4), m."""
        R, p = T_world_start[:3, :3], T_world_start[:3, 3]

        def at(t: float) -> RcmReference:
            way = self.way(t)
            target = np.eye(4)
            target[:3, :3] = R @ _about_x(way.turn)
            target[:3, 3] = p + R @ way.d
            ahead = np.concatenate([R @ way.d_rate, way.turn_rate * R[:, 0]])
            return RcmReference(target, ahead, np.array(way.entry_rate[: len(self.across)]))

        return at

    def of(self, T_world_start: Array) -> OfTool:
        """The path of a tool that starts at T_0 (4, 4), m, without the velocity of the entry point."""
        return OfTool(self, T_world_start)


@dataclass(frozen=True, eq=False)
class OfTool:
    """A path of the source as a `trajectory.path.Path`, for a tool that starts at T_0 (4, 4), m."""

    path: RcmPath
    T_world_start: Array

    @property
    def duration(self) -> float:
        """Duration, s."""
        return self.path.duration

    @property
    def is_closed(self) -> bool:
        """Whether the path ends at its initial pose: S1 to S4 do, E1 does not."""
        return bool(np.abs(self.pose(self.duration) - self.pose(0.0)).max() < CLOSES)

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        return self.path.task(self.T_world_start)(s).T_world_target

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes."""
        return self.path.task(self.T_world_start)(s).feedforward


def _about_x(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


def s1(t: float) -> Way:
    """d = (½A sin ωt, 2.2A cos 2ωt − 2.2A, A sin 2ωt): withdrawal by 132 mm. Source: Coutinho 2015, eq. 4.1."""
    w = OMEGA
    return Way(
        (0.5 * A * sin(w * t), 2.2 * A * (cos(2 * w * t) - 1), A * sin(2 * w * t)),
        (0.5 * A * w * cos(w * t), -4.4 * A * w * sin(2 * w * t), 2 * A * w * cos(2 * w * t)),
    )


def s2(t: float) -> Way:
    """d = (½A sin ωt, −2A sin(3ωt − π/2) − 2A, ½A sin 2ωt). Source: Coutinho 2015, eq. 4.2."""
    w = OMEGA
    return Way(
        (0.5 * A * sin(w * t), 2 * A * (cos(3 * w * t) - 1), 0.5 * A * sin(2 * w * t)),
        (0.5 * A * w * cos(w * t), -6 * A * w * sin(3 * w * t), A * w * cos(2 * w * t)),
    )


def s3(t: float) -> Way:
    """d = (0, 0.9A sin(ωt − π/2) + 0.9A, 0), φ = −π/8 sin ωt: crosses θ₇ = 0. Source: Coutinho 2015, eqs. 4.3, 4.4."""
    w = OMEGA
    return Way(
        (0.0, 0.9 * A * (1 - cos(w * t)), 0.0),
        (0.0, 0.9 * A * w * sin(w * t), 0.0),
        -pi / 8 * sin(w * t),
        -pi / 8 * w * cos(w * t),
    )


def s4(t: float) -> Way:
    """As S2, while the entry point moves: v_rd = 5 (sin 3ωt, −sin 3ωt) mm/s. Source: Coutinho 2015, eqs. 4.5, 4.6."""
    way, v = s2(t), 0.005 * sin(3 * OMEGA * t)
    return Way(way.d, way.d_rate, entry_rate=(v, -v))


def e1(t: float) -> Way:
    """d = (30 mm sin ωk, 0, 0), φ = π/18 (cos ωk − 1), v_rd = (10 mm/s sin 8ωk, 0), ωk = 2π/7000 k, k = t / 9 ms.

    Source: Coutinho 2015, §4.2.1, with ω in rad per sample.
    """
    w = 2 * pi / 7000 / SAMPLE
    return Way(
        (0.03 * sin(w * t), 0.0, 0.0),
        (0.03 * w * cos(w * t), 0.0, 0.0),
        pi / 18 * (cos(w * t) - 1),
        -pi / 18 * w * sin(w * t),
        (0.01 * sin(8 * w * t), 0.0),
    )


PATHS: Mapping[str, RcmPath] = MappingProxyType(
    {
        "S1": RcmPath(s1, 200.0, SLIT),
        "S2": RcmPath(s2, 200.0, TROCAR),
        "S3": RcmPath(s3, 200.0, TROCAR),
        "S4": RcmPath(s4, 200.0, TROCAR),
        "E1": RcmPath(e1, 45.0, TROCAR),
    }
)
