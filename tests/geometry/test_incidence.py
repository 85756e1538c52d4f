from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.geometry.motions import axes, poses, vectors

from helicoide.geometry import incidence, rigid
from helicoide.geometry.clifford import CL031, Array

offsets = st.floats(-3, 3)
ORIGIN = rigid.point((0, 0, 0))
Z = rigid.line((0, 0, 1), (0, 0, 0))


def unit(v: Array) -> Array:
    return np.asarray(v / np.linalg.norm(v))


def crossing(v1: Array, v2: Array) -> bool:
    return bool(np.linalg.norm(np.cross(v1, v2)) > 1e-3)


@given(vectors, vectors)
def test_two_points_join_in_the_line_from_one_to_the_other(p: Array, q: Array) -> None:
    assume(np.linalg.norm(q - p) > 1e-3)
    found = incidence.join(rigid.point(p), rigid.point(q))
    np.testing.assert_allclose(found, rigid.line(unit(q - p), p), atol=1e-11)
    np.testing.assert_allclose(
        CL031.regressive(rigid.point(p), rigid.point(q)), np.linalg.norm(q - p) * found, atol=1e-12
    )
    np.testing.assert_array_equal(incidence.join(rigid.point(q), rigid.point(p)), -found)


@given(axes, vectors, vectors)
def test_a_line_and_a_point_join_in_a_plane(v: Array, r: Array, p: Array) -> None:
    normal = np.cross(v, p - r)
    assume(np.linalg.norm(normal) > 1e-3)
    found = incidence.join(rigid.line(v, r), rigid.point(p))
    np.testing.assert_allclose(found, rigid.plane(unit(normal), unit(normal) @ p), atol=1e-11)


@given(vectors, vectors, vectors)
def test_three_points_join_in_the_plane_of_eqs_25_and_26_reversed(p: Array, q: Array, r: Array) -> None:
    assume(np.linalg.norm(np.cross(q - p, r - p)) > 1e-3)
    points = rigid.point(p), rigid.point(q), rigid.point(r)
    np.testing.assert_allclose(incidence.join(*points), -rigid.plane_through(*points), atol=1e-9)


def test_the_plane_of_the_example() -> None:
    """Cerbaro 2022, eqs. 27–30, with the opposite face."""
    points = rigid.point([(1, 2, 3), (2, -2, 3), (-1, 1, 0)])
    normal, offset = rigid.normal_and_offset(incidence.join(*points))
    np.testing.assert_allclose([*normal, offset], [0.7845, 0.1961, -0.5883, -0.5883], atol=1e-4)


@given(vectors, axes, st.floats(-3, 3), st.floats(-3, 3))
def test_what_spans_nothing_joins_in_zero(r: Array, v: Array, a: float, b: float) -> None:
    p, q, s = (rigid.point(r + round(k, 2) * v) for k in (0, a, b))
    np.testing.assert_array_equal(incidence.join(p, p), 0)
    np.testing.assert_array_equal(incidence.join(p, q, s), 0)
    np.testing.assert_array_equal(incidence.join(rigid.line(v, r), s), 0)
    assert not incidence.is_finite(incidence.join(p, q, s))


@given(axes, offsets, axes, offsets)
def test_two_planes_meet_in_a_line(n1: Array, d1: float, n2: Array, d2: float) -> None:
    assume(crossing(n1, n2))
    found = incidence.meet(rigid.plane(n1, d1), rigid.plane(n2, d2))
    v, u = rigid.direction_and_moment(found)
    np.testing.assert_allclose(v, unit(np.cross(n1, n2)), atol=1e-12)
    r = np.cross(v, u)
    np.testing.assert_allclose([n1 @ r, n2 @ r, u @ v], [d1, d2, 0], atol=1e-9)


@given(axes, vectors, axes, offsets)
def test_a_line_meets_a_plane_in_a_point(v: Array, r: Array, n: Array, d: float) -> None:
    assume(abs(n @ v) > 1e-3)
    found = incidence.meet(rigid.line(v, r), rigid.plane(n, d))
    np.testing.assert_allclose(found, rigid.point(r + (d - n @ r) / (n @ v) * v), atol=1e-9)


@given(axes, axes, axes, vectors)
def test_three_planes_meet_in_a_point(n1: Array, n2: Array, n3: Array, p: Array) -> None:
    assume(abs(n1 @ np.cross(n2, n3)) > 1e-3)
    planes = [rigid.plane(n, n @ p) for n in (n1, n2, n3)]
    np.testing.assert_allclose(incidence.meet(*planes), rigid.point(p), atol=1e-9)


@given(axes, offsets, offsets)
def test_parallel_planes_meet_at_infinity(n: Array, d1: float, d2: float) -> None:
    assume(abs(d1 - d2) > 1e-3)
    for sign in (1, -1):
        found = incidence.meet(rigid.plane(n, d1), sign * rigid.plane(n, d2))
        assert not incidence.is_finite(found)
        np.testing.assert_allclose(rigid.direction_and_moment(found)[1], sign * (d2 - d1) * n, atol=1e-14)
    np.testing.assert_array_equal(incidence.meet(rigid.plane(n, d1), rigid.plane(n, d1)), 0)


@given(axes, vectors, axes, offsets)
def test_a_line_parallel_to_a_plane_meets_it_at_infinity(n: Array, r: Array, other: Array, d: float) -> None:
    assume(crossing(n, other) and abs(n @ r - d) > 1e-3)
    v = unit(np.cross(n, other))
    found = incidence.meet(rigid.line(v, r), rigid.plane(n, d))
    assert not incidence.is_finite(found)
    np.testing.assert_allclose(found, (d - n @ r) * rigid.null_part(rigid.point(v)), atol=1e-12)
    np.testing.assert_array_equal(incidence.meet(rigid.line(v, r), rigid.plane(n, n @ r)), 0)
    np.testing.assert_allclose(
        incidence.line_plane_distance(rigid.line(v, r), rigid.plane(n, d)), n @ r - d, atol=1e-12
    )


@pytest.mark.parametrize("build", [lambda p, v: rigid.line(v, p), lambda p, v: rigid.plane(v, v @ p)])
@given(p=vectors, v=axes, q=vectors)
def test_join_and_meet_keep_what_lies_in_both(
    build: Callable[[Array, Array], Array], p: Array, v: Array, q: Array
) -> None:
    """A point of X is the meet of X with the plane across it, whatever way it was made."""
    across = rigid.plane(v, v @ p)
    line = rigid.line(v, p)
    np.testing.assert_allclose(incidence.meet(line, across), rigid.point(p), atol=1e-12)
    foot = incidence.perpendicular_foot(rigid.point(q), build(p, v))
    np.testing.assert_allclose(incidence.perpendicular_foot(foot, build(p, v)), foot, atol=1e-12)


@given(vectors, axes, offsets)
def test_the_foot_on_a_plane(p: Array, n: Array, d: float) -> None:
    found = incidence.perpendicular_foot(rigid.point(p), rigid.plane(n, d))
    np.testing.assert_allclose(found, rigid.point(p - (n @ p - d) * n), atol=1e-13)


@given(vectors, axes, vectors)
def test_the_foot_on_a_line_and_the_distance_to_it(p: Array, v: Array, r: Array) -> None:
    line, point = rigid.line(v, r), rigid.point(p)
    nearest = r + v @ (p - r) * v
    np.testing.assert_allclose(incidence.perpendicular_foot(point, line), rigid.point(nearest), atol=1e-13)
    distance = incidence.point_line_distance(line, point)
    np.testing.assert_allclose(distance, np.linalg.norm(p - nearest), atol=1e-13)
    np.testing.assert_allclose(incidence.point_line_distance(-line, point), distance)


@given(axes, vectors, axes, vectors)
def test_angle_and_distance_of_two_lines(v1: Array, r1: Array, v2: Array, r2: Array) -> None:
    assume(crossing(v1, v2))
    lines = rigid.line(v1, r1), rigid.line(v2, r2)
    np.testing.assert_allclose(incidence.line_angle(*lines), np.arccos(v1 @ v2), atol=1e-9)
    np.testing.assert_allclose(incidence.line_angle(lines[0], -lines[1]), np.pi - np.arccos(v1 @ v2), atol=1e-9)
    expected = abs((r2 - r1) @ unit(np.cross(v1, v2)))
    np.testing.assert_allclose(incidence.line_distance(*lines), expected, atol=1e-10)


@pytest.mark.parametrize(("angle", "sign"), [(0, 1), (1e-12, 1), (1e-7, 1), (np.pi, -1)])
def test_angles_of_lines_keep_their_digits_where_a_cosine_loses_them(angle: float, sign: int) -> None:
    other = rigid.line((np.sin(angle), 0, sign * np.cos(angle - np.pi * (sign < 0))), (3, 1, 0))
    np.testing.assert_allclose(incidence.line_angle(Z, other), angle, rtol=1e-14)


@given(axes, vectors, vectors, st.sampled_from([1, -1]))
def test_the_distance_of_parallel_lines(v: Array, r1: Array, r2: Array, sign: int) -> None:
    expected = np.linalg.norm(np.cross(v, r2 - r1))
    found = incidence.line_distance(rigid.line(v, r1), sign * rigid.line(v, r2))
    np.testing.assert_allclose(found, expected, atol=1e-13)


@given(axes, vectors, axes, vectors)
def test_the_common_normal_of_skew_lines(v1: Array, r1: Array, v2: Array, r2: Array) -> None:
    assume(crossing(v1, v2))
    lines = rigid.line(v1, r1), rigid.line(v2, r2)
    normal, *feet = incidence.common_normal(*lines)
    n = unit(np.cross(v1, v2))
    s = np.linalg.solve(np.stack([v1, -v2, -n], axis=-1), r2 - r1)
    first, second = r1 + s[0] * v1, r2 + s[1] * v2
    np.testing.assert_allclose([rigid.coordinates(foot) for foot in feet], [first, second], atol=1e-8)
    np.testing.assert_allclose(normal, rigid.line(n, first), atol=1e-8)
    np.testing.assert_allclose(np.linalg.norm(second - first), incidence.line_distance(*lines), atol=1e-8)


@given(axes, axes, vectors)
def test_lines_that_cross_have_both_feet_there(v1: Array, v2: Array, p: Array) -> None:
    assume(crossing(v1, v2))
    normal, foot1, foot2 = incidence.common_normal(rigid.line(v1, p), rigid.line(v2, p))
    np.testing.assert_allclose([foot1, foot2], [rigid.point(p)] * 2, atol=1e-8)
    np.testing.assert_allclose(normal, rigid.line(unit(np.cross(v1, v2)), p), atol=1e-8)


@given(axes, vectors, vectors)
def test_the_common_normal_of_parallel_lines_is_the_one_nearest_to_the_origin(v: Array, r1: Array, r2: Array) -> None:
    assume(np.linalg.norm(np.cross(v, r2 - r1)) > 1e-3)
    normal, foot1, foot2 = incidence.common_normal(rigid.line(v, r1), -rigid.line(v, r2))
    np.testing.assert_allclose(rigid.coordinates(foot1), r1 - (v @ r1) * v, atol=1e-12)
    np.testing.assert_allclose(rigid.coordinates(foot2), r2 - (v @ r2) * v, atol=1e-12)
    np.testing.assert_allclose(normal, incidence.join(foot1, foot2))


@given(axes, vectors)
def test_a_line_has_no_one_normal_with_itself(v: Array, r: Array) -> None:
    normal, foot1, foot2 = incidence.common_normal(rigid.line(v, r), rigid.line(v, r))
    np.testing.assert_array_equal(normal, 0)
    np.testing.assert_allclose(foot1, foot2, atol=1e-13)


@given(axes, vectors, axes, offsets)
def test_the_angle_of_a_line_with_a_plane(v: Array, r: Array, n: Array, d: float) -> None:
    line, plane = rigid.line(v, r), rigid.plane(n, d)
    angle = incidence.line_plane_angle(line, plane)
    np.testing.assert_allclose(np.sin(angle), n @ v, atol=1e-14)
    np.testing.assert_allclose(
        [incidence.line_plane_angle(-line, plane), incidence.line_plane_angle(line, -plane)], -angle
    )
    if abs(n @ v) > 1e-6:
        assert incidence.line_plane_distance(line, plane) == 0


@given(poses, axes, vectors, axes, vectors, vectors)
def test_moving_keeps_distances_angles_and_what_is_incident(
    T: Array, v1: Array, r1: Array, v2: Array, r2: Array, p: Array
) -> None:
    assume(crossing(v1, v2) and np.linalg.norm(np.cross(v1, p - r1)) > 1e-3)
    here = rigid.line(v1, r1), rigid.line(v2, r2), rigid.plane(v2, v2 @ r1), rigid.point(p)
    M = rigid.motor_from_pose(T)
    line1, line2, plane, point = there = [rigid.move(M, X) for X in here]
    for measure, i, j in [
        (incidence.line_distance, 0, 1),
        (incidence.line_angle, 0, 1),
        (incidence.line_plane_angle, 0, 2),
        (incidence.point_line_distance, 0, 3),
        (rigid.point_plane_distance, 2, 3),
    ]:
        np.testing.assert_allclose(measure(there[i], there[j]), measure(here[i], here[j]), atol=1e-9)
    np.testing.assert_allclose(incidence.join(line1, point), rigid.move(M, incidence.join(here[0], here[3])), atol=1e-9)
    np.testing.assert_allclose(incidence.meet(line2, plane), rigid.move(M, incidence.meet(here[1], here[2])), atol=1e-9)


def test_everything_broadcasts() -> None:
    rng = np.random.default_rng(6)
    v, r = rng.normal(size=(2, 5, 3))
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    v[2] = (0, 0, -1)
    lines, points, planes = rigid.line(v, r), rigid.point(r + 1), rigid.plane(v, np.arange(5.0))
    for function, many in [
        (incidence.line_distance, lines),
        (incidence.line_angle, lines),
        (incidence.line_plane_angle, planes),
        (incidence.line_plane_distance, planes),
        (incidence.point_line_distance, points),
        (incidence.join, points),
        (incidence.meet, planes),
    ]:
        one_by_one = [function(Z, X) for X in many]
        np.testing.assert_allclose(function(Z, many), one_by_one, atol=1e-13)
    for at_once, single in zip(incidence.common_normal(Z, lines), incidence.common_normal(Z, lines[2]), strict=True):
        np.testing.assert_allclose(at_once[2], single, atol=1e-13)
    table = incidence.meet(lines[:3, None], planes)
    np.testing.assert_allclose(table[1, 4], incidence.meet(lines[1], planes[4]), atol=1e-12)
    np.testing.assert_allclose(
        incidence.perpendicular_foot(ORIGIN, planes)[3], incidence.perpendicular_foot(ORIGIN, planes[3]), atol=1e-14
    )
    assert incidence.is_finite(incidence.meet(Z, planes)).all()
