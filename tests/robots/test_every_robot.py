"""Every robot in a folder says one thing in all its files: robot.toml, URDF, meshes and their drawing."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import yourdfpy
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.kinematics.arms import MIXED, NAMES, postures

from helicoide.arrays import Array, frozen
from helicoide.contributions.robots import faults
from helicoide.geometry import rigid
from helicoide.kinematics.forward import FORMULATIONS, dh_frames, link_motors, link_poses, screw_displacements
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.kinematics.urdf_file import parse_urdf

AGREE = 1e-9
ROBOTS = [name for name in NAMES if name != MIXED]
WITH_PARAMETERS = [name for name in ROBOTS if load_robot(name).parameters]

every_robot = pytest.mark.parametrize("name", ROBOTS)


def with_frames(robot: Robot) -> yourdfpy.URDF:
    """The URDF with the frames of its links."""
    return yourdfpy.URDF(
        robot=parse_urdf(robot.urdf, robot.parameters).robot, build_scene_graph=True, load_meshes=False
    )


urdf_of = cache(lambda name: with_frames(load_robot(name)))


def check_roads(robot: Robot, urdf: yourdfpy.URDF, q: Array) -> None:
    """Three roads, the kernel and the URDF lead to one tool, and the kernel's links stand where the URDF's stand."""
    urdf.update_cfg(dict(zip((joint.name for joint in robot.variables), q, strict=True)))
    poses = link_poses(robot.chain, q)
    for pose, link in zip(poses, (urdf.base_link, *(joint.link for joint in robot.joints)), strict=True):
        np.testing.assert_allclose(pose, urdf.get_transform(link), rtol=0, atol=AGREE)
    tools = [road(robot, q) for road in FORMULATIONS.values()]
    for tool in (*tools, poses[-1] @ robot.T_link_tool):
        np.testing.assert_allclose(tool, urdf.get_transform(robot.tool_link), rtol=0, atol=AGREE)


@every_robot
def test_it_is_what_is_asked_of_a_robot(name: str) -> None:
    """Its files agree, its meshes are there and drawn by build.py, its folder is light, its titles are its own."""
    assert [fault.en for fault in faults(name)] == []


@every_robot
def test_the_roads_agree_on_every_link(name: str) -> None:
    """Each frame of a road moves from where it is at q = 0 as the screws displace its link."""
    robot = load_robot(name)
    at_zero = dh_frames(robot, frozen(np.zeros(robot.lower.size)))
    origins = np.array([np.zeros(3), *robot.points])
    for q in postures(robot, 5):
        displacements = np.array(screw_displacements(robot, q))
        np.testing.assert_allclose(
            [rigid.pose_from_motor(m) for m in link_motors(robot, q)], displacements, rtol=0, atol=AGREE
        )
        np.testing.assert_allclose(dh_frames(robot, q), displacements @ at_zero, rtol=0, atol=AGREE)
        links = displacements.copy()
        links[:, :3, 3] += np.einsum("ijk,ik->ij", displacements[:, :3, :3], origins)
        np.testing.assert_allclose(link_poses(robot.chain, q), links, rtol=0, atol=AGREE)


@pytest.mark.parametrize("name", WITH_PARAMETERS)
@settings(max_examples=10)
@given(data=st.data())
def test_other_lengths_reach_every_file(name: str, data: st.DataObject) -> None:
    folder = load_robot(name).urdf.parent
    lengths = {length: data.draw(st.floats(1, 5000), label=length) for length in load_robot(name).parameters}
    robot = robot_from_folder(folder, lengths)
    assert robot.parameters == pytest.approx({length: value / 1000 for length, value in lengths.items()})
    assert robot.reach == pytest.approx(sum(lengths.values()) / 1000)
    for q in postures(robot, 3):
        check_roads(robot, with_frames(robot), q)
