"""The work space of a step: one array, allocated once, for its results and temporary values."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.cascade import level_buffer_size
from helicoide.ik.guard.collision import WATCHED
from helicoide.ik.guard.packed import CRITICAL, SETTING, At, array_parts
from helicoide.ik.guard.rows import BOX
from helicoide.kernels import kernel_into, python_function

SHARE, PULL, REPORT = 0, 1, 2
# Rows of `StepBuffers.table`: the bounds of `rows.MotionBox`, then these, the other rows of J, and the constraints.
SOLUTION, BEFORE, REACHED, STOOD, DAMPING, JACOBIAN = range(BOX, BOX + 6)
ROWS = JACOBIAN + 6


class StepBuffers(NamedTuple):
    """The parts of a work space.

    report: share and pull as in `Work`; rates (n,) and multipliers as in `Work`; task (2, 6): v and its weights; bounds
    (4, n + r): lower, upper, multipliers, and a copy of the multipliers; spare: temporary values of
    `cascade.first_level`; frames (2, m + 1, 4, 4): link poses before and after the step; points: rows of four numbers,
    axes, points and clearances (see `parts_of_points`); table: rows of n numbers.
    """

    report: Array
    rates: Array
    multipliers: Array
    task: Array
    bounds: Array
    spare: Array
    frames: Array
    points: Array
    table: Array


@dataclass(frozen=True, eq=False)
class Work:
    """A work space, with the results of the last step.

    memory: the whole array, for the kernels; rates (n,): q̇ of the step, rad/s or m/s, read by the next one; poses
    (m + 1, 4, 4), m, of the links after it; multipliers: those of the constraints: 2 n position limits, clearances,
    2 n speed limits, 2 n accelerations, the entry point.
    """

    memory: Array
    rates: Array
    poses: Array
    multipliers: Array

    @property
    def share(self) -> float:
        """The fraction of the step that was taken: less than 1 if the whole step would violate a constraint."""
        return float(self.memory[SHARE])

    @property
    def pull(self) -> float:
        """The weighted size of the task, ‖W v‖."""
        return float(self.memory[PULL])


@kernel_into
def most_rows(at: At) -> int:
    """The largest number of constraint rows besides the joint bounds: clearances, and second witnesses of pairs."""
    return at.clearances + at.end - at.pairs


@kernel_into
def row_counts(at: At) -> tuple[int, int, int, int, int, int, int, int, int]:
    """The size of each part of a work space, in the order of `StepBuffers`."""
    m, n, rows, points = at.m, at.n, most_rows(at), at.planes - at.points
    spots = 2 * m + points + 2 * at.clearances + max(m + 1, n)
    held, spare = 6 * n + at.clearances + 1, level_buffer_size(n)
    return REPORT, n, held, 12, 4 * (n + rows), spare, 32 * (m + 1), WATCHED * spots, n * (ROWS + rows)


@kernel_into
def opened(memory: Array, at: At) -> StepBuffers:
    """The parts of a work space, as views of its memory."""
    report, rates, held, task, bounds, spare, frames, spots, table = row_counts(at)
    a = report + rates
    b = a + held
    c = b + task
    d = c + bounds
    e = d + spare
    f = e + frames
    g = f + spots
    return StepBuffers(
        memory[:report],
        memory[report:a],
        memory[a:b],
        memory[b:c].reshape(2, 6),
        memory[c:d].reshape(4, bounds // 4),
        memory[d:e],
        memory[e:f].reshape(2, at.m + 1, 4, 4),
        memory[f:g].reshape(spots // WATCHED, WATCHED),
        memory[g : g + table].reshape(table // at.n, at.n),
    )


def work_for(arm: Array) -> Work:
    """A work space for the steps of a packed arm, which starts at rest."""
    blank, at, held, frames = _blank(tuple(arm[SETTING, :CRITICAL].tolist()))
    memory = blank.copy()
    poses = memory[frames : frames + 16 * (at.m + 1)].reshape(at.m + 1, 4, 4)
    return Work(memory, memory[REPORT:held], poses, memory[held : held + 6 * at.n + at.clearances + 1])


@lru_cache(maxsize=64)
def _blank(counts: tuple[float, ...]) -> tuple[Array, At, int, int]:
    """The initial memory of an arm with these counts, its parts, and where multipliers and `frames` begin in it."""
    setting = np.zeros((1, CRITICAL))
    setting[SETTING] = counts
    at = python_function(array_parts)(setting)
    many = python_function(row_counts)(at)
    memory = np.zeros(sum(many))
    room = python_function(opened)(memory, at)
    room.table[STOOD], room.frames[:, :, 3, 3] = np.nan, 1.0
    return memory, at, sum(many[:2]), sum(many[:6])


@kernel_into
def parts_of_points(at: At) -> tuple[int, int, int, int]:
    """The first rows of the parts of `spots`: points, watched clearances, the same after the step, temporary rows.

    Before them are the joint axes, m before the step and m after it. A point has its position and `rows.FAR`. There is
    one temporary row for each link or variable.
    """
    points = 2 * at.m
    near = points + at.planes - at.points
    return points, near, near + at.clearances, near + 2 * at.clearances
