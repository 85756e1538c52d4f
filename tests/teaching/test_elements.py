"""Points, lines, planes and motions of a notebook agree with each other and with the geometry from arrays."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import helicoide
from helicoide.geometry.clifford import CL031, PGA
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError

coordinates = st.tuples(*[st.floats(-10, 10)] * 3)
directions = coordinates.filter(lambda v: np.linalg.norm(v) > 0.1)
angles = st.floats(-3, 3)


@given(directions, coordinates, angles, st.floats(-1, 1))
def test_a_screw_is_its_pose_and_its_logarithm(
    direction: tuple[float, ...], through: tuple[float, ...], angle: float, pitch: float
) -> None:
    M = helicoide.screw(direction, through, angle, pitch)
    again = helicoide.motor(helicoide.pose(M))
    np.testing.assert_allclose(again.values * np.sign(again.values @ M.values), M.values, atol=1e-9)
    np.testing.assert_allclose(helicoide.exp(helicoide.log(M)).values, again.values, atol=1e-9)


@given(directions, coordinates, angles, coordinates)
def test_a_motor_moves_a_point_as_its_pose_does(
    direction: tuple[float, ...], through: tuple[float, ...], angle: float, place: tuple[float, ...]
) -> None:
    M = helicoide.screw(direction, through, angle)
    x, y, z, _ = helicoide.pose(M) @ [*place, 1.0]
    np.testing.assert_allclose((M >> helicoide.point(*place)).values, helicoide.point(x, y, z).values, atol=1e-9)


def test_quaternions_multiply_as_hamilton_carved() -> None:
    i, j, k = (helicoide.quaternion(0, *row) for row in np.eye(3))
    minus_one = helicoide.quaternion(-1, 0, 0, 0).values
    for square in (i * i, j * j, k * k, i * j * k):
        np.testing.assert_array_equal(square.values, minus_one)


def test_rotor_and_translator_make_a_motor() -> None:
    M = helicoide.translator((1, 2, 3)) * helicoide.rotor((0, 0, 2), np.pi / 2)
    expected = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]
    np.testing.assert_allclose(helicoide.pose(M), expected, atol=1e-12)


p, q = helicoide.point(0, 0, 1), helicoide.point(3, 4, 1)
x_axis, higher = helicoide.line((2, 0, 0), (5, 0, 0)), helicoide.line((0, 1, 0), p)
floor, ceiling = helicoide.plane((0, 0, 2), 0.25), helicoide.plane((0, 0, -1), -2.0)


@pytest.mark.parametrize(
    ("a", "b", "expected"),
    [
        (p, q, 5.0),
        (p, floor, 0.75),
        (q, x_axis, np.sqrt(17.0)),
        (x_axis, higher, 1.0),
        (x_axis, floor, -0.25),
        (floor, ceiling, 1.75),
        (floor, helicoide.plane((1, 0, 0), 3.0), 0.0),
        (higher, helicoide.plane((0, 1, 0), 3.0), 0.0),
    ],
)
def test_distances(a: Multivector, b: Multivector, expected: float) -> None:
    assert helicoide.distance(a, b) == pytest.approx(expected, abs=1e-12)
    assert helicoide.distance(b, a) == helicoide.distance(a, b)


def test_join_and_meet() -> None:
    np.testing.assert_allclose(
        helicoide.join(p, helicoide.point(0, 5, 1)).values, helicoide.line((0, 1, 0), p).values, atol=1e-12
    )
    three = helicoide.meet(floor, helicoide.plane((1, 0, 0), 3.0), helicoide.plane((0, 1, 0), 2.0))
    np.testing.assert_allclose(three.values, helicoide.point(3, 2, 0.25).values, atol=1e-12)


@pytest.mark.parametrize(
    ("bad", "said"),
    [
        (lambda: helicoide.point(0, 0, np.nan), "3 finite numbers"),
        (lambda: helicoide.point(0, 0, "x"), "3 finite numbers"),  # type: ignore[arg-type]
        (lambda: helicoide.line((0, 0, 0), (1, 0, 0)), "no direction"),
        (lambda: helicoide.plane((0, 0, 1, 0), 1.0), "3 finite numbers"),
        (lambda: helicoide.plane((0, 0, 1), np.inf), "1 finite numbers"),
        (lambda: helicoide.motor(np.ones((4, 4))), "4 × 4 pose"),
        (lambda: helicoide.pose(p), "not close to a motor"),
        (lambda: helicoide.distance(p, helicoide.rotor((0, 0, 1), 1.0)), "points, lines and planes"),
        (lambda: helicoide.distance(p, p - p), "points, lines and planes"),
        (lambda: helicoide.join(p, Multivector(PGA.blade("1"), PGA)), "Cl(0,3,1)"),
        (lambda: helicoide.join(p, 3.0), "Cl(0,3,1)"),  # type: ignore[arg-type]
    ],
)
def test_what_is_wrong_is_refused_in_words(bad: Callable[[], object], said: str) -> None:
    with pytest.raises(HelicoideError) as refusal:
        bad()
    assert said in refusal.value.text.en
    assert refusal.value.text.en != refusal.value.text.pt_BR


def test_a_multivector_prints_itself_in_both_namings() -> None:
    page = (1.0 - 0.5 * helicoide.line((0, 0, 1), (1, 0, 0)))._repr_html_()
    assert "e<sub>1</sub>e<sub>2</sub>" in page
    assert "e<sub>12</sub>" in page
    assert "Cl(0,3,1)" in page
    formula = Multivector(CL031.blade("e1e2e"), CL031)._repr_latex_()
    assert formula == "$e_{1}e_{2}e$"
