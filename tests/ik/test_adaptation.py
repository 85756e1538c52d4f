"""Targets that give way to planes: each rule by itself, and a whole path of the Movemaster by them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes, Zones
from helicoide.ik import adaptation
from helicoide.ik.adaptation import (
    NONE,
    Rule,
    TargetPoints,
    adapted,
    everywhere,
    moved_away,
    moving_point_distances,
    trimmed,
    with_distances_kept,
    with_target_moved,
)
from helicoide.ik.converge import INNER, POSE, Tolerance, converged, solver_of
from helicoide.ik.methods import configured_method
from helicoide.studies.cerbaro_runs.confined import ELLIPSE, confined_problem, path_samples
from helicoide.studies.cerbaro_runs.setups import fixed_point, position_task, tool_position

ZONES = Zones()
FLOOR_AND_WALL = Planes(frozen([[0, 0, 1], [0, 1, 0]]), frozen([[0, 0, 0], [0, -0.3, 0]]))
UP = frozen([0, 0, 1])
coordinates = st.floats(-1, 1)
points = st.tuples(coordinates, coordinates, coordinates).map(np.array)
angles = st.floats(-3.1, 3.1)
distances = st.floats(0, 0.0799)


def at(distance: float) -> Array:
    return np.array([0.4, 0.1, distance])


@given(distance=distances)
def test_the_corrected_rule_brings_the_critical_joint_a_tenth_beyond_the_critical_distance(distance: float) -> None:
    assert moved_away(at(distance), distance, UP, 0.08, True)[2] == pytest.approx(0.088)


@pytest.mark.parametrize(("distance", "by"), [(0.0, 0.08), (0.05, 0.025), (0.08 / 1.1, 0.0), (0.078, -0.0058)])
def test_the_printed_rule_turns_round_before_the_critical_distance(distance: float, by: float) -> None:
    """It rests at 72.7 mm and pulls nearer what is farther than that."""
    assert moved_away(at(distance), distance, UP, 0.08, False)[2] - distance == pytest.approx(by, abs=1e-12)


@given(target=points, before=points, azimuth=angles, elevation=angles)
def test_a_target_held_back_comes_no_nearer_and_moves_along_the_normal_only(
    target: Array, before: Array, azimuth: float, elevation: float
) -> None:
    n = np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)])
    back = with_distances_kept(target, before, n)
    assert (back - before) @ n >= -1e-12
    np.testing.assert_allclose(np.cross(back - target, n), 0, atol=1e-12)
    if (target - before) @ n >= 0:
        np.testing.assert_array_equal(back, target)
    np.testing.assert_allclose(with_distances_kept(back, before, n), back, atol=1e-12)


@given(cloud=st.lists(points, min_size=1, max_size=9))
def test_trimmed_points_keep_the_warning_distance_and_others_stay(cloud: list[Array]) -> None:
    planes, which = confined_problem().planes, (1, 2, 3)
    before = np.array(cloud)
    after = trimmed(before, planes, which, 0.110)
    left = after @ planes.normals[list(which)].T - planes.offsets[list(which)]
    assert left.min() >= 0.110 - 2e-9
    clear = (before @ planes.normals[list(which)].T - planes.offsets[list(which)] >= 0.110).all(axis=1)
    np.testing.assert_array_equal(after[clear], before[clear])


def test_trimming_leaves_what_it_is_given_alone() -> None:
    given_points = np.zeros((1, 3))
    trimmed(given_points, confined_problem().planes, (3,), 0.110)
    np.testing.assert_array_equal(given_points, np.zeros((1, 3)))


BOTH = everywhere(FLOOR_AND_WALL)


@pytest.mark.parametrize(
    ("near", "rule", "expected"),
    [
        ((0.05, 0.2), BOTH, (0.4, 0.1, 0.138)),  # critical: away from the floor
        ((0.05, 0.04), BOTH, (0.4, 0.148, 0.1)),  # the nearer of two
        ((0.05, 0.2), replace(BOTH, corrected=False), (0.4, 0.1, 0.125)),
        ((0.10, 0.2), BOTH, (0.4, 0.1, 0.15)),  # warning: not below the target before
        ((0.10, 0.10), BOTH, (0.4, 0.2, 0.15)),
        ((0.10, 0.2), replace(BOTH, damps=False), (0.4, 0.1, 0.1)),
        ((0.05, 0.2), Rule((1,)), (0.4, 0.1, 0.1)),  # the floor is not watched
        ((0.05, 0.04), NONE, (0.4, 0.1, 0.1)),
        ((0.12, 0.2), BOTH, (0.4, 0.1, 0.1)),
    ],
)
def test_which_rule_applies(near: tuple[float, float], rule: Rule, expected: tuple[float, ...]) -> None:
    target, before = np.array([0.4, 0.1, 0.1]), np.array([0.3, 0.2, 0.15])
    found = with_target_moved(target, before, np.array(near), FLOOR_AND_WALL, ZONES, rule)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)
    assert (found is target) == (tuple(target) == expected)


def test_the_printed_damping_forbids_to_rise_whatever_the_plane() -> None:
    level = Rule((0,), level=True)
    higher, lower = np.array([0.4, 0.1, 0.2]), np.array([0.4, 0.1, 0.1])
    near = np.array([0.1, 1.0])
    np.testing.assert_array_equal(with_target_moved(higher, lower, near, FLOOR_AND_WALL, ZONES, level), lower)
    assert with_target_moved(lower, higher, near, FLOOR_AND_WALL, ZONES, level) is lower
    assert with_target_moved(higher, None, near, FLOOR_AND_WALL, ZONES, level) is higher


def test_the_points_that_cannot_move_are_not_watched() -> None:
    """Recomputed from eq. 20 and the printed planes by other code; the waist would be 257 mm from nothing."""
    near = 1000 * moving_point_distances(confined_problem(), np.zeros(5))
    np.testing.assert_allclose(near, [220.93, 278.46, 291.83, 400.0], atol=0.05)
    home = 1000 * moving_point_distances(confined_problem(), confined_problem().robot.poses["home"].copy())
    assert home[0] == pytest.approx(21.09, abs=0.05)


def by(rule: Rule, samples: int = 41) -> tuple[adaptation.Track, Array]:
    """The first quarter of the ellipse, which leads up to the ceiling, without secondary objective."""
    here = confined_problem()
    solver = solver_of(here, configured_method("damped", damping=0.1), 0.5, replace(INNER, tolerance=Tolerance(1e-3)))
    way = path_samples(ELLIPSE, 4 * samples)[:samples]
    first = position_task(here, fixed_point(*way[0]))
    start = converged(replace(solver, until=POSE), first, here.robot.poses["path_start"])
    path = TargetPoints(way, lambda p: position_task(here, fixed_point(*p)))
    return adapted(solver, path, start.q, rule), way


def test_without_a_rule_a_path_is_followed_into_the_planes() -> None:
    track, way = by(NONE)
    np.testing.assert_array_equal(track.targets, way)
    np.testing.assert_array_equal(track.moved, 0)
    assert track.errors.max() <= 1e-3
    assert track.near.min() < 0.07


@pytest.mark.parametrize(("damps", "ratchets"), [(True, False), (True, True), (False, False)])
def test_with_the_corrected_rule_nothing_comes_nearer_than_the_critical_distance(damps: bool, ratchets: bool) -> None:
    here = confined_problem()
    track, way = by(replace(everywhere(here.planes), damps=damps, ratchets=ratchets))
    assert track.near.min() >= 0.080
    assert (track.moved > 0).any()
    assert track.moved.max() < adaptation.CAP
    former = track.targets if ratchets else way
    ahead = np.einsum("kj,pj->kp", track.targets[1:] - former[:-1], here.planes.normals)
    if damps:  # where a plane warns, its target comes no nearer to it than the former point
        assert (ahead[track.near[1:] < 0.110] >= -1e-9).all()
    untouched = track.moved == 0
    np.testing.assert_array_equal(track.targets[untouched], way[untouched])
    for q, target, near, error in zip(track.q, track.targets, track.near, track.errors, strict=True):
        np.testing.assert_array_equal(near, moving_point_distances(here, q))
        assert np.linalg.norm(tool_position(here, q) - target) == pytest.approx(error, abs=1e-9)


def test_with_the_printed_rule_it_gives_up_at_72_7_mm() -> None:
    track, _ = by(Rule((0,), corrected=False, damps=False, cap=30))
    assert (track.moved == 30).any()
    assert track.near[:, 0].min() == pytest.approx(0.08 / 1.1, abs=1e-3)


def test_targets_out_of_reach_end_after_their_cap_and_are_told_by_their_error() -> None:
    here = confined_problem()
    solver = solver_of(here, configured_method("damped", damping=50.0), 0.5, replace(INNER, cap=40))
    points = np.array([[0.7, 0.0, 0.4], [0.9, 0.0, 0.4]])
    path = TargetPoints(points, lambda p: position_task(here, fixed_point(*p)))
    shares: list[float] = []
    track = adapted(solver, path, here.robot.poses["ready"], progress=shares.append)
    assert track.errors[0] <= 0.010
    assert track.errors[1] == pytest.approx(0.08, abs=5e-3)
    assert shares == [0.5, 1.0]
