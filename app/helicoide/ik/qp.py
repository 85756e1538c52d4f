"""A small strictly convex quadratic program, solved exactly by the dual active-set method.

minimise ½ ‖y − ŷ‖²  with  lower ≤ C y ≤ upper,  after the change of variables y = Lᵀx, H = L Lᵀ, that makes the Hessian
the identity. Source: Goldfarb and Idnani 1983, A numerically stable dual method for solving strictly convex quadratic
programs; here the active rows are kept orthonormalised (Gram-Schmidt), anew from a row that is dropped.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array

SOLVED, INFEASIBLE = 0, 1


@kernel
def dot(a: Array, b: Array) -> float:
    """a·b, without the call into BLAS that costs more than the work for a handful of numbers."""
    total = 0.0
    for i in range(a.shape[0]):
        total += a[i] * b[i]
    return total


@kernel
def cholesky(H: Array) -> Array:
    """Lower triangular L with L Lᵀ = H, for H (n, n) positive definite; on its diagonal stand 1/Lᵢᵢ."""
    n = H.shape[0]
    L = np.zeros((n, n))
    for i in range(n):
        for j in range(i + 1):
            total = H[i, j]
            for k in range(j):
                total -= L[i, k] * L[j, k]
            L[i, j] = 1.0 / np.sqrt(total) if i == j else total * L[j, j]
    return L


@kernel
def forward_substitution(L: Array, row: Array, solved: Array) -> None:
    """Fill solved (n,) with L⁻¹ a, for a row a (n,) and L of `cholesky`."""
    n = L.shape[0]
    first = 0
    while first < n and row[first] == 0.0:
        solved[first] = 0.0
        first += 1
    for i in range(first, n):
        total = row[i]
        for k in range(first, i):
            total -= L[i, k] * solved[k]
        solved[i] = total * L[i, i]


@kernel
def back_substitution(L: Array, y: Array) -> Array:
    """x with Lᵀ x = y, for y (n,) and L of `cholesky`."""
    n = L.shape[0]
    x = y.copy()
    for i in range(n - 1, -1, -1):
        for k in range(i + 1, n):
            x[i] -= L[k, i] * x[k]
        x[i] *= L[i, i]
    return x


@kernel
def split(c: Array, side: int, Q: Array, R: Array, count: int, z: Array, r: Array, along: Array) -> None:
    """A row as a combination of the active rows and the rest z that is orthogonal to them: side c = Σ rⱼ cⱼ + z.

    Args: c (n,); side ±1; the active rows are Cᵀ = Qᵀ R, the first `count` rows of Q orthonormal, R upper triangular.
    Fills z (n,), r (count,), and along (count,), the components along Q.
    """
    n = c.shape[0]
    for k in range(n):
        z[k] = side * c[k]
    for j in range(count):
        along[j] = r[j] = dot(Q[j], z)
        for k in range(n):
            z[k] -= along[j] * Q[j, k]
    for j in range(count - 1, -1, -1):
        for k in range(j + 1, count):
            r[j] -= R[j, k] * r[k]
        r[j] /= R[j, j]


@kernel
def append(Q: Array, R: Array, count: int, z: Array, along: Array) -> None:
    """One more active row, as `split` gives it."""
    length = np.sqrt(dot(z, z))
    for k in range(z.shape[0]):
        Q[count, k] = z[k] / length
    for j in range(count):
        R[j, count] = along[j]
    R[count, count] = length


@kernel
def lengths(C: Array) -> Array:
    """Length of each row, (m,)."""
    long = np.empty(C.shape[0])
    for i in range(C.shape[0]):
        long[i] = np.sqrt(dot(C[i], C[i]))
    return long


@kernel
def most_violated(
    C: Array, long: Array, lower: Array, upper: Array, y: Array, held: NDArray[np.int64]
) -> tuple[int, int]:
    """The row not yet active that is violated most, over its length and beyond rounding, and its side; −1 for none.

    The side is 1 where cᵢ·y is below its lower bound, −1 where it is above its upper one.
    """
    worst, side, worst_slack = -1, 0, -1e-13 * (1.0 + np.sqrt(dot(y, y)))
    for i in range(C.shape[0]):
        if held[i] != 0 or long[i] == 0.0:
            continue
        value = 0.0
        for k in range(y.shape[0]):
            value += C[i, k] * y[k]
        if value - lower[i] < worst_slack * long[i]:
            worst, side, worst_slack = i, 1, (value - lower[i]) / long[i]
        if upper[i] - value < worst_slack * long[i]:
            worst, side, worst_slack = i, -1, (upper[i] - value) / long[i]
    return worst, side


@kernel
def project(C: Array, lower: Array, upper: Array, y: Array) -> tuple[Array, Array, int]:
    """The point nearest to y where lower ≤ C y ≤ upper.

    Args: C (m, n); lower, upper (m,), infinite where there is no bound; y (n,). Returns the point (n,), the multipliers
    (m,), positive where the lower bound holds and negative where the upper one does, and SOLVED or INFEASIBLE.
    Rows of zeros are skipped.
    """
    m, n = C.shape
    y = y.copy()
    multipliers, held, long = np.zeros(m), np.zeros(m, dtype=np.int64), lengths(C)
    active, count = np.empty(n, dtype=np.int64), 0
    Q, R = np.empty((n, n)), np.empty((n, n))
    z, r, along = np.empty(n), np.empty(n), np.empty(n)
    for _ in range(10 * (m + n)):
        p, side = most_violated(C, long, lower, upper, y, held)
        if p < 0:
            return y, multipliers * held, SOLVED
        bound = lower[p] if side > 0 else -upper[p]
        while True:
            split(C[p], side, Q, R, count, z, r, along)
            curvature = dot(z, z)
            drop, step = -1, np.inf
            for j in range(count):
                if r[j] > 1e-12 and multipliers[active[j]] / r[j] < step:
                    drop, step = j, multipliers[active[j]] / r[j]
            full = np.inf
            if curvature > 1e-20 * long[p] * long[p] and count < n:
                full = (bound - side * dot(C[p], y)) / curvature
            if step == np.inf and full == np.inf:
                return y, multipliers * held, INFEASIBLE
            t = min(step, full)
            if full < np.inf:
                for k in range(n):
                    y[k] += t * z[k]
            for j in range(count):
                multipliers[active[j]] -= t * r[j]
            multipliers[p] += t
            if full <= step:
                append(Q, R, count, z, along)
                active[count] = p
                held[p] = side
                count += 1
                break
            multipliers[active[drop]] = 0.0
            held[active[drop]] = 0
            for j in range(drop, count - 1):
                active[j] = active[j + 1]
                split(C[active[j]], held[active[j]], Q, R, j, z, r, along)
                append(Q, R, j, z, along)
            count -= 1
    return y, multipliers * held, INFEASIBLE


@kernel
def holds(A: Array, lower: Array, upper: Array, x: Array) -> bool:
    """Whether lower ≤ A x ≤ upper."""
    for i in range(A.shape[0]):
        value = 0.0
        for k in range(x.shape[0]):
            value += A[i, k] * x[k]
        if value < lower[i] or value > upper[i]:
            return False
    return True


@kernel
def solve(H: Array, g: Array, A: Array, lower: Array, upper: Array) -> tuple[Array, Array, int]:
    """minimise ½ xᵀ H x − gᵀ x  with  lower ≤ A x ≤ upper.

    Args: H (n, n) positive definite; g (n,); A (m, n); lower, upper (m,), infinite where there is no bound.
    Returns x (n,), the multipliers of `project` (m,), H x − g = Aᵀ μ, and SOLVED or INFEASIBLE.
    """
    L = cholesky(H)
    y = np.empty(g.shape[0])
    forward_substitution(L, g, y)
    x = back_substitution(L, y)
    if holds(A, lower, upper, x):
        return x, np.zeros(A.shape[0]), SOLVED
    C = np.empty(A.shape)
    for i in range(A.shape[0]):
        forward_substitution(L, A[i], C[i])
    y, multipliers, verdict = project(C, lower, upper, y)
    return back_substitution(L, y), multipliers, verdict
