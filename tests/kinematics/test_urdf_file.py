"""A broken URDF is one line in both languages that names the file and the place; meshes are found as ROS finds them."""

from __future__ import annotations

from pathlib import Path

import pytest
import trimesh

from helicoide.kinematics.urdf_chain import from_urdf
from helicoide.kinematics.urdf_file import mesh_file, parsed
from helicoide.text import HelicoideError
from tests.kinematics.urdfs import GOOD, chain_of, write

# what is replaced in the good file, by what, and the words that name the place
MISTAKES = {
    "no robot": ("<robot ", "<model ", ["'model'", "'robot'"]),
    "a robot without a name": ('<robot name="arm">', "<robot>", ["robot", "name"]),
    "a link without a name": ('<link name="upper"/>', "<link/>", ["link", "name"]),
    "two links of one name": ('<link name="upper"/>', '<link name="upper"/><link name="upper"/>', ["link 'upper'"]),
    "two joints of one name": ('<joint name="two"', '<joint name="one"', ["joint 'one'", "name"]),
    "no parent": ('<parent link="upper"/>', "", ["'two'", "parent"]),
    "no child": ('<child link="lower"/>', "<child/>", ["'two'", "child"]),
    "an unknown link": ('<child link="lower"/>', '<child link="nowhere"/>', ["'two'", "'nowhere'"]),
    "two parents": ('<parent link="lower"/><child link="tool"/>', '<parent link="base"/><child link="lower"/>',
                    ["'lower'", "'two'", "'end'"]),
    "two roots": ('<link name="tool"/>', '<link name="tool"/><link name="table"/>', ["base", "table"]),
    "a cycle": ('<parent link="base"/>', '<parent link="lower"/>', ["upper → lower → upper"]),
    "a cycle beside the arm": ("</robot>", chain_of(["p", "q", "p"]) + "</robot>", ["p → q → p"]),
    "nan in an origin": ('xyz="0.1 0 0.3"', 'xyz="0.1 nan 0.3"', ["'one'", "origin xyz", "nan"]),
    "nan in an axis": ('<axis xyz="0 1 0"/>', '<axis xyz="0 nan 0"/>', ["'two'", "axis", "nan"]),
    "infinity in a limit": ('upper="2"', 'upper="inf"', ["'two'", "limit upper", "inf"]),
    "a word for a number": ('lower="-1"', 'lower="low"', ["'two'", "limit lower", "low"]),
    "two numbers for three": ('<axis xyz="0 1 0"/>', '<axis xyz="0 1"/>', ["'two'", "axis", "0 1", "3"]),
    "nan in a picture": ('<link name="upper"/>', '<link name="upper"><visual><origin rpy="nan 0 0"/></visual></link>',
                         ["link 'upper'", "rpy"]),
    "xacro": ("</robot>", '<xacro:arm xmlns:xacro="http://ros.org/wiki/xacro"/></robot>', ["xacro"]),
    "broken XML": ('<link name="tool"/>', '<link name="tool">', ["line", "column"]),
    "a zero axis": ('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>', ["'two'", "axis", "zero"]),
    "no limit": ('<limit lower="-1" upper="2" velocity="0.5"/>', "", ["'two'", "limit"]),
    "no lower limit": ('lower="-1" ', "", ["'two'", "lower"]),
    "limits swapped": ('lower="-1"', 'lower="3"', ["'two'", "3 to 2", "below"]),
    "a floating joint": ('name="two" type="prismatic"', 'name="two" type="floating"', ["'two'", "'floating'", "prismatic"]),
    "a planar joint": ('name="end" type="fixed"', 'name="end" type="planar"', ["'end'", "'planar'", "prismatic"]),
    "a joint without a type": ('name="end" type="fixed"', 'name="end"', ["'end'", "type", "prismatic"]),
    "an unknown driver": ("</limit>", '</limit><mimic joint="three"/>', ["'two'", "'three'"]),
    "a driver beyond itself": ("</limit>", '</limit><mimic joint="two"/>', ["'two'"]),
    "a driver that cannot move": ("</limit>", '</limit><mimic joint="one" multiplier="5" offset="50"/>', ["'one'", "limits"]),
}  # fmt: skip


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


@pytest.mark.parametrize("mistake", MISTAKES)
def test_its_reason_is_said_in_portuguese_too(tmp_path: Path, mistake: str) -> None:
    if mistake == "broken XML":
        return
    old, new, _ = MISTAKES[mistake]
    with pytest.raises(HelicoideError) as caught:
        from_urdf(write(tmp_path, old, new), "tool")
    text = caught.value.text
    assert text.en.partition("cannot be used: ")[2] != text.pt_BR.partition(str(tmp_path / "arm.urdf") + ": ")[2]


def test_the_unchanged_file_is_accepted(tmp_path: Path) -> None:
    assert [joint.name for joint in from_urdf(write(tmp_path)).joints] == ["one", "two"]


@pytest.mark.parametrize(("text", "word"), [("", "line 1"), ("hello", "line 1"), ("<robot/>", "links")])
def test_what_is_no_robot_is_refused(tmp_path: Path, text: str, word: str) -> None:
    (path := tmp_path / "arm.urdf").write_text(text, "utf-8")
    assert word in refused(path)


def test_bytes_that_are_no_text_are_refused(tmp_path: Path) -> None:
    (path := tmp_path / "arm.urdf").write_bytes(b"\xff\xfe\x00")
    refused(path)


def test_a_folder_and_a_missing_file_are_refused(tmp_path: Path) -> None:
    assert "directory" in refused(tmp_path).lower()
    assert "No such file" in refused(tmp_path / "arm.urdf")


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
    path = with_mesh(tmp_path, "upper.stl")
    (tmp_path / "upper.stl").write_text("nothing", "utf-8")
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
