"""Functions of all closed forms: θ of A cos θ + B sin θ = C, final Newton steps, and equality of postures: kernels."""

from __future__ import annotations

from functools import lru_cache
from math import atan2, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.descent import descend
from helicoide.ik.postures.errors import COLUMNS, goal_of
from helicoide.ik.postures.listing import wrapped_angle
from helicoide.ik.postures.measure import Stand, measured, remains
from helicoide.ik.postures.packed import LANES, PERIOD, WIDTH, behind_joints, search_of, wide
from helicoide.kernels import kernel, kernel_into
from helicoide.kinematics.robot import Robot

# The largest error of a posture without polishing, m and rad, and the largest number of steps; sines, or lengths in m,
# below which an angle is free; the fraction of its largest value by which a radicand may be negative; postures nearer
# than MERGED, rad, are equal.
EXACT, STEPS = 1e-12, 5
FREE, ROUNDING, MERGED = 1e-10, 1e-12, 1e-5


@kernel_into
def linear(A: float, B: float, C: float, kept: float) -> tuple[int, float, float]:
    """The number of θ of A cos θ + B sin θ = C, and both, rad: Atan2(B, A) ± Atan2(√(A² + B² − C²), C).

    One, `kept`, rad, where every θ is a solution.
    """
    size = A * A + B * B
    if size < FREE * FREE:
        return int(abs(C) < FREE), kept, kept
    radicand = size - C * C
    if radicand < -ROUNDING * size:
        return 0, kept, kept
    middle, aside = atan2(B, A), atan2(sqrt(max(radicand, 0.0)), C)
    return 2, middle + aside, middle - aside


@lru_cache(maxsize=64)
def polisher(robot: Robot) -> Array:
    """A robot packed for `polished`, (k, 12): the table of a search without limits and periods.

    The rows of `measure.measured` come after it.
    """
    ranges, links = wide(robot), measured(robot)
    ranges[:, PERIOD] = 0.0
    wider = ((0, 0), (0, WIDTH - links.shape[1]))
    return np.concatenate([search_of(robot, ranges, 1.0, (EXACT, EXACT), STEPS, 1).table, np.pad(links, wider)])


@kernel_into
def polished(table: Array, T_world_tool: Array, goal: Stand, q: Array) -> float:
    """The error of a posture, the larger of m and rad, after Newton's steps, which change q in place.

    The steps are needed where axes meet or are parallel only approximately.
    Args: table of `polisher`; T_world_tool (4, 4), m; goal: its `measure.stand_of`; q (n,), rad.
    """
    links = table[behind_joints(table) + q.shape[0] :]
    missed, turned = remains(links, q, goal)
    if max(missed, turned) > EXACT:
        polish(table, T_world_tool, q)
        missed, turned = remains(links, q, goal)
    return max(missed, turned)


@kernel
def polish(table: Array, T_world_tool: Array, q: Array) -> None:
    """Newton's steps, which change q in place; arguments as in `polished`."""
    descend(table, goal_of(table, T_world_tool), q, np.zeros((COLUMNS + q.shape[0], LANES)))


@kernel_into
def is_known(rows: Array, k: int, q: Array) -> bool:
    """Whether one of the first k rows equals the posture q (n,), rad, up to `MERGED` and full turns."""
    for i in range(k):
        j = 0
        while j < q.shape[0] and abs(wrapped_angle(rows[i, j] - q[j])) < MERGED:
            j += 1
        if j == q.shape[0]:
            return True
    return False
