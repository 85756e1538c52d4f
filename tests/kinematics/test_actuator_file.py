"""The table [actuators] of a robot file: what it says, and what is said of a wrong one."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from helicoide.kinematics.actuators import BallScrew
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.text import HelicoideError

PLAIN = (load_robot("movemaster").urdf.parent / "robot.toml").read_text("utf-8").partition("[actuators]")[0]
GEAR = '{ kind = "gear", pulses_per_deg = 100 }'
GEARS = ", ".join([GEAR] * 4)
COUPLING = "coupling = [[1, 0, 0, 0, 0], [0, 1, 0, 0, 0], [0, 1, 1, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0, 1]]"
SCREW = '{ kind = "ball_screw", sides_mm = [400, 300], pulses_per_mm = 50, length_at_zero_mm = 500, zero_deg = -30 }'
GOOD = f"{PLAIN}\n[actuators]\n{COUPLING}\ndrives = [{GEARS}, {SCREW}]\n"

# what is replaced, by what, and the words that name the place and what would be right
MISTAKES = {
    "singular coupling": ("[0, 1, 1, 0, 0]", "[0, 1, 0, 0, 0]", ["coupling", "singular"]),
    "four rows": ("[[1, 0, 0, 0, 0], ", "[", ["coupling", "5 rows of 5"]),
    "four columns": ("[0, 1, 1, 0, 0]", "[0, 1, 1, 0]", ["coupling", "5 rows of 5"]),
    "half a joint": ("[0, 1, 1, 0, 0]", "[0, 1, 0.5, 0, 0]", ["coupling", "int"]),
    "four drives": (f"{GEAR}, ", "", ["4 drives", "5 joints", "J1, J2, J3, J4, J5"]),
    "zero pulses": ("pulses_per_deg = 100", "pulses_per_deg = 0", ["pulses_per_deg", "A1", "zero"]),
    "zero pulses of a screw": ("pulses_per_mm = 50", "pulses_per_mm = 0", ["pulses_per_mm", "A5", "zero"]),
    "no side": ("sides_mm = [400, 300]", "sides_mm = [400, 0]", ["sides_mm", "A5", "positive"]),
    "too long for a triangle": ("zero_mm = 500", "zero_mm = 701", ["A5", "701", "between 100 and 700"]),
    "too short for a triangle": ("zero_mm = 500", "zero_mm = 99", ["A5", "99", "between 100 and 700"]),
    "unknown kind": ('kind = "gear"', 'kind = "belt"', ["belt", "actuators.drives"]),
    "unknown key": ("zero_deg = -30", "zero_deg = -30, stroke_mm = 3", ["stroke_mm", "actuators.drives"]),
    "unknown key of the table": ("drives = [", "motors = 5\ndrives = [", ["motors", "$.actuators"]),
    "missing key": (", length_at_zero_mm = 500", "", ["length_at_zero_mm", "actuators.drives"]),
    "not finite": ("pulses_per_deg = 100", "pulses_per_deg = inf", ["finite"]),
    "a joint that slides": (
        "limits_deg = [-120, 0]\nspeed_deg_s = 60",
        'kind = "prismatic"\nlimits_mm = [-120, 0]\nspeed_mm_s = 60',
        ["turn", "slide", "J3"],
    ),
}


def from_text(folder: Path, text: str) -> Robot:
    (folder / "robot.toml").write_text(text, "utf-8")
    return robot_from_folder(folder)


def test_a_file_says_the_actuators_and_one_without_has_none(tmp_path: Path) -> None:
    actuators = from_text(tmp_path, GOOD).actuators
    assert actuators
    assert actuators.labels[2] == "A3 (J2 + J3)"
    assert actuators.drives[4] == BallScrew((0.4, 0.3), 50_000, 0.5, math.radians(-30))
    assert from_text(tmp_path, PLAIN).actuators is None


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_one_line_that_names_its_place(tmp_path: Path, mistake: str) -> None:
    old, new, place = MISTAKES[mistake]
    assert old in GOOD
    with pytest.raises(HelicoideError) as caught:
        from_text(tmp_path, GOOD.replace(old, new, 1))
    said = caught.value.text.en
    assert "\n" not in said
    assert [word for word in ["robot.toml", *place] if word not in said] == []
