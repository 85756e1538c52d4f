"""The guarded step of a task with several levels, or of an arm with an instrument in an entry point.

The entry point is a first level of two rows. They hold to first order only: the second-order error of a step is added
to them and the step is solved again, until it no longer changes.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard import cascade, qp
from helicoide.ik.guard.clearance_rows import raise_bounds
from helicoide.ik.guard.collision import Watched
from helicoide.ik.guard.entry import FIRM, entry_rows, miss
from helicoide.ik.guard.guarded import (
    SMALLEST_SHARE,
    accept_step,
    attribute_multipliers,
    prepare_step,
    pulled,
    relax_bounds,
    try_step,
)
from helicoide.ik.guard.packed import CARRIER, SETTING, PlacedArm
from helicoide.ik.guard.qp import Constraints
from helicoide.ik.guard.rows import BOX, Indices, MotionBox, Task
from helicoide.ik.guard.work import PULL, REACHED, ROWS, SOLUTION, StepBuffers, parts_of_points
from helicoide.kernels import kernel

# The tolerance of this correction, m; how often it is tried before the task is halved, and how often it is halved.
SETTLED, TRIES, HALVINGS = 1e-6, 5, 6
LEAST_DAMPING = 1e-9


@kernel
def with_entry(task: Task, begins: Indices, rows: Array, displacement: Array) -> tuple[Task, Indices]:
    """The task with a new first level of two rows (2, n) that ask for a displacement (2,), m; and its `begins`.

    Two rows do not determine all joints, so each joint has at least `LEAST_DAMPING`.
    """
    J, v, weights, damping = task
    damping = np.maximum(damping, LEAST_DAMPING)
    r, levels = v.shape[0], np.empty(begins.shape[0] + 1, dtype=np.int64)
    levels[0] = 2
    for k in range(begins.shape[0]):
        levels[k + 1] = begins[k] + 2
    stacked, desired, firm = np.empty((r + 2, J.shape[1])), np.empty(r + 2), np.full(r + 2, FIRM)
    for i in range(r + 2):
        desired[i] = displacement[i] if i < 2 else v[i - 2]
        for k in range(J.shape[1]):
            stacked[i, k] = rows[i, k] if i < 2 else J[i - 2, k]
        if i >= 2:
            firm[i] = weights[i - 2]
    return (stacked, desired, firm, damping), levels


@kernel
def linearise_entry(task: Task, step: Array, displacement: Array, away: Array, after: Array) -> bool:
    """Add the second-order error ℓ of a step to the first two rows; returns whether they change by less than `SETTLED`.

    ℓ = e' − e + J Δq. Args: step: Δq (n,); asked: the displacement without ℓ, away: e, both of `entry_rows`, and after:
    e' of `miss`, (2,) each, m.
    """
    J, v, _, _ = task
    settled = True
    for i in range(2):
        bent = displacement[i] + after[i] - away[i] + qp.inner_product(J[i], step)
        settled = settled and abs(bent - v[i]) < SETTLED
        v[i] = bent
    return settled


@kernel
def entry_pull(task: Task, begins: Indices, A: Array, step: Array, multipliers: Array) -> float:
    """‖λ‖, λ the multipliers of the first two rows in the next level: J₁ᵀ W² (v₁ − J₁ x) − d x + Aᵀ μ = J₀ᵀ λ."""
    J = task[0]
    n = J.shape[1]
    H, g = np.empty((n, n)), np.empty(n)
    cascade.normal_equations(task, 2, begins[1] if begins.shape[0] > 1 else J.shape[0], H, g)
    for i in range(step.shape[0]):
        g[i] -= qp.inner_product(H[i], step)
        g[i] += multipliers[1, i]
        for r in range(A.shape[0]):
            g[i] += A[r, i] * multipliers[1, J.shape[1] + r]
    a, b, c = qp.inner_product(J[0], J[0]), qp.inner_product(J[0], J[1]), qp.inner_product(J[1], J[1])
    s, t = qp.inner_product(J[0], g), qp.inner_product(J[1], g)
    determinant = max(a * c - b * b, 1e-12 * a * c)
    return float(np.sqrt((c * s - b * t) ** 2 + (a * t - b * s) ** 2) / determinant) if determinant > 0.0 else 0.0


@kernel
def solve_levels(
    task: Task, begins: Indices, constraints: Constraints, motion: MotionBox, x: Array, multipliers: Array
) -> int:
    """`cascade.solve_cascade`; where it is infeasible, the acceleration bounds are widened by `relax_bounds`."""
    verdict = cascade.solve_cascade(task, begins, constraints, x, multipliers)
    if verdict != qp.SOLVED:
        verdict = relax_bounds(task, begins, constraints, motion, x, multipliers)
    return verdict


@kernel
def tick_in_levels(placed: PlacedArm, task: Task, begins: Indices, dt: float, buffers: StepBuffers) -> None:
    """`guarded.guarded_tick` for a task of several levels, or for an arm with an instrument in an entry point.

    Args: begins: the rows at which further levels begin. Other arguments as there.
    """
    arm, at, table, bounds, spots = placed.arm, placed.at, buffers.table, buffers.bounds, buffers.points
    through, x, motion = arm[SETTING, CARRIER] > 0.0, table[SOLUTION], MotionBox(table[:BOX], buffers.rates, dt)
    tried = PlacedArm(arm, at, table[REACHED], buffers.frames[1], spots[at.m : 2 * at.m])
    w, rows = prepare_step(placed, motion, buffers)
    k, (a, b, c, _) = at.n + rows, parts_of_points(at)
    watched = Watched(spots[a:b], spots[b : b + w], spots[c : c + w])
    constraints = Constraints(table[ROWS : ROWS + rows], bounds[0, :k], bounds[1, :k])
    buffers.report[PULL] = pulled(task)
    levels, asked, pair, away = begins, motion.rates, motion.bounds, motion.rates
    if through:
        shaft, asked, pair, away = entry_rows(placed, dt)
        task, levels = with_entry(task, begins, shaft, asked)
    multipliers = np.empty((levels.shape[0] + 1, k))
    solve_levels(task, levels, constraints, motion, x, multipliers)
    share, tries, halvings, done = 1.0, 0, 0, False
    while share > SMALLEST_SHARE:
        clear, straight = try_step(placed, tried, watched, x, share, dt), True
        if through and share == 1.0:
            straight = linearise_entry(task, x, asked, away, miss(arm, tried.poses, pair))
        if clear and not straight and tries == TRIES and halvings < HALVINGS:
            tries, halvings = 0, halvings + 1
            for i in range(task[1].shape[0]):
                task[1][i] = asked[i] if i < 2 else 0.5 * task[1][i]
        if clear and (straight or tries == TRIES):
            done = True
            break
        if tries < (TRIES if through else 1):
            tries += 1
            if not clear:
                raise_bounds(placed, watched, constraints, x)
            again, multipliers_again = np.empty(at.n), np.empty((levels.shape[0] + 1, k))
            if solve_levels(task, levels, constraints, motion, again, multipliers_again) == qp.SOLVED:
                x[:], multipliers[:] = again, multipliers_again
                continue
        share *= 0.5
    attribute_multipliers(at, multipliers, 1 if through else 0, motion.bounds, watched.near, buffers.multipliers)
    if through and done:
        buffers.multipliers[-1] = entry_pull(task, levels, constraints.A, x, multipliers)
    accept_step(placed, tried, share if done else 0.0, dt, buffers)
