"""A recording in memory: the joints over time, and what was around the arm."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.confinement import Planes
from helicoide.recorder.recorded_arm import RecordedArm
from helicoide.text import Text

Value = TypeVar("Value")


@dataclass(frozen=True, eq=False)
class JointSamples:
    """Joint values q (k, n) and velocities (k, n), rad or m, rad/s or m/s, at increasing times (k,), s.

    Velocities are NaN where the file gives none.
    """

    times: Array
    q: Array
    velocities: Array

    def q_at(self, time: float) -> Array:
        """The joint values (n,) at a time, s, by linear interpolation; those at the ends outside."""
        return np.array([np.interp(time, self.times, column) for column in self.q.T])

    def taken(self, columns: NDArray[np.intp]) -> JointSamples:
        """The same samples with other columns, such as another order of the joints."""
        return JointSamples(self.times, self.q[:, columns], self.velocities[:, columns])


@dataclass(frozen=True, eq=False)
class Recording:
    """What a file contains. Times are in s from its first sample; poses are position, m, and wxyz, (k, 7).

    setpoints: what was sent to the joints, where `samples` are read back; tool, target: poses of the samples, NaN where
    the file gives none; planes, gripper, methods, statuses: each with the time from which it holds; notes: sentences on
    how the file was read.
    """

    title: str
    arm: RecordedArm
    samples: JointSamples
    setpoints: JointSamples | None = None
    tool: Array | None = None
    target: Array | None = None
    planes: tuple[tuple[float, Planes], ...] = ()
    gripper: tuple[tuple[float, float], ...] = ()
    methods: tuple[tuple[float, str], ...] = ()
    statuses: tuple[tuple[float, Text], ...] = ()
    notes: tuple[Text, ...] = ()

    @property
    def duration(self) -> float:
        """The time of the last sample, s."""
        return float(self.samples.times[-1])

    def planes_at(self, time: float) -> Planes | None:
        """The planes at a time, s; None if the file has none."""
        return holding_at(self.planes, time)

    def gripper_at(self, time: float) -> float:
        """The opening of the gripper at a time, s, 0 closed to 1 open; 0 if the file does not say."""
        return holding_at(self.gripper, time) or 0.0

    def status_at(self, time: float) -> Text | None:
        """The status of the arm at a time, s; None if the file has none."""
        return holding_at(self.statuses, time)


def holding_at(changes: Sequence[tuple[float, Value]], time: float) -> Value | None:
    """The value that holds at a time, s: the last of values with increasing times that is not later, else None."""
    count = bisect_right(changes, time, key=itemgetter(0))
    return changes[count - 1][1] if count else None
