"""The constraint rows of clearances: their velocity dampers, and their correction after a step was tried."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard import collision, qp
from helicoide.ik.guard.collision import LEFT, NUMBER, PLANE, POINT, S, T
from helicoide.ik.guard.packed import FIRST, LINK, At
from helicoide.ik.guard.rows import DOWN, UP, damper, point_displacement
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import DRIVER


@kernel_into
def hard_rows(
    arm: Array, at: At, poses: Array, axes: Array, near: Array, points: Array, box: Array, dt: float,
    A: Array, lower: Array, upper: Array, moves: Array,
) -> None:  # fmt: skip
    """Write lower ≤ [I; A] Δq ≤ upper: n joint bounds, dampers of w clearances, unused rows for second witnesses.

    Args: poses and axes of `packed.place_links`; near (w, 4) and points (p, 4) of `collision.watch`; box of
    `motion_box`; moves (n, 4): temporary values.
    """
    n, swept = at.n, -1
    for i in range(n):
        lower[i], upper[i] = box[DOWN, i], box[UP, i]
    for i in range(n, lower.shape[0]):
        lower[i], upper[i] = -np.inf, np.inf
    for j in range(near.shape[0]):
        number = int(near[j, NUMBER])
        if number < at.by_planes:
            point, plane = int(near[j, POINT]), int(near[j, PLANE])
            if point != swept:
                point_displacements(arm, at, poses, axes, points, point, moves)
                swept = point
            for i in range(n):
                A[j, i] = arm[plane, 0] * moves[i, 0] + arm[plane, 1] * moves[i, 1] + arm[plane, 2] * moves[i, 2]
        else:
            pair = at.pairs + number - at.by_planes
            collision.witness_row(A, j, arm, at, pair, points, near[j, S], near[j, T], poses, axes)
        lower[n + j] = damper(near[j, LEFT], A, j, arm, at, dt)


@kernel_into
def point_displacements(arm: Array, at: At, poses: Array, axes: Array, points: Array, which: int, moves: Array) -> None:
    """Write J_pᵀ of one of the points (p, 4), m, world, into moves (n, 4); poses and axes of `packed.place_links`."""
    x, y, z = points[which, 0], points[which, 1], points[which, 2]
    moves[:] = 0.0
    for i in range(int(arm[at.points + which, LINK])):
        column, v = int(arm[FIRST + i, DRIVER]), point_displacement(arm, i, poses, axes, x, y, z)
        moves[column, 0] += v[0]
        moves[column, 1] += v[1]
        moves[column, 2] += v[2]


@kernel_into
def shortfall(near: Array, after: Array) -> float:
    """The largest violation after a step, m: how far a clearance is below 0, or below its value before if negative."""
    worst = 0.0
    for j in range(near.shape[0]):
        worst = max(worst, min(0.0, near[j, LEFT]) - after[j, LEFT])
    return worst


@kernel_into
def raise_bounds(
    arm: Array, at: At, A: Array, lower: Array, step: Array, near: Array, after: Array, points: Array, poses: Array,
    axes: Array,
) -> None:  # fmt: skip
    """Raise the bound of each violated clearance by 1.1 times the error of its linear prediction.

    Two bodies may have other witnesses after the step; these get an additional row.
    """
    n, spare = at.n, collision.between_bodies(at, near)
    for j in range(near.shape[0]):
        allowed, number = min(0.0, near[j, LEFT]), int(near[j, NUMBER])
        if after[j, LEFT] >= allowed:
            continue
        if number < at.by_planes:
            lower[n + j] += 1.1 * (near[j, LEFT] + qp.inner_product(A[j], step) - after[j, LEFT])
            continue
        row, pair = j + spare, at.pairs + number - at.by_planes
        there = collision.witness_row(A, row, arm, at, pair, points, after[j, S], after[j, T], poses, axes)
        lower[n + row] = allowed - there + 1.1 * (there + qp.inner_product(A[row], step) - after[j, LEFT])
