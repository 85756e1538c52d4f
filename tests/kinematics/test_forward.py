"""Three roads, the kernel and the URDF give one pose; the source's printed poses."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import yourdfpy
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array, frozen
from helicoide.geometry import rigid
from helicoide.kinematics.forward import FORMULATIONS, link_poses, points_in_world, tool_motor
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

FOLDER = load_robot("movemaster").urdf.parent
AGREE = 1e-9
Road = Callable[[Robot, Array], Array]
# the scene graph behind yourdfpy takes a turn below 1e-8 for none
angles = st.floats(-np.pi, np.pi).map(lambda angle: angle if abs(angle) > 1e-7 else 0.0)
special = st.sampled_from([0.0, np.pi / 2, -np.pi / 2, np.pi, -np.pi, 1e-6])
joints = st.lists(st.one_of(angles, special), min_size=5, max_size=5).map(frozen)


def tool_by_urdf(urdf: yourdfpy.URDF, q: Array) -> Array:
    urdf.update_cfg(np.array([*q, 0.0]))
    return np.asarray(urdf.get_transform("tool", "base_link"))


def tool_by_kernel(robot: Robot, q: Array) -> Array:
    """The last link's pose, times the tool in its frame."""
    T_link_tool = robot.T_world_tool_0.copy()
    T_link_tool[:3, 3] -= robot.points[-1]
    return np.asarray(link_poses(robot.chain, q)[-1] @ T_link_tool)


def loaded(folder: Path) -> yourdfpy.URDF:
    return yourdfpy.URDF.load(str(folder / "movemaster.urdf"), build_scene_graph=True, load_meshes=False)


URDF = loaded(FOLDER)


@given(q=joints)
def test_the_roads_the_kernel_and_the_urdf_agree(robot: Robot, q: Array) -> None:
    reference = tool_by_urdf(URDF, q)
    for road in (*FORMULATIONS.values(), tool_by_kernel):
        np.testing.assert_allclose(road(robot, q), reference, rtol=0, atol=AGREE)


@given(q=joints)
def test_every_link_of_the_kernel_stands_where_the_urdf_has_it(robot: Robot, q: Array) -> None:
    tool_by_urdf(URDF, q)
    poses = link_poses(robot.chain, q)
    np.testing.assert_array_equal(poses[0], np.eye(4))
    for joint, pose in zip(robot.joints, poses[1:], strict=True):
        np.testing.assert_allclose(pose, URDF.get_transform(joint.link, "base_link"), rtol=0, atol=AGREE)


@given(q=joints)
def test_guarded_points_are_carried_by_their_links(robot: Robot, q: Array) -> None:
    """At q = 0 the points are those of the file; each is carried by the joints up to its own."""
    at_zero = points_in_world(
        link_poses(robot.chain, frozen(np.zeros(5))), robot.monitored_points, robot.monitored_links
    )
    points = points_in_world(link_poses(robot.chain, q), robot.monitored_points, robot.monitored_links)
    for number, (point, carrier) in enumerate(zip(at_zero, robot.monitored_links, strict=True)):
        motor = rigid.motor_from_pose(np.eye(4))
        for joint, angle in zip(robot.joints[:carrier], q[:carrier], strict=True):
            motor = rigid.CL031.product(motor, rigid.screw_motor(joint.direction, joint.point, angle))
        moved = rigid.coordinates(rigid.move(motor, rigid.point(point)))
        np.testing.assert_allclose(points[number], moved, rtol=0, atol=AGREE)


# Recomputed from tab. 8 of Cerbaro 2022 (the second row is printed in eqs. 4-8): degrees, tool in mm, rotation by rows.
HOME = [[0.9563, 0, 0.2924], [0, 1, 0], [-0.2924, 0, 0.9563]]
ROWS: list[tuple[list[float], list[float], list[list[float]]]] = [
    ([0, 0, 0, 0, 0], [820, 0, 400], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]),
    (
        [30, 60, -90, -30, 90],
        [470.429399, 271.602540, 300],
        [[0.4330, 0.75, 0.5], [0.25, 0.4330, -0.8660], [-0.8660, 0.5, 0]],
    ),
    ([0, 106, -123, 0, 0], [481.427801, 0, 508.748157], HOME),
    ([0, -30, -5, 95, -90], [625.336760, 0, 376.791064], [[0.5, 0.8660, 0], [0, 0, 1], [0.8660, -0.5, 0]]),
    (
        [10, -30, -5, 95, 0],
        [615.836489, 108.588589, 376.791064],
        [[0.4924, -0.1736, -0.8529], [0.0868, 0.9848, -0.1504], [0.8660, 0, 0.5]],
    ),
    (
        [-10, -30, -5, 95, 0],
        [615.836489, -108.588589, 376.791064],
        [[0.4924, 0.1736, -0.8529], [-0.0868, 0.9848, 0.1504], [0.8660, 0, 0.5]],
    ),
]


@pytest.mark.parametrize("road", FORMULATIONS.values(), ids=FORMULATIONS)
@pytest.mark.parametrize(("q_deg", "position_mm", "rotation"), ROWS)
def test_poses_by_every_road(
    robot: Robot, road: Road, q_deg: list[float], position_mm: list[float], rotation: list[list[float]]
) -> None:
    T = road(robot, np.radians(q_deg))
    np.testing.assert_allclose(1000 * T[:3, 3], position_mm, rtol=0, atol=1e-6)
    np.testing.assert_allclose(T[:3, :3], rotation, rtol=0, atol=5.1e-5)


@pytest.mark.parametrize("road", FORMULATIONS.values(), ids=FORMULATIONS)
def test_the_target_of_the_first_experiment(robot: Robot, road: Road) -> None:
    """Cerbaro 2022, §4.4.4: four decimals of a degree, so 1e-4 mm; the tool points 60 degrees below level."""
    T = road(robot, np.radians([0, 56.4243, -129.9430, 13.5188, 0]))
    np.testing.assert_allclose(1000 * T[:3, 3], [440.0004, 0, 200.0004], rtol=0, atol=1e-4)
    np.testing.assert_allclose(T[:3, 0], [0.5, 0, -np.sqrt(0.75)], rtol=0, atol=1e-5)


# Recomputed from tab. 8: J1 to J5, mm.
JOINT_POINTS = {
    "example": [
        [0, 0, 400],
        [103.923, 60, 400],
        [212.176, 122.5, 616.506],
        [362.176, 209.103, 516.506],
        [362.176, 209.103, 516.506],
    ],
    "home": [[0, 0, 400], [120, 0, 400], [51.091, 0, 640.315], [242.352, 0, 581.841], [242.352, 0, 581.841]],
}


@pytest.mark.parametrize("name", JOINT_POINTS)
def test_joint_points(robot: Robot, name: str) -> None:
    poses = link_poses(robot.chain, robot.poses[name])
    np.testing.assert_allclose(1000 * poses[1:, :3, 3], JOINT_POINTS[name], rtol=0, atol=6e-4)


# Recomputed from eqs. 96-102, tool pose: 1 i j k and, in mm, the dual part.
DUAL_QUATERNIONS = {
    "example": ([0.683013, 0.5, 0.5, -0.183013], [-158.056080, 60.801270, 210.801270, 152.158620]),
    "home": ([0.989016, 0, 0.147809, 0], [0, 200.470984, 0, 287.159779]),
}


@pytest.mark.parametrize("name", DUAL_QUATERNIONS)
def test_dual_quaternions(robot: Robot, name: str) -> None:
    turn, shift_mm = DUAL_QUATERNIONS[name]
    coefficients = rigid.dual_quaternion(tool_motor(robot, robot.poses[name]))
    np.testing.assert_allclose(coefficients[:4], turn, rtol=0, atol=6e-7)
    np.testing.assert_allclose(1000 * coefficients[4:], shift_mm, rtol=0, atol=6e-7)


def changed(folder: Path, file: str, old: str, new: str) -> Path:
    """A copy of the robot's folder with one line of one file changed."""
    copy = folder / "changed"
    shutil.copytree(FOLDER, copy, ignore=shutil.ignore_patterns("__pycache__"))
    text = (copy / file).read_text("utf-8")
    assert text.count(old) == 1
    (copy / file).write_text(text.replace(old, new), "utf-8")
    return copy


def differing(folder: Path) -> set[str]:
    """The roads that lead elsewhere for the robot of a folder than for the shipped one."""
    robot, other, q = load_robot("movemaster"), robot_from_folder(folder), np.radians([30, 60, -90, -30, 90])
    roads = {**FORMULATIONS, "kernel": tool_by_kernel}
    found = {name for name, road in roads.items() if np.abs(road(robot, q) - road(other, q)).max() > 1e-6}
    moved = np.abs(tool_by_urdf(loaded(folder), q) - tool_by_urdf(URDF, q)).max() > 1e-6
    return found | ({"urdf"} if moved else set())


def test_a_changed_dh_row_moves_the_dh_road_alone(tmp_path: Path) -> None:
    assert differing(changed(tmp_path, "robot.toml", "a_mm = 250", "a_mm = 251")) == {"dh"}


def test_a_changed_screw_leaves_the_dh_road_and_the_urdf_alone(tmp_path: Path) -> None:
    folder = changed(
        tmp_path,
        "robot.toml",
        "screw = { direction = [0, -1, 0], point_mm = [370, 0, 400] }",
        "screw = { direction = [0, -1, 0], point_mm = [371, 0, 400] }",
    )
    assert differing(folder) == {"screws", "dual_quaternions", "kernel"}


def test_a_changed_urdf_moves_the_urdf_alone(tmp_path: Path) -> None:
    assert differing(changed(tmp_path, "movemaster.urdf", 'xyz="0.2 0 0"', 'xyz="0.201 0 0"')) == {"urdf"}
