"""The work space of a step, one array that is made once: what it comes to, and room for what is found on the way."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard import qp
from helicoide.ik.guard.collision import WATCHED
from helicoide.ik.guard.packed import CRITICAL, SETTING, At, array_parts
from helicoide.ik.guard.rows import BOX
from helicoide.kernels import kernel_into, python_function

SHARE, PULL, REPORT = 0, 1, 2
# Rows of the table of what each variable has: its box first, then these, J, the rows that bound it, and last H and g.
SOLUTION, BEFORE, REACHED, STOOD, DAMPING, JACOBIAN = range(BOX, BOX + 6)
ROWS = JACOBIAN + 6


class StepBuffers(NamedTuple):
    """An opened work space.

    report: the share and the pull; rates (n,) and held as in `Work`; task (2, 6): v and its weights; bounds (4, n + r):
    lower, upper, multipliers, and room for these; spare: room for `qp`; frames (2, m + 1, 4, 4): the links before and
    after the step; spots: rows of four numbers each, axes, points and distances; table: rows of n numbers each.
    """

    report: Array
    rates: Array
    held: Array
    task: Array
    bounds: Array
    spare: Array
    frames: Array
    spots: Array
    table: Array


@dataclass(frozen=True, eq=False)
class Work:
    """A work space, and what the last step came to.

    memory: all of it, as kernels take it; rates (n,): q̇ of the step, rad/s or m/s, read by the next one; poses
    (m + 1, 4, 4), m, of the links after it; held: the multipliers of what held it back, 2 n position limits,
    clearances, 2 n speed limits, 2 n accelerations, the entry point.
    """

    memory: Array
    rates: Array
    poses: Array
    held: Array

    @property
    def share(self) -> float:
        """The part of the step that was taken, 1 but where something would have come too near."""
        return float(self.memory[SHARE])

    @property
    def pull(self) -> float:
        """How hard the task pulled: ‖W v‖."""
        return float(self.memory[PULL])


@kernel_into
def most_rows(at: At) -> int:
    """How many rows may bound a step besides the joints' own: clearances, and second witnesses of pairs."""
    return at.clearances + at.end - at.pairs


@kernel_into
def row_counts(at: At) -> tuple[int, int, int, int, int, int, int, int, int]:
    """How many numbers each part of a work space has, in the order of `StepBuffers`."""
    m, n, rows, points = at.m, at.n, most_rows(at), at.planes - at.points
    spots = 2 * m + points + 2 * at.clearances + max(m + 1, n)
    held, table = 6 * n + at.clearances + 1, ROWS + rows + n + 1
    return REPORT, n, held, 12, 4 * (n + rows), qp.room(n), 32 * (m + 1), WATCHED * spots, n * table


@kernel_into
def opened(memory: Array, at: At) -> StepBuffers:
    """The parts of a work space."""
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
    """A work space for the steps of a packed arm, which is at rest before the first."""
    blank, at, held, frames = _blank(tuple(arm[SETTING, :CRITICAL].tolist()))
    memory = blank.copy()
    poses = memory[frames : frames + 16 * (at.m + 1)].reshape(at.m + 1, 4, 4)
    return Work(memory, memory[REPORT:held], poses, memory[held : held + 6 * at.n + at.clearances + 1])


@lru_cache(maxsize=64)
def _blank(counts: tuple[float, ...]) -> tuple[Array, At, int, int]:
    """The memory of an arm of so many parts before its first step, and where in it `held` and `frames` begin."""
    setting = np.zeros((1, CRITICAL))
    setting[SETTING] = counts
    at = python_function(array_parts)(setting)
    many = python_function(row_counts)(at)
    memory = np.zeros(sum(many))
    room = python_function(opened)(memory, at)
    room.table[STOOD], room.frames[:, :, 3, 3] = np.nan, 1.0
    return memory, at, sum(many[:2]), sum(many[:6])


@kernel_into
def parts_of_spots(at: At) -> tuple[int, int, int, int]:
    """Where in `spots` parts begin: points, what is watched, the same after the step, and room for the rows.

    The axes stand first, those before the step and those after it. Of a point there are its place and `unfelt`. Room is
    for one row of each link or variable.
    """
    points = 2 * at.m
    near = points + at.planes - at.points
    return points, near, near + at.clearances, near + 2 * at.clearances
