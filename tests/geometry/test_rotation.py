from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.geometry import rotation
from helicoide.geometry.clifford import Array
from helicoide.text import HelicoideError

ANGLES = [0.0, 1e-12, 1e-7, 0.3, np.pi / 2, np.pi - 1e-7, np.pi - 1e-12, np.pi]
angles = st.one_of(st.sampled_from(ANGLES), st.floats(0, np.pi))
any_angles = st.one_of(st.sampled_from([*ANGLES, *(-a for a in ANGLES), 2 * np.pi]), st.floats(-10, 10))
vectors = st.tuples(*[st.floats(-5, 5)] * 3).map(np.array)
axes = vectors.filter(lambda v: np.linalg.norm(v) > 1e-3).map(lambda v: v / np.linalg.norm(v))
quaternions = st.builds(rotation.from_axis_angle, axes, any_angles)


def rodrigues(axis: Array, angle: float) -> Array:
    """Matrix of a turn about a unit axis: I + sin θ K + (1 − cos θ) K²."""
    K = np.cross(np.eye(3), axis)
    return np.asarray(np.eye(3) + np.sin(angle) * K + 2 * np.sin(angle / 2) ** 2 * (K @ K))


def from_roll_pitch_yaw(roll: float, pitch: float, yaw: float) -> Array:
    x, y, z = np.eye(3)
    return rodrigues(z, roll) @ rodrigues(y, pitch) @ rodrigues(x, yaw)


def test_units_multiply_as_hamilton_s() -> None:
    one, i, j, k = np.eye(4)
    for p, q, r in [(i, j, k), (j, k, i), (k, i, j)]:
        np.testing.assert_array_equal(rotation.multiply(p, q), r)
        np.testing.assert_array_equal(rotation.multiply(q, p), -r)
        np.testing.assert_array_equal(rotation.multiply(p, p), -one)


@given(quaternions, quaternions, vectors)
def test_products_rotate_one_after_the_other(p: Array, q: Array, v: Array) -> None:
    twice = rotation.rotate(p, rotation.rotate(q, v))
    np.testing.assert_allclose(rotation.rotate(rotation.multiply(p, q), v), twice, atol=1e-13)
    np.testing.assert_allclose(rotation.to_matrix(p) @ rotation.to_matrix(q) @ v, twice, atol=1e-13)


@given(quaternions)
def test_the_conjugate_undoes(q: Array) -> None:
    np.testing.assert_allclose(rotation.multiply(q, rotation.conjugate(q)), np.eye(4)[0], atol=1e-15)


@given(axes, any_angles, vectors)
def test_quaternions_turn_as_rodrigues_does(axis: Array, angle: float, v: Array) -> None:
    q, R = rotation.from_axis_angle(3 * axis, angle), rodrigues(axis, angle)
    np.testing.assert_allclose(rotation.rotate(q, v), R @ v, atol=2e-14)
    np.testing.assert_allclose(rotation.to_matrix(-7 * q), R, atol=5e-15)


@given(axes, any_angles)
def test_matrices_come_back_at_every_angle(axis: Array, angle: float) -> None:
    R = rodrigues(axis, angle)
    q = rotation.from_matrix(R)
    assert q[0] >= 0
    assert abs(np.linalg.norm(q) - 1) < 1e-15
    np.testing.assert_allclose(rotation.to_matrix(q), R, atol=3e-15)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, -1, 0), (0, 0, 1), (0.6, -0.8, 0), (0, 0.6, 0.8)])
def test_half_turns_have_one_quaternion(axis: tuple[float, float, float]) -> None:
    n = np.array(axis)
    q = rotation.from_matrix(2 * np.outer(n, n) - np.eye(3))
    np.testing.assert_allclose(q, [0, *(n if n[np.flatnonzero(n)[0]] > 0 else -n)], atol=1e-15)


@given(axes, angles)
def test_rotation_vector_is_axis_times_angle(axis: Array, angle: float) -> None:
    q = rotation.from_axis_angle(axis, angle)
    near_half_turn = angle > np.pi - 1e-9
    found = rotation.rotation_vector(q)
    np.testing.assert_allclose(found * np.sign(found @ axis) if near_half_turn else found, angle * axis, atol=2e-15)
    np.testing.assert_allclose(rotation.rotation_vector(-q), found, atol=1e-15)


def test_rotation_vector_keeps_all_digits_of_tiny_and_half_turns() -> None:
    np.testing.assert_array_equal(rotation.rotation_vector(np.array([1.0, 0, 0, 0])), np.zeros(3))
    np.testing.assert_allclose(rotation.rotation_vector(np.array([1, 5e-301, 0, 0])), [1e-300, 0, 0], rtol=1e-15)
    np.testing.assert_allclose(rotation.rotation_vector(np.array([0.0, 0, 0, -1])), [0, 0, np.pi], rtol=1e-16)


@given(quaternions, quaternions)
def test_orientation_error_brings_q_to_the_target(q_target: Array, q: Array) -> None:
    error = rotation.orientation_error(q_target, q)
    assert np.linalg.norm(error) <= np.pi + 1e-12
    angle = float(np.linalg.norm(error))
    moved = (rodrigues(error / angle, angle) if angle else np.eye(3)) @ rotation.to_matrix(q)
    np.testing.assert_allclose(moved, rotation.to_matrix(q_target), atol=1e-14)


def test_orientation_error_example_of_cerbaro_appendix_f() -> None:
    q_target, q = rotation.from_axis_angle((0, 0, 1), [1.0, 0.4])
    difference = rotation.multiply(q_target, rotation.conjugate(q))
    np.testing.assert_allclose(difference, [0.955336, 0, 0, 0.295520], atol=5e-7)
    np.testing.assert_allclose(rotation.orientation_error(q_target, q), [0, 0, 0.6], atol=1e-15)
    np.testing.assert_allclose(rotation.orientation_error(-q_target, q), [0, 0, 0.6], atol=1e-15)


@given(quaternions)
def test_roll_pitch_yaw_agree_with_the_intrinsic_zyx_angles(q: Array) -> None:
    R = rotation.to_matrix(q)
    roll, pitch, yaw = rotation.roll_pitch_yaw_zyx(R)
    np.testing.assert_allclose(from_roll_pitch_yaw(roll, pitch, yaw), R, atol=2e-14)
    assert abs(pitch) <= np.pi / 2
    if abs(pitch) < 1.5:
        difference = yaw - np.arctan2(R[2, 1], R[2, 2])
        assert abs(np.sin(difference / 2)) < 1e-13


@pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2])
def test_roll_pitch_yaw_give_the_matrix_back_where_pitch_is_a_right_angle(pitch: float) -> None:
    R = from_roll_pitch_yaw(0.7, pitch, -0.4)
    R[np.abs(R) < 1e-12] = 0
    found = rotation.roll_pitch_yaw_zyx(R)
    np.testing.assert_allclose(from_roll_pitch_yaw(*found), R, atol=1e-15)


def test_roll_pitch_yaw_of_the_movemaster_example() -> None:
    """Cerbaro 2022, eq. 4 with eqs. 53–55."""
    s, c = np.sin(np.pi / 3), np.cos(np.pi / 3)
    R = np.array([[c, -s * s, s * c], [-s, -s * c, c * c], [0, -c, -s]])
    np.testing.assert_allclose(rotation.roll_pitch_yaw_zyx(R), [-1.047, 0, -2.618], atol=5e-4)


def test_angles_of_one_radian_about_the_diagonal() -> None:
    """Cerbaro 2022, eq. 90 would give (0.561, 0.561, 0.561) here."""
    R = rotation.to_matrix(rotation.from_axis_angle((1, 1, 1), 1.0))
    np.testing.assert_allclose(rotation.roll_pitch_yaw_zyx(R), [0.7445, 0.3391, 0.7445], atol=1e-4)


def test_everything_broadcasts() -> None:
    rng = np.random.default_rng(2)
    q = rotation.from_axis_angle(rng.normal(size=(4, 5, 3)), rng.normal(size=(4, 5)))
    v = rng.normal(size=(5, 3))
    R = rotation.to_matrix(q)
    np.testing.assert_allclose(rotation.rotate(q, v), np.einsum("abij,bj->abi", R, v), atol=1e-14)
    np.testing.assert_allclose(rotation.from_matrix(R), q * rotation.hemisphere(q), atol=1e-14)
    np.testing.assert_allclose(rotation.rotation_vector(q)[2, 3], rotation.rotation_vector(q[2, 3]), atol=1e-15)
    np.testing.assert_allclose(rotation.roll_pitch_yaw_zyx(R)[1, 1], rotation.roll_pitch_yaw_zyx(R[1, 1]), atol=1e-15)


@pytest.mark.parametrize("axis", [(0, 0, 0), (np.nan, 0, 1), (np.inf, 0, 0)])
def test_an_axis_needs_a_direction(axis: tuple[float, float, float]) -> None:
    with pytest.raises(HelicoideError, match="has no direction"):
        rotation.from_axis_angle([(0, 0, 1), axis], 1.0)
