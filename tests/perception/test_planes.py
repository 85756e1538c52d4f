"""Planes found in clouds."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.perception.views import INSIDE, READINGS, between, misses, read

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.kernels import python_function
from helicoide.perception.planes import ANGLE, DISTANCE, FoundPlane, best_plane, find_plane
from helicoide.state import State
from helicoide.text import HelicoideError, Text

DOWN = np.array([0.0, 0, -1])
seeds = st.integers(0, 2**32 - 1)


def wall(rng: np.random.Generator, k: int, noise: float, height: float = 0.6) -> Array:
    """Points about the plane z = height, m."""
    points = rng.uniform(-0.4, 0.4, (k, 3))
    points[:, 2] = height + noise * rng.normal(size=k)
    return points


def expect(answer: FoundPlane | Text) -> FoundPlane:
    assert isinstance(answer, FoundPlane), answer
    return answer


@pytest.mark.parametrize("name", READINGS)
def test_printed_planes_are_recovered_from_what_the_camera_sees(state: State, name: str) -> None:
    """Noise of 2 mm, 30 % outliers: within 2 mm at the centroid of the cloud and 0.5°, for each of 20 seeds."""
    found = np.array([misses(state, name, seed) for seed in range(20)])
    print(name, f"{1000 * found[:, 0].max():.2f} mm, {np.degrees(found[:, 1]).max():.3f}°")
    assert found[:, 0].max() < 0.002
    assert np.degrees(found[:, 1]).max() < 0.5


@pytest.mark.parametrize("name", READINGS)
def test_what_is_said_of_a_plane_is_so(state: State, name: str) -> None:
    cloud, answer = read(state, name, 0)
    found, towards = expect(answer), READINGS[name][1]
    distances = rigid.point_plane_distance(found.multivector, rigid.point(cloud.points))
    assert rigid.point_plane_distance(found.multivector, rigid.point(INSIDE)) > 0
    assert np.linalg.norm(found.plane.normal) == pytest.approx(1, abs=1e-14)
    np.testing.assert_array_equal(found.on_plane, np.abs(distances) <= DISTANCE)
    assert found.share == pytest.approx(found.on_plane.mean(), abs=1e-15)
    assert found.rms == pytest.approx(np.sqrt(np.mean(distances[found.on_plane] ** 2)), rel=1e-6)
    assert found.angle == pytest.approx(between(found.plane.normal, towards), abs=1e-12)
    np.testing.assert_allclose(found.centre, cloud.points[found.on_plane].mean(axis=0), rtol=0, atol=1e-12)
    assert rigid.point_plane_distance(found.multivector, rigid.point(found.centre)) == pytest.approx(0, abs=1e-12)


def by_algebra(triples: Array, judges: Array, cone: Array, inside: Array, distance: float) -> Array:
    """`best_plane` through the algebra: planes of eqs. 25 and 26 judged by the distances of eq. 20."""
    corners = rigid.point(triples)
    planes = rigid.plane_through(corners[:, 0], corners[:, 1], corners[:, 2])
    planes = planes[planes.any(axis=1)]
    planes = planes * np.sign(rigid.point_plane_distance(planes, rigid.point(inside)))[:, None]
    normals, offsets = rigid.normal_and_offset(planes)
    allowed = normals @ cone[:3] >= cone[3]
    planes, normals, offsets = planes[allowed], normals[allowed], offsets[allowed]
    if not len(planes):
        return np.zeros(4)
    apart = rigid.point_plane_distance(planes[:, None], rigid.point(judges)[None])
    best = np.minimum(apart**2, distance**2).sum(axis=1).argmin()
    return np.array([*normals[best], offsets[best]])


@settings(max_examples=60)
@given(seed=seeds)
def test_the_kernel_does_what_the_algebra_says(seed: int) -> None:
    rng = np.random.default_rng(seed)
    judges = wall(rng, int(rng.choice([30, 1300])), 0.02)
    triples = np.concatenate([judges[:30], rng.normal(size=(30, 3))])[rng.integers(60, size=(40, 3))]
    triples[3, 2] = 2 * triples[3, 1] - triples[3, 0]  # on one line
    triples[4, 2] = triples[4, 1]
    cone = np.array([*DOWN, np.cos(rng.uniform(0.05, 0.6))])
    asked = triples, judges, cone, rng.normal(size=3) * 0.1, rng.uniform(0.002, 0.05)
    expected = by_algebra(*asked)
    np.testing.assert_allclose(best_plane(*asked), expected, rtol=0, atol=1e-9)
    np.testing.assert_allclose(python_function(best_plane)(*asked), expected, rtol=0, atol=1e-9)


def test_a_draw_is_judged_by_all_even_if_the_first_speak_against_it() -> None:
    rng = np.random.default_rng(0)
    judges = np.concatenate([wall(rng, 600, 0.0, 0.5), wall(rng, 1500, 0.0, 0.6)])
    cone = np.array([*DOWN, 0.9])
    for triples in (judges[[0, 1, 2, 700, 701, 702]], judges[[700, 701, 702, 0, 1, 2]]):
        found = best_plane(triples.reshape(2, 3, 3), judges, cone, np.zeros(3), DISTANCE)
        np.testing.assert_allclose(found, [*DOWN, -0.6], rtol=0, atol=1e-12)


def test_the_same_seed_gives_the_same_plane(state: State) -> None:
    (_, once), (_, again), (_, other) = (read(state, "+y", seed) for seed in (7, 7, 8))
    np.testing.assert_array_equal(expect(once).plane.normal, expect(again).plane.normal)
    np.testing.assert_array_equal(expect(once).on_plane, expect(again).on_plane)
    assert expect(once).plane.offset == expect(again).plane.offset
    assert expect(other).plane.offset != expect(once).plane.offset


@pytest.mark.parametrize("inside", [0.23, 1.0])
def test_the_normal_points_to_the_side_that_is_inside(inside: float) -> None:
    points = wall(np.random.default_rng(0), 500, 0.001)
    towards = np.array([0, 0, np.sign(inside - 0.6)])
    found = expect(find_plane(points, 5 * towards, [0, 0, inside]))
    np.testing.assert_allclose(found.plane.normal, towards, rtol=0, atol=0.01)
    assert found.plane.offset == pytest.approx(0.6 * towards[2], abs=0.001)
    assert isinstance(find_plane(points, -towards, [0, 0, inside]), Text)


def test_a_plane_without_noise_is_found_exactly() -> None:
    points = wall(np.random.default_rng(0), 500, 0.0)
    found = expect(find_plane(points, DOWN, [0, 0, 0]))
    np.testing.assert_allclose(found.plane.normal, DOWN, rtol=0, atol=1e-12)
    assert (found.share, found.rms) == (1, pytest.approx(0, abs=1e-9))


@settings(max_examples=25)
@given(seed=seeds)
def test_a_cloud_that_is_moved_has_its_plane_moved(seed: int) -> None:
    """By a motor, as eq. 95 moves planes."""
    rng = np.random.default_rng(seed)
    motor = rigid.screw_motor(rng.normal(size=3), rng.normal(size=3), rng.normal(), 0.1)
    points, inside = np.concatenate([wall(rng, 300, 0.001), rng.uniform(-1, 1, (200, 3))]), np.zeros(3)
    here = expect(find_plane(points, DOWN, inside, seed=1))
    T = rigid.pose_from_motor(motor)
    there = expect(find_plane(points @ T[:3, :3].T + T[:3, 3], T[:3, :3] @ DOWN, T[:3, :3] @ inside + T[:3, 3], seed=1))
    np.testing.assert_allclose(there.multivector, rigid.move(motor, here.multivector), rtol=0, atol=1e-9)
    np.testing.assert_array_equal(there.on_plane, here.on_plane)


def test_the_larger_of_two_walls_is_found_and_one_that_faces_elsewhere_is_not(state: State) -> None:
    rng = np.random.default_rng(0)
    side = np.roll(wall(rng, 3000, 0.001), 1, axis=1)
    points = np.concatenate([wall(rng, 400, 0.001, 0.5), wall(rng, 600, 0.001, 0.6), side])
    assert expect(find_plane(points, DOWN, [0, 0, 0])).plane.offset == pytest.approx(-0.6, abs=0.001)


@pytest.mark.parametrize("dense", [1000, 30_000])
@pytest.mark.parametrize("size", [0.003, 0.02, 0.05])
def test_a_small_thing_with_more_points_than_the_wall_is_not_taken_for_it(dense: int, size: float) -> None:
    rng = np.random.default_rng(0)
    thing = [0.1, -0.1, 0.35] + size * rng.normal(size=(dense, 3))
    found = expect(find_plane(np.concatenate([thing, wall(rng, 500, 0.001)]), DOWN, [0, 0, 0]))
    assert found.plane.offset == pytest.approx(-0.6, abs=0.001)
    assert found.on_plane[dense:].all()


def test_where_two_walls_are_as_large_the_one_with_more_points_is_found() -> None:
    rng = np.random.default_rng(0)
    points = np.concatenate([wall(rng, 20_000, 0.001, 0.5), wall(rng, 15_000, 0.001, 0.6)])
    assert expect(find_plane(points, DOWN, [0, 0, 0])).plane.offset == pytest.approx(-0.5, abs=0.001)


def test_walls_may_tilt_as_far_as_asked_and_no_farther() -> None:
    tilted = wall(np.random.default_rng(0), 2000, 0.0005)
    tilted[:, 2] += np.tan(np.radians(9)) * tilted[:, 0]
    found = expect(find_plane(tilted, DOWN, [0, 0, 0]))
    assert np.degrees(found.angle) == pytest.approx(9, abs=0.05)
    assert isinstance(find_plane(tilted, DOWN, [0, 0, 0], angle=np.radians(4)), Text)
    assert np.degrees(ANGLE) == pytest.approx(10)


def nothing(rng: np.random.Generator) -> dict[str, tuple[Any, str]]:
    line = rng.uniform(-1, 1, (500, 1)) * [1.0, 0.2, 0] + np.array([0, 0, 0.6])
    return {
        "no points": (np.zeros((0, 3)), "0 points are too few"),
        "49 points": (wall(rng, 49, 0.0), "49 points are too few for a plane: at least 50 are needed"),
        "one place": (np.full((500, 3), 0.3), "none through the points is within 10°"),
        "a line": (line, "none through the points"),
        "a thick line": (line + 0.001 * rng.normal(size=line.shape), "the points lie along a line"),
        "fog": (rng.uniform(-1, 1, (5000, 3)), "No plane: the best has"),
        "another wall": (np.roll(wall(rng, 500, 0.0), 1, axis=1), "none through the points"),
    }


@pytest.mark.parametrize("case", nothing(np.random.default_rng(0)))
def test_clouds_without_a_plane_are_answered_in_words(case: str) -> None:
    points, said = nothing(np.random.default_rng(0))[case]
    answer = find_plane(points, DOWN, [0, 0, 0])
    assert isinstance(answer, Text)
    assert said in answer.en
    assert answer.pt_BR != answer.en


@pytest.mark.parametrize(
    "wrong",
    [
        {"towards": [0, 0, 0]},
        {"towards": [0, 0, np.nan]},
        {"towards": [0, 1]},
        {"inside": [np.inf, 0, 0]},
        {"distance": 0.0},
        {"distance": np.nan},
        {"distance": 0.2},
        {"angle": 0.0},
        {"angle": 2.0},
    ],
)
def test_a_search_for_nothing_is_refused_in_words(wrong: dict[str, Any]) -> None:
    asked: dict[str, Any] = {"towards": DOWN, "inside": [0, 0, 0], **wrong}
    with pytest.raises(HelicoideError, match=r"nonzero direction, .* to 100 mm"):
        find_plane(wall(np.random.default_rng(0), 100, 0.0), **asked)
