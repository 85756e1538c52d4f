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

from helicoide.ik.guard import cascade, collision, qp
from helicoide.ik.guard.entry import FIRM, entry_rows, miss
from helicoide.ik.guard.rows import (
    Guard,
    Indices,
    LimitArrays,
    Task,
    add_point,
    at,
    damper,
    motion_box,
)
from helicoide.kernels import kernel
from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses

SMALLEST_SHARE = 1e-6
# How near to the entry point the curvature of a step is settled, m; how often this is tried before the task is halved,
# and how often it is halved.
SETTLED, TRIES, HALVINGS = 1e-6, 5, 6
ROUNDING = 1e-10
LEAST_DAMPING = 1e-9


def indices(values: Any, *shape: int) -> Indices:
    """A read-only array of indices."""
    array = np.array(values, dtype=np.int64).reshape(shape or -1)
    array.flags.writeable = False
    return array


ONE_LEVEL = indices([])


@kernel
def hard_rows(
    guard: Guard, poses: Array, watched: Indices, near: Array, points: Array, box: Array, dt: float
) -> tuple[Array, Array, Array]:
    """Rows lower ≤ [I; A] Δq ≤ upper: the n joints, dampers of the w watched clearances, p spare for second witnesses.

    Args: watched, near, points of `collision.watch`, p of them between bodies; box of `motion_box`. Returns
    A (w + p, n), lower and upper (n + w + p,).
    """
    (chain, _, links), (_, _, _, acceleration), (normals, _, _), pairs, _, gain = guard
    n, w, k = acceleration.shape[0], watched.shape[0], normals.shape[0]
    rows = w + collision.between_bodies(guard, watched)
    A, lower, upper = np.zeros((rows, n)), np.empty(n + rows), np.empty(n + rows)
    for i in range(n):
        lower[i], upper[i] = box[0, i], box[1, i]
    for i in range(n, n + rows):
        lower[i], upper[i] = -np.inf, np.inf
    if w > 0:
        axes = jacobian.joint_axes(poses, chain)
        for j in range(w):
            pair = watched[j] - pairs[0] * k
            if pair < 0:
                r, p = watched[j] // k, watched[j] % k
                add_point(A, j, at(normals, p), at(points, r), links[r], poses, chain, axes)
            else:
                s, t = near[j, 1], near[j, 2]
                collision.witness_row(A, j, points, links, pairs, pair, s, t, poses, chain, axes)
            lower[n + j] = damper(near[j, 0], A, j, acceleration, gain, dt)
    return A, lower, upper


@kernel
def shortfall(near: Array, after: Array) -> float:
    """By how much the worst came closer than it may: the least distance, or where it was if that is nearer; m."""
    worst = 0.0
    for j in range(near.shape[0]):
        worst = max(worst, min(0.0, near[j, 0]) - after[j, 0])
    return worst


@kernel
def raise_by_loss(
    guard: Guard, A: Array, lower: Array, step: Array, watched: Indices, near: Array, after: Array, points: Array,
    poses: Array,
) -> None:  # fmt: skip
    """Add to the row of what came too close what its linear prediction lost, and a tenth for the rest.

    Bodies may be nearest elsewhere after the step: these witnesses have a row of their own.
    """
    (chain, _, links), _, planes, pairs, _, _ = guard
    n, spare = A.shape[1], collision.between_bodies(guard, watched)
    axes = jacobian.joint_axes(poses, chain)
    for j in range(watched.shape[0]):
        allowed, pair = min(0.0, near[j, 0]), watched[j] - pairs[0] * planes[0].shape[0]
        if after[j, 0] >= allowed:
            continue
        if pair < 0:
            lower[n + j] += 1.1 * (near[j, 0] + qp.dot(A[j], step) - after[j, 0])
            continue
        row, s, t = j + spare, after[j, 1], after[j, 2]
        there = collision.witness_row(A, row, points, links, pairs, pair, s, t, poses, chain, axes)
        lower[n + row] = allowed - there + 1.1 * (there + qp.dot(A[row], step) - after[j, 0])


@kernel
def within(q: Array, step: Array, share: float, limits: LimitArrays, dt: float) -> Array:
    """q and a share of Δq, cut to the limits to the last bit; a joint that is outside keeps its place as its limit.

    What is no number is no step.
    """
    lower, upper, speed, _ = limits
    moved = np.empty_like(q)
    for i in range(q.shape[0]):
        way = share * step[i] if np.isfinite(step[i]) else 0.0
        value = q[i] + min(max(way, -speed[i] * dt), speed[i] * dt)
        moved[i] = min(max(value, min(lower[i], q[i])), max(upper[i], q[i]))
    return moved


@kernel
def given_way(
    task: Task, begins: Indices, A: Array, lower: Array, upper: Array, box: Array, rates: Array, dt: float
) -> tuple[Array, Array, int]:
    """`cascade.descend`; where acceleration leaves no point, its bounds are first widened to the nearest that there is.

    Nearest to going on as before, Δq = q̇ dt. Args: lower, upper (m,): opened in place; box of `motion_box`.
    """
    step, multipliers, verdict = cascade.descend(task, begins, A, lower, upper)
    if verdict == qp.SOLVED:
        return step, multipliers, verdict
    n = rates.shape[0]
    before = lower[:n].copy(), upper[:n].copy()
    lower[:n], upper[:n] = box[2], box[3]
    nearest, _, verdict = qp.project(A, lower, upper, rates * dt)
    if verdict != qp.SOLVED:
        return np.zeros(n), multipliers, verdict
    for i in range(n):
        lower[i] = max(box[2, i], min(before[0][i], nearest[i] - ROUNDING))
        upper[i] = min(box[3, i], max(before[1][i], nearest[i] + ROUNDING))
    step, multipliers, verdict = cascade.descend(task, begins, A, lower, upper)
    return (step if verdict == qp.SOLVED else nearest), multipliers, qp.SOLVED


@kernel
def with_entry(task: Task, begins: Indices, rows: Array, asked: Array) -> tuple[Task, Indices]:
    """The same task after a first level of two rows (2, n) that ask for a displacement (2,), m.

    Two rows alone do not hold all joints: each is damped, if only a little.
    """
    J, v, weights, damping = task
    damping = np.maximum(damping, LEAST_DAMPING)
    r, levels = v.shape[0], np.empty(begins.shape[0] + 1, dtype=np.int64)
    levels[0] = 2
    for k in range(begins.shape[0]):
        levels[k + 1] = begins[k] + 2
    stacked, wished, firm = np.empty((r + 2, J.shape[1])), np.empty(r + 2), np.full(r + 2, FIRM)
    for i in range(r + 2):
        wished[i] = asked[i] if i < 2 else v[i - 2]
        for k in range(J.shape[1]):
            stacked[i, k] = rows[i, k] if i < 2 else J[i - 2, k]
        if i >= 2:
            firm[i] = weights[i - 2]
    return (stacked, wished, firm, damping), levels


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
    J = task[0]
    H, g = cascade.normal_equations(task, 2, begins[1] if begins.shape[0] > 1 else J.shape[0])
    for i in range(step.shape[0]):
        g[i] -= qp.dot(H[i], step)
        g[i] += multipliers[1, i]
        for r in range(A.shape[0]):
            g[i] += A[r, i] * multipliers[1, J.shape[1] + r]
    a, b, c = qp.dot(J[0], J[0]), qp.dot(J[0], J[1]), qp.dot(J[1], J[1])
    s, t = qp.dot(J[0], g), qp.dot(J[1], g)
    determinant = max(a * c - b * b, 1e-12 * a * c)
    return float(np.sqrt((c * s - b * t) ** 2 + (a * t - b * s) ** 2) / determinant) if determinant > 0.0 else 0.0


@kernel
def sorted_out(guard: Guard, multipliers: Array, kinds: Indices, watched: Indices, pull: float) -> Array:
    """The multipliers by what holds: 2 n position limits, clearances, 2 n speed limits, 2 n accelerations, the entry.

    Args: multipliers (levels, n + w + p), the entry's own level first where there is one; kinds (2, n) of `motion_box`;
    watched (w,) of `collision.watch`.
    """
    n, w, clear = kinds.shape[1], watched.shape[0], guard[3][0] * guard[2][0].shape[0] + guard[3][1].shape[0]
    held, spare = np.zeros(6 * n + clear + 1), multipliers.shape[1] - n - w
    for k in range(1 if guard[4][0] > 0 else 0, multipliers.shape[0]):
        for i in range(n):
            side = 0 if multipliers[k, i] > 0.0 else 1
            kind = kinds[side, i]
            start = clear + 2 * n * kind if kind > 0 else 0
            held[start + side * n + i] += abs(multipliers[k, i])
        for j in range(w):
            held[2 * n + watched[j]] += multipliers[k, n + j]
        for j in range(spare):
            held[2 * n + watched[w - spare + j]] += multipliers[k, n + w + j]
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
    chain, limits, entry, through = guard[0][0], guard[1], guard[4], guard[4][0] > 0
    watched, near, points = collision.watch(guard, poses, dt)
    box, kinds = motion_box(q, rates, limits, dt)
    A, lower, upper = hard_rows(guard, poses, watched, near, points, box, dt)
    levels, asked, pair, away = begins, rates, box, rates
    if through:
        rows, asked, pair, away = entry_rows(poses, chain, entry, dt)
        task, levels = with_entry(task, begins, rows, asked)
    step, multipliers, verdict = given_way(task, levels, A, lower, upper, box, rates, dt)
    share, tries, halvings = 1.0, 0, 0
    while share > SMALLEST_SHARE:
        q_after = within(q, step, share, limits, dt)
        poses_after = link_poses(chain, q_after)
        after = collision.measured(guard, poses_after, watched)
        clear, straight = shortfall(near, after) <= 0.0, True
        if through and share == 1.0:
            straight = bend(task, step, asked, away, miss(poses_after, entry, pair))
        if clear and not straight and tries == TRIES and halvings < HALVINGS:
            tries, halvings = 0, halvings + 1
            task[1][:2] = asked
            task[1][2:] *= 0.5
        if clear and (straight or tries == TRIES):
            pull = entry_pull(task, levels, A, step, multipliers) if through else 0.0
            return q_after, poses_after, sorted_out(guard, multipliers, kinds, watched, pull), share
        if tries < (TRIES if through else 1):
            tries += 1
            if not clear:
                raise_by_loss(guard, A, lower, step, watched, near, after, points, poses)
            again, multipliers_again, verdict = given_way(task, levels, A, lower, upper, box, rates, dt)
            if verdict == qp.SOLVED:
                step, multipliers = again, multipliers_again
                continue
        share *= 0.5
    return q.copy(), poses, sorted_out(guard, multipliers, kinds, watched, 0.0), 0.0
