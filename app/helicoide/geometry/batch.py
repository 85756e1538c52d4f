"""Thousands of products at once, with one multivector per row or one per column.

With columns, the same coefficient of all multivectors is contiguous, which allows vector instructions.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.geometry.clifford import CL031, PGA, Algebra, Array
from helicoide.kernels import kernel
from helicoide.text import HelicoideError, Text

TermIndices = NDArray[np.intp]

# Blocks of this many multivectors with 16 coefficients fit into the fastest cache while their terms are added up.
BLOCK = 64

MOTOR_ROWS = np.flatnonzero(CL031.grades % 2 == 0)
"""Indices of the coefficients of a motor of Cl(0,3,1) or Cl(3,0,1): 1, e1e2, e1e3, e2e3, e1e, e2e, e3e, e1e2e3e."""

POINT_ROWS = np.flatnonzero(CL031.grades == 3)
"""Indices of the coefficients of a point: e1e2e3, e1e2e, e1e3e, e2e3e."""


def batch_products(algebra: Algebra, a: Array, b: Array) -> Array:
    """Geometric products aᵢ bᵢ. a, b: (N, 2ⁿ); returns (N, 2ⁿ). Source: Cerbaro 2022, eqs. 73–74."""
    out = np.empty_like(a)
    multiply_columns(*algebra.terms, a.T, b.T, out.T)
    return out


def batch_products_by_columns(algebra: Algebra, a: Array, b: Array) -> Array:
    """Geometric products with one multivector per column. a, b: (2ⁿ, N); returns (2ⁿ, N)."""
    out = np.empty_like(a)
    multiply_columns(*algebra.terms, a, b, out)
    return out


def batch_sandwiches(algebra: Algebra, a: Array, b: Array) -> Array:
    """Sandwiches aᵢ bᵢ aᵢ* with the Clifford conjugate. a, b: (N, 2ⁿ); returns (N, 2ⁿ).

    Source: Cerbaro 2022, eq. 95 as corrected for points, lines and planes.
    """
    return batch_products(algebra, batch_products(algebra, a, b), algebra.conjugate(a))


def move_points(algebra: Algebra, motors: Array, points: Array) -> Array:
    """Move each point by its motor, M X M*, in Cl(0,3,1) or Cl(3,0,1).

    With M = s + g + (d₀ + d) ε, g and d the coefficients of i, j, k, and X of weight w at v = w r:
    w' = ‖M‖² w and v' = ‖M‖² v + 2 g × (g × v + s v + w d) + 2 w (s d − d₀ g), where ‖M‖² = s² + g·g.
    motors: rows `MOTOR_ROWS`, (8, N); points: rows `POINT_ROWS`, (4, N), m; returns (4, N).
    Source: Cerbaro 2022, eq. 95 as corrected for points, lines and planes, written out in quaternions.
    """
    out = np.empty_like(points)
    move_columns(_orientation_sign(algebra), motors[0], motors[1:7], motors[7], points, out)
    return out


def move_full_points(algebra: Algebra, motors: Array, points: Array) -> Array:
    """`move_points` with one whole multivector per row; odd blades of motors, and grades of points but 3, are ignored.

    motors, points: (N, 16); returns (N, 16).
    """
    out = np.zeros(points.shape)
    M, rows = motors.T, slice(POINT_ROWS[0], POINT_ROWS[-1] + 1)
    move_columns(_orientation_sign(algebra), M[0], M[5:11], M[15], points.T[rows], out.T[rows])
    return out


def _orientation_sign(algebra: Algebra) -> float:
    """Sign of i = e2e3, j = −e1e3, k = e1e2, ε = −e1e2e3e and of a point's e2e3e, −e1e3e, e1e2e against Cl(0,3,1)."""
    if algebra not in (CL031, PGA):
        raise HelicoideError(
            Text(
                en=f"{algebra} has no motors and points to move: use {CL031} or {PGA}",
                pt_BR=f"{algebra} não tem motores e pontos para mover: use {CL031} ou {PGA}",
            )
        )
    return -float(algebra.squares[0])


@kernel
def move_columns(sign: float, scalars: Array, bivectors: Array, volumes: Array, points: Array, out: Array) -> None:
    """The equation of `move_points`, column by column, with the motors split by grade."""
    for i in range(points.shape[1]):
        s, d0 = scalars[i], -sign * volumes[i]
        gx, gy, gz = sign * bivectors[2, i], -sign * bivectors[1, i], sign * bivectors[0, i]
        dx, dy, dz = bivectors[3, i], bivectors[4, i], bivectors[5, i]
        w, x, y, z = points[0, i], sign * points[3, i], -sign * points[2, i], sign * points[1, i]
        squared = s * s + gx * gx + gy * gy + gz * gz
        cx = gy * z - gz * y + s * x + w * dx
        cy = gz * x - gx * z + s * y + w * dy
        cz = gx * y - gy * x + s * z + w * dz
        out[0, i] = squared * w
        out[3, i] = sign * (squared * x + 2 * (gy * cz - gz * cy + w * (s * dx - d0 * gx)))
        out[2, i] = -sign * (squared * y + 2 * (gz * cx - gx * cz + w * (s * dy - d0 * gy)))
        out[1, i] = sign * (squared * z + 2 * (gx * cy - gy * cx + w * (s * dz - d0 * gz)))


@kernel
def multiply_columns(places: TermIndices, factors: Array, a: Array, b: Array, out: Array) -> None:
    """Products of columns, block by block: each row t of `places`, (k, i, j), adds factorsₜ aᵢ bⱼ to outₖ."""
    shape = (out.shape[0], BLOCK)
    left, right, total = np.zeros(shape), np.zeros(shape), np.empty(shape)
    for start in range(0, out.shape[1], BLOCK):
        width = min(BLOCK, out.shape[1] - start)
        left[:, :width] = a[:, start : start + width]
        right[:, :width] = b[:, start : start + width]
        total[:] = 0.0
        for t in range(len(factors)):
            factor, sums, x, y = factors[t], total[places[t, 0]], left[places[t, 1]], right[places[t, 2]]
            for column in range(BLOCK):
                sums[column] += factor * x[column] * y[column]
        out[:, start : start + width] = total[:, :width]
