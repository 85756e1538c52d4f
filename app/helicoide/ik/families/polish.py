"""What closed forms share: θ of A cos θ + B sin θ = C, Newton's last steps, whether two postures are one: kernels."""

from __future__ import annotations

from math import atan2, sqrt

import numpy as np

from helicoide.ik.postures.descent import Memory, descend, linearised, squares
from helicoide.ik.postures.listing import wrapped
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array
from helicoide.kinematics.tool import DRIVER, X, Y, Z, behind, ending, rows_of

# What a posture may miss without polish, m and rad, and how many steps there are; sines, or lengths in m, that leave an
# angle free; what rounding takes from a radicand, of its largest value; postures nearer than MERGED, rad, are one.
EXACT, STEPS = 1e-12, 5
FREE, ROUNDING, MERGED = 1e-10, 1e-12, 1e-5


@kernel
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


@kernel
def off(arm: Array, T_world_tool: Array, q: Array) -> float:
    """By how much the tool is off a pose (4, 4), in the number that differs most, 1 and m."""
    x, y, z = X, Y, Z
    last = arm.shape[0] - 1
    for i in range(last):
        x, y, z = behind(x, y, z, arm[i], q[int(arm[i, DRIVER])])
    tool = rows_of(arm[last])
    x, y, z, most = ending(x, tool), ending(y, tool), ending(z, tool), 0.0
    for j in range(4):
        apart = max(abs(x[j] - T_world_tool[0, j]), abs(y[j] - T_world_tool[1, j]), abs(z[j] - T_world_tool[2, j]))
        most = max(most, apart)
    return most


@kernel
def polished(arm: Array, free: Array, T_world_tool: Array, q: Array, memory: Memory) -> float:
    """What is left of a pose (4, 4), m, the larger of m and rad, after Newton's steps in q: axes may meet inexactly.

    Args: arm of `tool.packed`; free (n, 6): the joints without limits, as `descent` takes them.
    """
    if off(arm, T_world_tool, q) < EXACT:
        return EXACT
    _, missed, turned = descend(arm, free, T_world_tool, (1.0, 1.0), (EXACT, EXACT), STEPS, q, memory)
    if missed == np.inf:
        p, r = squares(linearised(arm, q, T_world_tool, (1.0, 1.0), memory[0]))
        missed, turned = np.sqrt(p), np.sqrt(r)
    return max(missed, turned)


@kernel
def is_known(rows: Array, k: int, q: Array) -> bool:
    """Whether one of the first k rows has the posture q (n,), rad."""
    for i in range(k):
        far = 0.0
        for j in range(q.shape[0]):
            far = max(far, abs(wrapped(rows[i, j] - q[j])))
        if far < MERGED:
            return True
    return False
