"""The guarded step as one function call, for the control loop of the lab and for scripts.

Pack the arm once (`packing.packed`) and allocate its work space once (`work.work_for`). Each `step` changes q in place.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard.guarded import guarded_tick, placed_at
from helicoide.ik.guard.levels import tick_in_levels
from helicoide.ik.guard.packed import CARRIER, ORIENTATION, POSITION_FIRST, SETTING, PlacedArm, array_parts, place_links
from helicoide.ik.guard.rows import Indices, Task
from helicoide.ik.guard.work import DAMPING, JACOBIAN, SHARE, StepBuffers, opened
from helicoide.ik.task import pose_task
from helicoide.kernels import kernel, kernel_into

STILL = np.zeros(3)


@kernel_into
def step(arm: Array, q: Array, T_world_target: Array, ahead: Array, dt: float, memory: Array) -> float:
    """One guarded step of the tool towards a pose, under joint limits, planes, obstacles and self-collision pairs.

    Args: arm of `packing.packed`; q (n,), rad or m, changed in place; T_world_target (4, 4), m; ahead (3,): velocity of
    the target point, m/s, world frame, `STILL` if it is at rest; dt, s; memory of `work.work_for`: it holds the joint
    velocities of the previous step and receives the results of this one. Returns the fraction of the computed step that
    was taken, 0 to 1. Shapes are not checked.
    """
    at = array_parts(arm)
    buffers = opened(memory, at)
    placed = placed_at(arm, at, q, buffers)
    table, law = buffers.table, buffers.task
    task = (table[JACOBIAN : JACOBIAN + 6], law[0], law[1], table[DAMPING])
    pose_task(placed, T_world_target, ahead, dt, task)
    if arm[SETTING, CARRIER] > 0.0 or (arm[SETTING, POSITION_FIRST] > 0.0 and arm[SETTING, ORIENTATION] > 0.0):
        step_in_levels(placed, task, dt, buffers)
    else:
        guarded_tick(placed, task, dt, buffers)
    return float(memory[SHARE])


@kernel
def step_in_levels(placed: PlacedArm, task: Task, dt: float, buffers: StepBuffers) -> None:
    """The step in levels of priority: the entry point first, if any; the orientation last, if it has its own level."""
    arm = placed.arm
    split = arm[SETTING, POSITION_FIRST] > 0.0 and arm[SETTING, ORIENTATION] > 0.0
    begins = np.empty(1 if split else 0, dtype=np.int64)
    for k in range(begins.shape[0]):
        begins[k] = 3
    tick_in_levels(placed, task, begins, dt, buffers)


@kernel
def task_at(arm: Array, q: Array, T_world_target: Array, ahead: Array, dt: float) -> Task:
    """The task that `step` solves: J (6, n); v (6,), a displacement, m and rad; weights (6,); damping (n,), m².

    Args as in `step`.
    """
    at = array_parts(arm)
    placed = PlacedArm(arm, at, q, np.empty((at.m + 1, 4, 4)), np.empty((at.m, 4)))
    place_links(placed)
    task = (np.empty((6, at.n)), np.empty(6), np.empty(6), np.empty(at.n))
    pose_task(placed, T_world_target, ahead, dt, task)
    return task


@kernel_into
def step_task(
    arm: Array, q: Array, J: Array, v: Array, weights: Array, damping: Array, begins: Indices, dt: float, memory: Array
) -> float:
    """One guarded step for any task: minimise ‖W (J Δq − v)‖² + Σ dᵢ Δqᵢ², in levels of priority.

    A later level moves the arm only in the null space of the earlier ones. Args: J (r, n); v (r,): displacement asked
    of this step; weights (r,): the diagonal of W; damping d (n,), in the unit of (W v)² / Δqᵢ²; begins: the first row
    of each level but the first, empty for one level. Other arguments and result as in `step`.
    """
    # Four arrays, not one tuple: Python passes them to a kernel faster.
    at = array_parts(arm)
    buffers = opened(memory, at)
    placed = placed_at(arm, at, q, buffers)
    task = (J, v, weights, damping)
    if arm[SETTING, CARRIER] > 0.0 or begins.shape[0] > 0:
        tick_in_levels(placed, task, begins, dt, buffers)
    else:
        guarded_tick(placed, task, dt, buffers)
    return float(memory[SHARE])
