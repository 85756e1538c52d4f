"""The interfaces of paths: pose of a target, or joint values, by a parameter in seconds, with exact derivatives."""

from __future__ import annotations

from math import isfinite
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.text import HelicoideError, Text

# Nodes and weights of Gauss and Legendre on [−1, 1].
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class Path(Protocol):
    """A path of the target: its parameter s runs from 0 to `duration`, s."""

    @property
    def duration(self) -> float:
        """How long it takes, s."""

    @property
    def is_closed(self) -> bool:
        """Whether it ends in the pose in which it begins."""

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's origin, (6,), m/s and rad/s, world axes; at a corner that of the following piece."""


class JointPath(Protocol):
    """A path of all joints: its parameter s runs from 0 to `duration`, s."""

    @property
    def duration(self) -> float:
        """How long it takes, s."""

    @property
    def is_closed(self) -> bool:
        """Whether it ends with the joint values with which it begins."""

    def q(self, s: float) -> Array:
        """Joint values (n,), rad or m."""

    def rates(self, s: float) -> Array:
        """dq/ds (n,), rad/s or m/s; at a corner that of the following piece."""


class SmoothJointPath(JointPath, Protocol):
    """A path of all joints without corners; each function takes an array of parameters (...) and returns (..., n)."""

    @property
    def knots(self) -> Array:
        """Parameters at which the second derivative may have a kink or a jump, with both ends, ascending, (k,), s."""

    def q(self, s: ArrayLike) -> Array:
        """Joint values (..., n), rad or m."""

    def rates(self, s: ArrayLike) -> Array:
        """dq/ds (..., n), rad/s or m/s."""

    def accelerations(self, s: ArrayLike) -> Array:
        """d²q/ds² (..., n), rad/s² or m/s²."""


def wrapped_parameter(path: Path | JointPath, s: float) -> float:
    """A parameter brought into [0, duration], s: a closed path repeats, an open one stays at its ends."""
    return s % path.duration if path.is_closed else min(max(s, 0.0), path.duration)


def path_length(path: Path, pieces: int = 64) -> float:
    """Length of the path of the target's origin, m: ∫ ‖v‖ ds, by Gauss-Legendre quadrature with eight nodes a piece.

    It is exact to rounding if no corner lies inside a piece.
    """
    half = path.duration / pieces / 2
    middles = half * (2 * np.arange(pieces) + 1)
    speeds = [[np.linalg.norm(path.twist(float(s))[:3]) for s in middle + half * _NODES] for middle in middles]
    return float(half * np.sum(np.array(speeds) @ _WEIGHTS))


def checked_duration(duration: float) -> float:
    """The duration, s; raises HelicoideError unless it is a positive number."""
    if not (isfinite(duration) and duration > 0):
        raise HelicoideError(
            Text(
                en="The duration of a path must be a positive number of seconds, not {duration:g}.",
                pt_BR="A duração de uma trajetória deve ser um número positivo de segundos, não {duration:g}.",
            ).format(duration=duration)
        )
    return duration
