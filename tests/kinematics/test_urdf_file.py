"""A broken URDF is one line in both languages that names the file and the place; meshes are found as ROS finds them."""

from __future__ import annotations

from pathlib import Path

import pytest
import trimesh
from tests.kinematics.urdfs import GOOD, MISTAKES, chain_of, write

from helicoide.kinematics.urdf_chain import from_urdf
from helicoide.kinematics.urdf_file import mesh_file, parsed
from helicoide.text import HelicoideError


def refused(path: Path, tip: str | None = "tool") -> str:
    with pytest.raises(HelicoideError) as caught:
        from_urdf(path, tip)
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


@pytest.mark.parametrize("mistake", sorted(MISTAKES))
def test_its_reason_is_said_in_portuguese_too(tmp_path: Path, mistake: str) -> None:
    old, new, _ = MISTAKES[mistake]
    with pytest.raises(HelicoideError) as caught:
        from_urdf(write(tmp_path, old, new), "tool")
    text = caught.value.text
    assert text.en.partition("cannot be used: ")[2] != text.pt_BR.partition(str(tmp_path / "arm.urdf") + ": ")[2]


def test_the_unchanged_file_is_accepted(tmp_path: Path) -> None:
    assert [joint.name for joint in from_urdf(write(tmp_path)).joints] == ["one", "two"]


@pytest.mark.parametrize(
    ("text", "word"), [("", "it is empty"), ("hello", "line 1"), ("<robot/>", "links"), ("<model/>", "'model'")]
)
def test_what_is_no_robot_is_refused(tmp_path: Path, text: str, word: str) -> None:
    (path := tmp_path / "arm.urdf").write_text(text, "utf-8")
    assert word in refused(path)


def test_bytes_that_are_no_text_are_refused(tmp_path: Path) -> None:
    (path := tmp_path / "arm.urdf").write_bytes(b"\xff\xfe\x00")
    refused(path)


def test_a_folder_and_a_missing_file_are_refused(tmp_path: Path) -> None:
    assert "it is a folder, not a file" in refused(tmp_path)
    assert "there is no such file" in refused(tmp_path / "arm.urdf")


@pytest.mark.parametrize(
    ("shape", "said"),
    [
        ('<sphere radius="0"/>', 'sphere radius="0": give positive metres'),
        ("<sphere/>", 'sphere radius="": give positive metres'),
        ('<box size="1 -1 1"/>', 'box size="1 -1 1": give positive metres'),
        ('<cylinder radius="1" length="0"/>', 'cylinder length="0": give positive metres'),
    ],
)
def test_a_body_of_no_size_is_refused(tmp_path: Path, shape: str, said: str) -> None:
    body = f'<link name="body"><visual><geometry>{shape}</geometry></visual></link>'
    (path := tmp_path / "arm.urdf").write_text(f'<robot name="one">{body}</robot>', "utf-8")
    assert f"link 'body' has {said}" in refused(path, None)


@pytest.mark.parametrize("count", [200, 3000])
def test_too_many_joints_are_refused(tmp_path: Path, count: int) -> None:
    links = [f"link{i}" for i in range(count + 1)]
    (path := tmp_path / "long.urdf").write_text(f'<robot name="long">{chain_of(links)}</robot>', "utf-8")
    assert f"{count} moving joints; an arm has 1 to 30" in refused(path, None)


def test_parameters_are_filled_in(tmp_path: Path) -> None:
    path = write(tmp_path, 'xyz="0.1 0 0.3"', 'xyz="0.1 0 ${l1}"')
    assert parsed(path, {"l1": 0.7}).joint_map["one"].origin[2, 3] == pytest.approx(0.7)
    assert "${l1}" in refused(path)


def with_mesh(folder: Path, filename: str) -> Path:
    visual = f'<visual><geometry><mesh filename="{filename}"/></geometry></visual>'
    folder.mkdir(parents=True, exist_ok=True)
    return write(folder, '<link name="upper"/>', f'<link name="upper">{visual}</link>')


def test_a_mesh_is_missed_only_when_meshes_are_asked(tmp_path: Path) -> None:
    path = with_mesh(tmp_path, "meshes/upper.stl")
    from_urdf(path)
    with pytest.raises(HelicoideError) as caught:
        parsed(path, meshes=True)
    for words in (caught.value.text.en, caught.value.text.pt_BR):
        assert len(words.splitlines()) == 1
        assert [word for word in (str(path), "'upper'", "meshes/upper.stl") if word not in words] == []


def test_a_mesh_that_holds_none_is_refused(tmp_path: Path) -> None:
    path = with_mesh(tmp_path, "upper.glb")
    (tmp_path / "upper.glb").write_text("nothing", "utf-8")
    with pytest.raises(HelicoideError, match=r"arm\.urdf"):
        parsed(path, meshes=True)


@pytest.mark.parametrize(
    ("urdf", "filename"),
    [
        ("", "upper.stl"),
        ("arm/urdf", "../meshes/upper.stl"),
        ("arm/urdf", "package://arm/meshes/upper.stl"),
        ("arm/robots/urdf", "package://arm/meshes/upper.stl"),
        ("arm_description/urdf", "package://arm/meshes/upper.stl"),
    ],
)
def test_meshes_are_found_where_the_urdf_means_them(tmp_path: Path, urdf: str, filename: str) -> None:
    path = with_mesh(tmp_path / urdf, filename)
    mesh = tmp_path / (filename if not urdf else "arm/meshes/upper.stl")
    mesh.parent.mkdir(parents=True, exist_ok=True)
    trimesh.creation.box((1, 2, 3)).export(mesh)
    assert Path(mesh_file(path)(filename)).resolve() == mesh.resolve()
    assert sorted(parsed(path, meshes=True).scene.extents) == pytest.approx([1, 2, 3])


def test_the_good_file_names_what_is_replaced() -> None:
    assert [old for old, _, _ in MISTAKES.values() if GOOD.count(old) != 1] == []
