"""Planes, zones, and where a moved plane or obstacle stops."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.driving import after, clear_posture, quaternion, with_joints

from helicoide import gate
from helicoide.arrays import Array, frozen
from helicoide.command import MoveToJoints
from helicoide.confinement import (
    Obstacles,
    Zone,
    Zones,
    last_free_point,
    planes_of,
    segment_distances,
    signed_distances,
)
from helicoide.confinement.obstacles import PATH_STEP
from helicoide.geometry import rigid
from helicoide.kinematics.robot import Robot
from helicoide.readout import plane_distances
from helicoide.state import State, initial_state

seeds = st.integers(0, 2**32 - 1)


@given(seed=seeds)
def test_distances_are_those_of_the_algebra(robot: Robot, seed: int) -> None:
    """l = ½ ⋆(πp − pπ) (Cerbaro 2022, eq. 20)."""
    rng = np.random.default_rng(seed)
    planes, points = planes_of(robot.panes), rng.uniform(-1, 1, (5, 3))
    table = signed_distances(planes.normals, frozen(planes.offsets), points)
    pi = rigid.plane(planes.normals, planes.offsets)
    by_algebra = rigid.point_plane_distance(pi[None], rigid.point(points)[:, None])
    np.testing.assert_allclose(table, by_algebra, rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("distance", "zone"),
    [
        (-0.5, Zone.CRITICAL),
        (0.080, Zone.CRITICAL),
        (0.08001, Zone.WARNING),
        (0.10999, Zone.WARNING),
        (0.110, Zone.FREE),
        (1.0, Zone.FREE),
    ],
)
def test_zones_change_at_80_and_110_mm(distance: float, zone: Zone) -> None:
    """Cerbaro 2022, section 6.1."""
    assert Zones().zone_of(distance) is zone


def test_pane_centres_lie_on_their_planes(robot: Robot) -> None:
    planes = planes_of(robot.panes)
    np.testing.assert_allclose(planes.offsets, [pane.offset for pane in robot.panes], rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(planes.normals, axis=1), 1, atol=1e-15)
    np.testing.assert_allclose(planes.centres, [pane.centre for pane in robot.panes], rtol=0, atol=1e-5)


def dragged(state: State, index: int, centre: Array, wxyz: Array) -> State:
    for phase in ("start", "update", "end"):
        state = gate.drag_plane("seat", phase, index, centre, wxyz)(state)
    return state


@settings(max_examples=300)
@given(seed=seeds)
def test_a_plane_stops_at_80_mm_from_any_side(robot: Robot, seed: int) -> None:
    rng = np.random.default_rng(seed)
    state = initial_state(robot)
    state = with_joints(state, clear_posture(rng, state, 0.08))
    centre, wxyz = rng.uniform(-0.8, 0.8, 3), quaternion(rng)
    moved = dragged(state, int(rng.integers(3)), centre, wxyz)
    (index,) = np.flatnonzero((moved.problem.planes.normals != state.problem.planes.normals).any(axis=1))
    normal = rigid.rotation.to_matrix(wxyz)[:, 2]
    asked = float(((state.monitored_points - centre) @ normal).min())
    np.testing.assert_allclose(moved.problem.planes.normals[index], normal, rtol=0, atol=1e-12)
    assert plane_distances(moved)[:, index].min() == pytest.approx(max(0.080, asked), abs=1e-9)
    assert moved.request.drag is None
    # only the motion along the normal is limited, not the motion sideways
    sideways = moved.problem.planes.centres[index] - centre
    np.testing.assert_allclose(sideways - (sideways @ normal) * normal, 0, atol=1e-12)


@settings(max_examples=50)
@given(seed=seeds)
def test_the_arm_does_not_move_because_of_a_plane(robot: Robot, seed: int) -> None:
    rng = np.random.default_rng(seed)
    state = initial_state(robot)
    state = with_joints(state, clear_posture(rng, state, 0.08))
    resting = replace(
        state, request=replace(state.request, command=rng.choice([state.request.command, MoveToJoints(state.arm.q)]))
    )
    moved = dragged(resting, int(rng.integers(3)), rng.uniform(-0.8, 0.8, 3), quaternion(rng))
    np.testing.assert_array_equal(after(moved, 0.3).arm.q, state.arm.q)


def test_restored_planes_are_those_of_the_file(state: State) -> None:
    moved = dragged(state, 0, np.array([0.5, 0.0, 0.9]), np.array([0.0, 1.0, 0.0, 0.0]))
    restored = gate.restore_planes()(moved)
    original = planes_of(state.robot.panes)
    np.testing.assert_allclose(restored.problem.planes.normals, original.normals, rtol=0, atol=1e-12)
    np.testing.assert_allclose(restored.problem.planes.offsets, original.offsets, rtol=0, atol=1e-5)


def test_restored_planes_stop_at_the_arm_too(robot: Robot, state: State) -> None:
    """In the example of the source the elbow is 35 mm from the measured ceiling: the ceiling stays 45 mm above."""
    high = with_joints(state, robot.poses["example"])
    restored = gate.restore_planes()(high)
    assert plane_distances(restored).min() == pytest.approx(0.080, abs=1e-9)


@given(seeds)
def test_distance_from_straight_pieces_is_that_of_their_nearest_point(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points, ends = rng.normal(size=(4, 3)), rng.normal(size=(5, 2, 3))
    ends[0, 1] = ends[0, 0]
    along = ends[:, :1] + np.linspace(0, 1, 2001)[:, None] * (ends[:, 1:] - ends[:, :1])
    sampled = np.linalg.norm(points[:, None, None] - along, axis=3).min(axis=2)
    found = segment_distances(points, ends)
    assert (found <= sampled + 1e-12).all()
    np.testing.assert_allclose(found, sampled, atol=2e-3)


@given(seeds)
def test_what_is_moved_rests_before_the_first_body_in_its_way(seed: int) -> None:
    rng = np.random.default_rng(seed)
    ends, apart = rng.normal(size=(3, 2, 3)), rng.uniform(0.05, 0.3, 3)
    start, asked = rng.normal(size=(2, 3))
    assume((segment_distances(start[None], ends)[0] > apart).all())
    rests = last_free_point(start, asked, ends, apart)
    way = start + np.linspace(0, 1, 4001)[:, None] * (asked - start)
    left = (segment_distances(way, ends) - apart).min(axis=1)
    length = np.linalg.norm(asked - start)
    share = np.linalg.norm(rests - start) / length
    assert (segment_distances(rests[None], ends)[0] >= apart - 1e-9).all()
    # between two checked points it may graze a body, and may pass or stop there
    touched, entered = (np.append(np.flatnonzero(left < depth), 4000)[0] / 4000 for depth in (1e-3, -1e-3))
    assert touched - PATH_STEP / length - 1e-9 <= share <= entered + 1e-9


def test_obstacles_are_replaced_and_taken_away() -> None:
    three = Obstacles().with_sphere([1, 0, 0], 0.1).with_capsule([0, 1, 0], [0, 2, 0], 0.2).with_sphere([0, 0, 1], 0.3)
    moved = three.with_sphere_at(1, [5, 5, 5], 0.4)
    np.testing.assert_array_equal(moved.ends[1], [[5, 5, 5]] * 2)
    np.testing.assert_array_equal(moved.radii, [0.1, 0.4, 0.3])
    np.testing.assert_array_equal(three.without(0).radii, [0.2, 0.3])
    assert len(three.points) == 2 + 8
    assert three.points[1:9, 1].tolist() == pytest.approx(np.linspace(1, 2, 8).tolist())
    assert Obstacles().points.shape == (0, 3)
