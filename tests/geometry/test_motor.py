from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.geometry.motions import ANGLES, angles, axes, of, pose, poses, vectors

from helicoide.geometry import motor, rigid
from helicoide.geometry.clifford import CL031, Array
from helicoide.text import HelicoideError

ONE = CL031.blade("1")
shifts = st.one_of(st.just(0.0), st.floats(-2, 2))


def screw(n: Array, r: Array, angle: float, advance: float) -> Array:
    """Bivector ½(α + εd)(n + ε r×n) whose exponential turns by α and advances by d."""
    along = rigid.null_part(2 * rigid.translator(n))
    return np.asarray((angle * rigid.line(n, r) + advance * along) / 2)


def series(B: Array) -> Array:
    """Exponential by its power series."""
    total, term = ONE, ONE
    for power in range(1, 40):
        term = CL031.product(term, B) / power
        total = total + term
    return total


@given(vectors, vectors)
def test_exp_is_the_power_series(v: Array, u: Array) -> None:
    B = rigid.motor_from_dual_quaternion(np.concatenate([[0], v, [0], u]))
    np.testing.assert_allclose(motor.exp(B), series(B), atol=1e-13)


@given(axes, vectors, angles, shifts)
def test_exp_of_half_the_angle_turns_by_plus_the_angle(n: Array, r: Array, angle: float, advance: float) -> None:
    """exp(+θL/2) with the lines of Cerbaro 2022, eq. 17; displacement d = t s + (I − R) s0 of its eq. 62."""
    T = pose(n, angle, np.zeros(3))
    T[:3, 3] = advance * n + r - T[:3, :3] @ r
    np.testing.assert_allclose(rigid.pose_from_motor(motor.exp(screw(n, r, angle, advance))), T, atol=2e-14)


@given(axes, vectors, st.one_of(st.sampled_from(ANGLES[:4]), st.floats(0, 3.14)), shifts)
def test_log_of_exp_is_the_screw(n: Array, r: Array, angle: float, advance: float) -> None:
    B = screw(n, r, angle, advance)
    np.testing.assert_allclose(motor.log(motor.exp(B)), B, atol=1e-12)
    np.testing.assert_allclose(motor.log(-motor.exp(B)), B, atol=1e-12)


@pytest.mark.parametrize("angle", ANGLES)
@given(n=axes, r=vectors, advance=shifts)
def test_exp_of_log_is_the_motor(angle: float, n: Array, r: Array, advance: float) -> None:
    M = motor.exp(screw(n, r, angle, advance))
    np.testing.assert_allclose(motor.exp(motor.log(M)), rigid.canonical(M), atol=1e-12)


@given(axes.filter(lambda n: min(abs(n)) > 1e-6), vectors, shifts)
def test_log_of_a_half_turn_takes_the_axis_that_starts_positive(n: Array, r: Array, advance: float) -> None:
    turn = rigid.line(n, r)
    M = CL031.product(rigid.translator(advance * n), turn)
    sign = np.sign(n[0])
    expected = screw(sign * n, r, np.pi, sign * advance)
    np.testing.assert_allclose(motor.log(M), expected, atol=1e-14)
    np.testing.assert_allclose(motor.log(-M), expected, atol=1e-14)


def test_log_keeps_all_digits_of_tiny_turns() -> None:
    B = screw(np.array([0.0, 0.6, 0.8]), np.array([1.0, 2.0, 3.0]), 1e-200, 0.0)
    np.testing.assert_allclose(motor.log(motor.exp(B)), B, rtol=1e-14)


@given(poses)
def test_log_of_a_pose_is_at_most_half_a_turn(T: Array) -> None:
    v, _ = rigid.direction_and_moment(motor.log(rigid.motor_from_pose(T)))
    assert 2 * np.linalg.norm(v) <= np.pi + 1e-15
    np.testing.assert_allclose(rigid.pose_from_motor(motor.exp(motor.log(rigid.motor_from_pose(T)))), T, atol=1e-12)


@given(poses)
def test_a_motor_times_its_conjugate_is_one(T: Array) -> None:
    """Cerbaro 2022, eq. 97, on both sides."""
    M = rigid.motor_from_pose(T)
    np.testing.assert_allclose(CL031.product(M, CL031.conjugate(M)), ONE, atol=1e-14)
    np.testing.assert_allclose(CL031.product(CL031.conjugate(M), M), ONE, atol=1e-14)
    np.testing.assert_allclose(rigid.pose_from_motor(CL031.conjugate(M)), np.linalg.inv(T), atol=1e-12)


@given(poses, poses, poses)
def test_motors_compose_in_any_grouping(T_a_b: Array, T_b_c: Array, T_c_d: Array) -> None:
    a, b, c = map(rigid.motor_from_pose, (T_a_b, T_b_c, T_c_d))
    left, right = CL031.product(CL031.product(a, b), c), CL031.product(a, CL031.product(b, c))
    np.testing.assert_allclose(left, right, atol=1e-13)
    np.testing.assert_allclose(rigid.pose_from_motor(left), T_a_b @ T_b_c @ T_c_d, atol=1e-13)


elements = st.lists(st.floats(-2, 2), min_size=16, max_size=16).map(np.array)


@given(poses, poses, elements)
def test_moving_twice_is_moving_by_the_product(T_a_b: Array, T_b_c: Array, X_c: Array) -> None:
    M_a_b, M_b_c = map(rigid.motor_from_pose, (T_a_b, T_b_c))
    twice = rigid.move(M_a_b, rigid.move(M_b_c, X_c))
    np.testing.assert_allclose(twice, rigid.move(CL031.product(M_a_b, M_b_c), X_c), atol=1e-12)


@given(poses, elements, elements)
def test_moving_keeps_every_product(T: Array, X: Array, Y: Array) -> None:
    """Incidence, distances and angles are products, so they are kept too."""
    M = rigid.motor_from_pose(T)
    for product in (CL031.product, CL031.outer, CL031.regressive):
        moved = product(rigid.move(M, X), rigid.move(M, Y))
        np.testing.assert_allclose(rigid.move(M, product(X, Y)), moved, atol=2e-11)


@given(poses)
def test_each_blade_moves_as_its_factors_do_and_keeps_its_grade(T: Array) -> None:
    M = rigid.motor_from_pose(T)
    moved = rigid.move(M, np.eye(16))
    for blade, place, grade in zip(CL031.blades, moved, CL031.grades, strict=True):
        factors = ONE
        for generator in blade:
            factors = CL031.product(factors, moved[1 + generator])
        np.testing.assert_allclose(place, factors, atol=1e-13)
        np.testing.assert_allclose(place, CL031.grade(place, int(grade)), atol=1e-14)
    np.testing.assert_allclose(rigid.move(CL031.conjugate(M), moved), np.eye(16), atol=1e-13)


@given(poses, st.lists(st.floats(-0.05, 0.05), min_size=8, max_size=8).map(np.array))
def test_normalized_brings_a_bent_motor_back(T: Array, bend: Array) -> None:
    M = rigid.motor_from_pose(T)
    found = motor.normalize_motor(M + rigid.motor_from_dual_quaternion(bend))
    assert motor.is_motor(found, 1e-14)
    np.testing.assert_allclose(found, M, atol=0.4)
    np.testing.assert_allclose(motor.normalize_motor(-3 * M), -M, atol=1e-14)


def test_normalized_refuses_what_is_not_close_to_a_motor() -> None:
    for wrong in (of(e1e=1), of(one=1, e1=1e-3), of(one=np.nan)):
        with pytest.raises(HelicoideError, match="not close to a motor"):
            motor.normalize_motor(wrong)


def test_is_motor_tells_motors_from_others() -> None:
    motors = np.array([of(one=1, e1e=5), of(e1e2=-1)])
    others = np.array([of(one=1.001), of(one=1, e1e2e3e=1e-3), of(e1=1), of(one=1, e=1), of(e1e=1), of(one=np.nan)])
    np.testing.assert_array_equal(motor.is_motor(motors), True)
    np.testing.assert_array_equal(motor.is_motor(others), False)
    assert motor.is_motor(others[0], tolerance=0.01)


@given(poses, poses, st.floats(0, 1))
def test_sclerp_starts_and_ends_where_it_should(T0: Array, T1: Array, s: float) -> None:
    M0, M1 = rigid.motor_from_pose(T0), rigid.motor_from_pose(T1)
    np.testing.assert_allclose(motor.sclerp(M0, M1, 0), M0, atol=1e-15)
    np.testing.assert_allclose(rigid.pose_from_motor(motor.sclerp(M0, M1, 1)), T1, atol=1e-12)
    there, back = motor.sclerp(M0, M1, s), motor.sclerp(M0, -M1, s)
    np.testing.assert_allclose(there, back, atol=1e-12)
    assert motor.is_motor(there, 1e-12)


@given(poses, poses, poses, st.floats(0, 1))
def test_sclerp_does_not_depend_on_the_frame(T: Array, T0: Array, T1: Array, s: float) -> None:
    M, M0, M1 = map(rigid.motor_from_pose, (T, T0, T1))
    elsewhere = motor.sclerp(CL031.product(M, M0), CL031.product(M, M1), s)
    turn = motor.screw_from_motor(CL031.product(CL031.conjugate(M0), M1)).angle
    if turn < 3.1:
        np.testing.assert_allclose(elsewhere, CL031.product(M, motor.sclerp(M0, M1, s)), atol=1e-11)


@given(poses, axes, vectors, st.floats(0, 3.1), shifts, st.floats(0, 1))
def test_sclerp_follows_the_screw_evenly(T: Array, n: Array, r: Array, angle: float, advance: float, s: float) -> None:
    M0 = rigid.motor_from_pose(T)
    M1 = CL031.product(M0, motor.exp(screw(n, r, angle, advance)))
    part = motor.exp(screw(n, r, s * angle, s * advance))
    np.testing.assert_allclose(motor.sclerp(M0, M1, s), CL031.product(M0, part), atol=1e-12)


@given(axes, vectors, st.one_of(st.sampled_from(ANGLES[2:4]), st.floats(1e-3, 3.14)), shifts)
def test_the_screw_of_chasles(n: Array, r: Array, angle: float, advance: float) -> None:
    found = motor.screw_from_motor(motor.exp(screw(n, r, angle, advance)))
    np.testing.assert_allclose(found.direction, n, atol=1e-12)
    np.testing.assert_allclose(found.point, r - (r @ n) * n, atol=1e-11)
    np.testing.assert_allclose(found.angle, angle, atol=1e-14)
    np.testing.assert_allclose(found.displacement, advance, atol=1e-11)
    np.testing.assert_allclose(found.pitch, found.displacement / angle)


@given(poses)
def test_screws_give_their_motor_back(T: Array) -> None:
    M = rigid.motor_from_pose(T)
    found = motor.screw_from_motor(M)
    np.testing.assert_allclose(rigid.pose_from_motor(motor.motor_from_screw(found)), T, atol=1e-12)
    assert 0 <= found.angle <= np.pi
    np.testing.assert_array_equal(motor.screw_from_motor(-M).displacement, found.displacement)


@given(axes, st.floats(1e-6, 2))
def test_a_translation_has_a_screw_without_turn(n: Array, length: float) -> None:
    found = motor.screw_from_motor(rigid.translator(length * n))
    np.testing.assert_allclose(found.direction, n, atol=1e-15)
    np.testing.assert_allclose(found.displacement, length)
    np.testing.assert_array_equal(found.point, 0)
    np.testing.assert_array_equal([found.angle, found.pitch], [0, np.inf])
    np.testing.assert_allclose(motor.motor_from_screw(found), rigid.translator(length * n), atol=1e-15)


@pytest.mark.parametrize("identity", [ONE, -ONE])
def test_the_identity_has_no_axis(identity: Array) -> None:
    found = motor.screw_from_motor(identity)
    np.testing.assert_array_equal([*found.direction, *found.point], 0)
    np.testing.assert_array_equal([found.angle, found.displacement, found.pitch], 0)
    np.testing.assert_array_equal(motor.motor_from_screw(found), ONE)


def test_a_turn_within_rounding_is_a_translation() -> None:
    M = rigid.screw_motor((0, 0, 1), (1e13, 0, 0), 1e-13)
    found = motor.screw_from_motor(M)
    np.testing.assert_allclose(found.direction, (0, -1, 0), atol=1e-12)
    np.testing.assert_allclose([found.angle, found.displacement], (0, 1))


def test_screw_of_the_quarter_turn_and_shift() -> None:
    """Cerbaro 2022, eq. 96: a quarter turn about z, then 100 mm along x, is a quarter turn about (50, 50)."""
    M = CL031.product(rigid.translator((100, 0, 0)), rigid.rotor((0, 0, 1), np.pi / 2))
    found = motor.screw_from_motor(M)
    np.testing.assert_allclose(found.direction, (0, 0, 1))
    np.testing.assert_allclose(found.point, (50, 50, 0), atol=1e-13)
    np.testing.assert_allclose([found.angle, found.displacement], (np.pi / 2, 0), atol=1e-14)


def test_everything_broadcasts() -> None:
    rng = np.random.default_rng(5)
    M = motor.exp(rigid.motor_from_dual_quaternion(np.insert(rng.normal(size=(3, 4, 6)), [0, 3], 0, axis=-1)))
    M[1, 2], M[2, 1] = ONE, rigid.translator((1, 2, 3))
    found = motor.screw_from_motor(M)
    assert (found.direction.shape, found.pitch.shape) == ((3, 4, 3), (3, 4))
    np.testing.assert_allclose(motor.motor_from_screw(found), rigid.canonical(M), atol=1e-14)
    np.testing.assert_allclose(motor.exp(motor.log(M)), rigid.canonical(M), atol=1e-14)
    way = motor.sclerp(M[0, 0], M[0, 1], np.linspace(0, 1, 5))
    np.testing.assert_allclose(way[2], motor.sclerp(M[0, 0], M[0, 1], 0.5), atol=1e-15)
    np.testing.assert_allclose(motor.sclerp(M[0], M[1], 0.25)[3], motor.sclerp(M[0, 3], M[1, 3], 0.25), atol=1e-15)
    assert motor.is_motor(motor.normalize_motor(1.1 * M)).shape == (3, 4)
