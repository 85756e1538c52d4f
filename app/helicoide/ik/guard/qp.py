"""A small strictly convex quadratic program, solved exactly by the dual active-set method.

minimise ½ xᵀ H x − gᵀ x  with  lower ≤ [I; A] x ≤ upper: bounds of the variables first, then rows. A bound is a row of
the identity, which is not stored. With H = L Lᵀ and y = Lᵀ x the Hessian is the identity, and a row a becomes
c = L⁻¹ a. Rows are checked with x itself; only the row that becomes active is transformed.

Source: Goldfarb and Idnani 1983, A numerically stable dual method for solving strictly convex quadratic programs. Here
the active rows are orthonormalised (Gram-Schmidt), once more from a dropped row on.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel, kernel_into

SOLVED, INFEASIBLE = 0, 1
ROUNDING = 1e-12


class Constraints(NamedTuple):
    """lower ≤ [I; A] x ≤ upper.

    A (m, n); lower, upper (b + m,), infinite where there is no bound: the first b are bounds of x itself, b = n or 0.
    Rows of zeros are skipped.
    """

    A: Array
    lower: Array
    upper: Array


class QpSolution(NamedTuple):
    """A minimum and its multipliers.

    x (n,); multipliers: μ (b + m,), H x − g = [I; A]ᵀ μ, positive where a lower bound holds and negative where an upper
    one does.
    """

    x: Array
    multipliers: Array


class ActiveRows(NamedTuple):
    """The active rows c = side L⁻¹ a and their orthonormalised form, Cᵀ = Qᵀ R; the row that enters comes after them.

    C (n + 1, n); Q (n, n), rows orthonormal; R (n + 1, n + 1) upper triangular; force (n + 1,): their multipliers;
    numbers (n + 1,): theirs in [I; A].
    """

    C: Array
    Q: Array
    R: Array
    force: Array
    numbers: Array


@kernel_into
def inner_product(a: Array, b: Array) -> float:
    """a·b without BLAS, whose call costs more than the sum of a few products."""
    total = 0.0
    for i in range(a.shape[0]):
        total += a[i] * b[i]
    return total


@kernel_into
def copy_into(a: Array, b: Array) -> None:
    """Write a (n,) into b."""
    for i in range(a.shape[0]):
        b[i] = a[i]


@kernel_into
def cholesky(H: Array) -> None:
    """Overwrite H (n, n), positive definite, with L, L Lᵀ = H, below the diagonal, and 1/Lᵢᵢ on the diagonal."""
    for i in range(H.shape[0]):
        for j in range(i + 1):
            total = H[i, j]
            for k in range(j):
                total -= H[i, k] * H[j, k]
            H[i, j] = 1.0 / np.sqrt(total) if i == j else total * H[j, j]


@kernel_into
def forward_substitution(L: Array, a: Array) -> None:
    """Overwrite a (n,) with L⁻¹ a, for L of `cholesky`."""
    n = L.shape[0]
    first = 0
    while first < n and a[first] == 0.0:
        first += 1
    for i in range(first, n):
        total = a[i]
        for k in range(first, i):
            total -= L[i, k] * a[k]
        a[i] = total * L[i, i]


@kernel_into
def back_substitution(L: Array, y: Array, x: Array) -> None:
    """Write L⁻ᵀ y into x, for y (n,) and L of `cholesky`."""
    n = L.shape[0]
    for i in range(n - 1, -1, -1):
        total = y[i]
        for k in range(i + 1, n):
            total -= L[k, i] * x[k]
        x[i] = total * L[i, i]


@kernel_into
def rounding(L: Array, y: Array, x: Array) -> float:
    """A bound of the rounding error of x = L⁻ᵀ y: of the order of ε (1 + ‖x‖ + ‖y‖ / minᵢ Lᵢᵢ), with a wide margin."""
    softest = 0.0
    for i in range(x.shape[0]):
        softest = max(softest, L[i, i])
    return float(ROUNDING * (1.0 + np.sqrt(inner_product(x, x)) + softest * np.sqrt(inner_product(y, y))))


@kernel_into
def most_violated(constraints: Constraints, x: Array, sides: Array, excess: float) -> tuple[int, int]:
    """The most violated inactive row and its side; row −1 where none is violated by more than `excess`.

    The violation is divided by the norm of the row. The side is 1 where aᵢ·x is below its lower bound, −1 where it is
    above its upper one. Args: sides (b + m,), other than 0 for active rows.
    """
    A, lower, upper = constraints
    n, bounds = x.shape[0], lower.shape[0] - A.shape[0]
    worst, side = -1, 0
    for i in range(lower.shape[0]):
        value, square = 0.0, 1.0
        if i < bounds:
            value = x[i]
        else:
            for k in range(n):
                value += A[i - bounds, k] * x[k]
        beyond = max(lower[i] - value, value - upper[i])
        if beyond <= 0.0 or sides[i] != 0.0:
            continue
        if i >= bounds:
            square = 0.0
            for k in range(n):
                square += A[i - bounds, k] * A[i - bounds, k]
        if beyond > excess * np.sqrt(square) and square > 0.0:
            worst, side, excess = i, 1 if value < lower[i] else -1, beyond / np.sqrt(square)
    return worst, side


@kernel_into
def transform(L: Array, A: Array, row: int, side: int, c: Array) -> None:
    """Write side L⁻¹ a into c (n,); `row` is the number of a in [I; A], counted from the first row of A."""
    n = L.shape[0]
    for k in range(n):
        c[k] = side * A[row, k] if row >= 0 else 0.0
    if row < 0:
        c[n + row] = side
    forward_substitution(L, c)


@kernel_into
def split(c: Array, Q: Array, R: Array, count: int, z: Array, r: Array) -> float:
    """Split a row into a combination of the active rows and a rest z orthogonal to them: c = Σ rⱼ cⱼ + z.

    Args: c (n,); the active rows are Cᵀ = Qᵀ R, the first `count` rows of Q orthonormal, R upper triangular.
    Writes z (n,), r (count,), and column `count` of R, the components of c along Q. Returns ‖z‖².
    """
    n = c.shape[0]
    for k in range(n):
        z[k] = c[k]
    for j in range(count):
        along = 0.0
        for k in range(n):
            along += Q[j, k] * z[k]
        for k in range(n):
            z[k] -= along * Q[j, k]
        R[j, count] = r[j] = along
    for j in range(count - 1, -1, -1):
        for k in range(j + 1, count):
            r[j] -= R[j, k] * r[k]
        r[j] /= R[j, j]
    return inner_product(z, z)


@kernel_into
def append(Q: Array, R: Array, count: int, z: Array) -> None:
    """Add an active row to Q and R. Args: z: the rest of the row, of `split`."""
    length = np.sqrt(inner_product(z, z))
    for k in range(z.shape[0]):
        Q[count, k] = z[k] / length
    R[count, count] = length


@kernel_into
def drop(active: ActiveRows, out: int, count: int, z: Array, r: Array) -> None:
    """Remove row `out` of the `count` active rows; those after it, and the entering one, move up by one place.

    Args: z, r: temporary values of `split`.
    """
    C, Q, R, force, numbers = active
    for j in range(out, count):
        numbers[j], force[j] = numbers[j + 1], force[j + 1]
        for k in range(C.shape[1]):
            C[j, k] = C[j + 1, k]
        if j < count - 1:
            split(C[j], Q, R, j, z, r)
            append(Q, R, j, z)


@kernel_into
def buffer_size(n: int) -> int:
    """The size of the array `spare` of `solve_into`."""
    return 4 * n * n + 8 * n + 4


@kernel_into
def active_set(L: Array, y: Array, constraints: Constraints, solution: QpSolution, spare: Array) -> int:
    """Move y to the nearest point where x = L⁻ᵀ y keeps the constraints, and write the multipliers, zero before.

    During the iteration `multipliers` has the sides of the active rows, and `ActiveRows.force` their multipliers.
    Args: spare (`buffer_size`,): temporary values. Returns SOLVED or INFEASIBLE.
    """
    (A, lower, upper), (x, multipliers) = constraints, solution
    n, bounds, count = L.shape[0], lower.shape[0] - A.shape[0], 0
    p, side = most_violated(constraints, x, multipliers, ROUNDING)
    if p < 0:
        return SOLVED
    excess = rounding(L, y, x)
    a, b = (n + 1) * n, (2 * n + 1) * n
    c = b + (n + 1) * (n + 1)
    C, Q, R = spare[:a].reshape(n + 1, n), spare[a:b].reshape(n, n), spare[b:c].reshape(n + 1, n + 1)
    z, r, force, numbers = spare[c : c + n], spare[c + n :], spare[c + 2 * n :], spare[c + 3 * n + 1 :]
    active = ActiveRows(C, Q, R, force, numbers)
    for _ in range(10 * (lower.shape[0] + n)):
        transform(L, A, p - bounds, side, C[count])
        bound = lower[p] if side > 0 else -upper[p]
        multipliers[p], numbers[count], force[count] = side, p, 0.0
        while True:
            entering = C[count]
            curvature = split(entering, Q, R, count, z, r)
            out, step, full = -1, np.inf, np.inf
            for j in range(count):
                if r[j] > 1e-12 and force[j] / r[j] < step:
                    out, step = j, force[j] / r[j]
            if curvature > 1e-20 * inner_product(entering, entering) and count < n:
                full = (bound - inner_product(entering, y)) / curvature
            if step == np.inf and full == np.inf:
                return INFEASIBLE
            t = min(step, full)
            for k in range(n):
                y[k] += t * z[k] if full < np.inf else 0.0
            for j in range(count):
                force[j] -= t * r[j]
            force[count] += t
            if full <= step:
                break
            multipliers[int(numbers[out])] = 0.0
            drop(active, out, count, z, r)
            count -= 1
        append(Q, R, count, z)
        count += 1
        back_substitution(L, y, x)
        excess = max(excess, rounding(L, y, x))
        p, side = most_violated(constraints, x, multipliers, excess)
        if p < 0:
            for j in range(count):
                multipliers[int(numbers[j])] *= force[j]
            return SOLVED
    return INFEASIBLE


@kernel
def project_into_limits(constraints: Constraints, x: Array) -> tuple[QpSolution, int]:
    """The point nearest to x (n,) that keeps the constraints, its multipliers, and the verdict."""
    y, spare = x.copy(), np.empty(buffer_size(x.shape[0]))
    solution = QpSolution(x.copy(), np.zeros(constraints.lower.shape[0]))
    return solution, active_set(np.eye(x.shape[0]), y, constraints, solution, spare)


@kernel_into
def solve_into(H: Array, g: Array, constraints: Constraints, solution: QpSolution, spare: Array) -> int:
    """Write the solution of: minimise ½ xᵀ H x − gᵀ x under constraints. Returns SOLVED or INFEASIBLE.

    Args: H (n, n) positive definite, of which the lower half is read, and g (n,): both are overwritten; spare
    (`buffer_size`,): temporary values.
    """
    solution.multipliers[:] = 0.0
    cholesky(H)
    forward_substitution(H, g)
    back_substitution(H, g, solution.x)
    return active_set(H, g, constraints, solution, spare)


@kernel
def solve_qp(H: Array, g: Array, constraints: Constraints) -> tuple[QpSolution, int]:
    """`solve_into` with new arrays and H and g unchanged: the solution and the verdict."""
    solution = QpSolution(np.empty(g.shape[0]), np.empty(constraints.lower.shape[0]))
    return solution, solve_into(H.copy(), g.copy(), constraints, solution, np.empty(buffer_size(g.shape[0])))
