"""Where the guarded arm comes to rest: its ticks, simulated ahead until the joints stand still."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.ik.guard.collision import clearances
from helicoide.ik.guard.work import REPORT
from helicoide.ik.step import step, step_task
from helicoide.ik.task import joint_task
from helicoide.kernels import kernel

AT_REST = 1e-5


class Horizon(NamedTuple):
    """How far ahead ticks are simulated: the duration of one, s, and the largest number of them."""

    dt: float
    ticks: int


@kernel
def are_clear(arm: Array, postures: Array) -> NDArray[np.bool_]:
    """Which postures (p, n), rad or m, keep the distances from planes and obstacles and between bodies, (p,)."""
    clear = np.empty(postures.shape[0], dtype=np.bool_)
    for k in range(postures.shape[0]):
        clear[k] = (clearances(arm, postures[k]) > 0.0).all()
    return clear


@kernel
def roll_to_rest(
    arm: Array, q: Array, T_world_target: Array, joints: tuple[bool, Array, int], horizon: Horizon, memory: Array
) -> None:
    """Guarded ticks, each from rest, until no joint moves by `AT_REST`; q and the work space are those of the last.

    Args: arm of `packing.packed`, without acceleration limits; q (n,), rad or m, changed in place; T_world_target
    (4, 4), m; joints: whether to go to joint values instead, these values (n,), and `yielding` of `joint_task`; memory
    of `work.work_for`.
    """
    dt, ticks = horizon
    rates, ahead, begins = memory[REPORT : REPORT + q.shape[0]], np.zeros(3), np.empty(0, dtype=np.int64)
    for _ in range(ticks):
        rates[:] = 0.0
        if joints[0]:
            J, v, weights, damping = joint_task(q, joints[1], joints[2], dt)
            step_task(arm, q, J, v, weights, damping, begins, dt, memory)
        else:
            step(arm, q, T_world_target, ahead, dt, memory)
        if dt * np.max(np.abs(rates)) < AT_REST:
            break
