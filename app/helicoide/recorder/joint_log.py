"""Joint values as they come out of a file, and what is left of them: usable, in order, no time twice."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.recorder.recording import JointSamples
from helicoide.text import HelicoideError, Text

MOST_SAMPLES, MOST_JOINTS = 400_000, 64
LARGEST_VALUE = 1e4  # rad or m
TOO_MANY = Text(
    en="it has more than {most} samples, or more than {joints} joints",
    pt_BR="tem mais de {most} amostras, ou mais de {joints} juntas",
).format(most=MOST_SAMPLES, joints=MOST_JOINTS)


@dataclass(eq=False)
class JointLog:
    """Joint values of the named joints in the order of the file: times, ns, q and velocities, rad or m."""

    names: tuple[str, ...]
    ns: list[int] = field(default_factory=list)
    q: list[Array] = field(default_factory=list)
    velocities: list[Array] = field(default_factory=list)

    def add(self, ns: int, q: Sequence[float] | Array, velocities: Sequence[float] | Array = ()) -> None:
        """Take a sample; one without a value for each joint is NaN and left out later. Raises HelicoideError."""
        n = len(self.names)
        if len(self.ns) >= MOST_SAMPLES or n > MOST_JOINTS:
            raise HelicoideError(TOO_MANY)
        self.ns.append(ns)
        self.q.append(_row(q, n))
        self.velocities.append(_row(velocities, n))

    def kept(self) -> NDArray[np.intp]:
        """Which samples are used, in order of time: those with usable joint values, the first of each time."""
        usable = np.abs(np.array(self.q).reshape(len(self.ns), len(self.names))) < LARGEST_VALUE  # not NaN either
        known = np.flatnonzero(usable.all(axis=1))
        _, first = np.unique(np.array(self.ns, dtype=np.int64)[known], return_index=True)
        return known[first]

    def samples(self, start: int) -> JointSamples:
        """The samples that are used, with times in s from `start`, ns."""
        kept = self.kept()
        times = (np.array(self.ns, dtype=np.int64)[kept] - start) / 1e9
        return JointSamples(frozen(times), frozen(np.array(self.q)[kept]), frozen(np.array(self.velocities)[kept]))


def _row(values: Sequence[float] | Array, n: int) -> Array:
    """The values (n,), or NaN if there are more or fewer."""
    row = np.asarray(values, dtype=np.float64)
    return row if row.shape == (n,) else np.full(n, np.nan)
