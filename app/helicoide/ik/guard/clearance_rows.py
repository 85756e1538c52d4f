"""The constraint rows of clearances: their velocity dampers, and their correction after a step was tried."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard import collision, qp
from helicoide.ik.guard.collision import LEFT, NUMBER, PLANE, POINT, S, T, Watched, Witnesses
from helicoide.ik.guard.packed import FIRST, LINK, PlacedArm
from helicoide.ik.guard.qp import Constraints
from helicoide.ik.guard.rows import DOWN, UP, MotionBox, at_row, damper, point_displacement
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import DRIVER


@kernel_into
def hard_rows(placed: PlacedArm, watched: Watched, motion: MotionBox, constraints: Constraints, moves: Array) -> None:
    """Write the constraints of Δq: n joint bounds, dampers of w clearances, unused rows for second witnesses.

    Args: moves (n, 4): temporary values.
    """
    (arm, at, _, _, _), (points, near, _), (A, lower, upper) = placed, watched, constraints
    n, swept = at.n, -1
    for i in range(n):
        lower[i], upper[i] = motion.bounds[DOWN, i], motion.bounds[UP, i]
    for i in range(n, lower.shape[0]):
        lower[i], upper[i] = -np.inf, np.inf
    for j in range(near.shape[0]):
        number = int(near[j, NUMBER])
        if number < at.by_planes:
            point, plane = int(near[j, POINT]), int(near[j, PLANE])
            if point != swept:
                point_displacements(placed, points, point, moves)
                swept = point
            for i in range(n):
                A[j, i] = arm[plane, 0] * moves[i, 0] + arm[plane, 1] * moves[i, 1] + arm[plane, 2] * moves[i, 2]
        else:
            witnesses = Witnesses(at.pairs + number - at.by_planes, near[j, S], near[j, T])
            collision.witness_row(A[j], placed, points, witnesses)
        lower[n + j] = damper(near[j, LEFT], A, j, arm, at, motion.dt)


@kernel_into
def point_displacements(placed: PlacedArm, points: Array, which: int, moves: Array) -> None:
    """Write J_pᵀ of one of the points (p, 4), m, world, into moves (n, 4)."""
    (arm, at, _, poses, axes), point = placed, at_row(points, which)
    moves[:] = 0.0
    for i in range(int(arm[at.points + which, LINK])):
        column, v = int(arm[FIRST + i, DRIVER]), point_displacement(arm, i, poses, axes, point)
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
def raise_bounds(placed: PlacedArm, watched: Watched, constraints: Constraints, step: Array) -> None:
    """Raise the bound of each clearance that a step violates by 1.1 times the error of its linear prediction.

    Two bodies may have other witnesses after the step; these get an additional row.
    Args: placed: the arm before the step; step: Δq (n,).
    """
    (_, at, _, _, _), (points, near, after), (A, lower, _) = placed, watched, constraints
    collision.place_bodies(placed, points)
    n, spare = at.n, collision.between_bodies(at, near)
    for j in range(near.shape[0]):
        allowed, number = min(0.0, near[j, LEFT]), int(near[j, NUMBER])
        if after[j, LEFT] >= allowed:
            continue
        if number < at.by_planes:
            lower[n + j] += 1.1 * (near[j, LEFT] + qp.inner_product(A[j], step) - after[j, LEFT])
            continue
        row, witnesses = j + spare, Witnesses(at.pairs + number - at.by_planes, after[j, S], after[j, T])
        there = collision.witness_row(A[row], placed, points, witnesses)
        lower[n + row] = allowed - there + 1.1 * (there + qp.inner_product(A[row], step) - after[j, LEFT])
