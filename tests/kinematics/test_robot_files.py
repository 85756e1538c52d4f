"""A wrong robot file is one sentence that names the file and the place."""

from __future__ import annotations

import shutil
import tomllib
from pathlib import Path

import numpy as np
import pytest

from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.kinematics.urdf_file import parse_urdf
from helicoide.text import HelicoideError

GOOD = (load_robot("movemaster").urdf.parent / "robot.toml").read_text("utf-8")

# what is replaced, by what, and the words that name the place
MISTAKES = {
    "unknown key": ('urdf = "movemaster.urdf"', 'urdf = "movemaster.urdf"\ncolour = "red"', ["colour"]),
    "unknown key of a joint": ('link = "waist"', 'link = "waist"\nmass = 3', ["mass", "$.joints"]),
    "missing key": ("speed_deg_s = 60 ", "# speed_deg_s = 60 ", ["speed_deg_s", "J1"]),
    "a word for a number": ("speed_deg_s = 60 ", 'speed_deg_s = "fast" #', ["$.joints", "speed_deg_s"]),
    "two numbers for a triple": (
        "point_mm = [370, 0, 400]\n",
        "point_mm = [370, 0]\n",
        ["$.guarded_points", "point_mm"],
    ),
    "not a number": ("speed_deg_s = 60 ", "speed_deg_s = nan #", ["nan", "finite"]),
    "zero axis": ("direction = [0, 0, 1]", "direction = [0, 0, 0]", ["axis", "J1"]),
    "limits swapped": ("limits_deg = [-120, 0]", "limits_deg = [0, -120]", ["J3", "limits"]),
    "no speed": ("speed_deg_s = 60 ", "speed_deg_s = 0 ", ["J1", "speed"]),
    "missing home": ("[poses.home]", "[poses.elsewhere]", ["home", "missing"]),
    "missing ready": ("[poses.ready]", "[poses.elsewhere]", ["ready", "missing"]),
    "four angles": ("joints = [0, 0, 0, 0, 0]", "joints = [0, 0, 0, 0]", ["zero", "4", "5"]),
    "an unknown kind": ('link = "waist"', 'link = "waist"\nkind = "spherical"', ["spherical", "$.joints"]),
    "a slide in degrees": ('link = "waist"', 'link = "waist"\nkind = "prismatic"', ["J1", "limits_mm", "speed_mm_s"]),
    "limits in two units": ('link = "waist"', 'link = "waist"\nspeed_mm_s = 3', ["J1", "limits_deg", "speed_deg_s"]),
    "a frame on no joint": ("[gripper]", '[frames.wrist]\njoint = "J7"\nposition_mm = [0, 0, 0]\n\n[gripper]', ["J7"]),
    "an unknown frame": ("[gripper]", '[frames.elbow]\njoint = "J2"\nposition_mm = [0, 0, 0]\n\n[gripper]', ["elbow"]),
    "a sum of unknown lengths": ("d_mm = 400", 'd_mm = "h1 + h2"', ["$.joints", "d_mm"]),
    "unknown carrier": ('joint = "J3"\n', 'joint = "J9"\n', ["J9", "J1, J2, J3, J4, J5"]),
    "plane without a normal": ("normal = [0, 0, 1]", "normal = [0, 0, 0]", ["-z", "normal"]),
    "a capsule on no joint": ('joint = "J4"\nfrom_mm', 'joint = "J8"\nfrom_mm', ["J8", "J1, J2, J3, J4, J5"]),
    "a capsule without a body": ("radius_mm = 40", "radius_mm = 0", ["hand", "radius"]),
    "a pair with an unknown capsule": ('["base", "hand"]', '["base", "fist"]', ["fist", "base, shoulder"]),
    "a pair of one": ('["base", "hand"]', '["hand", "hand"]', ["hand", "itself"]),
    "no acceleration": ("speed_deg_s = 60 ", "acceleration_deg_s2 = 0\nspeed_deg_s = 60 ", ["J1", "acceleration"]),
    "a slide's acceleration": (
        "speed_deg_s = 60 ",
        "acceleration_mm_s2 = 9\nspeed_deg_s = 60 ",
        ["J1", "acceleration_deg_s2"],
    ),
    "a plane without a size": ("size_mm = [", "size_mm = [-1, 3] #", ["size_mm", "-1", "positive"]),
    "a negative capsule": ("radius_mm = 40", "radius_mm = -40", ["hand", "radius_mm", "-40", "positive"]),
    "a gripper that does not open": ("opening_mm = ", "opening_mm = -", ["opening_mm", "positive"]),
    "a bent tool": ("R_dh_tool = [", "R_dh_tool = [[0, 0, 0], [0, 1, 0], [0, 0, 1]] #", ["R_dh_tool", "rotation"]),
    "a camera that looks at itself": (
        "look_at_mm = [",
        f"look_at_mm = {tomllib.loads(GOOD)['camera']['position_mm']} # [",
        ["position_mm", "look_at_mm", "differ"],
    ),
    "two joints of a name": ('name = "J2"', 'name = "J1"', ["J1", "name of its own"]),
    "a length of nothing": ("[gripper]", "[parameters]\nl1 = 0\n[gripper]", ["l1", "positive", "not 0"]),
    "a whole number without end": ("d_mm = 400", "d_mm = 1" + "0" * 20, ["number", "1×10⁹"]),
    "more digits than Python reads": ("d_mm = 400", "d_mm = 1" + "0" * 5000, ["number"]),
    "a key of many dots": ("d_mm = 400", "d_mm = 400\n" + "a." * 9000 + "a = 1", ["dots"]),
    "deep": ("d_mm = 400", "d_mm = " + "[" * 9000, ["too deep"]),
    "broken toml": ("[tool]", "[tool", ["line"]),
}


def refused(folder: Path) -> str:
    with pytest.raises(HelicoideError) as caught:
        robot_from_folder(folder)
    text = caught.value.text
    for words in (text.en, text.pt_BR):
        assert str(folder / "robot.toml") in words
        assert "\n" not in words
    assert text.en != text.pt_BR
    return text.en


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_named_with_its_place(tmp_path: Path, mistake: str) -> None:
    old, new, place = MISTAKES[mistake]
    assert old in GOOD
    (tmp_path / "robot.toml").write_text(GOOD.replace(old, new, 1), "utf-8")
    said = refused(tmp_path)
    assert [word for word in place if word not in said] == []


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    assert "there is no such file" in refused(tmp_path)


def test_a_folder_in_its_place_is_named(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").mkdir()
    assert "it is a folder: name a file in it" in refused(tmp_path)


@pytest.mark.parametrize(
    ("text", "said"), [("", "it is empty"), (" \n", "it is empty"), ("# only words\n", "title is missing")]
)
def test_a_file_of_nothing_is_named(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "robot.toml").write_text(text, "utf-8")
    assert said in refused(tmp_path)


def test_a_folder_with_accents_and_blanks_holds_robots_like_any_other(tmp_path: Path, robot: Robot) -> None:
    copied = tmp_path / "Área de trabalho" / "meu braço"
    shutil.copytree(robot.urdf.parent, copied)
    same = robot_from_folder(copied)
    assert same.name == "meu braço"
    meshes = parse_urdf(same.urdf, meshes=True).scene.geometry
    assert len(meshes) == len(parse_urdf(robot.urdf, meshes=True).scene.geometry) > 0


def test_bytes_that_are_no_text_are_refused(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_bytes(b"\xff\xfe\x00")
    refused(tmp_path)


def test_the_unchanged_file_is_accepted(tmp_path: Path, robot: Robot) -> None:
    (tmp_path / "robot.toml").write_text(GOOD, "utf-8")
    assert [joint.name for joint in robot_from_folder(tmp_path).joints] == [joint.name for joint in robot.joints]


def test_an_unknown_robot_lists_those_there_are() -> None:
    with pytest.raises(HelicoideError, match="movemaster"):
        load_robot("puma")


@pytest.mark.parametrize("q", [[0.0] * 4, [0.0] * 6, [0, 0, float("nan"), 0, 0], [0, 0, float("inf"), 0, 0]])
def test_joint_values_are_counted_and_finite(robot: Robot, q: list[float]) -> None:
    with pytest.raises(HelicoideError, match="J1, J2, J3, J4, J5"):
        robot.check_joints(q)


def test_capsules_pairs_and_accelerations_are_read(tmp_path: Path) -> None:
    """The forearm lies from the elbow to the wrist, 200 mm along x in the frame of its link."""
    changed = GOOD.replace("speed_deg_s = 60 ", "acceleration_deg_s2 = 90\nspeed_deg_s = 60 ", 1)
    (tmp_path / "robot.toml").write_text(changed, "utf-8")
    robot = robot_from_folder(tmp_path)
    forearm = next(capsule for capsule in robot.capsules if capsule.name == "forearm")
    assert forearm.links == (3, 3)
    assert forearm.radius == 0.065
    np.testing.assert_allclose(forearm.ends, [[0, 0, 0], [0.2, 0, 0]], atol=1e-12)
    assert {(robot.bodies[a].name, robot.bodies[b].name) for a, b in robot.self_collision} >= {("base", "gripper")}
    np.testing.assert_allclose(robot.acceleration, [np.pi / 2, *[np.inf] * 4])


def test_the_former_name_of_assumed_is_read_and_remarked(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text('ours = ["speeds"]\nassumed = ["limits"]\n' + GOOD, "utf-8")
    robot = robot_from_folder(tmp_path)
    assert robot.assumed == ("limits", "speeds")
    (remark,) = robot.remarks
    assert "assumed" in remark.en
    assert "assumed" in remark.pt_BR
