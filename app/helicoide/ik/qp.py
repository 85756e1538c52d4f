"""A small strictly convex quadratic program, solved exactly by the dual active-set method.

minimise ½ ‖y − ŷ‖²  with  cᵢ·y ≥ bᵢ,  after the change of variables y = Lᵀx, H = L Lᵀ, that makes the Hessian the
identity. Source: Goldfarb and Idnani 1983, A numerically stable dual method for solving strictly convex quadratic
programs; here the active rows are kept orthonormalised (Gram-Schmidt), anew from a row that is dropped.
"""

from __future__ import annotations

import numpy as np

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
    """Lower triangular L with L Lᵀ = H, for H (n, n) positive definite."""
    n = H.shape[0]
    L = np.zeros((n, n))
    for i in range(n):
        for j in range(i + 1):
            total = H[i, j]
            for k in range(j):
                total -= L[i, k] * L[j, k]
            L[i, j] = np.sqrt(total) if i == j else total / L[j, j]
    return L


@kernel
def forward_substitution(L: Array, rows: Array) -> Array:
    """The rows (m, n) each multiplied by L⁻¹: cᵢ = L⁻¹ aᵢ."""
    solved = rows.copy()
    n = L.shape[0]
    for r in range(rows.shape[0]):
        for i in range(n):
            total = solved[r, i]
            for k in range(i):
                total -= L[i, k] * solved[r, k]
            solved[r, i] = total / L[i, i]
    return solved


@kernel
def back_substitution(L: Array, y: Array) -> Array:
    """x with Lᵀ x = y, for y (n,)."""
    n = L.shape[0]
    x = y.copy()
    for i in range(n - 1, -1, -1):
        for k in range(i + 1, n):
            x[i] -= L[k, i] * x[k]
        x[i] /= L[i, i]
    return x


@kernel
def split(c: Array, Q: Array, R: Array, count: int) -> tuple[Array, Array, Array]:
    """A row as a combination of the active rows and the rest z that is orthogonal to them: c = Σ rⱼ cⱼ + z.

    Args: c (n,); the active rows are Cᵀ = Qᵀ R, the first `count` rows of Q orthonormal, R upper triangular.
    Returns z (n,), r (count,), and the components of c along Q (count,).
    """
    z = c.copy()
    along, r = np.empty(count), np.empty(count)
    for j in range(count):
        along[j] = r[j] = dot(Q[j], z)
        for k in range(z.shape[0]):
            z[k] -= along[j] * Q[j, k]
    for j in range(count - 1, -1, -1):
        for k in range(j + 1, count):
            r[j] -= R[j, k] * r[k]
        r[j] /= R[j, j]
    return z, r, along


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
def most_violated(C: Array, b: Array, y: Array, multipliers: Array) -> int:
    """The row not yet active whose slack cᵢ·y − bᵢ, over its length, is smallest and below rounding; −1 for none."""
    worst, worst_slack = -1, -1e-13 * (1.0 + np.sqrt(dot(y, y)))
    for i in range(C.shape[0]):
        if multipliers[i] > 0.0:
            continue
        slack, square = -b[i], 0.0
        for k in range(C.shape[1]):
            slack += C[i, k] * y[k]
            square += C[i, k] * C[i, k]
        if square > 0.0:
            slack /= np.sqrt(square)
            if slack < worst_slack:
                worst, worst_slack = i, slack
    return worst


@kernel
def project(C: Array, b: Array, y: Array) -> tuple[Array, Array, int]:
    """The point nearest to y where C y ≥ b.

    Args: C (m, n); b (m,); y (n,). Returns the point (n,), the multipliers (m,) ≥ 0, and SOLVED or INFEASIBLE.
    Rows of zeros are skipped.
    """
    m, n = C.shape
    y = y.copy()
    multipliers = np.zeros(m)
    active, count = np.empty(n, dtype=np.int64), 0
    Q, R = np.empty((n, n)), np.empty((n, n))
    for _ in range(10 * (m + n)):
        p = most_violated(C, b, y, multipliers)
        if p < 0:
            return y, multipliers, SOLVED
        while True:
            z, r, along = split(C[p], Q, R, count)
            curvature = dot(z, z)
            drop, step = -1, np.inf
            for j in range(count):
                if r[j] > 1e-12 and multipliers[active[j]] / r[j] < step:
                    drop, step = j, multipliers[active[j]] / r[j]
            full = np.inf
            if curvature > 1e-20 * dot(C[p], C[p]) and count < n:
                full = (b[p] - dot(C[p], y)) / curvature
            if step == np.inf and full == np.inf:
                return y, multipliers, INFEASIBLE
            t = min(step, full)
            if full < np.inf:
                y += t * z
            for j in range(count):
                multipliers[active[j]] -= t * r[j]
            multipliers[p] += t
            if full <= step:
                append(Q, R, count, z, along)
                active[count] = p
                count += 1
                break
            multipliers[active[drop]] = 0.0
            for j in range(drop, count - 1):
                active[j] = active[j + 1]
                z, _, along = split(C[active[j]], Q, R, j)
                append(Q, R, j, z, along)
            count -= 1
    return y, multipliers, INFEASIBLE


@kernel
def solve(H: Array, g: Array, A: Array, b: Array) -> tuple[Array, Array, int]:
    """minimise ½ xᵀ H x − gᵀ x  with  A x ≥ b.

    Args: H (n, n) positive definite; g (n,); A (m, n); b (m,). Returns x (n,), multipliers (m,), SOLVED or INFEASIBLE.
    """
    L = cholesky(H)
    y = forward_substitution(L, g.reshape(1, -1))[0]
    y, multipliers, verdict = project(forward_substitution(L, A), b, y)
    return back_substitution(L, y), multipliers, verdict
