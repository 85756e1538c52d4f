"""Every robot in a folder says one thing in all its files: robot.toml, URDF, meshes and their drawing."""

from __future__ import annotations

import importlib.util
import io
from functools import cache
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import trimesh
import yourdfpy
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.kinematics.arms import MIXED, NAMES, postures

from helicoide.geometry import rigid
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.folder import from_folder
from helicoide.kinematics.forward import ROADS, dh_frames, link_motors, link_poses, screw_displacements
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_faults import remarks_and_faults
from helicoide.kinematics.urdf_file import parsed
from helicoide.kinematics.urdf_mesh import mesh_file
from helicoide.text import LANGUAGES

AGREE = 1e-9
ROBOTS = [name for name in NAMES if name != MIXED]
WITH_PARAMETERS = [name for name in ROBOTS if load(name).parameters]

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
def test_its_files_do_not_contradict_each_other(name: str) -> None:
    assert remarks_and_faults(load(name)) == ()


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


@pytest.mark.parametrize("language", LANGUAGES)
def test_titles_are_told_apart(language: str) -> None:
    titles = [load(name).title[language] for name in ROBOTS]  # type: ignore[index]
    assert len(set(titles)) == len(titles)
    assert all(title.strip() for title in titles)
