"""Task levels: each is solved in the null space of the levels before it, all under the same constraints.

    minimise ‖Wₖ (Jₖ x − vₖ)‖² + Σ dᵢ xᵢ²  over x = xₖ₋₁ + Zₖ u,   Jⱼ Zₖ = 0 for every j < k

u = 0 satisfies the constraints because xₖ₋₁ does, so a level never changes what those before it attain.
Source: Nakamura, Hanafusa and Yoshikawa 1987 (null spaces); Kanoun, Lamiraux and Wieber 2011 (with inequalities).
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.guard import qp
from helicoide.ik.guard.qp import Constraints, QpSolution
from helicoide.ik.guard.rows import Indices, Task
from helicoide.kernels import kernel, kernel_into

DEPENDENT = 1e-6
NEGLIGIBLE = 1e-9


@kernel_into
def normal_equations(task: Task, first: int, end: int, H: Array, g: Array) -> None:
    """Write H = Jᵀ W² J + diag(d) and g = Jᵀ W² v of the rows of a task from `first` to before `end`."""
    J, v, weights, damping = task
    n = J.shape[1]
    for a in range(n):
        g[a] = 0.0
        for c in range(a + 1):
            H[a, c] = damping[a] if a == c else 0.0
    for s in range(first, end):
        square = weights[s] * weights[s]
        for a in range(n):
            pull = square * J[s, a]
            g[a] += pull * v[s]
            for c in range(a + 1):
                H[a, c] += pull * J[s, c]
    for a in range(n):
        for c in range(a):
            H[c, a] = H[a, c]


@kernel
def orthonormalised(rows: Array, basis: Array, count: int, smallest: float) -> int:
    """Extend an orthonormal basis by rows, the longest remainder first, until none is longer than `smallest`.

    Args: rows (m, n), orthogonal to the first `count` rows of basis (n, n); overwritten. Returns the new count.
    """
    n = basis.shape[0]
    while count < n:
        longest, square = -1, smallest * smallest
        for i in range(rows.shape[0]):
            if qp.inner_product(rows[i], rows[i]) > square:
                longest, square = i, qp.inner_product(rows[i], rows[i])
        if longest < 0:
            break
        for k in range(n):
            basis[count, k] = rows[longest, k] / np.sqrt(square)
        for i in range(rows.shape[0]):
            for _ in range(2):
                along = qp.inner_product(rows[i], basis[count])
                for k in range(n):
                    rows[i, k] = rows[i, k] - along * basis[count, k] if i != longest else 0.0
        count += 1
    return count


@kernel
def null_space(J: Array) -> Array:
    """Orthonormal columns Z (n, n − rank) with J Z = 0; rows that depend on others up to `DEPENDENT` do not count."""
    n = J.shape[1]
    rows, basis, rest = J.copy(), np.zeros((n, n)), np.eye(n)
    largest = 0.0
    for i in range(J.shape[0]):
        largest = max(largest, qp.inner_product(J[i], J[i]))
    rank = orthonormalised(rows, basis, 0, DEPENDENT * np.sqrt(largest)) if largest > 0.0 else 0
    for i in range(n):
        for k in range(rank):
            along = basis[k, i]
            for j in range(n):
                rest[i, j] -= along * basis[k, j]
    orthonormalised(rest, basis, rank, DEPENDENT)
    Z = np.empty((n, n - rank))
    for i in range(n):
        for k in range(rank, n):
            Z[i, k - rank] = basis[k, i]
    return Z


@kernel
def times(A: Array, B: Array) -> Array:
    """A B, without BLAS, for small matrices."""
    product = np.zeros((A.shape[0], B.shape[1]))
    for i in range(A.shape[0]):
        for k in range(A.shape[1]):
            for j in range(B.shape[1]):
                product[i, j] += A[i, k] * B[k, j]
    return product


@kernel
def narrowed(task: Task, first: int, end: int, Z: Array) -> Array:
    """The part of Z that a level leaves free: Z N with W J Z N = 0."""
    J, _, weights, _ = task
    felt = times(J[first:end], Z)
    for s in range(first, end):
        for k in range(Z.shape[1]):
            felt[s - first, k] *= weights[s]
    return times(Z, null_space(felt))


@kernel
def reduced_rows(constraints: Constraints, Z: Array, x: Array) -> Constraints:
    """The constraints of x + Z u as rows of u; rows that do not depend on u, up to rounding, are set to zero."""
    A, lower, upper = constraints
    (n, free), bounds = Z.shape, lower.shape[0] - A.shape[0]
    rows, low, high = np.zeros((lower.shape[0], free)), np.empty(lower.shape[0]), np.empty(lower.shape[0])
    for i in range(lower.shape[0]):
        done, square = 0.0, 0.0
        for k in range(n):
            entry = A[i - bounds, k] if i >= bounds else (1.0 if i == k else 0.0)
            done, square = done + entry * x[k], square + entry * entry
            for j in range(free):
                rows[i, j] += entry * Z[k, j]
        low[i], high[i] = lower[i] - done, upper[i] - done
        if qp.inner_product(rows[i], rows[i]) < NEGLIGIBLE * NEGLIGIBLE * square:
            for j in range(free):
                rows[i, j] = 0.0
    return Constraints(rows, low, high)


@kernel
def within_rest(task: Task, first: int, end: int, Z: Array, x: Array, constraints: Constraints) -> QpSolution:
    """The minimum of a level over x + Z u under constraints: the new x and the multipliers.

    Where rounding makes this infeasible, x is unchanged and the multipliers are zero.
    """
    n, free = Z.shape
    H, g = np.empty((n, n)), np.empty(n)
    normal_equations(task, first, end, H, g)
    HZ = times(H, Z)
    H_rest, g_rest = np.zeros((free, free)), np.zeros(free)
    for i in range(n):
        slope = g[i] - qp.inner_product(H[i], x)
        for j in range(free):
            g_rest[j] += Z[i, j] * slope
            for k in range(free):
                H_rest[j, k] += Z[i, j] * HZ[i, k]
    (u, multipliers), verdict = qp.solve_qp(H_rest, g_rest, reduced_rows(constraints, Z, x))
    if verdict != qp.SOLVED:
        return QpSolution(x, np.zeros(multipliers.shape[0]))
    moved = x.copy()
    for i in range(n):
        moved[i] += qp.inner_product(Z[i], u)
    return QpSolution(moved, multipliers)


@kernel_into
def level_buffer_size(n: int) -> int:
    """The size of the array `spare` of `first_level`."""
    return n * (n + 1) + qp.buffer_size(n)


@kernel_into
def first_level(task: Task, end: int, constraints: Constraints, solution: QpSolution, spare: Array) -> int:
    """Write the least-squares displacement x of the rows of a task before `end`, under constraints.

    Args: task: J (r, n), v (r,), weights (r,), damping d (n,); spare (`level_buffer_size`,): temporary values. Returns
    the verdict of `qp.solve_into`.
    """
    n = solution.x.shape[0]
    H, g = spare[: n * n].reshape(n, n), spare[n * n : n * (n + 1)]
    normal_equations(task, 0, end, H, g)
    return qp.solve_into(H, g, constraints, solution, spare[n * (n + 1) :])


@kernel
def solve_cascade(task: Task, begins: Indices, constraints: Constraints, x: Array, multipliers: Array) -> int:
    """Write the displacement x that solves the levels one after another, under constraints.

    Args: task: J (r, n), v (r,), weights (r,), damping d (n,); begins: the rows at which further levels begin, empty
    for one level. Writes x (n,) and the multipliers (levels, b + m); returns the verdict on the first level.
    """
    (r, n), count = task[0].shape, begins.shape[0]
    end = begins[0] if count > 0 else r
    verdict = first_level(task, end, constraints, QpSolution(x, multipliers[0]), np.empty(level_buffer_size(n)))
    for k in range(1, count + 1):
        multipliers[k] = 0.0
    if count > 0 and verdict == qp.SOLVED:
        Z, first = np.eye(n), 0
        for k in range(1, count + 1):
            Z = narrowed(task, first, end, Z)
            if Z.shape[1] == 0:
                break
            first, end = end, begins[k] if k < count else r
            x[:], multipliers[k] = within_rest(task, first, end, Z, x, constraints)
    return verdict
