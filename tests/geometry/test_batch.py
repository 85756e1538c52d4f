"""Many products at once are the products one by one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.geometry.motions import poses, vectors

from helicoide.geometry import batch, pga, rigid
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Algebra, Array
from helicoide.kernels import python_function
from helicoide.text import HelicoideError

ALGEBRAS = (CL031, PGA, QUATERNIONS, Algebra(4, 1, 0))
MOVING = (CL031, PGA)
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
    np.testing.assert_allclose(batch.batch_products(algebra, a, b), expected, atol=1e-13)
    rows = batch.batch_products_by_columns(algebra, np.ascontiguousarray(a.T), np.ascontiguousarray(b.T))
    np.testing.assert_allclose(rows.T, expected, atol=1e-13)
    assert rows.flags.c_contiguous


@pytest.mark.parametrize("algebra", ALGEBRAS, ids=str)
def test_sandwiches(algebra: Algebra) -> None:
    a, b = pairs(algebra, 70)
    expected = one_by_one(algebra, one_by_one(algebra, a, b), algebra.conjugate(a))
    np.testing.assert_allclose(batch.batch_sandwiches(algebra, a, b), expected, atol=1e-11)


@pytest.mark.parametrize("algebra", MOVING, ids=str)
def test_points_moved_by_even_multivectors_of_any_length(algebra: Algebra) -> None:
    motors, points = np.random.default_rng(2).normal(size=(2, 50, 16))
    motors, points = motors * (algebra.grades % 2 == 0), algebra.grade(points, 3)
    expected = algebra.product(algebra.product(motors, points), algebra.conjugate(motors))
    np.testing.assert_allclose(algebra.grade(expected, 3), expected, atol=1e-12)
    moved = batch.move_points(algebra, motors.T[batch.MOTOR_ROWS], points.T[batch.POINT_ROWS])
    np.testing.assert_allclose(moved, expected.T[batch.POINT_ROWS], atol=1e-12)
    np.testing.assert_allclose(batch.move_full_points(algebra, motors, points), expected, atol=1e-12)


@pytest.mark.parametrize("algebra", MOVING, ids=str)
def test_whole_points_are_moved_by_the_even_parts_alone_and_left_as_they_were(algebra: Algebra) -> None:
    motors, points = np.random.default_rng(3).normal(size=(2, 20, 16))
    even, three = motors * (algebra.grades % 2 == 0), algebra.grade(points, 3)
    kept = motors.copy(), points.copy()
    for given_array in (motors, points):
        given_array.setflags(write=False)
    moved = batch.move_full_points(algebra, motors, points)
    np.testing.assert_array_equal(moved, batch.move_full_points(algebra, even, three))
    np.testing.assert_array_equal([motors, points], kept)


@pytest.mark.parametrize("algebra", [QUATERNIONS, Algebra(4, 0, 0)], ids=str)
def test_algebras_without_points_are_refused(algebra: Algebra) -> None:
    rows = np.zeros((16, 2))
    for move, motors, points in (
        (batch.move_points, rows[:8], rows[:4]),
        (batch.move_full_points, rows.T, rows.T),
    ):
        with pytest.raises(HelicoideError, match=r"use Cl\(0,3,1\) or Cl\(3,0,1\)") as caught:
            move(algebra, motors, points)
        assert "pontos" in caught.value.text.pt_BR


@given(st.lists(st.tuples(poses, vectors), min_size=1, max_size=5))
def test_points_go_where_their_poses_take_them(cases: list[tuple[Array, Array]]) -> None:
    Ts, xyz = (np.array(column) for column in zip(*cases, strict=True))
    motors, points = rigid.motor_from_pose(Ts), rigid.point(xyz)
    expected = (Ts[:, :3, :3] @ xyz[..., None])[..., 0] + Ts[:, :3, 3]
    moved = batch.move_full_points(CL031, motors, points)
    np.testing.assert_allclose(rigid.coordinates(moved), expected, rtol=1e-12, atol=1e-12)
    modern = batch.move_full_points(PGA, pga.motor_to_modern(motors), pga.to_modern(points))
    np.testing.assert_allclose(pga.from_modern(modern), moved, rtol=1e-12, atol=1e-12)


def test_kernels_are_their_python_functions() -> None:
    a, b = pairs(CL031, 3)
    out = np.empty((16, 3))
    python_function(batch.multiply_columns)(*CL031.terms, a.T, b.T, out)
    np.testing.assert_allclose(batch.batch_products(CL031, a, b).T, out, atol=1e-14)
    motors, points = a.T[batch.MOTOR_ROWS], b.T[batch.POINT_ROWS]
    moved = np.empty_like(points)
    python_function(batch.move_columns)(1.0, motors[0], motors[1:7], motors[7], points, moved)
    np.testing.assert_allclose(batch.move_points(CL031, motors, points), moved, atol=1e-13)
