"""The small system of a step: its blocks, and the step itself, also of arms that leave the system open."""

from __future__ import annotations

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.ik.postures import blocks


@pytest.mark.parametrize("damping", [1.0, 1e-3, 1e-9, 1e-12])
@pytest.mark.parametrize("n", range(1, 10))
def test_a_step_is_that_of_least_squares(n: int, damping: float) -> None:
    """Jᵀ (J Jᵀ + λ)⁻¹ e, whose system has no solution without λ where there are fewer than six joints."""
    random = np.random.default_rng(n)
    for _ in range(20):
        columns, e = random.normal(size=(n, 6)), random.normal(size=6)
        step = columns @ blocks.solve_damped(columns, tuple(e.tolist()), damping)
        expected = np.linalg.lstsq(np.vstack([columns.T, np.sqrt(damping) * np.eye(n)]), np.append(e, np.zeros(n)))[0]
        np.testing.assert_allclose(step, expected, rtol=0, atol=1e-14 / damping + 1e-10 * np.abs(expected).max())


def test_columns_in_one_plane_leave_the_others_alone() -> None:
    """As of a planar arm, whose blocks are both singular but for λ: whatever lies across the plane asks for nothing."""
    random = np.random.default_rng(0)
    columns = np.zeros((3, 6))
    columns[:, [0, 1, 5]] = random.normal(size=(3, 3))
    e = random.normal(size=6)
    step = columns @ blocks.solve_damped(columns, tuple(e.tolist()), 1e-12)
    np.testing.assert_allclose(columns.T @ step, e * [1, 1, 0, 0, 0, 1], rtol=0, atol=1e-9)


def lower(F: blocks.Factors) -> Array:
    (yx, zx, zy), _ = F
    return np.array([[1, 0, 0], [yx, 1, 0], [zx, zy, 1]])


def test_the_factors_are_those_of_the_block() -> None:
    random = np.random.default_rng(1)
    for _ in range(20):
        A, v = random.normal(size=(3, 3)), random.normal(size=3)
        A = A @ A.T
        F = blocks.factors((A[0, 0], A[0, 1], A[0, 2], A[1, 1], A[1, 2], A[2, 2]))
        L, D = lower(F), np.diag(1 / np.array(F[1]))
        np.testing.assert_allclose(L @ D @ L.T, A, rtol=0, atol=1e-13)
        np.testing.assert_allclose(L @ blocks.forward(F, tuple(v)), v, rtol=0, atol=1e-12)
        np.testing.assert_allclose(L.T @ blocks.backward(F, tuple(v)), v, rtol=0, atol=1e-12)
        np.testing.assert_allclose(D @ blocks.divided_by_pivots(F, tuple(v)), v, rtol=0, atol=1e-12)
