"""Levels: none takes anything from those before it, and all keep to the same rows."""

from __future__ import annotations

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.linalg import norm

from helicoide.arrays import Array
from helicoide.ik.guard import cascade, qp
from helicoide.ik.guard.cascade import DEPENDENT, null_space
from helicoide.ik.guard.qp import Constraints

seeds = st.integers(0, 2**32 - 1)
Task = tuple[Array, Array, Array, Array]


def descend(task: Task, begins: Array, constraints: Constraints) -> tuple[Array, Array, int]:
    """What `cascade.solve_cascade` writes: x and the multipliers; and its verdict."""
    x, multipliers = np.empty(task[0].shape[1]), np.empty((len(begins) + 1, len(constraints.lower)))
    verdict = cascade.solve_cascade(task, begins, constraints, x, multipliers)
    return x, multipliers, verdict


def levels(seed: int, n: int, sizes: tuple[int, ...]) -> tuple[Task, Array]:
    """Random levels; a row of the first may be repeated in the second."""
    rng = np.random.default_rng(seed)
    r = sum(sizes)
    J, v = rng.normal(size=(r, n)), rng.normal(size=r)
    if rng.random() < 0.3:
        J[sizes[0]] = J[0]
    return (J, v, rng.choice([0.1, 1.0], r), np.full(n, 1e-6)), np.cumsum(sizes)[:-1].astype(np.int64)


def first_rows(task: Task, r: int) -> Task:
    J, v, weights, damping = task
    return J[:r], v[:r], weights[:r], damping


def box(n: int, size: float) -> Constraints:
    return Constraints(np.eye(n), np.full(n, -size), np.full(n, size))


def missed(task: Task, rows: slice, x: Array) -> float:
    J, v, weights, _ = task
    return float(np.linalg.norm(weights[rows] * (J[rows] @ x - v[rows])))


@settings(max_examples=100)
@given(seed=seeds, n=st.integers(1, 8), r=st.integers(1, 9), rank=st.integers(0, 8))
def test_a_null_space_is_what_the_rows_do_not_feel(seed: int, n: int, r: int, rank: int) -> None:
    rng, rank = np.random.default_rng(seed), min(rank, n, r)
    J = rng.normal(size=(r, rank)) @ rng.normal(size=(rank, n))
    sigma = np.linalg.svd(J, compute_uv=False)
    assume(not ((sigma > 1e-10 * sigma[0]) & (sigma < 1e-4 * sigma[0])).any())  # its rank is not a matter of opinion
    Z = null_space(J)
    assert Z.shape == (n, n - np.linalg.matrix_rank(J, tol=1e-6 * max(1e-300, np.linalg.norm(J, axis=1).max())))
    np.testing.assert_allclose(J @ Z, 0, atol=1e-8 * max(1.0, np.abs(J).max()))
    np.testing.assert_allclose(Z.T @ Z, np.eye(Z.shape[1]), atol=1e-12)


@settings(max_examples=100)
@given(seed=seeds, n=st.integers(4, 8), size=st.sampled_from([0.2, 1.0, 1e3]))
def test_a_level_takes_nothing_from_those_before_it(seed: int, n: int, size: float) -> None:
    """The first two of three levels are served as well as when they are alone, and the rows are kept."""
    task, begins = levels(seed, n, (2, 2, 3))
    rows = box(n, size)
    x, multipliers, verdict = descend(task, begins, rows)
    alone, _, _ = descend(first_rows(task, 2), begins[:0], rows)
    two, _, _ = descend(first_rows(task, 4), begins[:1], rows)
    assert verdict == qp.SOLVED
    J, v, weights, damping = task
    felt = norm(weights[:, None] * J, 2)
    # the softer the damping, the more of a bound is lost by rounding; the tick cuts the rest off
    rounding = qp.ROUNDING * (1 + norm(x) + felt * (norm(weights * v) + felt * norm(x)) / damping.min())
    assert (np.abs(x) <= size + rounding).all()
    unfelt = DEPENDENT * (1 + felt * norm(x))
    assert abs(missed(task, slice(2), x) - missed(task, slice(2), alone)) < unfelt
    assert abs(missed(task, slice(2, 4), x) - missed(task, slice(2, 4), two)) < unfelt
    assert multipliers.shape == (3, n)


@settings(max_examples=100)
@given(seed=seeds, n=st.integers(4, 8))
def test_without_bounds_the_levels_are_successive_pseudoinverses(seed: int, n: int) -> None:
    """x = J₁† v₁ + (J₂ N₁)† (v₂ − J₂ J₁† v₁), N₁ = I − J₁† J₁ (Nakamura, Hanafusa and Yoshikawa 1987)."""
    rng, damping = np.random.default_rng(seed), 1e-8
    J, v = rng.normal(size=(4, n)), rng.normal(size=4)
    x, _, _ = descend((J, v, np.ones(4), np.full(n, damping)), np.array([2]), box(n, 1e6))
    first = np.linalg.pinv(J[:2])
    second = np.linalg.pinv(J[2:] @ (np.eye(n) - first @ J[:2]))
    x_1 = first @ v[:2]
    x_2 = second @ (v[2:] - J[2:] @ x_1)
    # damping d takes at most d ‖x‖ / σ² from a level; what the first lacks, the second makes up for
    lacking, lacking_2 = (damping * norm(P, 2) ** 2 * norm(part) for P, part in ((first, x_1), (second, x_2)))
    made_up = norm(second, 2) * norm(J[2:], 2) * lacking
    # and damping alone decides what the rows leave free, with the condition number ‖J‖² / d
    rounding = np.finfo(float).eps * norm(J, 2) ** 2 / damping * norm(x)
    np.testing.assert_allclose(x, x_1 + x_2, rtol=0, atol=2 * (lacking + made_up + lacking_2 + 4 * rounding))


def test_one_level_is_the_programme_itself() -> None:
    task, _ = levels(3, 5, (3, 3))
    J, v, weights, damping = task
    x, multipliers, _ = descend(task, np.zeros(0, dtype=np.int64), box(5, 0.3))
    H, g = J.T @ (weights[:, None] ** 2 * J) + np.diag(damping), J.T @ (weights**2 * v)
    (expected, of_rows), _ = qp.solve_qp(H, g, box(5, 0.3))
    np.testing.assert_allclose(x, expected, atol=1e-12)
    np.testing.assert_allclose(multipliers[0], of_rows, atol=1e-12)
    assert np.abs(of_rows).max() > 0
