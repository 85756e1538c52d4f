"""URDF files that the tests write: a small arm, the same with one mistake, and long chains."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

from helicoide.kinematics.robot import Robot

GOOD = """<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/><link name="upper"/><link name="lower"/><link name="tool"/>
  <joint name="one" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0.1 0 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-1.5" upper="1.5" velocity="1" effort="1"></limit>
  </joint>
  <joint name="two" type="prismatic">
    <parent link="upper"/><child link="lower"/><origin xyz="0.2 0 0" rpy="0.1 0.2 0.3"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="2" velocity="0.5"/>
  </joint>
  <joint name="end" type="fixed">
    <parent link="lower"/><child link="tool"/><origin xyz="0 0 0.4"/>
  </joint>
</robot>
"""


def chain_of(links: list[str]) -> str:
    """Links, and a joint from each to the next that turns around z, 0.1 m along x."""
    joints = [
        f'<joint name="{a}-{b}" type="revolute"><parent link="{a}"/><child link="{b}"/><origin xyz="0.1 0 0"/>'
        '<axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1"/></joint>'
        for a, b in pairwise(links)
    ]
    return "".join([*(f'<link name="{link}"/>' for link in dict.fromkeys(links)), *joints])


# what is replaced in the good file, by what, and the words that name the place
MISTAKES = {
    "a link without a name": ('<link name="upper"/>', "<link/>", ["link", "name"]),
    "two links of one name": ('<link name="upper"/>', '<link name="upper"/><link name="upper"/>', ["link 'upper'"]),
    "two joints of one name": ('<joint name="two"', '<joint name="one"', ["joint 'one'", "name"]),
    "no parent": ('<parent link="upper"/>', "", ["'two'", "parent"]),
    "no child": ('<child link="lower"/>', "<child/>", ["'two'", "child"]),
    "an unknown link": ('<child link="lower"/>', '<child link="nowhere"/>', ["'two'", "'nowhere'"]),
    "two parents": ('<parent link="lower"/><child link="tool"/>', '<parent link="base"/><child link="lower"/>',
                    ["'lower'", "'upper'", "'base'"]),
    "two roots": ("</robot>", chain_of(["table", "leg"]) + "</robot>", ["base", "table"]),
    "a cycle": ('<parent link="base"/>', '<parent link="lower"/>', ["upper → lower → upper"]),
    "a cycle beside the arm": ("</robot>", chain_of(["p", "q", "p"]) + "</robot>", ["q → p → q"]),
    "nan in an origin": ('xyz="0.1 0 0.3"', 'xyz="0.1 nan 0.3"', ["'one'", "origin xyz", "nan"]),
    "nan in an axis": ('<axis xyz="0 1 0"/>', '<axis xyz="0 nan 0"/>', ["'two'", "axis", "nan"]),
    "nan in a limit": ('upper="2"', 'upper="nan"', ["'two'", "limit upper", "nan"]),
    "a word for a number": ('lower="-1"', 'lower="low"', ["'two'", "limit lower", "low"]),
    "two numbers for three": ('<axis xyz="0 1 0"/>', '<axis xyz="0 1"/>', ["'two'", "axis", "0 1", "3"]),
    "xacro in a number": ('xyz="0.2 0 0"', 'xyz="${l} 0 0"', ["'two'", "origin xyz", "xacro"]),
    "xacro in a name": ('<link name="tool"/>', '<link name="${prefix}tool"/>', ["${prefix}tool", "xacro"]),
    "too far for any number": ('xyz="0.1 0 0.3"', 'xyz="1e300 0 0.3"', ["'one'", "origin xyz", "1e300"]),
    "xacro": ("</robot>", '<xacro:arm xmlns:xacro="http://ros.org/wiki/xacro"/></robot>', ["xacro"]),
    "broken XML": ('<link name="tool"/>', '<link name="tool">', ["line", "column"]),
    "a zero axis": ('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>', ["'two'", "axis", "zero"]),
    "limits swapped": ('lower="-1"', 'lower="3"', ["'two'", "3 to 2", "below"]),
    "a floating joint": ('type="prismatic"', 'type="floating"', ["'two'", "'floating'", "prismatic"]),
    "a planar joint": ('name="end" type="fixed"', 'name="end" type="planar"', ["'end'", "'planar'", "prismatic"]),
    "an unknown type": ('type="prismatic"', 'type="hinge"', ["'two'", "'hinge'", "prismatic"]),
    "a joint without a type": ('name="end" type="fixed"', 'name="end"', ["'end'", "type", "prismatic"]),
    "an unknown driver": ('velocity="0.5"/>', 'velocity="0.5"/><mimic joint="three"/>', ["'two'", "'three'"]),
    "a driver beyond itself": ('velocity="0.5"/>', 'velocity="0.5"/><mimic joint="two"/>', ["'two'"]),
}  # fmt: skip


def write(folder: Path, old: str = "", new: str = "") -> Path:
    """The arm as a file, with one thing changed."""
    path = folder / "arm.urdf"
    path.write_text(GOOD.replace(old, new, 1) if old else GOOD, "utf-8")
    return path


def said(robot: Robot) -> str:
    """The remarks of a robot, in one line; fails where one is not in two languages, or not a single line."""
    for text in robot.remarks:
        assert text.en != text.pt_BR
        assert len(text.en.splitlines()) == len(text.pt_BR.splitlines()) == 1
    return " ".join(text.en for text in robot.remarks)
