"""Paths one after another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Generic, TypeVar

import numpy as np

from helicoide.arrays import Array
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.path import JointPath, Path

Piece = TypeVar("Piece", Path, JointPath)
# Where one path ends and the next begins may differ by this much, m, rad, or an entry of a pose.
GAP_TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class PathSequence(Generic[Piece]):
    """Paths of one kind one after another."""

    paths: tuple[Piece, ...]

    @cached_property
    def starts(self) -> Array:
        """When each path begins, and the last ends, (k + 1,), s."""
        return np.cumsum([0.0, *(path.duration for path in self.paths)])

    @property
    def duration(self) -> float:
        """All of them together, s."""
        return float(self.starts[-1])

    def active_path(self, s: float) -> tuple[Piece, float]:
        """The path that runs at s, at a corner the one that follows, and its own parameter then, s."""
        i = min(max(int(np.searchsorted(self.starts, s, side="right")) - 1, 0), len(self.paths) - 1)
        return self.paths[i], s - float(self.starts[i])


@dataclass(frozen=True, eq=False)
class PathChain(PathSequence[Path]):
    """Paths of the target one after another; `chain` makes one of paths that meet."""

    @property
    def is_closed(self) -> bool:
        """Whether the last ends where the first begins."""
        return bool(np.abs(self.pose(self.duration) - self.pose(0.0)).max() <= GAP_TOLERANCE)

    def pose(self, s: float) -> Array:
        """T_world_target (4, 4), m."""
        path, at = self.active_path(s)
        return path.pose(at)

    def twist(self, s: float) -> Array:
        """(v, ω) of the target's point (6,), m/s and rad/s, world axes; at a corner that of what follows."""
        path, at = self.active_path(s)
        return path.twist(at)


@dataclass(frozen=True, eq=False)
class JointPathChain(PathSequence[JointPath]):
    """Paths of the joints one after another; `chain_joint_paths` makes one of paths that meet."""

    @property
    def is_closed(self) -> bool:
        """Whether the last ends where the first begins."""
        return bool(np.abs(self.q(self.duration) - self.q(0.0)).max() <= GAP_TOLERANCE)

    def q(self, s: float) -> Array:
        """Joint values (n,), rad or m."""
        path, at = self.active_path(s)
        return path.q(at)

    def rates(self, s: float) -> Array:
        """dq/ds (n,), rad/s or m/s; at a corner that of what follows."""
        path, at = self.active_path(s)
        return path.rates(at)


def chain_paths(paths: Sequence[Path]) -> PathChain:
    """Paths of the target that meet, one after another; raises HelicoideError where two do not, or without any."""
    _check([(path.pose(0.0), path.pose(path.duration)) for path in paths])
    return PathChain(tuple(paths))


def chain_joint_paths(paths: Sequence[JointPath]) -> JointPathChain:
    """Paths of the joints that meet, one after another; raises HelicoideError where two do not, or without any."""
    _check([(path.q(0.0), path.q(path.duration)) for path in paths])
    return JointPathChain(tuple(paths))


def _check(ends: list[tuple[Array, Array]]) -> None:
    if not ends:
        raise HelicoideError(
            Text(en="A chain needs at least one path.", pt_BR="Uma cadeia precisa de ao menos uma trajetória.")
        )
    for i, ((_, end), (start, _)) in enumerate(pairwise(ends)):
        gap = float(np.abs(start - end).max())
        if gap > GAP_TOLERANCE:
            raise HelicoideError(
                Text(
                    en="Path {n} must begin where path {before} ends; they are {gap:.3g} apart.",
                    pt_BR="A trajetória {n} deve começar onde a trajetória {before} termina; estão a {gap:.3g} uma da "
                    "outra.",
                ).format(n=i + 2, before=i + 1, gap=gap)
            )
