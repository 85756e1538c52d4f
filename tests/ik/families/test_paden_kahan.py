"""The subproblems of Paden and Kahan: what they find is a solution, and what made the question is found."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.families.paden_kahan import Axis, angles_to_distance, angles_to_point, turn_to
from helicoide.ik.postures.branch import wrap

seeds = st.integers(0, 2**32 - 1)


def some_axis(rng: np.random.Generator) -> Axis:
    return Axis(np.asarray(rotation.unit_vector(rng.normal(size=3))), rng.normal(size=3))


def turned(axis: Axis, angle: float, p: Array) -> Array:
    """e^(ξ̂θ) p, by quaternions."""
    q = rotation.from_axis_angle(axis.direction, angle)
    return np.asarray(axis.point + rotation.rotate(q, p - axis.point))


@given(seeds)
def test_1_the_angle_is_the_one_by_which_the_point_was_turned(seed: int) -> None:
    rng = np.random.default_rng(seed)
    axis, p, theta = some_axis(rng), rng.normal(size=3), rng.uniform(-np.pi, np.pi)
    far = float(np.linalg.norm(np.cross(p - axis.point, axis.direction)))
    assert abs(wrap(turn_to(axis, p, turned(axis, theta, p), 0.0) - theta)) < 1e-13 * max(1.0, 1 / far)


@given(seeds)
def test_2_both_solutions_come_to_the_point_and_one_is_that_which_made_it(seed: int) -> None:
    rng = np.random.default_rng(seed)
    first = some_axis(rng)
    second = Axis(some_axis(rng).direction, first.point)
    assume(np.linalg.norm(np.cross(first.direction, second.direction)) > 0.1)
    p, theta = rng.normal(size=3), rng.uniform(-np.pi, np.pi, 2)
    goal = turned(first, theta[0], turned(second, theta[1], p))
    found = angles_to_point(first, second, p, goal, (0.0, 0.0))
    assert len(found) in (1, 2)
    for one, other in found:
        np.testing.assert_allclose(turned(first, one, turned(second, other, p)), goal, atol=1e-6)
    # two solutions that nearly meet are known to the root of rounding only
    assert min(float(np.abs(wrap(np.array(pair) - theta)).max()) for pair in found) < 1e-4


@given(seeds)
def test_3_both_solutions_have_the_distance_and_one_is_that_which_made_it(seed: int) -> None:
    rng = np.random.default_rng(seed)
    axis, p, q, theta = some_axis(rng), rng.normal(size=3), rng.normal(size=3), rng.uniform(-np.pi, np.pi)
    far = float(np.linalg.norm(q - turned(axis, theta, p)))
    found = angles_to_distance(axis, p, q, far, 0.0)
    assert len(found) in (1, 2)
    assert [np.linalg.norm(q - turned(axis, angle, p)) for angle in found] == pytest.approx(
        [far] * len(found), abs=1e-6
    )
    assert min(abs(float(wrap(angle - theta))) for angle in found) < 1e-4


X, Z = np.eye(3)[0], np.eye(3)[2]
WAIST = Axis(Z, np.zeros(3))


def test_what_lies_on_the_axis_keeps_its_angle() -> None:
    assert turn_to(WAIST, 2 * Z, 2 * Z, 0.7) == 0.7
    assert angles_to_distance(WAIST, 2 * Z, X, 5**0.5, 0.7) == [0.7]
    assert angles_to_point(WAIST, Axis(X, np.zeros(3)), Z, Z, (0.7, 0.0)) == [(0.7, 0.0)]


def test_on_the_edge_there_is_one_and_beyond_it_none() -> None:
    assert angles_to_distance(WAIST, X, 2 * X, 1.0, 0.0) == pytest.approx([0.0])
    assert angles_to_distance(WAIST, X, 2 * X, 3.0, 0.0) == pytest.approx([np.pi])
    for distance in (0.999, 3.001):
        assert angles_to_distance(WAIST, X, 2 * X, distance, 0.0) == []
    # the tip of a link that leans 45° from its axis cannot be brought upright over that axis but from one side
    lean = Axis(np.asarray(rotation.unit_vector(X + Z)), np.zeros(3))
    assert len(angles_to_point(WAIST, lean, X, Z, (0.0, 0.0))) == 1
    assert angles_to_point(WAIST, lean, X, 1.001 * Z, (0.0, 0.0)) == []


def test_the_example_of_the_book_by_hand() -> None:
    """From x about x̂ nothing moves; about z and y a point at x comes to z by θ₂ = −90°, where θ₁ is free."""
    lift = Axis(np.eye(3)[1], np.zeros(3))
    assert angles_to_point(WAIST, lift, X, Z, (0.3, 0.0)) == [(0.3, pytest.approx(-np.pi / 2))]
    for angles in angles_to_point(WAIST, lift, X, np.array([0, 0.6, 0.8]), (0.0, 0.0)):
        assert abs(np.sin(angles[0])) == pytest.approx(1)
