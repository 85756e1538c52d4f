"""What every path keeps: rigid poses, twists that are derivatives, ends that meet where it is closed; and chains."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.geometry.motions import axes, poses, rodrigues, vectors
from tests.kinematics.arms import twist_by_differences

from helicoide.arrays import Array
from helicoide.text import HelicoideError
from helicoide.trajectory.cerbaro import EQ_33
from helicoide.trajectory.joints import JointMove
from helicoide.trajectory.loop import EllipsePath, circle_path
from helicoide.trajectory.path import Path, path_length, wrapped_parameter
from helicoide.trajectory.path_chain import chain_joint_paths, chain_paths
from helicoide.trajectory.pose_paths import LinePath, ScrewPath
from helicoide.trajectory.timing import MinimumJerk, TimedJoints, TimedPath

durations = st.floats(0.5, 60.0)
shares = st.floats(0.01, 0.99)
postures_of_3 = st.tuples(*[st.floats(-3, 3)] * 3).map(np.array)
radii = st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
rotations = poses.map(lambda T: T[:3, :3])
loops = st.builds(EllipsePath, poses, radii, rotations, durations)
lines = st.builds(LinePath, poses, poses, durations)
screws = st.builds(ScrewPath, poses, poses, durations)
timed = st.builds(TimedPath, st.one_of(loops, lines, screws), st.just(MinimumJerk()), durations)


def holds_twist(path: Path, s: float) -> None:
    """The twist is the derivative of the pose; both by the path's own second, so that all paths compare."""
    scale = path.duration
    expected = twist_by_differences(lambda at: path.pose(float(at[0]) * scale), np.array([s]))[:, 0]
    np.testing.assert_allclose(scale * path.twist(s * scale), expected, rtol=0, atol=1e-7)


def are_rigid(T: Array) -> None:
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-12)
    assert np.linalg.det(T[:3, :3]) > 0
    np.testing.assert_array_equal(T[3], [0, 0, 0, 1])


@given(path=st.one_of(loops, lines, screws, timed), s=shares)
def test_the_twist_is_the_derivative_of_the_pose(path: Path, s: float) -> None:
    are_rigid(path.pose(s * path.duration))
    holds_twist(path, s)


@given(path=loops)
def test_a_loop_closes(path: EllipsePath) -> None:
    assert path.is_closed
    np.testing.assert_allclose(path.pose(path.duration), path.pose(0.0), atol=1e-12)
    np.testing.assert_allclose(path.twist(path.duration), path.twist(0.0), atol=1e-12 * (1 + 4 / path.duration))


@given(start=poses, end=poses, duration=durations, kind=st.sampled_from([LinePath, ScrewPath]))
def test_ways_between_poses_end_in_them(
    start: Array, end: Array, duration: float, kind: Callable[[Array, Array, float], Path]
) -> None:
    path = kind(start, end, duration)
    np.testing.assert_allclose(path.pose(0.0), start, rtol=0, atol=1e-14)
    np.testing.assert_allclose(path.pose(duration), end, rtol=0, atol=1e-14)
    assert path.is_closed == np.array_equal(start, end)


@given(path=lines, s=shares)
def test_a_line_is_straight_and_turns_evenly(path: LinePath, s: float) -> None:
    a, b, here = (T[:3, 3] for T in (path.T_world_start, path.T_world_end, path.pose(s * path.duration)))
    np.testing.assert_allclose(here, a + s * (b - a), atol=1e-12)
    np.testing.assert_allclose(path.twist(s * path.duration), path.twist(0.0), atol=0)
    assert path_length(path) == pytest.approx(float(np.linalg.norm(b - a)), abs=1e-12)
    assert np.linalg.norm(path.rotation) <= np.pi + 1e-12


@given(path=screws, s=shares)
def test_a_screw_is_one_motion_all_the_way(path: ScrewPath, s: float) -> None:
    """In its own axes its twist never changes; and two halves are alike: T(σ) T(0)⁻¹ twice is T(2σ) T(0)⁻¹."""
    R0, R = path.pose(0.0)[:3, :3], path.pose(s * path.duration)[:3, :3]
    for rows in (slice(0, 3), slice(3, 6)):
        in_own_axes = R.T @ path.twist(s * path.duration)[rows]
        np.testing.assert_allclose(in_own_axes, R0.T @ path.twist(0.0)[rows], atol=1e-12 * (1 + 10 / path.duration))
    back = np.linalg.inv(path.pose(0.0))
    once = path.pose(s * path.duration / 2) @ back
    np.testing.assert_allclose(once @ once, path.pose(s * path.duration) @ back, atol=1e-12)


def test_a_screw_and_a_line_agree_without_a_turn() -> None:
    start, end = np.eye(4), np.eye(4)
    end[:3, 3] = 0.3, -0.2, 0.5
    screw, line = ScrewPath(start, end, 2.0), LinePath(start, end, 2.0)
    np.testing.assert_allclose(screw.pose(0.7), line.pose(0.7), atol=1e-15)
    np.testing.assert_allclose(screw.twist(0.7), line.twist(0.7), atol=1e-15)


def test_a_quarter_turn_about_an_axis_beside_the_tool_is_an_arc_for_the_screw_and_a_chord_for_the_line() -> None:
    start, end = np.eye(4), np.eye(4)
    start[:3, 3] = 1.0, 0.0, 0.0
    end[:3, :3], end[:3, 3] = rodrigues(np.array([0.0, 0.0, 1.0]), np.pi / 2), [0.0, 1.0, 0.0]
    assert path_length(ScrewPath(start, end, 3.0)) == pytest.approx(np.pi / 2, abs=1e-12)
    assert path_length(LinePath(start, end, 3.0)) == pytest.approx(np.sqrt(2), abs=1e-12)
    np.testing.assert_allclose(ScrewPath(start, end, 3.0).pose(1.5)[:2, 3], [np.sqrt(0.5), np.sqrt(0.5)], atol=1e-15)


@given(centre=vectors, normal=axes, across=vectors, duration=durations, s=shares)
def test_a_circle_turns_about_its_normal(
    centre: Array, normal: Array, across: Array, duration: float, s: float
) -> None:
    arm = np.cross(normal, across)
    radius = float(np.linalg.norm(arm))
    assume(radius > 1e-3)
    path = circle_path(centre, normal, centre + arm, np.eye(3), duration)
    np.testing.assert_allclose(path.pose(0.0)[:3, 3], centre + arm, atol=1e-12)
    here = path.pose(s * duration)[:3, 3] - centre
    assert np.linalg.norm(here) == pytest.approx(radius)
    assert abs(normal @ here) < 1e-9
    np.testing.assert_allclose(path.twist(s * duration)[:3], 2 * np.pi / duration * np.cross(normal, here), atol=1e-9)
    assert path_length(path) == pytest.approx(2 * np.pi * radius, rel=1e-12)


@pytest.mark.parametrize("start", [(0.3, 0.0, 0.1), (0.0, 0.0, 0.0)])
def test_a_circle_needs_a_start_in_its_plane(start: tuple[float, float, float]) -> None:
    with pytest.raises(HelicoideError, match="perpendicular to its normal"):
        circle_path((0, 0, 0), (0, 0, 1), start, np.eye(3), 1.0)


def test_the_length_of_an_ellipse() -> None:
    """Ramanujan's second formula is good to 1e-9 for so round an ellipse."""
    a, b = 1.0, 0.8
    h = ((a - b) / (a + b)) ** 2
    expected = np.pi * (a + b) * (1 + 3 * h / (10 + np.sqrt(4 - 3 * h)))
    assert path_length(EllipsePath(np.eye(4), (a, b), np.eye(3), 7.0)) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("duration", [0.0, -1.0, float("nan"), float("inf")])
def test_a_duration_is_positive(duration: float) -> None:
    for kind in (LinePath, ScrewPath):
        with pytest.raises(HelicoideError, match="positive number of seconds"):
            kind(np.eye(4), np.eye(4), duration)
    with pytest.raises(HelicoideError, match="positive number of seconds"):
        EllipsePath(np.eye(4), (1, 1), np.eye(3), duration)
    with pytest.raises(HelicoideError, match="positive number of seconds"):
        TimedPath(EQ_33, MinimumJerk(), duration)
    with pytest.raises(HelicoideError, match="positive number of seconds"):
        TimedJoints(JointMove(np.zeros(2), np.ones(2), 1.0), MinimumJerk(), duration)
    with pytest.raises(HelicoideError, match="positive number of seconds"):
        JointMove(np.zeros(2), np.ones(2), duration)


def test_the_parameter_goes_round_or_stays_at_the_ends() -> None:
    there = np.eye(4)
    there[0, 3] = 1.0
    loop, line = EllipsePath(np.eye(4), (1, 1), np.eye(3), 4.0), LinePath(np.eye(4), there, 4.0)
    assert [wrapped_parameter(loop, s) for s in (-1.0, 1.0, 4.0, 9.0)] == [3.0, 1.0, 0.0, 1.0]
    assert [wrapped_parameter(line, s) for s in (-1.0, 1.0, 4.0, 9.0)] == [0.0, 1.0, 4.0, 4.0]


# Polylines and chains.


def test_a_chain_is_of_paths_that_meet() -> None:
    there = np.eye(4)
    there[0, 3] = 1.0
    out, back = LinePath(np.eye(4), there, 1.0), LinePath(there, np.eye(4), 2.0)
    path = chain_paths([out, back])
    assert path.duration == 3.0
    assert path.is_closed
    np.testing.assert_allclose(path.pose(2.0)[:3, 3], [0.5, 0, 0], atol=1e-15)
    np.testing.assert_allclose(path.twist(1.0), [-0.5, 0, 0, 0, 0, 0])
    with pytest.raises(HelicoideError, match="Path 2 must begin where path 1 ends; they are 1 apart"):
        chain_paths([out, out])
    with pytest.raises(HelicoideError, match="at least one"):
        chain_paths([])


def test_joint_moves_that_meet_make_a_chain() -> None:
    a, b = np.array([0.1, 0.2]), np.array([0.7, -0.4])
    path = chain_joint_paths([JointMove(a, b, 2.0), JointMove(b, a, 1.0)])
    assert path.is_closed
    np.testing.assert_array_equal(path.q(2.0), b)
    np.testing.assert_allclose(path.q(2.5), (a + b) / 2)
    np.testing.assert_allclose(path.rates(1.0), (b - a) / 2)
    np.testing.assert_allclose(path.rates(2.0), a - b)
    with pytest.raises(HelicoideError, match="Path 2 must begin"):
        chain_joint_paths([JointMove(a, b, 2.0), JointMove(a, b, 2.0)])


@given(start=postures_of_3, end=postures_of_3, duration=durations)
def test_a_joint_move_ends_exactly_where_it_was_taught(start: Array, end: Array, duration: float) -> None:
    path = JointMove(start, end, duration)
    np.testing.assert_array_equal(path.q([0.0, duration]), [start, end])
    np.testing.assert_allclose(path.q(0.25 * duration), 0.75 * start + 0.25 * end, atol=1e-15)
    np.testing.assert_array_equal(path.rates(0.3), (end - start) / duration)
    np.testing.assert_array_equal(JointMove(end, end, duration).q(0.7 * duration), end)
    np.testing.assert_array_equal(path.accelerations([0.1, 0.2]), np.zeros((2, 3)))
