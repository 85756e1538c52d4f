"""Where an arm ends whose tip nobody gives: at its tool, not at a jaw of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.kinematics.urdfs import chain_of

from helicoide.kinematics.urdf_chain import robot_from_urdf


@pytest.mark.parametrize(
    ("links", "expected"),
    [
        (["left_EndEffector", "cover"], "left_EndEffector"),
        (["link_eef"], "link_eef"),
        (["gripper_base", "fingertip"], "gripper_base"),
        (["Tip"], "Tip"),
        (["tipper", "handle", "legend"], "b"),
        (["gripper", "tool_frame"], "tool_frame"),
    ],
)
def test_the_tool_is_known_by_what_it_is_called(tmp_path: Path, links: list[str], expected: str) -> None:
    more = "".join(
        f'<link name="{link}"/><joint name="to-{link}" type="fixed"><parent link="b"/><child link="{link}"/></joint>'
        for link in links
    )
    text = f'<robot name="three">{chain_of(["base", "a", "b"])}{more}</robot>'
    (path := tmp_path / "three.urdf").write_text(text, "utf-8")
    assert robot_from_urdf(path).tool_link == expected


def test_the_tool_may_be_beside_the_fingers(tmp_path: Path) -> None:
    """Where the fingers hang on another link that is fixed to the same one as the tool."""
    fixed = '<joint name="to-{0}" type="fixed"><parent link="a"/><child link="{0}"/></joint>'
    fingers = chain_of(["fork", "left"]) + chain_of(["fork", "right"]).replace('<link name="fork"/>', "")
    more = '<link name="tool0"/>' + fixed.format("tool0") + fixed.format("fork") + fingers
    (path := tmp_path / "fork.urdf").write_text(f'<robot name="r">{chain_of(["base", "a"])}{more}</robot>', "utf-8")
    assert robot_from_urdf(path).tool_link == "tool0"


SHUTS = '<limit lower="0" upper="1.7" velocity="1"/>'


@pytest.mark.parametrize(
    ("links", "moved", "limit", "expected"),
    [
        (["gripper"], ["jaw"], SHUTS, "gripper"),
        (["hand", "palm"], ["jaw"], SHUTS, "hand"),
        (["body", "stator_gripper"], ["mover_gripper"], SHUTS, "stator_gripper"),
        (["body", "Fixed_Jaw_tip"], ["Jaw", "Jaw_tip"], SHUTS, "Fixed_Jaw_tip"),
        (["gripper"], ["jaw"], '<limit lower="-3" upper="3" velocity="1"/>', "jaw"),
        (["gripper"], ["jaw"], "", "jaw"),
        (["gripper_mount"], ["wrist", "tool0"], SHUTS, "tool0"),
        (["wrist"], ["last"], SHUTS, "last"),
        (["left_hand_thumb"], ["left_hand_tip"], SHUTS, "left_hand_tip"),
    ],
)
def test_a_last_joint_that_shuts_the_tool_is_no_joint_of_the_arm(
    tmp_path: Path, links: list[str], moved: list[str], limit: str, expected: str
) -> None:
    """base – a – what one joint carries – what the last one does; a hand alone is called so from its beginning."""
    begin = "left_hand_base" if "left" in links[0] else "a"
    fixed = '<joint name="to-{1}" type="fixed"><parent link="{0}"/><child link="{1}"/></joint>'
    last = (
        f'<joint name="last" type="revolute"><parent link="{links[0]}"/><child link="{moved[0]}"/>'
        f'<origin xyz="0.1 0 0"/><axis xyz="0 0 1"/>{limit}</joint>'
    )
    more = "".join(f'<link name="{name}"/>' for name in (*links[1:], *moved))
    more += "".join(fixed.format(part[0], name) for part in (links, moved) for name in part[1:])
    text = f'<robot name="r">{chain_of(["base", begin, links[0]])}{more}{last}</robot>'
    (path := tmp_path / "jaw.urdf").write_text(text, "utf-8")
    assert robot_from_urdf(path).tool_link == expected


def test_a_jaw_beyond_the_tool_is_no_joint_of_the_arm(tmp_path: Path) -> None:
    arm = chain_of(["base", "a", "tool0"])
    jaw = chain_of(["tool0", "jaw"]).replace("revolute", "prismatic").replace('<link name="tool0"/>', "")
    (path := tmp_path / "jaw.urdf").write_text(f'<robot name="r">{arm}{jaw}</robot>', "utf-8")
    assert robot_from_urdf(path).tool_link == "tool0"
