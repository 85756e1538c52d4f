"""A broken URDF is one line in both languages that names the file and the place; meshes are found as ROS finds them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from tests.kinematics.urdfs import GOOD, MISTAKES, chain_of, write

from helicoide.kinematics.urdf_chain import robot_from_urdf
from helicoide.kinematics.urdf_file import parse_urdf, undrawn_remark
from helicoide.kinematics.urdf_mesh import mesh_file
from helicoide.text import HelicoideError


def refused(path: Path, tip: str | None = "tool") -> str:
    with pytest.raises(HelicoideError) as caught:
        robot_from_urdf(path, tip)
    text = caught.value.text
    for words in (text.en, text.pt_BR):
        assert str(path) in words
        assert len(words.splitlines()) == 1
    assert text.en != text.pt_BR
    return text.en


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_named_with_its_place(tmp_path: Path, mistake: str) -> None:
    old, new, place = MISTAKES[mistake]
    said = refused(write(tmp_path, old, new))
    assert [word for word in place if word not in said] == []


@pytest.mark.parametrize("mistake", sorted(MISTAKES.keys() - {"broken XML"}))
def test_its_reason_is_said_in_portuguese_too(tmp_path: Path, mistake: str) -> None:
    old, new, _ = MISTAKES[mistake]
    with pytest.raises(HelicoideError) as caught:
        robot_from_urdf(write(tmp_path, old, new), "tool")
    text = caught.value.text
    assert text.en.partition("cannot be used: ")[2] != text.pt_BR.partition(str(tmp_path / "arm.urdf") + ": ")[2]


def test_the_unchanged_file_is_accepted(tmp_path: Path) -> None:
    assert [joint.name for joint in robot_from_urdf(write(tmp_path)).joints] == ["one", "two"]


@pytest.mark.parametrize(
    ("text", "word"), [("", "line 1"), ("hello", "line 1"), ("<robot/>", "links"), ("<model/>", "'model'")]
)
def test_what_is_no_robot_is_refused(tmp_path: Path, text: str, word: str) -> None:
    (path := tmp_path / "arm.urdf").write_text(text, "utf-8")
    assert word in refused(path)


def test_bytes_that_are_no_text_are_refused(tmp_path: Path) -> None:
    (path := tmp_path / "arm.urdf").write_bytes(b"\xff\xfe\x00")
    refused(path)


def test_a_folder_and_a_missing_file_are_refused(tmp_path: Path) -> None:
    assert "it is a folder" in refused(tmp_path)
    assert "there is no such file" in refused(tmp_path / "arm.urdf")


@pytest.mark.parametrize("count", [200, 3000])
def test_too_many_joints_are_refused(tmp_path: Path, count: int) -> None:
    links = [f"link{i}" for i in range(count + 1)]
    (path := tmp_path / "long.urdf").write_text(f'<robot name="long">{chain_of(links)}</robot>', "utf-8")
    assert f"{count} moving joints; an arm has 1 to 30" in refused(path, None)


def test_parameters_are_filled_in(tmp_path: Path) -> None:
    path = write(tmp_path, 'xyz="0.1 0 0.3"', 'xyz="0.1 0 ${l1}"')
    assert parse_urdf(path, {"l1": 0.7}).joint_map["one"].origin[2, 3] == pytest.approx(0.7)
    assert "${l1}" in refused(path)


def with_mesh(folder: Path, filename: str) -> Path:
    visual = f'<visual><geometry><mesh filename="{filename}"/></geometry></visual>'
    folder.mkdir(parents=True, exist_ok=True)
    return write(folder, '<link name="upper"/>', f'<link name="upper">{visual}</link>')


@pytest.mark.parametrize(
    ("visual", "words"),
    [
        ('<geometry><mesh filename="meshes/upper.stl"/></geometry>', ["upper", "meshes/upper.stl"]),
        ('<geometry><mesh filename="$(find arm)/upper.stl"/></geometry>', ["upper", "$(find arm)/upper.stl"]),
        ('<geometry><mesh filename="upper.stl" scale="0 1 1"/></geometry>', ["upper", "mesh", "size"]),
        ('<geometry><cylinder radius="1"/></geometry>', ["upper", "cylinder", "size"]),
        ('<geometry><box size="1 nan 1"/></geometry>', ["upper", "box", "size"]),
        ('<origin rpy="nan 0 0"/><geometry><box size="1 1 1"/></geometry>', ["upper", "pose"]),
        ("<geometry><torus/></geometry>", ["upper", "torus", "unknown"]),
        ("<geometry/>", ["upper", "no geometry"]),
        ("", ["upper", "no geometry"]),
    ],
)
def test_what_cannot_be_drawn_of_a_link_is_said_and_stops_no_arm(tmp_path: Path, visual: str, words: list[str]) -> None:
    path = write(tmp_path, '<link name="upper"/>', f'<link name="upper"><visual>{visual}</visual></link>')
    assert len(robot_from_urdf(path).joints) == 2
    said = undrawn_remark(path)
    assert said is not None
    for text in (said.en, said.pt_BR):
        assert len(text.splitlines()) == 1
        assert words[0] in text
    assert [word for word in words if word not in said.en] == []
    assert said.en != said.pt_BR
    assert parse_urdf(path, meshes=True).scene.geometry == {}
    assert undrawn_remark(write(tmp_path)) is None


def test_of_many_links_that_are_not_drawn_the_first_are_named(tmp_path: Path) -> None:
    mesh = '<visual><geometry><mesh filename="m.stl"/></geometry></visual>'
    said = undrawn_remark(write(tmp_path, '<link name="upper"/>', f'<link name="upper">{5 * mesh}</link>'))
    assert said is not None
    assert said.en.endswith("; and 2 more")


BOX = trimesh.creation.box((1, 2, 3)).export(file_type="stl")
POINTER = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"


@pytest.mark.parametrize(
    ("name", "content", "why"),
    [
        ("upper.glb", b"nothing", "cannot be read"),
        ("upper.dae", POINTER, "cannot be read"),
        ("upper.blend", b"BLENDER", "cannot be read"),
        ("upper.stl", POINTER, "no surface"),
        ("upper.stl", BOX[: len(BOX) // 2], "no surface"),
        ("upper.stl", BOX[:84] + np.full(12 * 50 // 4, np.nan, "<f4").tobytes(), "no surface"),
        ("upper.obj", b"v 0 0 0\n", "no surface"),
    ],
)
def test_a_mesh_that_holds_none_is_left_out_and_said(tmp_path: Path, name: str, content: bytes, why: str) -> None:
    path = with_mesh(tmp_path, name)
    (tmp_path / name).write_bytes(content)
    assert parse_urdf(path, meshes=True).scene.geometry == {}
    *_, said = robot_from_urdf(path).all_remarks
    assert name in said.en
    assert why in said.en
    assert name in said.pt_BR
    assert said.pt_BR.startswith("não desenhado: do elo upper, não ")


def test_a_mesh_that_was_mended_is_drawn(tmp_path: Path) -> None:
    path = with_mesh(tmp_path, "upper.stl")
    (tmp_path / "upper.stl").write_bytes(POINTER)
    assert undrawn_remark(path) is not None
    (tmp_path / "upper.stl").write_bytes(BOX)
    assert undrawn_remark(path) is None
    assert robot_from_urdf(path).all_remarks == ()


@pytest.mark.parametrize(
    ("urdf", "filename"),
    [
        ("", "upper.stl"),
        ("arm/urdf", "../meshes/upper.stl"),
        ("arm/urdf", "package://arm/meshes/upper.stl"),
        ("arm/robots/urdf", "package://arm/meshes/upper.stl"),
        ("arm_description/urdf", "package://arm/meshes/upper.stl"),
        ("arm/urdf", "model://arm/meshes/upper.stl"),
        ("arm/urdf", "$(find arm)/meshes/upper.stl"),
        ("arm/urdf", "../meshes/upper.STL"),
        ("arm/urdf", "..\\meshes\\upper.stl"),
    ],
)
def test_meshes_are_found_where_the_urdf_means_them(tmp_path: Path, urdf: str, filename: str) -> None:
    path = with_mesh(tmp_path / urdf, filename)
    mesh = tmp_path / (filename if not urdf else "arm/meshes/upper.stl")
    mesh.parent.mkdir(parents=True, exist_ok=True)
    trimesh.creation.box((1, 2, 3)).export(mesh)
    assert Path(mesh_file(path)(filename)).resolve() == mesh.resolve()
    assert sorted(parse_urdf(path, meshes=True).scene.extents) == pytest.approx([1, 2, 3])


@pytest.mark.parametrize("filename", ["package://../secret.stl", "package://arm/../../secret.stl", "package://arm//"])
def test_a_package_has_no_way_out(tmp_path: Path, filename: str) -> None:
    trimesh.creation.box((1, 2, 3)).export(tmp_path / "secret.stl")
    path = with_mesh(tmp_path / "arm/urdf", filename)
    assert parse_urdf(path, meshes=True).scene.geometry == {}


def test_the_good_file_names_what_is_replaced() -> None:
    assert [old for old, _, _ in MISTAKES.values() if GOOD.count(old) != 1] == []
