"""The guarded step: least squares under constraints, checked exactly afterwards.

One tick solves a strictly convex quadratic program for the joint displacement Δq (one for each level in `levels`),

    minimise   ‖W (J Δq − v)‖² + Σ dᵢ Δqᵢ²
    subject to −κ dt (l − δ) ≤ row Δq  for every clearance l > δ, else 0 ≤ row Δq   planes, obstacles, the arm itself
               max(−ω dt, lower − q) ≤ Δq ≤ min(ω dt, upper − q)                    position and speed
               |Δq/dt − q̇| ≤ a dt,  and slow enough to stop before a limit           acceleration

A damper holds to first order only. The clearances at q + Δq are therefore computed. Where one is violated, the
second-order error is added to its row and the program is solved once more; if one is still violated, the step is
shortened. Δq = 0 satisfies all constraints except those of acceleration. Where the constraints are infeasible, the
acceleration bounds are widened as little as possible, so there is always a solution.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard import cascade, collision, qp
from helicoide.ik.guard.clearance_rows import hard_rows, raise_bounds, shortfall
from helicoide.ik.guard.collision import NUMBER
from helicoide.ik.guard.packed import LOWER, SPEED, UPPER, At, place_links
from helicoide.ik.guard.rows import (
    BOX,
    BY_POSITION,
    DOWN_BY,
    HARD_DOWN,
    HARD_UP,
    Indices,
    Task,
    motion_box,
)
from helicoide.ik.guard.work import (
    BEFORE,
    PULL,
    REACHED,
    ROWS,
    SHARE,
    SOLUTION,
    STOOD,
    StepBuffers,
    parts_of_points,
)
from helicoide.kernels import kernel, kernel_into

SMALLEST_SHARE = 1e-6
ROUNDING = 1e-10


def indices(values: Sequence[int]) -> Indices:
    """A read-only array of indices."""
    array = np.array(values, dtype=np.int64)
    array.flags.writeable = False
    return array


ONE_LEVEL = indices([])


@kernel_into
def within(arm: Array, at: At, q: Array, step: Array, share: float, dt: float, reached: Array) -> None:
    """Write q plus a share of Δq, clipped exactly to the limits; for a joint outside, q replaces the limit.

    A displacement that is not finite counts as 0.
    """
    for i in range(at.n):
        limit, way = at.limits + i, share * step[i] if np.isfinite(step[i]) else 0.0
        most = arm[limit, SPEED] * dt
        value = q[i] + min(max(way, -most), most)
        reached[i] = min(max(value, min(arm[limit, LOWER], q[i])), max(arm[limit, UPPER], q[i]))


@kernel
def relax_bounds(
    task: Task, begins: Indices, A: Array, lower: Array, upper: Array, box: Array, rates: Array, dt: float, x: Array,
    multipliers: Array,
) -> int:  # fmt: skip
    """`cascade.solve_cascade` once more after it was infeasible, with wider acceleration bounds.

    They are widened to include the feasible point nearest to constant velocity, Δq = q̇ dt.
    Args: lower, upper (m,): changed in place; box of `motion_box`.
    """
    n = rates.shape[0]
    before, going_on = np.empty((2, n)), np.empty(n)
    for i in range(n):
        before[0, i], before[1, i], going_on[i] = lower[i], upper[i], rates[i] * dt
        lower[i], upper[i] = box[HARD_DOWN, i], box[HARD_UP, i]
    nearest, _, verdict = qp.project_into_limits(A, lower, upper, going_on)
    if verdict != qp.SOLVED:
        x[:] = 0.0
        return verdict
    for i in range(n):
        lower[i] = max(box[HARD_DOWN, i], min(before[0, i], nearest[i] - ROUNDING))
        upper[i] = min(box[HARD_UP, i], max(before[1, i], nearest[i] + ROUNDING))
    if cascade.solve_cascade(task, begins, A, lower, upper, x, multipliers) != qp.SOLVED:
        x[:] = nearest
    return qp.SOLVED


@kernel_into
def attribute_multipliers(
    at: At, multipliers: Array, own: int, box: Array, near: Array, pull: float, attributed: Array
) -> None:
    """Write the multiplier of each constraint into `attributed`, as in `work.Work.multipliers`.

    Last is `pull`, that of the entry point.

    Args: multipliers (levels, n + w + b), read from level `own` on, 1 if there is an entry point, else 0; box of
    `motion_box`; near (w, 4) of `collision.watch`.
    """
    n, w = at.n, near.shape[0]
    spare = multipliers.shape[1] - n - w
    attributed[:] = 0.0
    for k in range(own, multipliers.shape[0]):
        for i in range(n):
            side = 0 if multipliers[k, i] > 0.0 else 1
            by = int(box[DOWN_BY + side, i])
            start = at.clearances + 2 * n * by if by != BY_POSITION else 0
            attributed[start + side * n + i] += abs(multipliers[k, i])
        for j in range(w):
            attributed[2 * n + int(near[j, NUMBER])] += multipliers[k, n + j]
        for j in range(spare):
            attributed[2 * n + int(near[w - spare + j, NUMBER])] += multipliers[k, n + w + j]
    attributed[-1] = pull


@kernel_into
def pulled(task: Task) -> float:
    """‖W v‖ of a task."""
    square = 0.0
    for s in range(task[1].shape[0]):
        square += (task[2][s] * task[1][s]) ** 2
    return float(np.sqrt(square))


@kernel_into
def prepare_step(arm: Array, at: At, q: Array, dt: float, buffers: StepBuffers) -> tuple[int, int]:
    """Write all bounds of a step from q into a work space, which has the link poses at q.

    Returns the number of watched clearances, and the number of rows besides the joint bounds.
    """
    poses, spots, box = buffers.frames[0], buffers.points, buffers.table[:BOX]
    a, b, c, d = parts_of_points(at)
    axes, points, near, rest = spots[: at.m], spots[a:b], spots[b:c], spots[d:]
    w = collision.watch(arm, at, poses, points, dt, near, rest) if at.clearances > 0 else 0
    near = near[:w]
    rows = w + collision.between_bodies(at, near)
    lower, upper = buffers.bounds[0, : at.n + rows], buffers.bounds[1, : at.n + rows]
    A = buffers.table[ROWS : ROWS + rows]
    for j in range(w, rows):
        for i in range(at.n):
            A[j, i] = 0.0
    motion_box(arm, at, q, buffers.rates, dt, box)
    hard_rows(arm, at, poses, axes, near, points, box, dt, A, lower, upper, rest)
    return w, rows


@kernel_into
def try_step(arm: Array, at: At, q: Array, x: Array, share: float, dt: float, w: int, buffers: StepBuffers) -> bool:
    """Compute the posture after a share of a step; returns whether no clearance is violated there."""
    reached, spots = buffers.table[REACHED], buffers.points
    within(arm, at, q, x, share, dt, reached)
    place_links(arm, at.m, reached, buffers.frames[1], spots[at.m : 2 * at.m])
    a, b, c, _ = parts_of_points(at)
    near, after = spots[b : b + w], spots[c : c + w]
    if w > 0:
        collision.measure_clearances(arm, at, buffers.frames[1], spots[a:b], near, after)
    return shortfall(near, after) <= 0.0


@kernel_into
def add_contact_rows(arm: Array, at: At, x: Array, w: int, rows: int, buffers: StepBuffers) -> None:
    """Raise the bounds of the clearances that the tried step x violates, by `raise_bounds`."""
    a, b, c, _ = parts_of_points(at)
    poses, spots, points = buffers.frames[0], buffers.points, buffers.points[a:b]
    near, after = spots[b : b + w], spots[c : c + w]
    A, lower = buffers.table[ROWS : ROWS + rows], buffers.bounds[0, : at.n + rows]
    collision.place_bodies(arm, at, poses, points)
    raise_bounds(arm, at, A, lower, x, near, after, points, poses, spots[: at.m])


@kernel_into
def accept_step(at: At, q: Array, share: float, dt: float, buffers: StepBuffers) -> None:
    """Take the tried step, or none if the share is 0: update q, the joint velocities, the link poses and the axes."""
    table, frames, axes = buffers.table, buffers.frames, buffers.points
    buffers.report[SHARE] = share
    for i in range(at.n):
        now = table[REACHED, i] if share > 0.0 else q[i]
        buffers.rates[i], q[i], table[STOOD, i] = (now - q[i]) / dt, now, now
    for i in range(at.m + 1 if share > 0.0 else 0):
        for a in range(3):
            for b in range(4):
                frames[0, i, a, b] = frames[1, i, a, b]
    for i in range(at.m if share > 0.0 else 0):
        for a in range(3):
            axes[i, a] = axes[at.m + i, a]


@kernel_into
def update_poses(arm: Array, at: At, q: Array, buffers: StepBuffers) -> None:
    """Write the link poses at q (n,), unless those of the last step are for the same q."""
    stood = True
    for i in range(at.n):
        stood = stood and buffers.table[STOOD, i] == q[i]
    if not stood:
        place_links(arm, at.m, q, buffers.frames[0], buffers.points[: at.m])


@kernel_into
def solve_one(
    task: Task, A: Array, lower: Array, upper: Array, box: Array, rates: Array, dt: float, H: Array, x: Array,
    multipliers: Array, spare: Array,
) -> bool:  # fmt: skip
    """`cascade.first_level` for all rows of a task; where it is infeasible, the acceleration bounds are widened."""
    verdict = cascade.first_level(task, task[1].shape[0], A, lower, upper, H, x, multipliers, spare)
    if verdict != qp.SOLVED:
        verdict = relax_and_solve(task, A, lower, upper, box, rates, dt, x, multipliers)
    return verdict == qp.SOLVED


@kernel
def relax_and_solve(
    task: Task, A: Array, lower: Array, upper: Array, box: Array, rates: Array, dt: float, x: Array, multipliers: Array
) -> int:
    """`relax_bounds` for a task of one level."""
    begins, one = np.empty(0, dtype=np.int64), multipliers.reshape(1, multipliers.shape[0])
    return relax_bounds(task, begins, A, lower, upper, box, rates, dt, x, one)


@kernel_into
def solve_again(
    task: Task, A: Array, lower: Array, upper: Array, box: Array, rates: Array, dt: float, H: Array, x: Array,
    multipliers: Array, before: Array, multipliers_before: Array, spare: Array,
) -> bool:  # fmt: skip
    """`solve_one` once more; without a solution, x and the multipliers are restored."""
    qp.copy_into(x, before)
    qp.copy_into(multipliers, multipliers_before)
    is_solved = solve_one(task, A, lower, upper, box, rates, dt, H, x, multipliers, spare)
    if not is_solved:
        qp.copy_into(before, x)
        qp.copy_into(multipliers_before, multipliers)
    return is_solved


@kernel_into
def guarded_tick(arm: Array, at: At, q: Array, task: Task, dt: float, buffers: StepBuffers) -> None:
    """One guarded tick from q for a task of one level; q and the work space are changed in place.

    Args: q (n,), rad or m; task: J (r, n), v (r,) the displacement asked for, weights (r,), damping d (n,); dt, s;
    room: after `update_poses` at q, with the joint velocities of the tick before.
    """
    n, table, rates, spare = at.n, buffers.table, buffers.rates, buffers.spare
    w, rows = prepare_step(arm, at, q, dt, buffers)
    lower, upper, multipliers = (
        buffers.bounds[0, : n + rows],
        buffers.bounds[1, : n + rows],
        buffers.bounds[2, : n + rows],
    )
    A, H, x, box = table[ROWS : ROWS + rows], table[table.shape[0] - n - 1 :], table[SOLUTION], table[:BOX]
    buffers.report[PULL] = pulled(task)
    solve_one(task, A, lower, upper, box, rates, dt, H, x, multipliers, spare)
    share, is_new = 1.0, True
    while share > SMALLEST_SHARE and not try_step(arm, at, q, x, share, dt, w, buffers):
        if is_new:
            add_contact_rows(arm, at, x, w, rows, buffers)
            before, multipliers_before = table[BEFORE], buffers.bounds[3, : n + rows]
            if not solve_again(
                task, A, lower, upper, box, rates, dt, H, x, multipliers, before, multipliers_before, spare
            ):
                share *= 0.5
            is_new = False
        else:
            share *= 0.5
    first = parts_of_points(at)[1]
    near = buffers.points[first : first + w]
    attribute_multipliers(at, multipliers.reshape(1, n + rows), 0, box, near, 0.0, buffers.multipliers)
    accept_step(at, q, share if share > SMALLEST_SHARE else 0.0, dt, buffers)
