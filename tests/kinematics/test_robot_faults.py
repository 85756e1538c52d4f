"""A robot whose files contradict each other is told so, file by file and in both languages."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot_faults import faults, remarks_and_faults
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.kinematics.urdf_chain import robot_from_urdf

READY = "joints = [0, -70, -20, 0, 60, 0]"
# the file, what is replaced in it, by what, and the words that say where
MISTAKES = {
    "a row 10 mm off": ("robot.toml", "a_mm = 431.8", "a_mm = 441.8", ["DH rows", "J3", "10 mm"]),
    "the tool turned": (
        "robot.toml",
        "R_dh_tool = [[1, 0, 0], [0, 1, 0]",
        "R_dh_tool = [[0, 1, 0], [-1, 0, 0]",
        ["90°"],
    ),
    "no such link": ("robot.toml", 'link = "upper_arm"', 'link = "upperarm"', ["no link upperarm", "upper_arm"]),
    "no such tool": ("robot.toml", 'link = "tool"', 'link = "tol"', ["no link tol"]),
    "a joint renamed": ("puma560.urdf", 'joint name="J2"', 'joint name="K2"', ["no joint J2", "K2"]),
    "another link moved": ("robot.toml", 'link = "wrist"', 'link = "hand"', ["J4", "carries link wrist, not hand"]),
    "other limits": (
        "robot.toml",
        "limits_deg = [-266, 266]",
        "limits_deg = [-260, 266]",
        ["J6", "-4.64258", "-4.53786"],
    ),
    "another axis": ("robot.toml", "direction = [0, 0, -1]", "direction = [0, 0, 1]", ["J4", "its axis"]),
    "ready outside": ("robot.toml", READY, "joints = [0, -70, 50, 0, 60, 0]", ["ready", "J3"]),
    "ready singular": ("robot.toml", READY, "joints = [0, -70, -20, 0, 1, 0]", ["ready", "condition"]),
    "a pose twice": ("robot.toml", "joints = [0, 0, 0, 0, 0, 0]", READY, ["ready and zero"]),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A copy of the PUMA, whose files agree."""
    return Path(shutil.copytree(load_robot("puma560").urdf.parent, tmp_path / "puma560"))


def test_the_copy_has_no_faults(folder: Path) -> None:
    assert remarks_and_faults(robot_from_folder(folder)) == ()


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_contradiction_is_said_with_its_place(folder: Path, mistake: str) -> None:
    name, old, new, place = MISTAKES[mistake]
    text = (folder / name).read_text("utf-8")
    assert old in text
    (folder / name).write_text(text.replace(old, new, 1), "utf-8")
    said = remarks_and_faults(robot_from_folder(folder))
    assert [word for word in place if word not in " | ".join(fault.en for fault in said)] == []
    assert all(fault.en != fault.pt_BR for fault in said)


def test_a_urdf_alone_cannot_contradict_itself(folder: Path) -> None:
    assert faults(robot_from_urdf(folder / "puma560.urdf")) == ()
