"""The quadratic program: optimality by its conditions, against every choice of active rows, and against scipy."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize

from helicoide.arrays import Array
from helicoide.ik.guard import qp
from helicoide.ik.guard.qp import Constraints

seeds = st.integers(0, 2**32 - 1)
Program = tuple[Array, Array, Array, Array]


def feasible(seed: int, n: int, m: int) -> Program:
    """A random program with a point inside: some rows touch it, one is repeated, one may be zero."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(n, n)) * rng.choice([0.1, 1.0, 3.0], size=(n, 1))
    A = rng.normal(size=(m, n)) * rng.choice([1e-2, 1.0, 10.0], size=(m, 1))
    if m >= 3:
        A[-1] = A[0] * rng.choice([1.0, 2.0])
        A[-2] = 0.0 if rng.random() < 0.3 else A[-2]
    slack = rng.random(m) * (rng.permutation(m) >= rng.integers(3))
    inside = rng.normal(size=n)
    return root @ root.T + 1e-2 * np.eye(n), 5 * rng.normal(size=n), A, A @ inside - slack


def solved(program: Program) -> tuple[Array, Array, int]:
    """With A x ≥ b as the lower bound alone."""
    H, g, A, b = program
    (x, multipliers), verdict = qp.solve_qp(H, g, Constraints(A, b, np.full(len(b), np.inf)))
    return x, multipliers, verdict


def cost(program: Program, x: Array) -> float:
    H, g, _, _ = program
    return float(x @ H @ x / 2 - g @ x)


@settings(max_examples=300)
@given(seed=seeds, n=st.integers(1, 7), m=st.integers(0, 30))
def test_the_solution_meets_the_optimality_conditions(seed: int, n: int, m: int) -> None:
    """H x − g = Aᵀ μ, μ ≥ 0, A x ≥ b, μ (A x − b) = 0 (Karush, Kuhn and Tucker)."""
    H, g, A, b = feasible(seed, n, m)
    x, multipliers, verdict = solved((H, g, A, b))
    scale = 1 + np.abs(g).max() + np.abs(A.T @ multipliers).max()
    assert verdict == qp.SOLVED
    assert (multipliers >= 0).all()
    assert (A @ x - b >= -1e-9 * scale).all()
    np.testing.assert_allclose(H @ x - g, A.T @ multipliers, rtol=0, atol=1e-8 * scale)
    np.testing.assert_allclose(multipliers * (A @ x - b), 0, atol=1e-7 * scale)


def enumerated(program: Program) -> float:
    """The least cost over every set of rows held as equations whose solution is allowed."""
    H, g, A, b = program
    n, best = len(g), np.inf
    for size in range(n + 1):
        for rows in map(list, combinations(range(len(b)), size)):
            C = A[rows]
            if np.linalg.matrix_rank(C) < size:
                continue
            kkt = np.block([[H, -C.T], [C, np.zeros((size, size))]])
            x = np.linalg.solve(kkt, np.concatenate((g, b[rows])))[:n]
            if (A @ x - b >= -1e-9).all():
                best = min(best, cost(program, x))
    return best


@settings(max_examples=60)
@given(seed=seeds, n=st.integers(1, 3), m=st.integers(1, 6))
def test_the_solution_is_the_best_of_all_active_sets(seed: int, n: int, m: int) -> None:
    program = feasible(seed, n, m)
    x, _, verdict = solved(program)
    assert verdict == qp.SOLVED
    assert cost(program, x) == pytest.approx(enumerated(program), rel=1e-7, abs=1e-9)


@settings(max_examples=200)
@given(seed=seeds, n=st.integers(1, 7), m=st.integers(0, 12))
def test_a_contradiction_is_infeasible(seed: int, n: int, m: int) -> None:
    """Rows that ask for c·x ≥ 1 and −c·x ≥ −0.5, anywhere among others."""
    H, g, A, b = feasible(seed, n, m)
    rng = np.random.default_rng(seed + 1)
    c = rng.normal(size=n)
    A, b = np.vstack((A, c, -c)), np.array([*b, 1.0, -0.5])
    order = rng.permutation(len(b))
    *_, verdict = solved((H, g, np.ascontiguousarray(A[order]), b[order]))
    assert verdict == qp.INFEASIBLE


def test_without_rows_that_hold_it_is_the_free_minimum() -> None:
    H, g, A, b = feasible(1, 5, 8)
    x, multipliers, _ = solved((H, g, A, b - 1e6))
    np.testing.assert_allclose(x, np.linalg.solve(H, g), rtol=1e-9)
    assert not multipliers.any()


def test_a_corner_of_a_box() -> None:
    """By hand: the point of the unit square nearest to (3, 0.5) is (1, 0.5), pushed back from above with 2."""
    square = Constraints(np.eye(2), np.zeros(2), np.ones(2))
    (x, multipliers), verdict = qp.solve_qp(np.eye(2), np.array([3.0, 0.5]), square)
    assert verdict == qp.SOLVED
    np.testing.assert_allclose(x, [1, 0.5])
    np.testing.assert_allclose(multipliers, [-2, 0])


@settings(max_examples=200)
@given(seed=seeds, n=st.integers(1, 7), m=st.integers(0, 15))
def test_an_upper_bound_is_a_lower_bound_of_the_row_turned_round(seed: int, n: int, m: int) -> None:
    """Random bands of rows, some closed to an equation: as 2 m rows with lower bounds they have the same solution."""
    H, g, A, lower = feasible(seed, n, m)
    rng = np.random.default_rng(seed + 2)
    upper = lower + rng.random(m) * rng.choice([0.1, 3.0]) + 2 * np.abs(A).sum(axis=1)
    if m and n > 1:
        upper[0] = lower[0] = float(A[0] @ np.linalg.lstsq(A, lower, rcond=None)[0])
    (x, multipliers), verdict = qp.solve_qp(H, g, Constraints(A, lower, upper))
    twice = np.vstack((A, -A)), np.concatenate((lower, -upper))
    expected, _, of_twice = solved((H, g, *twice))
    assert verdict == of_twice
    if verdict == qp.SOLVED:
        scale = 1 + np.abs(expected).max() + np.abs(A.T @ multipliers).max()
        np.testing.assert_allclose(x, expected, rtol=0, atol=1e-6 * scale)
        np.testing.assert_allclose(H @ x - g, A.T @ multipliers, rtol=0, atol=1e-8 * scale)


@settings(max_examples=25)
@given(seed=seeds, n=st.integers(2, 6), m=st.integers(1, 8))
def test_scipy_finds_nothing_cheaper(seed: int, n: int, m: int) -> None:
    program = H, g, A, b = feasible(seed, n, m)
    x, _, _ = solved(program)
    rows = {"type": "ineq", "fun": lambda x: A @ x - b, "jac": lambda x: A}
    other = minimize(lambda x: cost(program, x), x, jac=lambda x: H @ x - g, constraints=rows, method="SLSQP")
    assert cost(program, x) <= other.fun + 1e-7 * (1 + abs(other.fun))
