"""What closed forms share: θ of A cos θ + B sin θ = C, Newton's last steps, whether two postures are one: kernels."""

from __future__ import annotations

from functools import lru_cache
from math import atan2, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.descent import descend
from helicoide.ik.postures.errors import COLUMNS, goal_of
from helicoide.ik.postures.listing import wrapped
from helicoide.ik.postures.measure import Stand, measured, remains
from helicoide.ik.postures.packed import LANES, PERIOD, WIDTH, behind_joints, search_of, wide
from helicoide.kernels import kernel, kernel_into
from helicoide.kinematics.robot import Robot

# What a posture may miss without polish, m and rad, and how many steps there are; sines, or lengths in m, that leave an
# angle free; what rounding takes from a radicand, of its largest value; postures nearer than MERGED, rad, are one.
EXACT, STEPS = 1e-12, 5
FREE, ROUNDING, MERGED = 1e-10, 1e-12, 1e-5


@kernel_into
def linear(A: float, B: float, C: float, kept: float) -> tuple[int, float, float]:
    """How many θ there are of A cos θ + B sin θ = C, and both: Atan2(B, A) ± Atan2(√(A² + B² − C²), C).

    The one kept, rad, where every θ solves it.
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
    """A robot as `polished` takes it, (k, 12): the table of a search without limits, in which no turn is taken back.

    The rows of `measure.measured` stand behind it.
    """
    ranges, links = wide(robot), measured(robot)
    ranges[:, PERIOD] = 0.0
    wider = ((0, 0), (0, WIDTH - links.shape[1]))
    return np.concatenate([search_of(robot, ranges, 1.0, (EXACT, EXACT), STEPS, 1).table, np.pad(links, wider)])


@kernel_into
def polished(table: Array, T_world_tool: Array, goal: Stand, q: Array) -> float:
    """What is left of a pose, the larger of m and rad, after Newton's steps in q: axes may meet inexactly.

    Args: table of `polisher`; T_world_tool (4, 4), m, and the same as `measure.stand_of` gives it; q (n,), rad.
    """
    links = table[behind_joints(table) + q.shape[0] :]
    missed, turned = remains(links, q, goal)
    if max(missed, turned) > EXACT:
        polish(table, T_world_tool, q)
        missed, turned = remains(links, q, goal)
    return max(missed, turned)


@kernel
def polish(table: Array, T_world_tool: Array, q: Array) -> None:
    """Newton's steps in q; arguments as in `polished`."""
    descend(table, goal_of(table, T_world_tool), q, np.zeros((COLUMNS + q.shape[0], LANES)))


@kernel_into
def is_known(rows: Array, k: int, q: Array) -> bool:
    """Whether one of the first k rows has the posture q (n,), rad."""
    for i in range(k):
        j = 0
        while j < q.shape[0] and abs(wrapped(rows[i, j] - q[j])) < MERGED:
            j += 1
        if j == q.shape[0]:
            return True
    return False
