"""Levels: each is solved in what the levels before leave free, and all of them within the same hard rows.

    minimise ‖Wₖ (Jₖ x − vₖ)‖² + Σ dᵢ xᵢ²  over x = xₖ₋₁ + Zₖ u,   Jⱼ Zₖ = 0 for every j < k

u = 0 keeps to the rows because xₖ₋₁ does, so that a level never takes anything from those before it.
Source: Nakamura, Hanafusa and Yoshikawa 1987 (null spaces); Kanoun, Lamiraux and Wieber 2011 (with inequalities).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.ik import qp
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array

DEPENDENT = 1e-6
NEGLIGIBLE = 1e-9


@kernel
def normal_equations(J: Array, v: Array, weights: Array, damping: Array) -> tuple[Array, Array]:
    """H = Jᵀ W² J + diag(d) and g = Jᵀ W² v, for J (r, n), v (r,), weights (r,), damping d (n,)."""
    r, n = J.shape
    H, g = np.zeros((n, n)), np.zeros(n)
    for a in range(n):
        for s in range(r):
            g[a] += weights[s] * weights[s] * J[s, a] * v[s]
        for c in range(a + 1):
            total = 0.0
            for s in range(r):
                total += weights[s] * weights[s] * J[s, a] * J[s, c]
            H[a, c] = H[c, a] = total
        H[a, a] += damping[a]
    return H, g


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
def orthonormalised(rows: Array, basis: Array, count: int, smallest: float) -> int:
    """Extend an orthonormal basis by rows, the longest remainder first, until none is longer than `smallest`.

    Args: rows (m, n), orthogonal to the first `count` rows of basis (n, n); they are used up. Returns the new count.
    """
    while count < basis.shape[0]:
        longest, square = -1, smallest * smallest
        for i in range(rows.shape[0]):
            if qp.dot(rows[i], rows[i]) > square:
                longest, square = i, qp.dot(rows[i], rows[i])
        if longest < 0:
            break
        basis[count] = rows[longest] / np.sqrt(square)
        for i in range(rows.shape[0]):
            for _ in range(2):
                rows[i] -= qp.dot(rows[i], basis[count]) * basis[count]
        rows[longest] = 0.0
        count += 1
    return count


@kernel
def null_space(J: Array) -> Array:
    """Orthonormal columns Z (n, n − rank) with J Z = 0; rows that depend on others up to `DEPENDENT` do not count."""
    n = J.shape[1]
    rows, basis, rest = J.copy(), np.zeros((n, n)), np.eye(n)
    largest = 0.0
    for i in range(J.shape[0]):
        largest = max(largest, qp.dot(J[i], J[i]))
    rank = orthonormalised(rows, basis, 0, DEPENDENT * np.sqrt(largest)) if largest > 0.0 else 0
    for i in range(n):
        for k in range(rank):
            rest[i] -= basis[k, i] * basis[k]
    orthonormalised(rest, basis, rank, DEPENDENT)
    return basis[rank:].T.copy()


@kernel
def reduced_rows(A: Array, Z: Array) -> Array:
    """A Z, with rows that Z leaves nothing of set to zero: they stay as they are."""
    reduced = times(A, Z)
    for i in range(A.shape[0]):
        if qp.dot(reduced[i], reduced[i]) < NEGLIGIBLE * NEGLIGIBLE * qp.dot(A[i], A[i]):
            reduced[i] = 0.0
    return reduced


@kernel
def within_rest(H: Array, g: Array, Z: Array, x: Array, A: Array, lower: Array, upper: Array) -> tuple[Array, Array]:
    """The least ½ xᵀ H x − gᵀ x over x + Z u with lower ≤ A (x + Z u) ≤ upper; gives the new x and the multipliers.

    Where rounding leaves no room, x stays.
    """
    n, rest = H.shape[0], Z.T.copy()
    slope, done = g.copy(), np.empty(A.shape[0])
    for i in range(n):
        slope[i] -= qp.dot(H[i], x)
    for i in range(A.shape[0]):
        done[i] = qp.dot(A[i], x)
    H_rest = times(rest, times(H, Z))
    g_rest = times(rest, slope.reshape(-1, 1))[:, 0].copy()
    u, multipliers, verdict = qp.solve(H_rest, g_rest, reduced_rows(A, Z), lower - done, upper - done)
    if verdict != qp.SOLVED:
        return x, np.zeros(A.shape[0])
    return x + times(Z, u.reshape(-1, 1))[:, 0], multipliers


@kernel
def descend(
    task: tuple[Array, Array, Array, Array], begins: NDArray[np.int64], A: Array, lower: Array, upper: Array
) -> tuple[Array, Array, int]:
    """The displacement that serves the levels in their order, within lower ≤ A x ≤ upper.

    Args: task: J (r, n), v (r,), weights (r,), damping d (n,); begins: the rows at which another level begins, none
    where all rows are one level; A (m, n). Returns x (n,), multipliers (levels, m) and the verdict on the first level.
    """
    J, v, weights, damping = task
    count = begins.shape[0]
    if count == 0:
        H, g = normal_equations(J, v, weights, damping)
        x, alone, verdict = qp.solve(H, g, A, lower, upper)
        return x, alone.reshape(1, -1), verdict
    x, Z, first = np.zeros(J.shape[1]), np.eye(J.shape[1]), 0
    multipliers, verdict = np.zeros((count + 1, A.shape[0])), qp.SOLVED
    for k in range(count + 1):
        end = begins[k] if k < count else J.shape[0]
        H, g = normal_equations(J[first:end], v[first:end], weights[first:end], damping)
        if k == 0:
            x, multipliers[0], verdict = qp.solve(H, g, A, lower, upper)
        else:
            x, multipliers[k] = within_rest(H, g, Z, x, A, lower, upper)
        if k == count or verdict != qp.SOLVED:
            break
        Z = times(Z, null_space(times(weights[first:end].reshape(-1, 1) * J[first:end], Z)))
        if Z.shape[1] == 0:
            break
        first = end
    return x, multipliers, verdict
