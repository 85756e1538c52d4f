"""The guarded step: levels of least squares within hard rows, checked exactly afterwards.

One tick solves, for the joint displacement Δq, one strictly convex quadratic programme a level (`cascade`),

    minimise   ‖W (J Δq − v)‖² + Σ dᵢ Δqᵢ²
    subject to −κ dt (l − δ) ≤ row Δq  for every clearance l > δ, else 0 ≤ row Δq   planes, obstacles, the arm itself
               max(−ω dt, lower − q) ≤ Δq ≤ min(ω dt, upper − q)                    position and speed
               |Δq/dt − q̇| ≤ a dt,  and slow enough to stop before a limit           acceleration

A damper holds to first order only. The poses at q + Δq are therefore computed; where something came closer than it may,
the second-order loss is added to its row and the programme is solved once more; what is still too close is settled by
shortening the step. Δq = 0 satisfies every row but those of acceleration, so there is always an answer: where the rows
have no point in common, acceleration gives way, by as little as the others ask.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from helicoide.confinement import distances
from helicoide.ik import cascade, collision, qp
from helicoide.ik.entry import FIRM, entry_rows, miss
from helicoide.ik.rows import (
    DAMPER_GAIN,
    Arm,
    Entry,
    Guard,
    Indices,
    LimitArrays,
    Pairs,
    PlaneArrays,
    damper,
    motion_box,
    plane_rows,
)
from helicoide.kernels import kernel
from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import carried_points, link_poses

SMALLEST_SHARE = 1e-6
# How near to the entry point the curvature of a step is settled, m; how often this is tried before the task is halved,
# and how often it is halved.
SETTLED, TRIES, HALVINGS = 1e-6, 5, 6
ROUNDING = 1e-10

Task = tuple[Array, Array, Array, Array]


def indices(values: Any, *shape: int) -> Indices:
    """A read-only array of indices; the kernels take its kind only."""
    array = np.array(values, dtype=np.int64).reshape(shape or -1)
    array.flags.writeable = False
    return array


ONE_LEVEL = indices([])
NO_PAIRS = indices([], 0, 4), frozen([])
NO_ENTRY: Entry = (0, frozen(np.zeros(3)), frozen(np.zeros(3)), frozen(np.zeros(3)))


@kernel
def clearances(poses: Array, arm: Arm, planes: PlaneArrays, pairs: Pairs) -> tuple[Array, Array, Array]:
    """What is left until something is too near: guarded points to planes, point after point, then the pairs of bodies.

    Args: poses (j + 1, 4, 4) of `link_poses`. Returns (g k + p,), m; the shares of the witnesses (p, 2); and the points
    where they are (m, 3), m.
    """
    points, k = carried_points(poses, arm[1], arm[2]), planes[0].shape[0]
    left, shares = np.empty(pairs[0] * k + pairs[1].shape[0]), np.empty((pairs[1].shape[0], 2))
    near = distances(planes[0], planes[1], points[: pairs[0]])
    for r in range(pairs[0] * k):
        left[r] = near[r // k, r % k] - planes[2]
    collision.gaps(points, pairs, left, shares)
    return left, shares, points


@kernel
def hard_rows(
    guard: Guard, poses: Array, axes: Array, left: Array, shares: Array, points: Array, box: Array, dt: float
) -> tuple[Array, Array, Array]:
    """Rows lower ≤ A Δq ≤ upper: the n joints, a damper for each clearance, and p spare rows for a second witness.

    Args: left, shares, points of `clearances`; box of `motion_box`. Returns A (n + g k + 2 p, n), lower and upper.
    """
    (chain, _, links), (_, _, _, acceleration), (normals, _, _), pairs, _, gain = guard
    n, p = acceleration.shape[0], shares.shape[0]
    rows = n + left.shape[0] + p
    A, lower, upper = np.zeros((rows, n)), np.full(rows, -np.inf), np.full(rows, np.inf)
    for i in range(n):
        A[i, i], lower[i], upper[i] = 1.0, box[0, i], box[1, i]
    plane_rows(A[n : n + left.shape[0] - p], poses, chain, axes, points, links, normals)
    for pair in range(p):
        row = A[n + left.shape[0] - p + pair]
        collision.witness_row(row, points, links, pairs, pair, shares[pair], poses, chain, axes)
    for r in range(left.shape[0]):
        lower[n + r] = damper(left[r], A[n + r], acceleration, gain, dt)
    return A, lower, upper


@kernel
def shortfall(left: Array, after: Array) -> float:
    """By how much the worst came closer than it may: the least distance, or where it was if that is nearer; m."""
    worst = 0.0
    for r in range(left.shape[0]):
        worst = max(worst, min(0.0, left[r]) - after[r])
    return worst


@kernel
def raise_by_loss(
    guard: Guard, A: Array, lower: Array, step: Array, left: Array, after: Array, points: Array, shares: Array,
    poses: Array, axes: Array,
) -> None:  # fmt: skip
    """Add to the row of what came too close what its linear prediction lost, and a tenth for the rest.

    Bodies may be nearest elsewhere after the step: these witnesses, `shares` (p, 2), have a row of their own.
    """
    (chain, _, links), _, _, pairs, _, _ = guard
    n, p = A.shape[1], shares.shape[0]
    for r in range(left.shape[0]):
        allowed, row, pair = min(0.0, left[r]), n + r, r - left.shape[0] + p
        if after[r] >= allowed:
            continue
        if pair < 0:
            lower[row] += 1.1 * (left[r] + qp.dot(A[row], step) - after[r])
            continue
        row += p
        there = collision.witness_row(A[row], points, links, pairs, pair, shares[pair], poses, chain, axes)
        lower[row] = allowed - there + 1.1 * (there + qp.dot(A[row], step) - after[r])


@kernel
def within(q: Array, step: Array, lower: Array, upper: Array, reach: Array) -> Array:
    """q + Δq, cut to the limits to the last bit; a joint that is outside keeps its place as its limit."""
    moved = np.empty_like(q)
    for i in range(q.shape[0]):
        value = q[i] + min(max(step[i], -reach[i]), reach[i])
        moved[i] = min(max(value, min(lower[i], q[i])), max(upper[i], q[i]))
    return moved


@kernel
def given_way(
    task: Task, begins: Indices, A: Array, lower: Array, upper: Array, box: Array, coast: Array
) -> tuple[Array, Array, int]:
    """`cascade.descend`; where acceleration leaves no point, its bounds are first widened to the nearest that there is.

    Nearest to going on as before, Δq = q̇ dt, coast (n,). Args: lower, upper (m,): opened in place; box of `motion_box`.
    """
    step, multipliers, verdict = cascade.descend(task, begins, A, lower, upper)
    if verdict == qp.SOLVED:
        return step, multipliers, verdict
    n = coast.shape[0]
    before = lower[:n].copy(), upper[:n].copy()
    lower[:n], upper[:n] = box[2], box[3]
    nearest, _, verdict = qp.project(A, lower, upper, coast)
    if verdict != qp.SOLVED:
        return np.zeros(n), multipliers, verdict
    for i in range(n):
        lower[i] = max(box[2, i], min(before[0][i], nearest[i] - ROUNDING))
        upper[i] = min(box[3, i], max(before[1][i], nearest[i] + ROUNDING))
    step, multipliers, verdict = cascade.descend(task, begins, A, lower, upper)
    return (step if verdict == qp.SOLVED else nearest), multipliers, qp.SOLVED


@kernel
def with_entry(task: Task, begins: Indices, rows: Array, asked: Array) -> tuple[Task, Indices]:
    """The same task after a first level of two rows (2, n) that ask for a displacement (2,), m."""
    J, v, weights, damping = task
    firm = np.full(2, FIRM)
    levels = np.empty(begins.shape[0] + 1, dtype=np.int64)
    levels[0], levels[1:] = 2, begins + 2
    return (np.concatenate((rows, J)), np.concatenate((asked, v)), np.concatenate((firm, weights)), damping), levels


@kernel
def bend(task: Task, step: Array, asked: Array, away: Array, after: Array) -> bool:
    """Ask of the first two rows what the curvature ℓ of a step takes as well; whether that changes nothing more.

    ℓ = e' − e + J Δq. Args: asked, away: e, and after: e', (2,), m, of `entry_rows` and `miss`.
    """
    J, v, _, _ = task
    settled = True
    for i in range(2):
        bent = asked[i] + after[i] - away[i] + qp.dot(J[i], step)
        settled = settled and abs(bent - v[i]) < SETTLED
        v[i] = bent
    return settled


@kernel
def entry_pull(task: Task, begins: Indices, A: Array, step: Array, multipliers: Array) -> float:
    """How hard the first two rows hold the level after them back: ‖λ‖, J₁ᵀ W² (v₁ − J₁ x) − d x + Aᵀ μ = J₀ᵀ λ."""
    J, v, weights, damping = task
    end = begins[1] if begins.shape[0] > 1 else J.shape[0]
    H, g = cascade.normal_equations(J[2:end], v[2:end], weights[2:end], damping)
    for i in range(step.shape[0]):
        g[i] -= qp.dot(H[i], step)
        for r in range(A.shape[0]):
            g[i] += A[r, i] * multipliers[1, r]
    a, b, c = qp.dot(J[0], J[0]), qp.dot(J[0], J[1]), qp.dot(J[1], J[1])
    s, t = qp.dot(J[0], g), qp.dot(J[1], g)
    determinant = max(a * c - b * b, 1e-12 * a * c)
    return float(np.sqrt((c * s - b * t) ** 2 + (a * t - b * s) ** 2) / determinant) if determinant > 0.0 else 0.0


@kernel
def sorted_out(multipliers: Array, through: bool, kinds: Indices, clear: int, pull: float) -> Array:
    """The multipliers by what holds: 2 n position limits, clearances, 2 n speed limits, 2 n accelerations, the entry.

    Args: multipliers (levels, n + clear + p), those of the entry's own level left out; kinds (2, n) of `motion_box`.
    """
    n = kinds.shape[1]
    held = np.zeros(6 * n + clear + 1)
    spare = multipliers.shape[1] - n - clear
    for k in range(1 if through else 0, multipliers.shape[0]):
        for i in range(n):
            side = 0 if multipliers[k, i] > 0.0 else 1
            kind = kinds[side, i]
            start = clear + 2 * n * kind if kind > 0 else 0
            held[start + side * n + i] += abs(multipliers[k, i])
        for r in range(clear):
            held[2 * n + r] += multipliers[k, n + r]
        for r in range(spare):
            held[2 * n + clear - spare + r] += multipliers[k, n + clear + r]
    held[-1] = pull
    return held


@kernel
def guarded_tick(
    guard: Guard, q: Array, rates: Array, poses: Array, task: Task, begins: Indices, dt: float
) -> tuple[Array, Array, Array, float]:
    """One guarded tick from q towards a task.

    Args: guard: `Problem.guard`; q (n,), rad, and its `link_poses`; rates (n,) of the tick before, rad/s; task:
    J (r, n), v (r,) the wished displacement, weights (r,), damping d (n,); begins: the rows at which further levels
    begin; dt, s.
    Returns q' (n,), its link poses, the multipliers of `sorted_out`, and the share of the step that was taken.
    """
    (chain, _, _), limits, _, pairs, entry, _ = guard
    reach, through = limits[2] * dt, entry[0] > 0
    axes = jacobian.joint_axes(poses, chain)
    left, shares, points = clearances(poses, guard[0], guard[2], pairs)
    box, kinds = motion_box(q, rates, limits, dt)
    A, lower, upper = hard_rows(guard, poses, axes, left, shares, points, box, dt)
    levels, asked, pair, away = begins.copy(), reach, box, reach
    if through:
        rows, asked, pair, away = entry_rows(poses, chain, axes, entry, dt)
        task, levels = with_entry(task, levels, rows, asked)
    step, multipliers, verdict = given_way(task, levels, A, lower, upper, box, rates * dt)
    share, tries, halvings = 1.0, 0, 0
    while share > SMALLEST_SHARE:
        q_after = within(q, share * step, limits[0], limits[1], reach)
        poses_after = link_poses(chain, q_after)
        after, shares_after, _ = clearances(poses_after, guard[0], guard[2], pairs)
        clear, straight = shortfall(left, after) <= 0.0, True
        if through and share == 1.0:
            straight = bend(task, step, asked, away, miss(poses_after, entry, pair))
        if clear and not straight and tries == TRIES and halvings < HALVINGS:
            tries, halvings = 0, halvings + 1
            task[1][:2] = asked
            task[1][2:] *= 0.5
        if clear and (straight or tries == TRIES):
            pull = entry_pull(task, levels, A, step, multipliers) if through else 0.0
            return q_after, poses_after, sorted_out(multipliers, through, kinds, left.shape[0], pull), share
        if tries < (TRIES if through else 1):
            tries += 1
            if not clear:
                raise_by_loss(guard, A, lower, step, left, after, points, shares_after, poses, axes)
            again, multipliers_again, verdict = given_way(task, levels, A, lower, upper, box, rates * dt)
            if verdict == qp.SOLVED:
                step, multipliers = again, multipliers_again
                continue
        share *= 0.5
    return q.copy(), poses, sorted_out(multipliers, through, kinds, left.shape[0], 0.0), 0.0


@kernel
def guarded_step(
    arm: Arm, q: Array, poses: Array, task: Task, limits: LimitArrays, planes: PlaneArrays, dt: float
) -> tuple[Array, Array, Array, float]:
    """`guarded_tick` of one level from rest, among planes alone; the multipliers are those of positions and planes."""
    n, m = q.shape[0], arm[1].shape[0]
    guard = (arm, limits, planes, (m, NO_PAIRS[0], NO_PAIRS[1]), NO_ENTRY, DAMPER_GAIN)
    q, poses, held, share = guarded_tick(guard, q, np.zeros(n), poses, task, ONE_LEVEL, dt)
    return q, poses, held[: 2 * n + m * planes[0].shape[0]].copy(), share
