"""Every robot in a folder says one thing in all its files: robot.toml, URDF, meshes and their drawing."""

from __future__ import annotations

import importlib.util
import io
from functools import cache
from itertools import combinations
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import trimesh
import yourdfpy
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.kinematics.arms import MIXED, NAMES, postures

from helicoide.arrays import Array, frozen
from helicoide.geometry import rigid
from helicoide.kinematics.folder import from_folder
from helicoide.kinematics.forward import ROADS, dh_frames, link_motors, link_poses, screw_displacements
from helicoide.kinematics.jacobian import geometric, joint_axes
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_file import parsed
from helicoide.kinematics.urdf_mesh import mesh_file
from helicoide.text import LANGUAGES

AGREE = 1e-9
ROBOTS = [name for name in NAMES if name != MIXED]
WITH_PARAMETERS = [name for name in ROBOTS if load(name).parameters]
# the switches of Cerbaro 2022, table 4, lie outside the limits of its table 3
OUTSIDE = {("movemaster", "home")}

every_robot = pytest.mark.parametrize("name", ROBOTS)


def with_frames(robot: Robot) -> yourdfpy.URDF:
    """The URDF with the frames of its links."""
    return yourdfpy.URDF(robot=parsed(robot.urdf, robot.parameters).robot, build_scene_graph=True, load_meshes=False)


urdf_of = cache(lambda name: with_frames(load(name)))


@cache
def build(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"{name}_build", load(name).urdf.parent / "build.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@cache
def drawn(name: str) -> dict[str, bytes]:
    files: dict[str, bytes] = build(name).files()
    return files


def meshes(name: str) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in (load(name).urdf.parent / "meshes").iterdir()}


def surfaces(data: bytes) -> dict[str, trimesh.Trimesh]:
    return dict(trimesh.load_scene(io.BytesIO(data), file_type="glb").geometry)


def check_roads(robot: Robot, urdf: yourdfpy.URDF, q: Array) -> None:
    """Three roads, the kernel and the URDF lead to one tool, and the kernel's links stand where the URDF's stand."""
    urdf.update_cfg(dict(zip((joint.name for joint in robot.variables), q, strict=True)))
    poses = link_poses(robot.chain, q)
    for pose, link in zip(poses, (urdf.base_link, *(joint.link for joint in robot.joints)), strict=True):
        np.testing.assert_allclose(pose, urdf.get_transform(link), rtol=0, atol=AGREE)
    tools = [road(robot, q) for road in ROADS.values()]
    for tool in (*tools, poses[-1] @ robot.T_link_tool):
        np.testing.assert_allclose(tool, urdf.get_transform(robot.tool_link), rtol=0, atol=AGREE)


@every_robot
def test_all_roads_lead_where_the_urdf_leads(name: str) -> None:
    robot = load(name)
    for q in (frozen(np.zeros(robot.lower.size)), *robot.poses.values(), *postures(robot, 20)):
        check_roads(robot, urdf_of(name), q)


@every_robot
def test_the_roads_agree_on_every_link(name: str) -> None:
    """Each frame of a road moves from where it is at q = 0 as the screws displace its link."""
    robot = load(name)
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


@every_robot
def test_the_frames_of_the_urdf_stand_on_the_screws(name: str) -> None:
    """At q = 0 they are parallel to the base, so that an axis of the URDF is the direction of its screw."""
    robot, urdf = load(name), urdf_of(name)
    urdf.update_cfg(np.zeros(urdf.num_actuated_joints))
    for joint in robot.joints:
        T_base_link = urdf.get_transform(joint.link)
        np.testing.assert_allclose(T_base_link[:3, :3], np.eye(3), atol=1e-12)
        np.testing.assert_allclose(T_base_link[:3, 3], joint.point, atol=1e-12)
        np.testing.assert_allclose(urdf.joint_map[joint.name].axis, joint.direction, atol=1e-12)


@every_robot
def test_the_joints_of_the_urdf_are_those_of_the_table(name: str) -> None:
    robot, urdf = load(name), urdf_of(name)
    for joint in robot.joints:
        other = urdf.joint_map[joint.name]
        assert (other.child, other.type, other.mimic) == (joint.link, joint.kind, None)
        limit = (other.limit.lower, other.limit.upper, other.limit.velocity)
        assert limit == pytest.approx((joint.lower, joint.upper, joint.speed), rel=1e-12)
    others = set(urdf.actuated_joint_names) - {joint.name for joint in robot.joints}
    assert others == ({robot.gripper.joint} if robot.gripper else set())


@pytest.mark.parametrize("name", WITH_PARAMETERS)
@settings(max_examples=10)
@given(data=st.data())
def test_other_lengths_reach_every_file(name: str, data: st.DataObject) -> None:
    folder = load(name).urdf.parent
    lengths = {length: data.draw(st.floats(1, 5000), label=length) for length in load(name).parameters}
    robot = from_folder(folder, lengths)
    assert robot.parameters == pytest.approx({length: value / 1000 for length, value in lengths.items()})
    assert robot.reach == pytest.approx(sum(lengths.values()) / 1000)
    for q in postures(robot, 3):
        check_roads(robot, with_frames(robot), q)


@every_robot
def test_the_drawing_gives_the_committed_meshes(name: str) -> None:
    committed = meshes(name)
    assert set(committed) == set(drawn(name))
    for file, data in drawn(name).items():
        fresh, old = surfaces(data), surfaces(committed[file])
        assert list(fresh) == list(old)
        for surface, part in fresh.items():
            np.testing.assert_array_equal(part.faces, old[surface].faces)
            np.testing.assert_allclose(part.vertices, old[surface].vertices, atol=1e-6)


@every_robot
def test_the_drawing_is_deterministic(name: str) -> None:
    assert build(name).files() == drawn(name)


@every_robot
def test_every_mesh_is_there_and_shown(name: str) -> None:
    """Those that the URDF names exist, in its own folder or another robot's, and none of its own is left over."""
    urdf = load(name).urdf
    visuals = [visual for link in urdf_of(name).robot.links for visual in link.visuals]
    shown = {Path(mesh_file(urdf)(visual.geometry.mesh.filename)).resolve() for visual in visuals}
    assert [path for path in shown if not path.is_file()] == []
    assert {path.name for path in shown if path.parent == (urdf.parent / "meshes").resolve()} == set(meshes(name))


@every_robot
def test_every_mesh_has_normals_of_unit_length(name: str) -> None:
    for data in meshes(name).values():
        for part in surfaces(data).values():
            np.testing.assert_allclose(np.linalg.norm(part.vertex_normals, axis=1), 1, atol=1e-5)


@every_robot
def test_the_folder_is_light(name: str) -> None:
    files = [path for path in load(name).urdf.parent.rglob("*") if path.is_file() and path.suffix != ".pyc"]
    assert sum(path.stat().st_size for path in files) < 1_000_000


@every_robot
def test_named_poses_are_inside_the_limits(name: str) -> None:
    robot = load(name)
    outside = {
        (name, pose)
        for pose, q in robot.poses.items()
        if np.any(q < robot.lower - 1e-12) or np.any(q > robot.upper + 1e-12)
    }
    assert outside == {exception for exception in OUTSIDE if exception[0] == name}


@every_robot
def test_named_poses_differ_in_name_and_place(name: str) -> None:
    robot = load(name)
    for one, other in combinations(robot.poses, 2):
        assert np.abs(robot.poses[one] - robot.poses[other]).max() > 1e-6, (one, other)
        for language in LANGUAGES:
            assert robot.pose_titles[one][language].strip() != robot.pose_titles[other][language].strip()


@every_robot
def test_ready_is_far_from_singular(name: str) -> None:
    """The condition of the Jacobian with lengths as parts of the reach."""
    robot = load(name)
    poses = link_poses(robot.chain, robot.poses["ready"])
    tool = (poses[-1] @ robot.T_link_tool)[:3, 3]
    J = geometric(poses, robot.chain, joint_axes(poses, robot.chain), tool, len(robot.joints))
    scale = np.array([1 / robot.reach] * 3 + [1] * 3)[:, None]
    slides = np.array([robot.reach if joint.slides else 1 for joint in robot.joints])
    assert np.linalg.cond(scale * J * slides) < 50


@pytest.mark.parametrize("language", LANGUAGES)
def test_titles_are_told_apart(language: str) -> None:
    titles = [load(name).title[language] for name in ROBOTS]  # type: ignore[index]
    assert len(set(titles)) == len(titles)
    assert all(title.strip() for title in titles)
