"""Many products at once are the products one by one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.geometry.motions import poses, vectors

from helicoide.geometry import batch, rigid
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Algebra, Array
from helicoide.kernels import plain

ALGEBRAS = (CL031, PGA, QUATERNIONS, Algebra(4, 1, 0))
COUNTS = (0, 1, batch.BLOCK - 1, batch.BLOCK, 2 * batch.BLOCK + 5)


def pairs(algebra: Algebra, count: int) -> tuple[Array, Array]:
    a, b = np.random.default_rng(count).normal(size=(2, count, len(algebra.blades)))
    return a, b


def one_by_one(algebra: Algebra, a: Array, b: Array) -> Array:
    return np.array([algebra.product(x, y) for x, y in zip(a, b, strict=True)]).reshape(a.shape)


@pytest.mark.parametrize("algebra", ALGEBRAS, ids=str)
@pytest.mark.parametrize("count", COUNTS)
def test_products_in_both_layouts(algebra: Algebra, count: int) -> None:
    a, b = pairs(algebra, count)
    expected = one_by_one(algebra, a, b)
    np.testing.assert_allclose(batch.products(algebra, a, b), expected, atol=1e-13)
    rows = batch.product_rows(algebra, np.ascontiguousarray(a.T), np.ascontiguousarray(b.T))
    np.testing.assert_allclose(rows.T, expected, atol=1e-13)
    assert rows.flags.c_contiguous


@pytest.mark.parametrize("algebra", ALGEBRAS, ids=str)
def test_sandwiches_in_both_layouts(algebra: Algebra) -> None:
    a, b = pairs(algebra, 70)
    expected = one_by_one(algebra, one_by_one(algebra, a, b), algebra.conjugate(a))
    np.testing.assert_allclose(batch.sandwiches(algebra, a, b), expected, atol=1e-11)
    rows = batch.sandwich_rows(algebra, np.ascontiguousarray(a.T), np.ascontiguousarray(b.T))
    np.testing.assert_allclose(rows.T, expected, atol=1e-11)


def test_points_moved_by_even_multivectors_of_any_length() -> None:
    motors, points = np.random.default_rng(2).normal(size=(2, 50, 16))
    motors, points = motors * (CL031.grades % 2 == 0), CL031.grade(points, 3)
    expected = CL031.product(CL031.product(motors, points), CL031.conjugate(motors))
    moved = batch.move_points(motors.T[batch.MOTOR_ROWS], points.T[batch.POINT_ROWS])
    np.testing.assert_allclose(moved, expected.T[batch.POINT_ROWS], atol=1e-12)
    np.testing.assert_allclose(CL031.grade(expected, 3), expected, atol=1e-12)


@given(st.lists(st.tuples(poses, vectors), min_size=1, max_size=5))
def test_points_go_where_their_poses_take_them(cases: list[tuple[Array, Array]]) -> None:
    Ts, xyz = (np.array(column) for column in zip(*cases, strict=True))
    motors, points = rigid.motor_from_pose(Ts), rigid.point(xyz)
    moved = np.zeros_like(points)
    moved[:, batch.POINT_ROWS] = batch.move_points(motors.T[batch.MOTOR_ROWS], points.T[batch.POINT_ROWS]).T
    expected = (Ts[:, :3, :3] @ xyz[..., None])[..., 0] + Ts[:, :3, 3]
    np.testing.assert_allclose(rigid.coordinates(moved), expected, rtol=1e-12, atol=1e-12)


def test_kernels_are_their_python_functions() -> None:
    a, b = pairs(CL031, 3)
    out = np.empty((16, 3))
    plain(batch.multiply_columns)(*CL031.terms, a.T, b.T, out)
    np.testing.assert_allclose(batch.products(CL031, a, b).T, out, atol=1e-14)
    motors, points = a.T[batch.MOTOR_ROWS], b.T[batch.POINT_ROWS]
    moved = np.empty_like(points)
    plain(batch.move_columns)(motors, points, moved)
    np.testing.assert_allclose(batch.move_points(motors, points), moved, atol=1e-13)
