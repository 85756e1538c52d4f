"""Searches from postures that are spread evenly over the joint ranges: kernels.

These postures depend only on their numbers, so the same input always has the same result. Shapes are not checked.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.qp import copy_into
from helicoide.ik.postures.descent import descend, joints_at_limits, minimise_error
from helicoide.ik.postures.errors import goal_of
from helicoide.ik.postures.packed import LOWER, SEARCHES, SETTING, STRIDE, UPPER, behind_joints
from helicoide.kernels import kernel_into


@kernel_into
def draw(table: Array, number: int, q: Array) -> None:
    """Write the posture of a number; those of consecutive numbers are spread evenly over the joint ranges.

    Source: Roberts 2018, The unreasonable effectiveness of quasirandom sequences (an additive recurrence).
    """
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        share = 0.5 + number * ranges[i, STRIDE]
        q[i] = ranges[i, LOWER] + (share - np.floor(share)) * (ranges[i, UPPER] - ranges[i, LOWER])


@kernel_into
def begin(table: Array, start: Array, q: Array) -> None:
    """Write the posture nearest to `start` within the limits that the search keeps."""
    ranges = table[behind_joints(table) :]
    for i in range(q.shape[0]):
        q[i] = joints_at_limits(ranges[i], start[i])


@kernel_into
def search(table: Array, T_world_tool: Array, start: Array, buffers: Array, answer: Array) -> None:
    """Write the first posture found: the first search starts at `start`, the others at the postures of `draw`.

    Args: table and room of `packed`; T_world_tool (4, 4), m; start (n,), rad or m. Writes answer (n + 4,): q, rad or m;
    the errors of position, m, and orientation, rad, infinite where nothing was found; the number of steps in all
    searches, and the number of searches.
    """
    n, goal = start.shape[0], goal_of(table, T_world_tool)
    q, total, searches = answer[:n], 0, int(table[SETTING, SEARCHES])
    begin(table, start, q)
    for number in range(1, searches + 1):
        steps, missed, turned = descend(table, goal, q, buffers)
        total += abs(steps)
        if missed < np.inf or number == searches:
            answer[n], answer[n + 1], answer[n + 2], answer[n + 3] = missed, turned, total, number
            break
        draw(table, number, q)


@kernel_into
def approach(table: Array, T_world_tool: Array, start: Array, buffers: Array, answer: Array) -> None:
    """Write the posture (n,) with the smallest e² of several searches, with starts as in `search`.

    Args: answer (3, n): the first row is the posture, the others are temporary.
    """
    best, q, trial = answer[0], answer[1], answer[2]
    goal, least = goal_of(table, T_world_tool), np.inf
    begin(table, start, q)
    for number in range(1, int(table[SETTING, SEARCHES]) + 1):
        left = minimise_error(table, goal, q, trial, buffers)
        if left < 0.999999 * least:
            copy_into(q, best)
            least = left
        draw(table, number, q)
