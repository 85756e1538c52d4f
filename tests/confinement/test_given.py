"""Planes from coefficients, from three points, and of a box."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.confinement import (
    BOX,
    Plane,
    box_planes,
    from_coefficients,
    planes_around,
    planes_of,
    signed_distances,
    through_points,
)
from helicoide.geometry import rigid
from helicoide.kinematics.robot import Robot
from helicoide.readout import printed_planes
from helicoide.text import HelicoideError

INSIDE = np.array([0.52, 0.0, 0.23])
seeds = st.integers(0, 2**32 - 1)

# Cerbaro 2022, section 6.2.1, as printed (mm); the walls are named as in the robot's file, the other way round.
PRINTED = {
    "+z": [0.0522, 0.0104, 0.9986, 663.1712],
    "+y": [0.0577, 0.9954, 0.0763, 356.2977],
    "-y": [-0.0479, -0.9968, 0.0634, 311.4408],
}


def distance(plane: Plane, point: Array) -> float:
    return float(rigid.point_plane_distance(rigid.plane(plane.normal, plane.offset), rigid.point(point)))


@pytest.mark.parametrize("name", PRINTED)
def test_printed_planes_are_those_of_the_robots_file(robot: Robot, name: str) -> None:
    """The source's numbers, in mm and with outward normals, turned by a point inside."""
    (pane,) = [pane for pane in robot.panes if pane.name == name]
    plane = from_coefficients([*PRINTED[name][:3], PRINTED[name][3] / 1000], INSIDE)
    np.testing.assert_allclose(plane.normal, pane.normal, rtol=0, atol=1e-12)
    assert plane.offset == pytest.approx(pane.offset, abs=1e-12)


@pytest.mark.parametrize("name", PRINTED)
def test_what_is_shown_as_printed_is_what_is_printed(robot: Robot, name: str) -> None:
    """Label, signs and millimetres of §6.2.1; the source calls our left wall −y."""
    (pane,) = [pane for pane in robot.panes if pane.name == name]
    label, _, sum_of_blades = pane.as_printed.partition(": ")
    assert label == {"+z": "+z", "+y": "-y", "-y": "+y"}[name]
    values = re.findall(r"(-?)\s?(\d+\.\d+) e", sum_of_blades)
    np.testing.assert_array_equal([float(sign + digits) for sign, digits in values], PRINTED[name])
    (line,) = [line for line in printed_planes(robot) if line.en.startswith(f"{name} (")]
    said = pane.as_printed.replace("-", "−").replace("e1", "e₁").replace("e2", "e₂").replace("e3", "e₃")
    assert said in line.en
    assert said.replace(".", ",") in line.pt_BR


@given(seed=seeds, exponent=st.integers(-300, 300), swapped=st.booleans())
def test_coefficients_of_any_scale_and_sign_are_one_plane(seed: int, exponent: int, swapped: bool) -> None:
    rng = np.random.default_rng(seed)
    normal, d, inside = rng.normal(size=3), rng.normal(), rng.normal(size=3)
    normal /= np.linalg.norm(normal)
    assume(abs(normal @ inside - d) > 1e-3)
    factor = 10.0**exponent * (-1 if swapped else 1)
    plane = from_coefficients(factor * np.array([*normal, d]), inside)
    assert np.linalg.norm(plane.normal) == pytest.approx(1, abs=1e-15)
    np.testing.assert_allclose(distance(plane, inside), abs(normal @ inside - d), rtol=0, atol=1e-12)
    on_it = rng.normal(size=3)
    on_it -= (normal @ on_it - d) * normal
    assert distance(plane, on_it) == pytest.approx(0, abs=1e-12)
    assert distance(plane, plane.foot(inside)) == pytest.approx(0, abs=1e-12)
    np.testing.assert_allclose(np.cross(plane.foot(inside) - inside, normal), 0, atol=1e-12)


def test_plane_through_the_points_of_the_source() -> None:
    """Cerbaro 2022, eqs. 27–30, seen from either side."""
    points = [[1, 2, 3], [2, -2, 3], [-1, 1, 0]]
    above = through_points(points, [-10, 0, 0])
    np.testing.assert_allclose([*above.normal, above.offset], [-0.7845, -0.1961, 0.5883, 0.5883], rtol=0, atol=1e-4)
    below = through_points(points, [10, 0, 0])
    np.testing.assert_array_equal([*below.normal, below.offset], [*-above.normal, -above.offset])


@given(seeds)
def test_three_points_lie_on_their_plane(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points, inside = rng.normal(size=(3, 3)), rng.normal(size=3)
    plane = through_points(points, inside)
    for point in points:
        assert distance(plane, point) == pytest.approx(0, abs=1e-9)
    assert distance(plane, inside) > 0


def test_a_box_holds_what_is_inside_and_touches_its_corners() -> None:
    low, high = np.array([0.1, -0.3, 0.05]), np.array([0.9, 0.35, 0.6])
    planes = box_planes(low, high)
    points = np.array([low, high, (low + high) / 2])
    table = signed_distances(planes.normals, planes.offsets, points)
    assert BOX == ("+z", "+y", "-y", "-z")
    np.testing.assert_allclose(table[0], [0.55, 0.65, 0, 0], atol=1e-12)
    np.testing.assert_allclose(table[1], [0, 0, 0.65, 0.55], atol=1e-12)
    np.testing.assert_allclose(table[2], [0.275, 0.325, 0.325, 0.275], atol=1e-12)
    np.testing.assert_allclose(planes.centres[:, 0], 0.5, atol=1e-12)


def test_a_box_takes_the_places_of_the_panes_of_the_robot(robot: Robot) -> None:
    """Names and faces in the order of the robot's file."""
    assert tuple(pane.name for pane in robot.panes) == BOX
    faces = box_planes([0.1, -0.3, 0], [0.9, 0.3, 0.6]).normals
    assert (np.einsum("ij,ij->i", faces, planes_of(robot.panes).normals) > 0.99).all()


def test_planes_stand_around_a_point() -> None:
    ceiling, wall = from_coefficients([0, 0, 2, 1.2], INSIDE), from_coefficients([0, 1, 0, 0.3], INSIDE)
    planes = planes_around([ceiling, wall], INSIDE)
    np.testing.assert_allclose(planes.centres, [[0.52, 0, 0.6], [0.52, 0.3, 0.23]], atol=1e-15)
    np.testing.assert_allclose(planes.offsets, [ceiling.offset, wall.offset], atol=1e-15)


@pytest.mark.parametrize(
    ("coefficients", "inside", "said"),
    [
        ([0, 0, 0, 1], INSIDE, "cannot be all zero"),
        ([0, 0, 1, 1e6], INSIDE, "within 1000 m"),
        ([1e-308, 0, 0, 1e308], INSIDE, "within 1000 m"),
        ([0, 0, 1], INSIDE, "4 finite numbers"),
        ([0, 0, np.nan, 1], INSIDE, "4 finite numbers"),
        (["a", 0, 0, 1], INSIDE, "4 finite numbers"),
        ([0, 0, 10**400, 1], INSIDE, "4 finite numbers"),
        ([0, 0, 1, 0.23], INSIDE, "lies on the plane"),
        ([0, 0, 1, 0], [0, 0, np.inf], "3 finite numbers up to 1000 m"),
        ([0, 0, 1, 0], [0, 0, 1e9], "3 finite numbers up to 1000 m"),
    ],
)
def test_what_is_no_plane_is_refused_in_words(coefficients: list[float], inside: Array, said: str) -> None:
    with pytest.raises(HelicoideError, match=said):
        from_coefficients(coefficients, inside)


@pytest.mark.parametrize(
    ("points", "said"),
    [
        ([[0, 0, 0], [1, 1, 1], [3, 3, 3]], "on one line"),
        ([[1, 2, 3], [1, 2, 3], [3, 3, 3]], "on one line"),
        ([[0, 0, 0], [1, 0, 0]], "9 finite numbers"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "lies on the plane"),
    ],
)
def test_points_without_a_plane_are_refused_in_words(points: list[list[float]], said: str) -> None:
    with pytest.raises(HelicoideError, match=said):
        through_points(points, [5, 5, 0])


@pytest.mark.parametrize(
    ("lower", "upper", "said"),
    [
        ([0, 0, 0], [1, -1, 1], r"not \(0, 0, 0\) and \(1, -1, 1\) m"),
        ([0, 0, 0], [1, 1, 0], "must be less"),
        ([0, 0, np.nan], [1, 1, 1], "3 finite numbers"),
        ([0, 0], [1, 1, 1], "3 finite numbers"),
    ],
)
def test_what_is_no_box_is_refused_in_words(lower: list[float], upper: list[float], said: str) -> None:
    with pytest.raises(HelicoideError, match=said):
        box_planes(lower, upper)
