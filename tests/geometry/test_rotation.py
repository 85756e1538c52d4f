from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation  # type: ignore[import-untyped]

from helicoide.geometry import rotation
from helicoide.geometry.clifford import Array
from helicoide.text import HelicoideError

Error = Callable[[Array, Array], Array]
EPS = np.finfo(float).eps
ANGLES = [0.0, 1e-12, 1e-7, 0.3, np.pi / 2, np.pi - 1e-7, np.pi - 1e-12, np.pi]
# below 1e-300 the halves and products of an angle have fewer digits than it
angles = st.one_of(st.sampled_from(ANGLES), st.floats(1e-300, np.pi))
any_angles = st.one_of(st.sampled_from([*ANGLES, *(-a for a in ANGLES), 2 * np.pi]), st.floats(-10, 10))
vectors = st.tuples(*[st.floats(-5, 5)] * 3).map(np.array)
axes = vectors.filter(lambda v: np.linalg.norm(v) > 1e-3).map(lambda v: v / np.linalg.norm(v))
quaternions = st.builds(rotation.from_axis_angle, axes, any_angles)


def rodrigues(axis: Array, angle: float) -> Array:
    """Matrix of a turn about a unit axis: I + sin θ K + (1 − cos θ) K²."""
    K = np.cross(np.eye(3), axis)
    return np.asarray(np.eye(3) + np.sin(angle) * K + 2 * np.sin(angle / 2) ** 2 * (K @ K))


def beside(v: Array, expected: Array) -> Array:
    """The rotation vector v, or −v where that is the same half turn and nearer to what is expected."""
    return -v if np.linalg.norm(expected) > np.pi - 1e-9 and v @ expected < 0 else v


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


@given(axes, any_angles)
def test_one_matrix_and_many_have_the_same_quaternion(axis: Array, angle: float) -> None:
    R = rodrigues(axis, angle)
    np.testing.assert_allclose(rotation.from_matrix(R), rotation.from_matrix(R[None])[0], rtol=0, atol=1e-15)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, -1, 0), (0, 0, 1), (0.6, -0.8, 0), (0, 0.6, 0.8)])
def test_half_turns_have_one_quaternion(axis: tuple[float, float, float]) -> None:
    n = np.array(axis)
    q = rotation.from_matrix(2 * np.outer(n, n) - np.eye(3))
    np.testing.assert_allclose(q, [0, *(n if n[np.flatnonzero(n)[0]] > 0 else -n)], atol=1e-15)


@given(axes, angles)
def test_rotation_vector_is_axis_times_angle(axis: Array, angle: float) -> None:
    q = rotation.from_axis_angle(axis, angle)
    found = rotation.rotation_vector(q)
    np.testing.assert_allclose(beside(found, angle * axis), angle * axis, atol=2e-15)
    np.testing.assert_allclose(rotation.rotation_vector(-q), found, atol=1e-15)


def test_rotation_vector_keeps_all_digits_of_tiny_and_half_turns() -> None:
    np.testing.assert_array_equal(rotation.rotation_vector(np.array([1.0, 0, 0, 0])), np.zeros(3))
    np.testing.assert_allclose(rotation.rotation_vector(np.array([1, 5e-301, 0, 0])), [1e-300, 0, 0], rtol=1e-15)
    np.testing.assert_allclose(rotation.rotation_vector(np.array([0.0, 0, 0, -1])), [0, 0, np.pi], rtol=1e-16)


@given(vectors, vectors)
def test_skew_is_the_cross_product(v: Array, u: Array) -> None:
    tolerance = 2 * EPS * np.linalg.norm(v) * np.linalg.norm(u)
    np.testing.assert_allclose(rotation.skew(v) @ u, np.cross(v, u), atol=tolerance)


@given(axes, any_angles)
def test_rotation_vectors_turn_as_rodrigues_does(axis: Array, angle: float) -> None:
    """Coutinho 2015, eq. 2.7."""
    v = angle * axis
    tolerance = 4 * EPS * (1 + abs(angle))
    np.testing.assert_allclose(rotation.exponential(v), rodrigues(axis, angle), atol=tolerance)
    quaternion = rotation.from_axis_angle(axis, angle)
    np.testing.assert_allclose(rotation.from_rotation_vector(v), quaternion, atol=tolerance / 2)
    np.testing.assert_allclose(rotation.exponential(v), Rotation.from_rotvec(v).as_matrix(), atol=tolerance)


@given(axes, angles)
def test_the_logarithm_undoes_the_exponential(axis: Array, angle: float) -> None:
    R = rotation.exponential(angle * axis)
    found = rotation.logarithm(R)
    np.testing.assert_allclose(beside(found, angle * axis), angle * axis, atol=1e-14)
    np.testing.assert_allclose(rotation.exponential(found), R, atol=1e-14)
    again = rotation.rotation_vector(rotation.from_rotation_vector(found))
    np.testing.assert_allclose(beside(again, found), found, atol=2e-15)


@pytest.mark.parametrize("scale", [1e-300, 1e-160, 1e-40, 1e-9])
def test_tiny_rotation_vectors_keep_all_digits(scale: float) -> None:
    tiny = scale * np.array([1.0, -2.0, 3.0])
    np.testing.assert_allclose(rotation.from_rotation_vector(tiny)[1:], tiny / 2, rtol=1e-15)
    np.testing.assert_allclose(rotation.logarithm(rotation.exponential(tiny)), tiny, rtol=1e-15)
    axis, angle = rotation.axis_angle(rotation.from_rotation_vector(tiny))
    np.testing.assert_allclose([*axis, angle], [*np.array([1, -2, 3]) / 14**0.5, scale * 14**0.5], rtol=1e-15)
    np.testing.assert_array_equal(rotation.exponential(np.zeros(3)), np.eye(3))
    np.testing.assert_array_equal(rotation.from_rotation_vector(np.zeros(3)), np.eye(4)[0])


@given(axes, angles)
def test_axis_and_angle_come_back(axis: Array, angle: float) -> None:
    q = rotation.from_axis_angle(axis, angle)
    n, theta = rotation.axis_angle(q)
    assert 0 <= theta <= np.pi
    assert np.linalg.norm(n) == pytest.approx(1, abs=1e-15)
    assert theta == pytest.approx(angle, abs=1e-15)
    np.testing.assert_allclose(rotation.from_axis_angle(n, theta), q * rotation.hemisphere_sign(q), atol=1e-15)


def test_without_a_turn_the_axis_is_z() -> None:
    axis, angle = rotation.axis_angle(np.array([[1.0, 0, 0, 0], [-1, 0, 0, 0], [0, -1, 0, 0]]))
    np.testing.assert_array_equal(axis, [[0, 0, 1], [0, 0, 1], [1, 0, 0]])
    np.testing.assert_array_equal(angle, [0, 0, np.pi])


@given(quaternions, quaternions)
def test_quaternions_by_the_formulas_of_coutinho(p: Array, q: Array) -> None:
    """Coutinho 2015, eqs. 2.11, 2.12–2.14 with the ½ of 2.13, and 2.16 with the minus of A.11."""
    (eta, *epsilon), K = q, rotation.skew(q[1:])
    R = np.eye(3) + 2 * eta * K + 2 * K @ K
    np.testing.assert_allclose(rotation.to_matrix(q), R, atol=2e-15)
    vector = p[0] * q[1:] + eta * p[1:] + np.cross(p[1:], epsilon)
    np.testing.assert_allclose(rotation.multiply(p, q), [p[0] * eta - p[1:] @ q[1:], *vector], atol=1e-15)
    radicands = [1 + np.trace(R), *(1 + 2 * np.diag(R) - np.trace(R))]
    differences = np.array([1, R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    found = np.where(differences < 0, -0.5, 0.5) * np.sqrt(np.clip(radicands, 0, None))
    if np.min(np.abs(q)) > 1e-3:  # the roots lose digits near zero
        np.testing.assert_allclose(rotation.from_matrix(R), found, atol=1e-12)


@given(quaternions, vectors)
def test_rates_of_quaternions(q: Array, omega: Array) -> None:
    """Vargas 2013, eqs. 2.45–2.46, base frame; Coutinho 2015, eq. 2.64, body frame."""
    eta, epsilon = q[0], q[1:]
    J, J_body = rotation.quaternion_jacobian(q), rotation.quaternion_jacobian_body(q)
    base = [-epsilon @ omega / 2, *(eta * omega - np.cross(epsilon, omega)) / 2]
    body = [-epsilon @ omega / 2, *(eta * omega + np.cross(epsilon, omega)) / 2]
    np.testing.assert_allclose(J @ omega, base, atol=4e-15)
    np.testing.assert_allclose(J_body @ omega, body, atol=4e-15)
    np.testing.assert_allclose(J.T @ J, np.eye(3) / 4, atol=1e-15)
    np.testing.assert_allclose(J @ rotation.to_matrix(q), J_body, atol=1e-14)
    turn = rotation.from_rotation_vector(np.outer([1e-6, -1e-6], omega))
    forward, back = rotation.multiply(turn, q)
    np.testing.assert_allclose(J @ omega, (forward - back) / 2e-6, atol=1e-8)


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
    np.testing.assert_allclose(rotation.quaternion_error(q_target, q), [0, 0, 0.295520], atol=5e-7)


@given(quaternions, quaternions)
def test_quaternion_errors_are_half_sines_along_the_shorter_turn(q_target: Array, q: Array) -> None:
    """Vargas 2013, eqs. 2.41–2.42; Cerbaro 2022, eqs. 91–92."""
    (eta_d, *_), (eta, *_) = q_target, q
    difference = eta * q_target[1:] - eta_d * q[1:] - np.cross(q_target[1:], q[1:])
    error, turn = rotation.quaternion_error(q_target, q), rotation.orientation_error(q_target, q)
    if abs(q_target @ q) > 1e-15:
        np.testing.assert_allclose(error, np.sign(q_target @ q) * difference, atol=1e-15)
    angle = np.linalg.norm(turn)
    np.testing.assert_allclose(error * angle, np.sin(angle / 2) * turn, atol=1e-14)
    np.testing.assert_allclose(rotation.quaternion_error(-q_target, q), error, atol=1e-15)
    body = rotation.quaternion_error_body(q_target, q)
    expected = rotation.rotate(rotation.conjugate(q), error)
    # at half a turn both ways are the shorter one
    np.testing.assert_allclose(body if body @ expected >= 0 else -body, expected, atol=1e-14)


@pytest.mark.parametrize("error", [rotation.quaternion_error, rotation.quaternion_error_body])
def test_quaternion_error_is_0_when_equal_and_1_when_opposite(error: Error) -> None:
    """Cerbaro 2022, App. F: |sin(θ/2)|, 0 for equal and 1 for opposite orientations."""
    q = rotation.from_axis_angle((3, 1, -2), 0.8)
    opposite = rotation.multiply(q, rotation.from_axis_angle((1, 2, 2), np.pi))
    np.testing.assert_allclose(error(q, q), 0, atol=1e-16)
    assert np.linalg.norm(error(opposite, q)) == pytest.approx(1, abs=1e-15)


@given(quaternions, quaternions)
def test_the_lyapunov_function_falls_as_vargas_says(q_target: Array, q: Array) -> None:
    """Vargas 2013, eqs. 2.47–2.48: V = 2(1 − Δη), V̇ = −e_oᵀ Λ e_o for ω = Λ e_o."""
    q_target = q_target * (np.sign(q_target @ q) or 1.0)
    error = rotation.quaternion_error(q_target, q)
    if q_target @ q > 1e-15:
        rate = rotation.quaternion_jacobian(q) @ (5 * error)
        assert -2 * q_target @ rate == pytest.approx(-5 * error @ error, abs=1e-14)


def angle_between(q_target: Array, q: Array) -> Array:
    """Degrees."""
    return np.asarray(np.degrees(np.linalg.norm(rotation.orientation_error(q_target, q), axis=-1)))


def as_read(q: Array) -> Array:
    """Of q and −q, at length one, what Shepperd's rule reads from their matrix: the largest component is positive."""
    largest = np.take_along_axis(q, np.argmax(np.abs(q), axis=-1)[..., None], axis=-1)
    return np.asarray(q * np.sign(largest) / np.linalg.norm(q, axis=-1, keepdims=True))


def follow(error: Error, q_target: Array, q: Array, gain: float, seconds: float, body: bool) -> Array:
    """Where ω = gain · error leads, as an angular velocity in the body or in the base frame, q read at every step."""
    step = 5e-3
    for _ in range(round(seconds / step)):
        turn = rotation.from_rotation_vector(gain * step * error(q_target, q))
        q = as_read(rotation.multiply(q, turn) if body else rotation.multiply(turn, q))
    return q


def random_quaternions(count: int, seed: int) -> Array:
    """Uniform rotations."""
    return as_read(np.random.default_rng(seed).normal(size=(count, 4)))


def plain_difference(q_target: Array, q: Array) -> Array:
    """Δε of Vargas 2013, eq. 2.41, without the change of sign."""
    return rotation.multiply(q_target, rotation.conjugate(q))[..., 1:]


def test_with_the_shorter_way_every_pair_converges() -> None:
    """Recomputed: of 300 random pairs (λ = 5, 6 s) all end within 6e-5°; without the sign 44 are off by 1°."""
    q_target, q = random_quaternions(300, 1), random_quaternions(300, 2)
    reached = follow(rotation.quaternion_error, q_target, q, 5.0, 6.0, body=False)
    assert np.max(angle_between(q_target, reached)) < 6.5e-5
    stuck = angle_between(q_target, follow(plain_difference, q_target, q, 5.0, 6.0, body=False)) > 1
    assert 25 <= np.count_nonzero(stuck) <= 60


def test_a_body_velocity_needs_the_error_in_the_body_frame() -> None:
    """Coutinho 2015, eqs. 2.62–2.63: R = Rot(x, 180°), R_d = R Rot(z, 20°), K = 2: the base error ends at 179.9°."""
    q = rotation.from_axis_angle((1, 0, 0), np.pi)
    q_target = rotation.multiply(q, rotation.from_axis_angle((0, 0, 1), np.radians(20)))
    literal = follow(rotation.quaternion_error, q_target, q, 2.0, 10.0, body=True)
    assert angle_between(q_target, literal) == pytest.approx(179.9, abs=0.1)
    corrected = follow(rotation.quaternion_error_body, q_target, q, 2.0, 10.0, body=True)
    assert angle_between(q_target, corrected) == pytest.approx(0.0009, abs=5e-5)


def test_the_base_error_as_a_body_velocity_fails_from_most_poses() -> None:
    """Coutinho 2015, eqs. 2.62–2.63: it fails from 35 of 40 random poses with errors of about 0.2 rad."""
    q = random_quaternions(40, 3)
    turn = rotation.from_rotation_vector(np.random.default_rng(4).normal(scale=0.12, size=(40, 3)))
    q_target = rotation.multiply(q, turn)
    literal = follow(rotation.quaternion_error, q_target, q, 2.0, 10.0, body=True)
    assert np.count_nonzero(angle_between(q_target, literal) > 1) > 20
    corrected = follow(rotation.quaternion_error_body, q_target, q, 2.0, 10.0, body=True)
    assert np.max(angle_between(q_target, corrected)) < 0.01


@pytest.mark.parametrize("body", [False, True])
@pytest.mark.parametrize("seconds", [0.5, 1.0, 2.0])
def test_the_angle_law_of_the_quaternion_error(seconds: float, body: bool) -> None:
    """Coutinho 2015, eqs. 2.64, 2.66, solved: tan(φ/4) = tan(φ₀/4) e^{−Kt/2}, simulated from 170° with K = 4."""
    q_target = random_quaternions(3, 5)
    start = np.radians([170, 90, 1])
    q = rotation.multiply(rotation.from_axis_angle(np.random.default_rng(6).normal(size=(3, 3)), start), q_target)
    error = rotation.quaternion_error_body if body else rotation.quaternion_error
    law = 4 * np.arctan(np.tan(start / 4) * np.exp(-2 * seconds))
    reached = angle_between(q_target, follow(error, q_target, q, 4.0, seconds, body))
    np.testing.assert_allclose(reached, np.degrees(law), atol=0.3)


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


def test_roll_pitch_yaw_of_a_quaternion_by_the_corrected_equation_90() -> None:
    """Cerbaro 2022, eq. 90: 1 rad about (1, 1, 1)/√3 is (0.7445, 0.3391, 0.7445); as printed, (0.561, 0.561, 0.561)."""
    q = rotation.from_axis_angle((1, 1, 1), 1.0)
    np.testing.assert_allclose(rotation.roll_pitch_yaw_of_quaternion(q), [0.7445, 0.3391, 0.7445], atol=1e-4)
    np.testing.assert_allclose(2 * np.arcsin(q[1:]), 0.561, atol=5e-4)
    about_x = rotation.from_axis_angle((1, 0, 0), 0.9)
    np.testing.assert_allclose(rotation.roll_pitch_yaw_of_quaternion(about_x), 2 * np.arcsin(about_x[:0:-1]))


@given(quaternions)
def test_roll_pitch_yaw_of_quaternions_in_closed_form(q: Array) -> None:
    """Cerbaro 2022, eq. 90, which prints them otherwise."""
    w, x, y, z = q
    roll, pitch, yaw = rotation.roll_pitch_yaw_of_quaternion(q)
    sine = np.clip(2 * (w * y - z * x), -1, 1)
    assert np.sin(pitch) == pytest.approx(sine, abs=1e-15)
    if abs(sine) < 0.999:
        found = np.array([roll, yaw])
        closed = np.arctan2(
            [2 * (w * z + x * y), 2 * (w * x + y * z)], [1 - 2 * (y * y + z * z), 1 - 2 * (x * x + y * y)]
        )
        np.testing.assert_allclose(np.sin((found - closed) / 2), 0, atol=1e-13)


def test_everything_broadcasts() -> None:
    rng = np.random.default_rng(2)
    q = rotation.from_axis_angle(rng.normal(size=(4, 5, 3)), rng.normal(size=(4, 5)))
    v = rng.normal(size=(5, 3))
    R = rotation.to_matrix(q)
    np.testing.assert_allclose(rotation.rotate(q, v), np.einsum("abij,bj->abi", R, v), atol=1e-14)
    np.testing.assert_allclose(rotation.from_matrix(R), q * rotation.hemisphere_sign(q), atol=1e-14)
    np.testing.assert_allclose(rotation.rotation_vector(q)[2, 3], rotation.rotation_vector(q[2, 3]), atol=1e-15)
    np.testing.assert_allclose(rotation.roll_pitch_yaw_zyx(R)[1, 1], rotation.roll_pitch_yaw_zyx(R[1, 1]), atol=1e-15)
    np.testing.assert_allclose(rotation.exponential(rotation.logarithm(R)), R, atol=1e-14)
    axis, angle = rotation.axis_angle(q)
    np.testing.assert_allclose(rotation.from_axis_angle(axis, angle), q * rotation.hemisphere_sign(q), atol=1e-15)
    np.testing.assert_allclose(
        rotation.from_rotation_vector(axis * angle[..., None])[1, 1], rotation.from_matrix(R[1, 1])
    )
    for jacobian in (rotation.quaternion_jacobian, rotation.quaternion_jacobian_body):
        np.testing.assert_allclose(jacobian(q)[3, 4], jacobian(q[3, 4]), atol=1e-15)
    for error in (rotation.quaternion_error, rotation.quaternion_error_body):
        np.testing.assert_allclose(error(q[0], q)[3, 4], error(q[0, 4], q[3, 4]), atol=1e-15)


@pytest.mark.parametrize("axis", [(0, 0, 0), (np.nan, 0, 1), (np.inf, 0, 0)])
def test_an_axis_needs_a_direction(axis: tuple[float, float, float]) -> None:
    with pytest.raises(HelicoideError, match="has no direction"):
        rotation.from_axis_angle([(0, 0, 1), axis], 1.0)
