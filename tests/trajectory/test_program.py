"""From waypoints to motion: every taught posture is passed exactly, from rest to rest, within the limits."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from tests.kinematics.arms import NAMES, arm, postures
from tests.trajectory.taught import taught

from helicoide.arrays import Array
from helicoide.ik.joints_along import joints_along
from helicoide.kinematics.robot import Robot
from helicoide.trajectory.joints import tool_pose_in
from helicoide.trajectory.path import Path
from helicoide.trajectory.pose_paths import ScrewPath
from helicoide.trajectory.program import Leg, gripper_commands, program_legs, program_path
from helicoide.trajectory.time_optimal import TimingShape, limit_ratio
from helicoide.trajectory.waypoints import GRIPPER_TIME, WaypointList, waypoint, with_gripper_action, with_waypoint

SHAPES: list[TimingShape] = ["trapezoid", "minimum jerk"]


def never(path: Path, start: Array, end: Array) -> Array | None:
    return None


def by_joints(here: WaypointList) -> WaypointList:
    return replace(here, waypoints=tuple(replace(each, move_type="joints") for each in here.waypoints))


def nearby(robot: Robot, way: str) -> WaypointList:
    """Four waypoints around `ready`, each a straight line or screw from the one before, and back to the first."""
    rng = np.random.default_rng(4)
    ready, spread = robot.poses["ready"], 0.05 * (robot.upper - robot.lower)
    here = WaypointList(robot)
    for i in range(4):
        q = np.clip(ready + rng.uniform(-1, 1, len(ready)) * spread, robot.lower, robot.upper)
        here = with_waypoint(here, i, waypoint(robot, f"p{i}", q, way, 0.25))
    return with_waypoint(here, 4, waypoint(robot, "back", here.waypoints[0].q, way))


def moved(here: WaypointList, shape: TimingShape = "trapezoid") -> list[Leg]:
    robot = here.robot
    return list(program_legs(here, robot.poses["ready"], partial(joints_along, robot), shape, 4 * robot.speed))


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("name", NAMES)
def test_every_taught_posture_is_passed_exactly(name: str, shape: TimingShape) -> None:
    robot = arm(name)
    here = by_joints(taught(name, "abcdefg"))
    found = list(program_legs(here, robot.poses["ready"], never, shape, 3 * robot.speed))
    path = program_path(found)
    assert path is not None
    before, t = robot.poses["ready"], 0.0
    for leg, point in zip(found, here.waypoints, strict=True):
        assert leg.joint_path is not None
        assert leg.waypoint is point
        np.testing.assert_array_equal(leg.joint_path.q(0.0), before)
        t += leg.joint_path.duration
        np.testing.assert_allclose(path.q(t), point.q, rtol=0, atol=1e-12)
        np.testing.assert_array_equal(path.q(t + 1e-9 + 0.9 * point.dwell), point.q)
        t, before = t + point.dwell, point.q
        assert limit_ratio(leg.joint_path, robot.speed, 3 * robot.speed) <= 1
    assert path.duration == pytest.approx(t)
    np.testing.assert_array_equal(path.q(path.duration), here.waypoints[-1].q)


@pytest.mark.parametrize("way", ["line", "screw"])
@pytest.mark.parametrize("name", ["movemaster", "puma560", "zebra_zero", "dia10", "scara", "planar3r", "polar_rp"])
def test_the_tool_keeps_to_lines_and_screws(name: str, way: str) -> None:
    """Between the samples too, to a hundredth of a millimetre for an arm with a reach of 1 m; postures are exact."""
    robot = arm(name)
    here = nearby(robot, way)
    found = moved(here)
    assert not any(leg.blocked for leg in found)
    for leg in found:
        assert leg.tool_path is not None
        assert leg.joint_path is not None
        np.testing.assert_array_equal(leg.joint_path.q(leg.joint_path.duration), leg.waypoint.q)
        assert limit_ratio(leg.joint_path, robot.speed, 4 * robot.speed) <= 1
        np.testing.assert_allclose(leg.tool_path.pose(1.0), tool_pose_in(robot, leg.waypoint.q), rtol=0, atol=1e-12)
        for u in np.linspace(0.013, 0.987, 23):
            share = float(leg.joint_path.law.at(u)[0])
            tool = tool_pose_in(robot, leg.joint_path.q(u * leg.joint_path.duration))
            missed = np.linalg.norm(tool[:3, 3] - leg.tool_path.pose(share)[:3, 3])
            assert missed < 1e-5 * robot.reach
            if name in ("puma560", "zebra_zero", "dia10"):
                np.testing.assert_allclose(tool, leg.tool_path.pose(share), rtol=0, atol=1e-5 * max(1.0, robot.reach))
    path = program_path(found)
    assert path is not None
    assert path.duration == pytest.approx(
        sum(leg.joint_path.duration for leg in found if leg.joint_path) + sum(each.dwell for each in here.waypoints)
    )


def test_a_screw_is_a_screw() -> None:
    found = moved(nearby(arm("puma560"), "screw"))
    assert all(isinstance(leg.tool_path, ScrewPath) for leg in found)


def test_a_leg_without_motion_takes_no_time() -> None:
    robot = arm("movemaster")
    ready = robot.poses["ready"]
    here = WaypointList(robot, (waypoint(robot, "here", ready), waypoint(robot, "still here", ready, "line", 2.0)))
    found = moved(here)
    assert [(leg.joint_path, leg.tool_path, leg.blocked) for leg in found] == [(None, None, False)] * 2
    path = program_path(found)
    assert path is not None
    assert path.duration == 2.0
    np.testing.assert_array_equal(path.rates(1.0), np.zeros(5))
    assert program_path(moved(replace(here, waypoints=here.waypoints[:1]))) is None


def test_a_line_that_the_arm_cannot_follow_is_a_value() -> None:
    """From one side of the base to the other, straight through it."""
    robot = arm("puma560")
    left, right = np.tile(robot.poses["ready"], (2, 1))
    left[0], right[0] = np.pi / 2, -np.pi / 2
    here = WaypointList(robot, (waypoint(robot, "left", left), waypoint(robot, "right", right, "line")))
    to_left, leg = moved(here)
    assert not to_left.blocked
    assert leg.blocked
    assert leg.joint_path is None
    assert leg.tool_path is not None
    assert program_path([to_left, leg]) is None


@pytest.mark.parametrize("end", [0, -1])
def test_joints_that_miss_a_taught_posture_are_not_taken(end: int) -> None:
    """A little is put right: the leg then begins and ends exactly where it should."""
    robot = arm("puma560")
    ready, (there,) = robot.poses["ready"], postures(robot, 1)
    here = WaypointList(robot, (waypoint(robot, "there", there, "line"),))

    def leg(miss: float) -> Leg:
        def follow(path: Path, start: Array, stop: Array) -> Array:
            rows = np.linspace(start, stop, 11)
            rows[end, 2] += miss
            return rows

        (only,) = program_legs(here, ready, follow, "trapezoid", robot.speed)
        return only

    assert leg(2e-6).blocked
    joints = leg(5e-7).joint_path
    assert joints is not None
    np.testing.assert_array_equal(joints.q([0.0, joints.duration]), [ready, there])


def test_what_was_taught_stays_as_it_is() -> None:
    here = nearby(arm("movemaster"), "line")
    before = [each.q.copy() for each in here.waypoints]
    moved(here)
    for each, q in zip(here.waypoints, before, strict=True):
        np.testing.assert_array_equal(each.q, q)
        assert not each.q.flags.writeable


def test_the_gripper_is_asked_where_a_waypoint_says_so_and_the_arm_waits_for_it() -> None:
    """Points of `taught` stay 0, 0.5 and 1 s; what opens or closes there stays as long as the gripper takes."""
    plain = by_joints(taught("movemaster"))
    here = with_gripper_action(with_gripper_action(plain, "a", "open"), "c", "closed")
    before, found = program_path(moved(plain)), moved(here)
    path, asked = program_path(found), list(gripper_commands(found))
    assert before is not None
    assert path is not None
    assert path.duration == pytest.approx(before.duration + GRIPPER_TIME)
    assert [opening for _, opening in asked] == [1.0, 0.0]
    for (s, _), name in zip(asked, "ac", strict=True):
        for inside in (s + 1e-9, s + GRIPPER_TIME - 1e-9):
            np.testing.assert_allclose(path.q(inside), here.waypoints[here.index(name)].q, rtol=0, atol=1e-8)
    assert list(gripper_commands(moved(plain))) == []
