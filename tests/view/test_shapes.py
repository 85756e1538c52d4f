"""Meshes stand where the URDF puts them, for any q, whatever the frames of its links are."""

from __future__ import annotations

import io
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
import trimesh
import yourdfpy
from viser._messages import Message, SetOrientationMessage, SetPositionMessage

from helicoide import content
from helicoide.geometry import rotation
from helicoide.kinematics import urdf_file
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load
from helicoide.view import shapes
from helicoide.view.layers.arm import Placed
from helicoide.view.shapes import Shape

BOX, CYLINDER, SPHERE = '<box size="0.1 0.2 0.4"/>', '<cylinder radius="0.1" length="0.6"/>', '<sphere radius="0.2"/>'
MESH = '<mesh filename="plate.stl" scale="0.001 0.002 0.003"/>'  # of 100 mm each way
TURNED = '<origin xyz="1 2 3" rpy="0 1.5707963267948966 0"/>'  # its x along -z, its z along x
ARMS = [*sorted(content.found("robots")), "ur5", "kr16_2", "so101"]


class Said:
    """A scene that keeps what is said to it."""

    def __init__(self) -> None:
        self.positions: dict[str, tuple[float, ...]] = {}
        self.quaternions: dict[str, tuple[float, ...]] = {}

    def _queue_scene_message(self, message: Message) -> None:
        if isinstance(message, SetPositionMessage):
            self.positions[message.name] = message.position
        elif isinstance(message, SetOrientationMessage):
            self.quaternions[message.name] = message.wxyz


def node(said: Said, name: str) -> SimpleNamespace:
    """A node of a scene, of which nothing has been said."""
    return SimpleNamespace(
        _impl=SimpleNamespace(name=name, api=said, position=np.full(3, np.nan), wxyz=np.full(4, np.nan))
    )


@pytest.mark.parametrize("name", ARMS)
def test_every_mesh_stands_where_the_urdf_has_its_link(name: str) -> None:
    robot = load(name)
    found = shapes.load(robot)
    said = Said()
    frames = [node(said, shape.name) for shape in found]
    oracle = yourdfpy.URDF(urdf_file.parsed(robot.urdf, robot.parameters).robot, load_meshes=False)
    q = np.random.default_rng(3).uniform(robot.lower, robot.upper)
    Placed(found, cast(Any, frames)).write(link_poses(robot.chain, q), gripper=0.0)
    oracle.update_cfg(dict(zip((joint.name for joint in robot.variables), q, strict=True)))
    for shape in found:
        T = oracle.get_transform(shape.name)
        np.testing.assert_allclose(said.positions[shape.name], T[:3, 3], atol=1e-9)
        np.testing.assert_allclose(rotation.to_matrix(np.array(said.quaternions[shape.name])), T[:3, :3], atol=1e-9)
        assert len(shape.edges) > 0 or not shape.glb


def visual(geometry: str, origin: str = "", name: str = "") -> str:
    """One visual of a URDF link; red, so that colours can be looked for."""
    red = "<material name='red'><color rgba='1 0 0 1'/></material>"
    return f"<visual {name}>{origin}<geometry>{geometry}</geometry>{red}</visual>"


def drawn(folder: Path, *visuals: str) -> list[Shape]:
    """The shapes of an arm of one joint whose link `upper` has these visuals and no others."""
    trimesh.creation.box(extents=(100, 100, 100)).export(folder / "plate.stl")
    (path := folder / "one.urdf").write_text(
        f"""<robot name="one"><link name="base"/><link name="upper">{"".join(visuals)}</link>
        <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3"/>
        <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>""",
        "utf-8",
    )
    return shapes.load(load(str(path)))


def meshes(shape: Shape) -> list[trimesh.Trimesh]:
    """What a browser draws of a shape, in the frame of its link, from left to right."""
    scene = cast(trimesh.Scene, trimesh.load(io.BytesIO(shape.glb), file_type="glb"))
    return sorted(cast(list[trimesh.Trimesh], scene.dump()), key=lambda mesh: float(mesh.bounds[0, 0]))


@pytest.mark.parametrize(
    ("geometry", "half"),
    [(BOX, (0.05, 0.1, 0.2)), (CYLINDER, (0.1, 0.1, 0.3)), (SPHERE, (0.2, 0.2, 0.2)), (MESH, (0.05, 0.1, 0.15))],
)
def test_a_link_of_one_solid_is_drawn_in_its_size_at_its_place(
    tmp_path: Path, geometry: str, half: tuple[float, float, float]
) -> None:
    x, y, z = half
    for origin, middle, extents in (("", (0, 0, 0), (x, y, z)), (TURNED, (1, 2, 3), (z, y, x))):
        (shape,) = drawn(tmp_path, visual(geometry, origin))
        (mesh,) = meshes(shape)
        np.testing.assert_allclose(mesh.bounds, [np.subtract(middle, extents), np.add(middle, extents)], atol=1e-6)
        assert (shape.name, shape.link) == ("upper", 1)
        assert len(shape.edges) > 0
        np.testing.assert_array_equal(np.unique(mesh.visual.vertex_colors, axis=0), [[255, 0, 0, 255]])


@pytest.mark.parametrize("name", ["", "name='upper'"])
def test_the_solids_of_one_link_are_all_drawn(tmp_path: Path, name: str) -> None:
    for one, other in ((BOX, CYLINDER), (BOX, MESH), (SPHERE, SPHERE)):
        alone = [meshes(*drawn(tmp_path, each))[0] for each in (visual(one), visual(other, TURNED))]
        together = meshes(*drawn(tmp_path, visual(one, "", name), visual(other, TURNED, name)))
        np.testing.assert_allclose([mesh.bounds for mesh in together], [mesh.bounds for mesh in alone], atol=1e-6)


def test_a_box_shows_flat_faces_with_twelve_edges(tmp_path: Path) -> None:
    (shape,) = drawn(tmp_path, visual(BOX))
    normals = np.abs(meshes(shape)[0].vertex_normals)
    np.testing.assert_allclose(normals.max(axis=1), 1, atol=1e-6)
    assert len(shape.edges) == 12


@pytest.mark.parametrize("nothing", ['<box size="0 0 0"/>', '<cylinder radius="0" length="1"/>'])
def test_a_solid_without_a_size_is_not_drawn(tmp_path: Path, nothing: str) -> None:
    assert [shape.name for shape in drawn(tmp_path, visual(nothing))] == ["base", "upper"]  # as lines
    assert len(meshes(*drawn(tmp_path, visual(nothing), visual(BOX)))) == 1
