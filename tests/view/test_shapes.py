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
from PIL import Image
from tests.kinematics.urdfs import chain_of, write
from viser._messages import Message, SetOrientationMessage, SetPositionMessage

from helicoide import content
from helicoide.geometry import rotation
from helicoide.kinematics import urdf_file
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.seat import Seat
from helicoide.state import initial_state
from helicoide.text import Language
from helicoide.view import shapes
from helicoide.view.layers.arm import LinkNodes
from helicoide.view.panels import robot as panel
from helicoide.view.rows import HtmlRow
from helicoide.view.scene import outlook
from helicoide.view.shapes import Shape
from helicoide.view.window_view import View

BOX, CYLINDER, SPHERE = '<box size="0.1 0.2 0.4"/>', '<cylinder radius="0.1" length="0.6"/>', '<sphere radius="0.2"/>'
MESH = '<mesh filename="plate.stl" scale="0.001 0.002 0.003"/>'  # of 100 mm each way
TURNED = '<origin xyz="1 2 3" rpy="0 1.5707963267948966 0"/>'  # its x along -z, its z along x
ARMS = [*sorted(content.content_folders("robots")), "ur5", "kr16_2", "so101"]


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


def led_from_beside(folder: Path) -> Robot:
    """An arm whose second joint follows one beside it, with boxes on its links."""
    text = chain_of(["base", "a", "b"]) + chain_of(["base", "x"]).replace('<link name="base"/>', "")
    for link in "ab":
        text = text.replace(f'<link name="{link}"/>', f'<link name="{link}">{visual(BOX)}</link>')
    text = text.replace('<child link="b"/>', '<child link="b"/><mimic joint="base-x" multiplier="2" offset="0.1"/>')
    (path := folder / "led.urdf").write_text(f'<robot name="led">{text}</robot>', "utf-8")
    return load_robot(str(path), "b")


@pytest.mark.parametrize("name", [*ARMS, "led"])
def test_every_mesh_stands_where_the_urdf_has_its_link(name: str, tmp_path: Path) -> None:
    robot = led_from_beside(tmp_path) if name == "led" else load_robot(name)
    found = shapes.load_shapes(robot)
    said = Said()
    frames = [node(said, shape.name) for shape in found]
    oracle = yourdfpy.URDF(urdf_file.parse_urdf(robot.urdf, robot.parameters).robot, load_meshes=False)
    q = np.random.default_rng(3).uniform(robot.lower, robot.upper)
    LinkNodes(found, cast(Any, frames)).write(link_poses(robot.chain, q), gripper=0.0)
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
    return shapes.load_shapes(load_robot(str(path)))


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


@pytest.mark.parametrize(("mode", "written"), [("RGB", b"image/jpeg"), ("RGBA", b"image/png")])
def test_opaque_textures_are_written_as_jpeg(tmp_path: Path, mode: str, written: bytes) -> None:
    """To write them as PNG takes so long that arms with many take more than ten seconds."""
    box, texture = trimesh.creation.box(extents=(100, 100, 100)), Image.new(mode, (8, 8), "red")
    box.visual = trimesh.visual.TextureVisuals(box.vertices[:, :2] / 100, image=texture)
    box.export(tmp_path / "plate.glb")
    (shape,) = drawn(tmp_path, visual(MESH.replace("stl", "glb")))
    assert written in shape.glb
    assert shape.glb.count(b"image/") == 1
    assert len(shape.edges) == 12


def test_a_box_shows_flat_faces_with_twelve_edges(tmp_path: Path) -> None:
    (shape,) = drawn(tmp_path, visual(BOX))
    normals = np.abs(meshes(shape)[0].vertex_normals)
    np.testing.assert_allclose(normals.max(axis=1), 1, atol=1e-6)
    assert len(shape.edges) == 12


@pytest.mark.parametrize(
    "nothing", ['<box size="0 0 0"/>', '<cylinder radius="0" length="1"/>', '<capsule radius="0" length="0"/>']
)
def test_a_solid_without_a_size_is_not_drawn(tmp_path: Path, nothing: str) -> None:
    assert [shape.name for shape in drawn(tmp_path, visual(nothing))] == ["base", "upper"]  # as lines
    assert len(meshes(*drawn(tmp_path, visual(nothing), visual(BOX)))) == 1


SAID: dict[Language, str] = {"en": "there is no mesh plate.stl", "pt_BR": "não há malha plate.stl"}


def test_what_is_not_drawn_is_said_in_the_panel_of_the_robot(tmp_path: Path) -> None:
    robot = load_robot(
        str(write(tmp_path, '<link name="upper"/>', f'<link name="upper">{visual(MESH)}</link>')), "tool"
    )
    words = next(row for row in panel.rows(robot) if isinstance(row, HtmlRow))
    for language, said in SAID.items():
        assert said in words.html(View(initial_state(robot), Seat("", language)))
    assert words.html(View(initial_state(load_robot("movemaster")), Seat("", "en"))) == ""


@pytest.mark.parametrize("origin", ["", TURNED])
def test_a_capsule_is_a_cylinder_between_two_spheres(tmp_path: Path, origin: str) -> None:
    """Radius 0.1 m about a piece of 0.6 m: 0.8 m long."""
    (shape,) = drawn(tmp_path, visual('<capsule radius="0.1" length="0.6"/>', origin))
    bounds = np.array([mesh.bounds for mesh in meshes(shape)])
    low, high = bounds[:, 0].min(axis=0), bounds[:, 1].max(axis=0)
    np.testing.assert_allclose(np.sort(high - low), [0.2, 0.2, 0.8], atol=1e-3)
    np.testing.assert_allclose((low + high) / 2, [1, 2, 3] if origin else [0, 0, 0], atol=1e-6)


def test_an_arm_that_shows_nothing_is_drawn_as_lines_and_cylinders(tmp_path: Path) -> None:
    robot = load_robot(str(write(tmp_path)), "tool")
    found = shapes.load_shapes(robot)
    assert [(shape.name, shape.link) for shape in found] == [("base", 0), ("upper", 1), ("lower", 2)]
    for shape, end in zip(found, np.diff([[0, 0, 0], *robot.points, robot.T_world_tool_0[:3, 3]], axis=0), strict=True):
        assert len(shape.edges) > 0
        spread = np.array([mesh.bounds for mesh in meshes(shape)])
        assert np.all(spread[:, 0].min(axis=0) <= np.minimum(end, 0) + 1e-6)
        assert np.all(spread[:, 1].max(axis=0) >= np.maximum(end, 0) - 1e-6)


def test_a_link_in_whose_place_nothing_is_seen_is_added_where_most_are_missing(tmp_path: Path) -> None:
    box = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    robot = load_robot(str(write(tmp_path, '<link name="base"/>', f'<link name="base">{box}</link>')), "tool")
    assert [(shape.name, shape.link) for shape in shapes.load_shapes(robot)] == [
        ("base", 0),
        ("upper", 1),
        ("lower", 2),
    ]


def test_what_follows_stands_where_it_stands_at_zero(tmp_path: Path) -> None:
    """The pose on the link is that at zero, not that to which the shift of a follower would bring it."""
    follows = '<limit lower="-1" upper="2" velocity="0.5"/><mimic joint="one" offset="0.5"/>'
    box = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    path = write(tmp_path, '<limit lower="-1" upper="2" velocity="0.5"/>', follows)
    path.write_text(
        path.read_text("utf-8").replace('<link name="lower"/>', f'<link name="lower">{box}</link>'), "utf-8"
    )
    (shape,) = (shape for shape in shapes.load_shapes(load_robot(str(path), "tool")) if shape.name == "lower")
    assert shape.link == 2
    np.testing.assert_allclose(shape.T_link_shape[:3, 3], 0, atol=1e-12)


def test_a_later_base_is_where_the_scene_begins(tmp_path: Path) -> None:
    box = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    path = write(tmp_path, '<link name="tool"/>', f'<link name="tool">{box}</link>')
    robot = load_robot(str(path), "tool", (), "upper")
    (shape,) = (shape for shape in shapes.load_shapes(robot) if shape.name == "tool")
    poses = link_poses(robot.chain, np.zeros(1))
    np.testing.assert_allclose(poses[shape.link] @ shape.T_link_shape, robot.T_world_tool_0, atol=1e-12)


@pytest.mark.parametrize("height", [0.0, 0.3])
def test_an_arm_that_reaches_nowhere_is_seen(tmp_path: Path, height: float) -> None:
    text = chain_of(["base", "plate"]).replace('xyz="0.1 0 0"', f'xyz="0 0 {height}"')
    (path := tmp_path / "plate.urdf").write_text(f'<robot name="plate">{text}</robot>', "utf-8")
    robot = load_robot(str(path))
    place, looked_at = outlook(robot)
    assert np.linalg.norm(place - looked_at) > 0.2
    assert [shape.name for shape in shapes.load_shapes(robot)][-1] == "plate"


def test_whatever_stands_beside_the_arm_it_is_drawn(tmp_path: Path) -> None:
    box = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    beside = "".join(
        f'<link name="{kind}">{box}</link><joint name="to-{kind}" type="{kind}"><parent link="upper"/>'
        f'<child link="{kind}"/><axis xyz="0 0 0"/><mimic joint="gone"/></joint>'
        for kind in ("floating", "planar", "hinge", "revolute")
    )
    path = write(tmp_path, "</robot>", beside + "</robot>")
    found = shapes.load_shapes(load_robot(str(path), "tool"))
    assert {"floating", "planar", "hinge", "revolute"} <= {shape.name for shape in found}
