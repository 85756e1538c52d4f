"""Distances and angles of the arm's points and lines to planes, and their rows."""

from __future__ import annotations

import numpy as np
import pytest
from tests.kinematics.arms import NAMES, arm, derivative, postures

from helicoide.geometry import incidence, rigid, rotation
from helicoide.kinematics import clearance
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_motors, link_poses
from helicoide.kinematics.robot import Robot

each_arm = pytest.mark.parametrize("name", NAMES)
NORMAL, OFFSET = rotation.unit([0.3, -0.7, 0.6]), -0.4
PLANE = rigid.plane(NORMAL, OFFSET)
ENDS = np.array([[0.05, -0.1, 0.1], [-0.1, 0.2, 0.15]])


@each_arm
def test_the_row_of_a_point_is_the_derivative_of_its_distance(name: str) -> None:
    robot = arm(name)
    for link, joint in enumerate(robot.joints, start=1):
        at_zero = rigid.point(ENDS[0] + joint.point)

        def distance(q: Array, at_zero: Array = at_zero, link: int = link) -> Array:
            return rigid.point_plane_distance(PLANE, rigid.move(link_motors(robot, q)[link], at_zero))

        q = postures(robot, 1, seed=link)[0]
        found = clearance.point_plane(robot, q, ENDS[0], link, NORMAL, OFFSET)
        assert found.distance == pytest.approx(distance(q), abs=1e-12)
        np.testing.assert_allclose(found.row, derivative(distance, q), rtol=0, atol=1e-8)


@each_arm
def test_the_row_of_a_line_is_that_of_its_nearer_end_and_its_angle(name: str) -> None:
    robot = arm(name)
    ends_seen = set()
    for seed, q in enumerate(postures(robot, 20)):
        link = 1 + seed % len(robot.joints)

        def angle(q: Array, link: int = link) -> Array:
            a, b = ENDS @ link_poses(robot.chain, q)[link, :3, :3].T
            return incidence.line_plane_angle(rigid.line(rotation.unit(b - a), a), PLANE)

        found = clearance.line_plane(robot, q, ENDS, link, NORMAL, OFFSET)
        each = [clearance.point_plane(robot, q, end, link, NORMAL, OFFSET) for end in ENDS]
        assert found.nearer.distance == min(end.distance for end in each)
        np.testing.assert_array_equal(found.nearer.row, each[found.end].row)
        assert found.angle == pytest.approx(angle(q), abs=1e-12)
        np.testing.assert_allclose(found.angle_row, derivative(angle, q), rtol=0, atol=1e-6)
        ends_seen.add(found.end)
    assert ends_seen == {0, 1}


def test_an_upright_line_has_the_largest_angle_and_no_row(robot: Robot) -> None:
    found = clearance.line_plane(robot, np.zeros(5), np.diag([0, 0, 0.2])[1:], 3, [0, 0, 1], 0.0)
    assert found.angle == pytest.approx(np.pi / 2)
    assert found.end == 0
    assert found.nearer.distance == pytest.approx(0.4)
    np.testing.assert_array_equal(found.angle_row, np.zeros(5))


def test_the_plane_distances_of_the_example(robot: Robot) -> None:
    """Recomputed from the planes of Cerbaro 2022, §6.2.1: the tool in the example posture, mm."""
    tool = robot.frames["tool"]
    for pane, expected in zip(robot.panes, (336.21, 35.91, 585.69), strict=False):
        at = tool.T_link_frame[:3, 3]
        found = clearance.point_plane(robot, robot.poses["example"], at, tool.link, pane.normal, pane.offset)
        assert 1000 * found.distance == pytest.approx(expected, abs=0.02)
