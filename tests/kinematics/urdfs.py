"""URDF files that the tests write: a small arm, the same with one thing changed, and long chains."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

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


def write(folder: Path, old: str = "", new: str = "") -> Path:
    """The arm as a file, with one thing changed."""
    path = folder / "arm.urdf"
    path.write_text(GOOD.replace(old, new, 1) if old else GOOD, "utf-8")
    return path


def chain_of(links: list[str]) -> str:
    """Links, and a joint from each to the next that turns around z, 0.1 m along x."""
    joints = [
        f'<joint name="{a}-{b}" type="revolute"><parent link="{a}"/><child link="{b}"/><origin xyz="0.1 0 0"/>'
        '<axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1"/></joint>'
        for a, b in pairwise(links)
    ]
    return "".join([*(f'<link name="{link}"/>' for link in dict.fromkeys(links)), *joints])
