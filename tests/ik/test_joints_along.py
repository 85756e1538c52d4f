"""Joints that carry the tool along a path between two postures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.kinematics.arms import arm

from helicoide.arrays import Array
from helicoide.ik.joints_along import PLACES, joints_along
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.joints import tool_pose_in
from helicoide.trajectory.pose_paths import LinePath, ScrewPath

ARMS = ["movemaster", "puma560", "zebra_zero", "dia10", "dia10_rod", "scara", "planar2r", "planar3r", "polar_rp"]


def ends(robot: Robot, seed: int) -> tuple[Array, Array]:
    """`ready`, and a posture not far from it."""
    ready = robot.poses["ready"]
    way = np.random.default_rng(seed).uniform(-0.06, 0.06, len(ready)) * (robot.upper - robot.lower)
    return ready, np.clip(ready + way, robot.lower, robot.upper)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ARMS)
def test_the_tool_is_on_the_line_and_the_joints_end_as_asked(name: str, seed: int) -> None:
    robot = arm(name)
    start, end = ends(robot, seed)
    path = LinePath(tool_pose_in(robot, start), tool_pose_in(robot, end), 2.0)
    rows = joints_along(robot, path, start, end)
    assert rows is not None
    assert rows.shape == (PLACES, len(start))
    np.testing.assert_allclose(rows[[0, -1]], [start, end], rtol=0, atol=1e-9)
    for share, q in zip(np.linspace(0, 1, PLACES), rows, strict=True):
        np.testing.assert_allclose(tool_pose_in(robot, q)[:3, 3], path.pose(2.0 * share)[:3, 3], rtol=0, atol=1e-7)


@pytest.mark.parametrize("kind", [LinePath, ScrewPath])
@pytest.mark.parametrize("name", ["puma560", "zebra_zero", "dia10"])
def test_an_arm_with_six_joints_keeps_the_orientation_too(name: str, kind: type[LinePath] | type[ScrewPath]) -> None:
    robot = arm(name)
    start, end = ends(robot, 11)
    path = kind(tool_pose_in(robot, start), tool_pose_in(robot, end), 1.0)
    rows = joints_along(robot, path, start, end)
    assert rows is not None
    for share, q in zip(np.linspace(0, 1, PLACES), rows, strict=True):
        np.testing.assert_allclose(tool_pose_in(robot, q), path.pose(share), rtol=0, atol=1e-7)


def test_an_arm_with_five_joints_comes_as_near_as_it_can_to_the_orientation() -> None:
    """No other posture with the tool at the same point is turned nearer: its turn is least along what is left free."""
    robot = arm("movemaster")
    start, end = ends(robot, 2)
    path = LinePath(tool_pose_in(robot, start), tool_pose_in(robot, end), 1.0)
    rows = joints_along(robot, path, start, end)
    assert rows is not None

    def turned(q: Array) -> float:
        R = path.pose(0.5)[:3, :3].T @ tool_pose_in(robot, q)[:3, :3]
        return float(np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1)))

    middle = rows[PLACES // 2]
    at = tool_pose_in(robot, middle)[:3, 3]
    columns = [(tool_pose_in(robot, middle + way)[:3, 3] - at) / 1e-6 for way in 1e-6 * np.eye(5)]
    free = np.linalg.svd(np.stack(columns, axis=1))[2][3:]
    assert turned(middle) > 1e-4
    for way in (*free, *-free):
        assert turned(middle + 1e-3 * way) > turned(middle)


def test_no_way_through_the_base() -> None:
    robot = arm("puma560")
    left, right = np.tile(robot.poses["ready"], (2, 1))
    left[0], right[0] = np.pi / 2, -np.pi / 2
    assert (
        joints_along(robot, LinePath(tool_pose_in(robot, left), tool_pose_in(robot, right), 1.0), left, right) is None
    )


def test_no_way_beyond_the_limits() -> None:
    """Half way along a chord the elbow is bent more than at both ends: more than a narrower limit allows."""
    robot = arm("planar2r")
    start, end = np.array([0.2, 2.0]), np.array([1.4, 2.0])
    path = LinePath(tool_pose_in(robot, start), tool_pose_in(robot, end), 1.0)
    rows = joints_along(robot, path, start, end)
    assert rows is not None
    bent = float(rows[:, 1].max())
    assert bent > 2.1
    for limit, follows in ((bent + 0.01, True), (bent - 0.01, False)):
        narrow = replace(robot, joints=(robot.joints[0], replace(robot.joints[1], upper=limit)))
        assert (joints_along(narrow, path, start, end) is not None) == follows


def test_no_way_to_another_form_of_the_arm() -> None:
    """The elbow would have to jump to its other side."""
    robot = arm("planar2r")
    start, end = np.array([0.2, 1.0]), np.array([0.9, -1.0])
    path = LinePath(tool_pose_in(robot, start), tool_pose_in(robot, end), 1.0)
    assert joints_along(robot, path, start, end) is None


def test_no_way_out_of_reach() -> None:
    """The stretched arm stands still, although the tool is not where it should be."""
    robot = arm("planar2r")
    stretched = np.array([0.3, 0.0])
    beyond = tool_pose_in(robot, stretched)
    beyond[:3, 3] *= 1.2
    assert joints_along(robot, LinePath(tool_pose_in(robot, stretched), beyond, 1.0), stretched, stretched) is None
