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
from helicoide.ik.guard.collision import NUMBER, Watched
from helicoide.ik.guard.packed import LOWER, SPEED, UPPER, At, PlacedArm, place_links
from helicoide.ik.guard.qp import Constraints, QpSolution
from helicoide.ik.guard.rows import (
    BOX,
    BY_POSITION,
    DOWN_BY,
    HARD_DOWN,
    HARD_UP,
    Indices,
    MotionBox,
    Task,
    bound_motion,
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
def within(placed: PlacedArm, step: Array, share: float, dt: float, reached: Array) -> None:
    """Write q plus a share of Δq, clipped exactly to the limits; for a joint outside, q replaces the limit.

    A displacement that is not finite counts as 0.
    """
    arm, at, q, _, _ = placed
    for i in range(at.n):
        limit, way = at.limits + i, share * step[i] if np.isfinite(step[i]) else 0.0
        most = arm[limit, SPEED] * dt
        value = q[i] + min(max(way, -most), most)
        reached[i] = min(max(value, min(arm[limit, LOWER], q[i])), max(arm[limit, UPPER], q[i]))


@kernel
def relax_bounds(
    task: Task, begins: Indices, constraints: Constraints, motion: MotionBox, x: Array, multipliers: Array
) -> int:
    """`cascade.solve_cascade` once more after it was infeasible, with wider acceleration bounds.

    They are widened to include the feasible point nearest to constant velocity, Δq = q̇ dt. The bounds of the
    constraints are changed in place.
    """
    (_, lower, upper), (box, rates, dt) = constraints, motion
    n = rates.shape[0]
    before, going_on = np.empty((2, n)), np.empty(n)
    for i in range(n):
        before[0, i], before[1, i], going_on[i] = lower[i], upper[i], rates[i] * dt
        lower[i], upper[i] = box[HARD_DOWN, i], box[HARD_UP, i]
    (nearest, _), verdict = qp.project_into_limits(constraints, going_on)
    if verdict != qp.SOLVED:
        x[:] = 0.0
        return verdict
    for i in range(n):
        lower[i] = max(box[HARD_DOWN, i], min(before[0, i], nearest[i] - ROUNDING))
        upper[i] = min(box[HARD_UP, i], max(before[1, i], nearest[i] + ROUNDING))
    if cascade.solve_cascade(task, begins, constraints, x, multipliers) != qp.SOLVED:
        x[:] = nearest
    return qp.SOLVED


@kernel_into
def attribute_multipliers(at: At, multipliers: Array, own: int, box: Array, near: Array, attributed: Array) -> None:
    """Write the multiplier of each constraint but the entry point into `attributed`, as in `work.Work.multipliers`.

    Args: multipliers (levels, n + w + b), read from level `own` on, 1 if there is an entry point, else 0; box: bounds
    of the `MotionBox`; near (w, 4) of `collision.Watched`.
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


@kernel_into
def pulled(task: Task) -> float:
    """‖W v‖ of a task."""
    square = 0.0
    for s in range(task[1].shape[0]):
        square += (task[2][s] * task[1][s]) ** 2
    return float(np.sqrt(square))


@kernel_into
def prepare_step(placed: PlacedArm, motion: MotionBox, buffers: StepBuffers) -> tuple[int, int]:
    """Write all bounds of a step into a work space.

    Returns the number of watched clearances, and the number of rows besides the joint bounds.
    """
    at, spots = placed.at, buffers.points
    a, b, c, d = parts_of_points(at)
    every, rest = Watched(spots[a:b], spots[b:c], spots[c:d]), spots[d:]
    w = collision.watch(placed, every, motion.dt, rest) if at.clearances > 0 else 0
    watched = Watched(every.points, every.near[:w], every.after[:w])
    rows = w + collision.between_bodies(at, watched.near)
    A = buffers.table[ROWS : ROWS + rows]
    for j in range(w, rows):
        for i in range(at.n):
            A[j, i] = 0.0
    bound_motion(placed, motion)
    constraints = Constraints(A, buffers.bounds[0, : at.n + rows], buffers.bounds[1, : at.n + rows])
    hard_rows(placed, watched, motion, constraints, rest)
    return w, rows


@kernel_into
def try_step(placed: PlacedArm, tried: PlacedArm, watched: Watched, step: Array, share: float, dt: float) -> bool:
    """Place the arm after a share of a step Δq (n,), into `tried`; returns whether no clearance is violated there."""
    within(placed, step, share, dt, tried.q)
    place_links(tried)
    if watched.near.shape[0] > 0:
        collision.measure_clearances(tried, watched)
    return shortfall(watched.near, watched.after) <= 0.0


@kernel_into
def accept_step(placed: PlacedArm, tried: PlacedArm, share: float, dt: float, buffers: StepBuffers) -> None:
    """Take the tried step, or none if the share is 0: update the posture and the joint velocities."""
    at, q, stood = placed.at, placed.q, buffers.table[STOOD]
    buffers.report[SHARE] = share
    for i in range(at.n):
        now = tried.q[i] if share > 0.0 else q[i]
        buffers.rates[i], q[i], stood[i] = (now - q[i]) / dt, now, now
    for i in range(at.m + 1 if share > 0.0 else 0):
        for a in range(3):
            for b in range(4):
                placed.poses[i, a, b] = tried.poses[i, a, b]
    for i in range(at.m if share > 0.0 else 0):
        for a in range(3):
            placed.axes[i, a] = tried.axes[i, a]


@kernel_into
def placed_at(arm: Array, at: At, q: Array, buffers: StepBuffers) -> PlacedArm:
    """The arm at q (n,), rad or m; its links are placed unless the last step left them at the same q."""
    placed = PlacedArm(arm, at, q, buffers.frames[0], buffers.points[: at.m])
    stood = True
    for i in range(at.n):
        stood = stood and buffers.table[STOOD, i] == q[i]
    if not stood:
        place_links(placed)
    return placed


@kernel_into
def solve_one(task: Task, constraints: Constraints, motion: MotionBox, solution: QpSolution, spare: Array) -> bool:
    """`cascade.first_level` for all rows of a task; where it is infeasible, the acceleration bounds are widened."""
    verdict = cascade.first_level(task, task[1].shape[0], constraints, solution, spare)
    if verdict != qp.SOLVED:
        verdict = relax_and_solve(task, constraints, motion, solution)
    return verdict == qp.SOLVED


@kernel
def relax_and_solve(task: Task, constraints: Constraints, motion: MotionBox, solution: QpSolution) -> int:
    """`relax_bounds` for a task of one level."""
    begins, one = np.empty(0, dtype=np.int64), solution.multipliers.reshape(1, solution.multipliers.shape[0])
    return relax_bounds(task, begins, constraints, motion, solution.x, one)


@kernel_into
def solve_again(
    task: Task, constraints: Constraints, motion: MotionBox, solution: QpSolution, before: QpSolution, spare: Array
) -> bool:
    """`solve_one` once more; without a solution, the one before is restored. Args: before: temporary values."""
    qp.copy_into(solution.x, before.x)
    qp.copy_into(solution.multipliers, before.multipliers)
    is_solved = solve_one(task, constraints, motion, solution, spare)
    if not is_solved:
        qp.copy_into(before.x, solution.x)
        qp.copy_into(before.multipliers, solution.multipliers)
    return is_solved


@kernel_into
def guarded_tick(placed: PlacedArm, task: Task, dt: float, buffers: StepBuffers) -> None:
    """One guarded tick for a task of one level; the posture and the work space are changed in place.

    Args: placed of `placed_at`; task: J (r, n), v (r,) the displacement asked for, weights (r,), damping d (n,); dt, s;
    buffers: with the joint velocities of the tick before.
    """
    at, table, bounds, spots = placed.at, buffers.table, buffers.bounds, buffers.points
    motion = MotionBox(table[:BOX], buffers.rates, dt)
    tried = PlacedArm(placed.arm, at, table[REACHED], buffers.frames[1], spots[at.m : 2 * at.m])
    w, rows = prepare_step(placed, motion, buffers)
    k, (a, b, c, _) = at.n + rows, parts_of_points(at)
    watched = Watched(spots[a:b], spots[b : b + w], spots[c : c + w])
    constraints = Constraints(table[ROWS : ROWS + rows], bounds[0, :k], bounds[1, :k])
    solution, before = QpSolution(table[SOLUTION], bounds[2, :k]), QpSolution(table[BEFORE], bounds[3, :k])
    buffers.report[PULL] = pulled(task)
    solve_one(task, constraints, motion, solution, buffers.spare)
    share, is_new = 1.0, True
    while share > SMALLEST_SHARE and not try_step(placed, tried, watched, solution.x, share, dt):
        if is_new:
            raise_bounds(placed, watched, constraints, solution.x)
            if not solve_again(task, constraints, motion, solution, before, buffers.spare):
                share *= 0.5
            is_new = False
        else:
            share *= 0.5
    attribute_multipliers(at, solution.multipliers.reshape(1, k), 0, motion.bounds, watched.near, buffers.multipliers)
    accept_step(placed, tried, share if share > SMALLEST_SHARE else 0.0, dt, buffers)
