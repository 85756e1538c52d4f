"""Arms of the packages example-robot-data and rtb-data: three roads, the kernel and yourdfpy lead to one pose."""

from __future__ import annotations

from functools import cache
from importlib.metadata import distribution

import numpy as np
import pytest
import yourdfpy
from tests.kinematics.arms import postures

from helicoide.arrays import Array
from helicoide.kinematics.forward import FORMULATIONS, link_poses
from helicoide.kinematics.library import PACKAGES, load_robot, packaged_urdfs
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_chain import robot_from_urdf
from helicoide.kinematics.urdf_file import parse_urdf

# the arms by name, with their variables and the link where those end that do not say it themselves
ARMS: dict[str, tuple[int, str | None]] = {
    "panda": (7, None),
    "ur3_gripper": (6, None),
    "ur5": (6, None),
    "ur10": (6, None),
    "kinova": (6, None),
    "xarm7": (7, None),
    "z1": (6, None),
    "so100": (5, None),
    "so101": (5, None),
    "talos_left_arm": (6, None),
    "tiago": (8, None),
    "b1-z1": (6, None),
    "anymal-kinova": (6, None),
    "finger_edu": (3, None),
    "allegro_right_hand": (4, "link_15.0_tip"),
    "baxter": (7, "left_gripper"),
    "pr2": (9, "r_gripper_l_finger_tip_link"),
    "romeo": (9, "LFinger13Link"),
    "irb140": (6, None),
    "kr16_2": (6, None),
    "kr120r2500pro": (6, None),
    "kr210l150": (6, None),
    "lbr_iiwa_14_r820": (7, None),
    "al5d": (4, None),
    "puma560": (6, None),
}
SLIDING = {"tiago": 1, "pr2": 1}
FOLLOWING = {"pr2": 1, "romeo": 2}


@cache
def packaged_arm(name: str) -> Robot:
    return robot_from_urdf(packaged_urdfs()[name], ARMS[name][1])


def tool_by_kernel(robot: Robot, q: Array) -> Array:
    return np.asarray(link_poses(robot.chain, q)[-1] @ robot.T_link_tool)


@pytest.mark.parametrize("package", PACKAGES)
def test_the_packages_are_installed(package: str) -> None:
    files = {str(file.locate()) for file in distribution(package).files or []}
    assert [name for name, path in packaged_urdfs().items() if str(path) in files]


@pytest.mark.parametrize("name", ARMS)
def test_all_roads_lead_where_the_urdf_leads(name: str) -> None:
    robot = packaged_arm(name)
    urdf = yourdfpy.URDF(robot=parse_urdf(robot.urdf).robot, build_scene_graph=True, load_meshes=False)
    for q in postures(robot, 20):
        urdf.update_cfg(dict(zip((joint.name for joint in robot.variables), q, strict=True)))
        expected = urdf.get_transform(robot.tool_link)
        for road in (*FORMULATIONS.values(), tool_by_kernel):
            np.testing.assert_allclose(road(robot, q), expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", ARMS)
def test_the_joints_are_those_that_are_counted_by_hand(name: str) -> None:
    robot = packaged_arm(name)
    assert len(robot.variables) == ARMS[name][0]
    assert sum(joint.is_prismatic for joint in robot.joints) == SLIDING.get(name, 0)
    assert len(robot.joints) - len(robot.variables) == FOLLOWING.get(name, 0)


@pytest.mark.parametrize("name", ARMS)
def test_what_a_file_does_not_say_is_sensible(name: str) -> None:
    robot = packaged_arm(name)
    assert np.all(robot.lower < robot.upper)
    assert np.all(robot.speed > 0)
    assert np.all((robot.lower <= robot.poses["ready"]) & (robot.poses["ready"] <= robot.upper))


def test_a_name_means_the_folder_before_the_package() -> None:
    assert load_robot("puma560").urdf != packaged_urdfs()["puma560"]
    assert load_robot("panda").urdf == packaged_urdfs()["panda"]
