"""The small system of a step of a search, in blocks of position and orientation: kernels.

    (J Jᵀ + λ) y = e,   J Jᵀ + λ = [P Qᵀ; Q R]

There are six equations for any number of joints, so no temporary arrays are needed. Each block is factored as L D Lᵀ.
Source: Golub and Van Loan 2013, Matrix computations, §3.2 (Schur's complement) and §4.1.
"""

from __future__ import annotations

from helicoide.arrays import Array
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import Triple, dot

Error = tuple[float, float, float, float, float, float]
Symmetric = tuple[float, float, float, float, float, float]  # xx, xy, xz, yy, yz, zz
Factors = tuple[Triple, Triple]  # l₂₁, l₃₁ and l₃₂ of L; 1/d₁, 1/d₂ and 1/d₃


@kernel_into
def plus(a: Triple, x: float, b: Triple) -> Triple:
    """a + x b."""
    return a[0] + x * b[0], a[1] + x * b[1], a[2] + x * b[2]


@kernel_into
def plus_square(A: Symmetric, v: Triple) -> Symmetric:
    """A + v vᵀ."""
    x, y, z = v
    return A[0] + x * x, A[1] + x * y, A[2] + x * z, A[3] + y * y, A[4] + y * z, A[5] + z * z


@kernel_into
def factors(A: Symmetric) -> Factors:
    """L and D⁻¹ of A = L D Lᵀ."""
    xx, xy, xz, yy, yz, zz = A
    a = 1.0 / xx
    yx, zx = a * xy, a * xz
    b, below = 1.0 / (yy - yx * xy), yz - yx * xz
    zy = b * below
    return (yx, zx, zy), (a, b, 1.0 / (zz - zx * xz - zy * below))


@kernel_into
def forward(F: Factors, v: Triple) -> Triple:
    """L⁻¹ v."""
    (yx, zx, zy), _ = F
    y = v[1] - yx * v[0]
    return v[0], y, v[2] - zx * v[0] - zy * y


@kernel_into
def divided_by_pivots(F: Factors, v: Triple) -> Triple:
    """D⁻¹ v."""
    _, d = F
    return d[0] * v[0], d[1] * v[1], d[2] * v[2]


@kernel_into
def backward(F: Factors, v: Triple) -> Triple:
    """L⁻ᵀ v."""
    (yx, zx, zy), _ = F
    y = v[1] - zy * v[2]
    return v[0] - yx * y - zx * v[2], y, v[2]


@kernel_into
def solve_damped(columns: Array, e: Error, damping: float) -> Error:
    """y of (J Jᵀ + λ) y = e: with P = L D Lᵀ and H = L⁻¹ Qᵀ, first (R − Hᵀ D⁻¹ H) y₂ = e₂ − Hᵀ D⁻¹ L⁻¹ e₁, then y₁.

    Args: columns (n, ≥ 6) of J, position first; damping: λ > 0, without which arms with fewer than six joints have no
    solution.
    """
    P = R = (damping, 0.0, 0.0, damping, 0.0, damping)
    x = y = z = (0.0, 0.0, 0.0)
    for i in range(columns.shape[0]):
        column = columns[i]
        v, w = (column[0], column[1], column[2]), (column[3], column[4], column[5])
        P, R = plus_square(P, v), plus_square(R, w)
        x, y, z = plus(x, w[0], v), plus(y, w[1], v), plus(z, w[2], v)
    F = factors(P)
    x, y, z, e1 = forward(F, x), forward(F, y), forward(F, z), forward(F, (e[0], e[1], e[2]))
    a, b, c = divided_by_pivots(F, x), divided_by_pivots(F, y), divided_by_pivots(F, z)
    xx, xy, xz, yy, yz, zz = R
    G = factors((xx - dot(x, a), xy - dot(x, b), xz - dot(x, c), yy - dot(y, b), yz - dot(y, c), zz - dot(z, c)))
    e2 = (e[3] - dot(a, e1), e[4] - dot(b, e1), e[5] - dot(c, e1))
    y2 = backward(G, divided_by_pivots(G, forward(G, e2)))
    y1 = backward(F, divided_by_pivots(F, plus(plus(plus(e1, -y2[0], x), -y2[1], y), -y2[2], z)))
    return y1[0], y1[1], y1[2], y2[0], y2[1], y2[2]
