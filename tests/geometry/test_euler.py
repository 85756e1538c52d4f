from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation  # type: ignore[import-untyped]

from helicoide.geometry import euler, rotation
from helicoide.geometry.clifford import Array
from helicoide.text import HelicoideError

# Angles at, and ever nearer to, the singularities of all conventions: multiples of a right angle.
NEAR = [0.0, 1e-15, 3e-13, -3e-13, 1e-9, -1e-7, 1e-4]
SPECIAL = [k * np.pi / 2 + off for k in range(-2, 3) for off in NEAR]
conventions = st.sampled_from(euler.CONVENTIONS)
angle = st.one_of(st.sampled_from(SPECIAL), st.floats(-7, 7))
triples = st.tuples(angle, angle, angle).map(np.array)
vectors = st.tuples(*[st.floats(-5, 5)] * 3).map(np.array)
every_convention = pytest.mark.parametrize("convention", euler.CONVENTIONS)


def oracle_name(convention: str) -> str:
    """The oracle writes intrinsic conventions in capitals and extrinsic ones in small letters."""
    return convention.removeprefix(euler.EXTRINSIC) if euler.EXTRINSIC in convention else convention.upper()


def comes_back(convention: str) -> bool:
    return convention[-3] == convention[-1]


def right_angle(convention: str) -> float:
    """Middle angle that is farthest from both singularities."""
    return np.pi / 2 if comes_back(convention) else 0.0


def regular_angles(convention: str, count: int) -> Array:
    """Random angles in their ranges, 0.01 rad and more from the singularities."""
    rng = np.random.default_rng(5)
    middle = np.array([0, right_angle(convention), 0])
    return np.asarray(middle + rng.uniform(-1, 1, (count, 3)) * [np.pi, np.pi / 2 - 0.01, np.pi])


def test_there_are_twenty_four() -> None:
    assert len(set(euler.CONVENTIONS)) == 24
    assert {c.removeprefix(euler.EXTRINSIC) for c in euler.CONVENTIONS} == set(euler.SEQUENCES)


@given(triples, conventions)
def test_matrices_are_those_of_the_oracle(angles: Array, convention: str) -> None:
    expected = Rotation.from_euler(oracle_name(convention), angles).as_matrix()
    np.testing.assert_allclose(euler.euler_matrix(angles, convention), expected, atol=5e-15)


@every_convention
def test_angles_are_those_of_the_oracle(convention: str) -> None:
    R = Rotation.random(300, rng=7).as_matrix()
    found = euler.euler_angles(R, convention)
    expected = Rotation.from_matrix(R).as_euler(oracle_name(convention))
    np.testing.assert_allclose(euler.euler_angle_error(expected, found.values), 0, atol=1e-11)
    assert not np.any(found.singular)


@every_convention
def test_angles_come_back(convention: str) -> None:
    angles = regular_angles(convention, 300)
    found = euler.euler_angles(euler.euler_matrix(angles, convention), convention)
    np.testing.assert_allclose(found.values, angles, atol=1e-12)
    np.testing.assert_allclose(
        found.singularity_margin, np.pi / 2 - np.abs(angles[:, 1] - right_angle(convention)), atol=1e-14
    )


@given(triples, conventions)
def test_every_matrix_is_recovered_also_near_and_at_the_singularities(angles: Array, convention: str) -> None:
    R = euler.euler_matrix(angles, convention)
    found = euler.euler_angles(R, convention)
    recovered = euler.euler_matrix(found.values, convention)
    np.testing.assert_allclose(recovered, R, atol=3 * euler.SINGULAR if found.singular else 1e-14)
    assert abs(found.values[1] - right_angle(convention)) <= np.pi / 2
    assert np.all(np.abs(found.values) <= np.pi)


@every_convention
@pytest.mark.parametrize("side", [-1, 1])
def test_at_a_singularity_the_leftmost_angle_is_zero(convention: str, side: int) -> None:
    angles = np.array([0.7, right_angle(convention) + side * np.pi / 2, -0.4])
    R = euler.euler_matrix(angles, convention)
    found = euler.euler_angles(R, convention)
    assert found.singular
    assert found.values[2 if euler.EXTRINSIC in convention else 0] == 0
    np.testing.assert_allclose(euler.euler_matrix(found.values, convention), R, atol=1e-15)


@every_convention
@pytest.mark.parametrize("distance", [1e-12, 1e-8, 1e-3, 0.5])
def test_the_margin_says_how_near_the_singularity_is(convention: str, distance: float) -> None:
    angles = np.array([0.7, right_angle(convention) + np.pi / 2 - distance, -0.4])
    found = euler.euler_angles(euler.euler_matrix(angles, convention), convention)
    assert not found.singular
    np.testing.assert_allclose(found.singularity_margin, distance, atol=1e-15)
    assert abs(euler.velocity_determinant(angles, convention)) == pytest.approx(np.sin(distance), abs=1e-15)


def test_tiny_angles_keep_their_digits() -> None:
    tiny = np.array([1e-200, -2e-30, 3e-17])
    R = np.eye(3) + rotation.skew(tiny[::-1])
    np.testing.assert_allclose(euler.euler_angles(R, "zyx").values, tiny, rtol=1e-15)


@given(triples, st.sampled_from(euler.SEQUENCES))
def test_fixed_axes_are_turned_axes_in_the_opposite_order(angles: Array, sequence: str) -> None:
    fixed = euler.EXTRINSIC + sequence
    R = euler.euler_matrix(angles, fixed)
    np.testing.assert_allclose(euler.euler_matrix(angles[::-1], sequence[::-1]), R, atol=1e-15)
    np.testing.assert_array_equal(
        euler.euler_angles(R, fixed).values[::-1], euler.euler_angles(R, sequence[::-1]).values
    )


@given(triples, vectors, conventions)
def test_the_velocity_matrix_is_the_derivative_of_the_matrix(angles: Array, rates: Array, convention: str) -> None:
    """ω = E φ̇ (Vargas 2013, eq. 2.26) against a central difference of the turns."""
    step = 1e-5 * rates
    turn = euler.euler_matrix(angles + step, convention) @ euler.euler_matrix(angles - step, convention).T
    omega = euler.velocity_matrix(angles, convention) @ rates
    np.testing.assert_allclose(omega, rotation.logarithm(turn) / 2e-5, atol=1e-6)


@every_convention
def test_the_jacobian_gives_the_rates_back(convention: str) -> None:
    angles = regular_angles(convention, 100)
    J, E = euler.euler_jacobian(angles, convention), euler.velocity_matrix(angles, convention)
    np.testing.assert_allclose(J @ E, np.broadcast_to(np.eye(3), J.shape), atol=1e-12)
    np.testing.assert_allclose(np.linalg.det(J) * euler.velocity_determinant(angles, convention), 1, rtol=1e-11)


@given(triples, conventions)
def test_the_determinant_is_a_cosine_or_a_sine(angles: Array, convention: str) -> None:
    expected = abs(np.sin(angles[1]) if comes_back(convention) else np.cos(angles[1]))
    found = euler.velocity_determinant(angles, convention)
    assert abs(found) == pytest.approx(expected, abs=1e-14)
    assert found == pytest.approx(np.linalg.det(euler.velocity_matrix(angles, convention)), abs=1e-14)


def test_rates_of_roll_pitch_yaw_in_closed_form() -> None:
    """E of "zyx" is [z, R_z y, R_z R_y x] with determinant −cos ϑ."""
    roll, pitch, _ = angles = np.array([0.3, -0.8, 1.9])
    s, c = np.sin(roll), np.cos(roll)
    E = [[0, -s, c * np.cos(pitch)], [0, c, s * np.cos(pitch)], [1, 0, -np.sin(pitch)]]
    np.testing.assert_allclose(euler.velocity_matrix(angles, euler.ROLL_PITCH_YAW), E, atol=1e-16)
    assert euler.velocity_determinant(angles, euler.ROLL_PITCH_YAW) == pytest.approx(-np.cos(pitch))


@every_convention
def test_a_singular_jacobian_keeps_the_rate_of_the_middle_angle_only(convention: str) -> None:
    angles = np.array([0.7, right_angle(convention) + np.pi / 2, -0.4])
    J = euler.euler_jacobian(angles, convention)
    assert np.all(np.isnan(J[[0, 2]]))
    np.testing.assert_allclose(J[1], euler.velocity_matrix(angles, convention)[:, 1], atol=1e-15)


@given(triples)
def test_the_sources_roll_pitch_yaw_is_zyx(angles: Array) -> None:
    """Cerbaro 2022, eqs. 53–55: Roll is about z, Yaw about x."""
    R = euler.euler_matrix(angles, euler.ROLL_PITCH_YAW)
    found = euler.euler_angles(R, euler.ROLL_PITCH_YAW)
    named = rotation.roll_pitch_yaw_zyx(R)
    np.testing.assert_allclose(euler.euler_matrix(named, euler.ROLL_PITCH_YAW), R, atol=1e-14)
    if not found.singular:
        # ±π is one angle
        np.testing.assert_allclose(euler.euler_angle_error(named, found.values), 0, atol=1e-14)


def test_angles_of_the_movemaster_example() -> None:
    """Cerbaro 2022, eqs. 4 and 6: (Roll, Pitch, Yaw) = (−1.047, 0, −2.618); pitch −(q₂ + q₃ + q₄), yaw q₅ of R_S."""
    s, c = np.sin(np.pi / 3), np.cos(np.pi / 3)
    R_dh = np.array([[c, -s * s, s * c], [-s, -s * c, c * c], [0, -c, -s]])
    np.testing.assert_allclose(euler.euler_angles(R_dh, euler.ROLL_PITCH_YAW).values, [-1.047, 0, -2.618], atol=5e-4)
    R_screws = R_dh @ np.array([[0.0, 0, 1], [0, -1, 0], [1, 0, 0]]).T
    q1, q2, q3, q4, q5 = np.radians([30, 60, -90, -30, 90])
    np.testing.assert_allclose(
        euler.euler_matrix([q1, -(q2 + q3 + q4), q5], euler.ROLL_PITCH_YAW), R_screws, atol=1e-15
    )


@given(triples, triples)
def test_the_error_of_angles_goes_the_shorter_way(target: Array, angles: Array) -> None:
    """Vargas 2013, eq. 2.37, and Cerbaro 2022, eq. 56."""
    error = euler.euler_angle_error(target, angles)
    assert np.all(np.abs(error) <= np.pi + 1e-15)
    turns = (target - angles - error) / (2 * np.pi)
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-15)


def test_the_error_of_angles_is_the_difference_of_near_angles() -> None:
    found = euler.euler_angle_error([0.3, 3.1, -3.1], [0.1, -3.1, 3.1])
    np.testing.assert_allclose(found, [0.2, 6.2 - 2 * np.pi, 2 * np.pi - 6.2], atol=1e-15)


@every_convention
def test_following_the_error_of_angles_reaches_the_target(convention: str) -> None:
    """ω = E λ (φ_d − φ): each angle decays as e^{−λt} (Vargas 2013, eqs. 2.37–2.39), whatever the convention."""
    target, start = regular_angles(convention, 2)
    gain, step, R = 5.0, 1e-3, euler.euler_matrix(start, convention)
    for _ in range(1000):
        angles = euler.euler_angles(R, convention).values
        rates = gain * euler.euler_angle_error(target, angles)
        R = rotation.exponential(euler.velocity_matrix(angles, convention) @ rates * step) @ R
    left = euler.euler_angle_error(target, euler.euler_angles(R, convention).values)
    expected = euler.euler_angle_error(target, start) * np.exp(-gain)
    np.testing.assert_allclose(left, expected, atol=0.02)


@every_convention
def test_everything_broadcasts(convention: str) -> None:
    angles = regular_angles(convention, 6).reshape(2, 3, 3)
    R = euler.euler_matrix(angles, convention)
    np.testing.assert_allclose(R[1, 2], euler.euler_matrix(angles[1, 2], convention), atol=1e-15)
    found = euler.euler_angles(R, convention)
    np.testing.assert_allclose(found.values[1, 2], angles[1, 2], atol=1e-12)
    assert found.singularity_margin.shape == found.singular.shape == (2, 3)
    J = euler.euler_jacobian(angles, convention)
    np.testing.assert_allclose(J[1, 2], euler.euler_jacobian(angles[1, 2], convention), atol=1e-14)
    assert euler.velocity_determinant(angles, convention).shape == (2, 3)


@pytest.mark.parametrize("name", ["", "zzx", "ZYX", "xyzx", "intrinsic zyx", "extrinsic", "extrinsic xxy"])
def test_a_wrong_name_is_answered_with_the_valid_ones(name: str) -> None:
    for ask in (euler.euler_matrix, euler.velocity_matrix, euler.velocity_determinant, euler.euler_jacobian):
        with pytest.raises(HelicoideError, match=f'"{name}" is no convention'):
            ask(np.zeros(3), name)
    with pytest.raises(HelicoideError) as caught:
        euler.euler_angles(np.eye(3), name)
    for language in (caught.value.text.en, caught.value.text.pt_BR):
        assert all(sequence in language for sequence in (*euler.SEQUENCES, euler.EXTRINSIC))
        assert "\n" not in language
