"""The Movemaster's drawing keeps within its shell, its fingers meet, and its panes stand on their planes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy

from helicoide.arrays import Array
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_file import parse_urdf

MESHES = Path(__file__).parents[2] / "robots" / "movemaster" / "meshes"
SHELL = 0.065  # Cerbaro 2022, section 6.1
TOOL_RUN = 0.25


@pytest.fixture
def urdf(robot: Robot) -> yourdfpy.URDF:
    return yourdfpy.URDF(robot=parse_urdf(robot.urdf).robot, build_scene_graph=True, load_meshes=False)


def vertices(name: str) -> Array:
    points: Array = trimesh.load_scene(MESHES / f"{name}.glb").to_mesh().vertices
    return points


def distance_to_run(points: Array, length: float) -> Array:
    """Distance of points to the segment from the origin to (length, 0, 0)."""
    beyond = points - np.column_stack([np.clip(points[:, 0], 0, length), np.zeros((len(points), 2))])
    distance: Array = np.linalg.norm(beyond, axis=1)
    return distance


def test_fingers_open_and_close_symmetrically(robot: Robot, urdf: yourdfpy.URDF) -> None:
    assert robot.gripper is not None
    upper = urdf.joint_map[robot.gripper.joint].limit.upper
    for grip in (0.0, 0.01, upper):
        urdf.update_cfg(np.array([*np.radians([10, 20, -30, 40, 50]), grip]))
        left = urdf.get_transform("finger_left", "gripper")
        right = urdf.get_transform("finger_right", "gripper")
        np.testing.assert_allclose(left[:3, 3] * [1, -1, 1], right[:3, 3], atol=1e-12)
        assert left[1, 3] - right[1, 3] == pytest.approx(2 * grip)
    assert robot.gripper.opening == pytest.approx(2 * upper)


def test_closed_fingers_meet_without_crossing() -> None:
    assert 0 <= vertices("finger")[:, 1].min() < 0.0005


def test_the_ellipse_starts_where_its_pose_puts_the_tool(robot: Robot, urdf: yourdfpy.URDF) -> None:
    urdf.update_cfg(np.array([*robot.poses["path_start"], 0]))
    np.testing.assert_allclose(urdf.get_transform("tool", "base_link")[:3, 3], [0.46, 0, 0.23], atol=1e-6)


@pytest.mark.parametrize(
    ("link", "length"), [("upper_arm", 0.25), ("forearm", 0.2), ("wrist", TOOL_RUN), ("gripper", TOOL_RUN)]
)
def test_the_arm_keeps_within_its_shell(link: str, length: float) -> None:
    assert distance_to_run(vertices(link), length).max() < SHELL


@pytest.mark.parametrize("grip", [0.0, 0.03])
def test_the_fingers_keep_within_the_shell(urdf: yourdfpy.URDF, grip: float) -> None:
    urdf.update_cfg(np.array([0, 0, 0, 0, 0, grip]))
    points = vertices("finger") + urdf.get_transform("finger_left", "gripper")[:3, 3]
    assert distance_to_run(points, TOOL_RUN).max() < SHELL


def test_panes_lie_on_their_planes_and_the_work_is_inside(robot: Robot) -> None:
    for pane in robot.panes:
        assert np.linalg.norm(pane.normal) == pytest.approx(1, abs=1e-12)
        assert pane.normal @ pane.centre == pytest.approx(pane.offset, abs=1e-5)
        assert pane.normal @ [0.52, 0, 0.23] > pane.offset
