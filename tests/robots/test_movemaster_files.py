"""The Movemaster's files agree with each other: drawing and meshes, URDF and robot.toml, shell and planes."""

from __future__ import annotations

import importlib.util
import io
import tomllib
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import trimesh
import yourdfpy
from numpy.typing import NDArray

ROBOT = Path(__file__).parents[2] / "robots" / "movemaster"
SHELL = 0.065  # Cerbaro 2022, section 6.1
TOOL_RUN = 0.25


@pytest.fixture(scope="module")
def build() -> ModuleType:
    spec = importlib.util.spec_from_file_location("movemaster_build", ROBOT / "build.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def table() -> dict[str, Any]:
    return tomllib.loads((ROBOT / "robot.toml").read_text("utf-8"))


@pytest.fixture
def urdf() -> yourdfpy.URDF:
    return yourdfpy.URDF.load(str(ROBOT / "movemaster.urdf"), build_scene_graph=True, load_meshes=False)


def pose(urdf: yourdfpy.URDF, joints_deg: list[float], grip: float = 0.0) -> None:
    urdf.update_cfg(np.array([*np.radians(joints_deg), grip]))


def loaded(data: bytes) -> dict[str, trimesh.Trimesh]:
    return dict(trimesh.load_scene(io.BytesIO(data), file_type="glb").geometry)


def vertices(name: str) -> NDArray[np.float64]:
    return np.vstack([part.vertices for part in loaded((ROBOT / "meshes" / f"{name}.glb").read_bytes()).values()])


def distance_to_run(points: NDArray[np.float64], length: float) -> NDArray[np.float64]:
    """Distance of points to the segment from the origin to (length, 0, 0)."""
    beyond = points - np.column_stack([np.clip(points[:, 0], 0, length), np.zeros((len(points), 2))])
    distance: NDArray[np.float64] = np.linalg.norm(beyond, axis=1)
    return distance


def test_the_drawing_gives_the_committed_meshes(build: ModuleType) -> None:
    drawn = build.files()
    assert {path.name for path in (ROBOT / "meshes").iterdir()} == set(drawn)
    for name, data in drawn.items():
        committed = loaded((ROBOT / "meshes" / name).read_bytes())
        fresh = loaded(data)
        assert list(fresh) == list(committed)
        for surface, part in fresh.items():
            np.testing.assert_array_equal(part.faces, committed[surface].faces)
            np.testing.assert_allclose(part.vertices, committed[surface].vertices, atol=1e-6)


def test_the_drawing_is_deterministic(build: ModuleType) -> None:
    assert build.files() == build.files()


def test_the_robot_is_light() -> None:
    assert sum(path.stat().st_size for path in ROBOT.rglob("*") if "__pycache__" not in path.parts) < 1_000_000


def test_every_mesh_has_normals_of_unit_length() -> None:
    for path in (ROBOT / "meshes").iterdir():
        for part in loaded(path.read_bytes()).values():
            np.testing.assert_allclose(np.linalg.norm(part.vertex_normals, axis=1), 1, atol=1e-5)


def test_every_mesh_that_the_urdf_names_exists(urdf: yourdfpy.URDF) -> None:
    named = {visual.geometry.mesh.filename for link in urdf.robot.links for visual in link.visuals}
    assert named == {f"meshes/{path.name}" for path in (ROBOT / "meshes").iterdir()}


def test_fingers_open_and_close_symmetrically(urdf: yourdfpy.URDF, table: dict[str, Any]) -> None:
    for grip in (0.0, 0.01, urdf.joint_map["grip"].limit.upper):
        pose(urdf, [10, 20, -30, 40, 50], grip)
        left = urdf.get_transform("finger_left", "gripper")
        right = urdf.get_transform("finger_right", "gripper")
        np.testing.assert_allclose(left[:3, 3] * [1, -1, 1], right[:3, 3], atol=1e-12)
        assert left[1, 3] - right[1, 3] == pytest.approx(2 * grip)
    assert table["gripper"]["opening_mm"] == pytest.approx(2000 * urdf.joint_map["grip"].limit.upper)


def test_closed_fingers_meet_without_crossing() -> None:
    assert 0 <= vertices("finger")[:, 1].min() < 0.0005


def test_joint_limits_and_speeds_of_the_urdf_are_those_of_the_table(urdf: yourdfpy.URDF, table: dict[str, Any]) -> None:
    for row in table["joints"]:
        joint = urdf.joint_map[row["name"]]
        assert joint.child == row["link"]
        np.testing.assert_allclose(np.degrees([joint.limit.lower, joint.limit.upper]), row["limits_deg"], atol=1e-9)
        assert np.degrees(joint.limit.velocity) == pytest.approx(row["speed_deg_s"])


def test_urdf_frames_at_zero_stand_on_the_screws(urdf: yourdfpy.URDF, table: dict[str, Any]) -> None:
    pose(urdf, [0, 0, 0, 0, 0])
    for row in table["joints"]:
        T_base_link = urdf.get_transform(row["link"], "base_link")
        np.testing.assert_allclose(T_base_link[:3, :3], np.eye(3), atol=1e-12)
        np.testing.assert_allclose(1000 * T_base_link[:3, 3], row["screw"]["point_mm"], atol=1e-9)
        np.testing.assert_allclose(urdf.joint_map[row["name"]].axis, row["screw"]["direction"])


def test_tool_of_the_printed_example(urdf: yourdfpy.URDF) -> None:
    pose(urdf, [30, 60, -90, -30, 90])
    position = urdf.get_transform("tool", "base_link")[:3, 3]
    np.testing.assert_allclose(position, [0.4704294, 0.2716025, 0.3], atol=5e-8)


def test_the_ellipse_starts_where_its_pose_puts_the_tool(urdf: yourdfpy.URDF, table: dict[str, Any]) -> None:
    pose(urdf, table["poses"]["path_start"]["joints_deg"])
    np.testing.assert_allclose(urdf.get_transform("tool", "base_link")[:3, 3], [0.46, 0, 0.23], atol=1e-6)


@pytest.mark.parametrize(
    ("link", "length"), [("upper_arm", 0.25), ("forearm", 0.2), ("wrist", TOOL_RUN), ("gripper", TOOL_RUN)]
)
def test_the_arm_keeps_within_its_shell(link: str, length: float) -> None:
    assert distance_to_run(vertices(link), length).max() < SHELL


@pytest.mark.parametrize("grip", [0.0, 0.03])
def test_the_fingers_keep_within_the_shell(urdf: yourdfpy.URDF, grip: float) -> None:
    pose(urdf, [0, 0, 0, 0, 0], grip)
    points = vertices("finger") + urdf.get_transform("finger_left", "gripper")[:3, 3]
    assert distance_to_run(points, TOOL_RUN).max() < SHELL


def test_panes_lie_on_their_planes_and_the_work_is_inside(table: dict[str, Any]) -> None:
    for plane in table["planes"]:
        normal = np.array(plane["normal"])
        assert np.linalg.norm(normal) == pytest.approx(1, abs=1e-4)
        assert normal @ plane["centre_mm"] == pytest.approx(plane["offset_mm"], abs=0.01)
        assert normal @ [520, 0, 230] > plane["offset_mm"]
