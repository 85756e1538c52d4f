"""One coefficient is given, the result is valid and has it, and the rest changes as little as it may."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.geometry import motor, rigid, rotation
from helicoide.geometry.clifford import CL031, Array
from helicoide.geometry.given_coefficient import motor_with_coefficient, plane_with_coefficient
from helicoide.text import HelicoideError

ROTOR, DUAL = ("1", "e2e3", "e3e1", "e1e2"), ("e1e", "e2e", "e3e", "e1e2e3e")
numbers = st.floats(-1.0, 1.0)
vectors = st.tuples(numbers, numbers, numbers)


def at(M: Array, blade: str) -> float:
    place, sign = CL031.parse_blade(blade)
    return float(sign * M[place])


def random_motor(turn: tuple[float, ...], t: tuple[float, ...]) -> Array:
    T = np.eye(4)
    T[:3, :3] = rotation.exponential(3 * np.array(turn))
    T[:3, 3] = t
    return rigid.canonical(rigid.motor_from_pose(T))


@given(vectors, vectors, st.sampled_from(ROTOR), numbers)
def test_a_rotor_coefficient_is_kept_and_so_is_the_position(
    turn: tuple[float, ...], t: tuple[float, ...], blade: str, value: float
) -> None:
    M = random_motor(turn, t)
    try:
        moved = motor_with_coefficient(M, blade, value)
    except HelicoideError:
        rest = [at(M, other) for other in ROTOR if other != blade]
        assert np.linalg.norm(rest) < 1e-8
        return
    assert motor.is_motor(moved)
    assert at(moved, blade) == pytest.approx(value, abs=1e-12)
    np.testing.assert_allclose(rigid.pose_from_motor(moved)[:3, 3], t, atol=1e-9)


@given(vectors, vectors, st.sampled_from(DUAL), numbers)
def test_a_dual_coefficient_is_kept_and_so_is_the_orientation(
    turn: tuple[float, ...], t: tuple[float, ...], blade: str, value: float
) -> None:
    M = random_motor(turn, t)
    try:
        moved = motor_with_coefficient(M, blade, value)
    except HelicoideError:
        return
    scale = max(1.0, float(np.abs(moved).max()))
    assert motor.is_motor(moved, 1e-8 * scale**2)
    assert at(moved, blade) == pytest.approx(value, abs=1e-9)
    before, after = rigid.pose_from_motor(M), rigid.pose_from_motor(moved)
    np.testing.assert_allclose(after[:3, :3], before[:3, :3], atol=1e-12)


@pytest.mark.parametrize("blade", [*ROTOR, *DUAL])
def test_the_value_that_is_there_changes_nothing(blade: str) -> None:
    M = random_motor((0.2, -0.3, 0.1), (0.4, 0.5, -0.6))
    np.testing.assert_allclose(motor_with_coefficient(M, blade, at(M, blade)), M, atol=1e-12)


def test_what_no_motor_has_is_refused() -> None:
    M = random_motor((0.2, -0.3, 0.1), (0.4, 0.5, -0.6))
    for blade in ("e1", "e", "e1e2e3", "e2e3e"):
        with pytest.raises(HelicoideError, match="A motor has only"):
            motor_with_coefficient(M, blade, 0.1)
    for value in (1.5, -1.0001):
        with pytest.raises(HelicoideError, match="from −1 to 1"):
            motor_with_coefficient(M, "1", value)
    with pytest.raises(HelicoideError, match="all zero"):
        motor_with_coefficient(CL031.blade("1"), "1", 0.5)


@given(vectors.filter(lambda n: np.linalg.norm(n) > 0.1), numbers, st.sampled_from(("e1", "e2", "e3")), numbers)
def test_a_plane_keeps_its_distance_or_its_normal(
    normal: tuple[float, ...], d: float, blade: str, value: float
) -> None:
    n = np.array(normal) / np.linalg.norm(normal)
    pi = rigid.plane(n, d)
    shifted = rigid.normal_and_offset(plane_with_coefficient(pi, "e", value))
    np.testing.assert_allclose(shifted[0], n)
    assert shifted[1] == pytest.approx(value)
    try:
        turned = plane_with_coefficient(pi, blade, value)
    except HelicoideError:
        return
    m, offset = rigid.normal_and_offset(turned)
    assert np.linalg.norm(m) == pytest.approx(1.0)
    assert at(turned, blade) == pytest.approx(value)
    assert offset == pytest.approx(d)


def test_what_no_plane_has_is_refused() -> None:
    with pytest.raises(HelicoideError, match="A plane has only"):
        plane_with_coefficient(rigid.plane([0, 0, 1], 0.5), "e1e2", 0.5)
