"""A pose as an arm's own frames see it: one kernel."""

from __future__ import annotations

import numpy as np

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array


@kernel
def framed(T_base_world: Array, T_world_tool: Array, T_tool_end: Array) -> Array:
    """T_base_end = T_base_world T_world_tool T_tool_end, (4, 4), m."""
    first, T = np.zeros((4, 4)), np.zeros((4, 4))
    for i in range(3):
        for j in range(4):
            for k in range(4):
                first[i, j] += T_base_world[i, k] * T_world_tool[k, j]
    for i in range(3):
        for j in range(4):
            for k in range(4):
                T[i, j] += first[i, k] * T_tool_end[k, j]
    T[3, 3] = 1.0
    return T
