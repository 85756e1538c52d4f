"""URDF files as people have them: what is in them that others read differently, and what each comes to."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.kinematics.urdfs import GOOD, chain_of, said, write

from helicoide.arrays import Array
from helicoide.kinematics.forward import FORMULATIONS, tool_by_screws
from helicoide.kinematics.robot import SMALLEST_REACH
from helicoide.kinematics.urdf_chain import robot_from_urdf
from helicoide.kinematics.urdf_limits import SLIDE
from helicoide.text import HelicoideError

LIMIT = '<limit lower="-1" upper="2" velocity="0.5"/>'
Q = np.array([0.7, 0.35])


def good_tool(folder: Path, q: Array = Q) -> Array:
    return tool_by_screws(robot_from_urdf(write(folder), "tool"), q)


@pytest.mark.parametrize(
    "content",
    [
        b"\xef\xbb\xbf" + GOOD.encode(),
        GOOD.encode("utf-16"),
        GOOD.encode("utf-16-le"),
        GOOD.encode("utf-32"),
        GOOD.replace('"1.0"?', '"1.0" encoding="utf-16"?').encode("utf-16"),
        GOOD.replace('"1.0"?', '"1.0" encoding="utf-16"?').encode(),
        GOOD.replace('"1.0"?', '"1.0" encoding="ISO-8859-1"?').replace("arm", "braço").encode("latin-1"),
        GOOD.replace('"1.0"?', '"1.0" encoding="windows-1252"?').replace("arm", "braço").encode("cp1252"),
        GOOD.replace('"1.0"?', '"1.0" encoding="gb2312"?').replace("arm", "机械臂").encode("gb2312"),
        GOOD.replace("arm", "braço").encode("latin-1"),
        b"\n \n<!-- made by a program -->" + GOOD.encode(),
        GOOD.replace("<robot ", '<robot xmlns="http://ros.org" ').encode(),
        GOOD.replace("\n", "\r\n").encode(),
        GOOD.replace("\n", "\r").encode(),
    ],
)
def test_a_file_is_read_in_the_encoding_that_it_has(tmp_path: Path, content: bytes) -> None:
    (path := tmp_path / "other.urdf").write_bytes(content)
    robot = robot_from_urdf(path, "tool")
    np.testing.assert_array_equal(tool_by_screws(robot, Q), good_tool(tmp_path))
    assert robot.title.en in ("arm", "braço", "机械臂")


@pytest.mark.parametrize(
    "more",
    [
        '<xacro:property name="a" value="1"/>',
        '<ros2_control name="s"><joint name="one"><command_interface name="position"/></joint></ros2_control>',
        '<transmission name="t"><joint name="nowhere"/></transmission>',
        '<gazebo reference="nowhere"><sensor:imu x="${y}"/></gazebo>',
        '<material name="grey"><color rgba="a b"/></material><material name="grey"/><material/>',
        "<!-- ${nothing} --><?program does?>",
    ],
)
def test_what_others_add_stops_no_arm(tmp_path: Path, more: str) -> None:
    robot = robot_from_urdf(write(tmp_path, "</robot>", more + "</robot>"), "tool")
    np.testing.assert_array_equal(tool_by_screws(robot, Q), good_tool(tmp_path))


@pytest.mark.parametrize(
    "inside",
    [
        '<inertial><mass value="nan"/><inertia ixx="-"/></inertial>',
        '<inertial><origin xyz="1 2"/></inertial>',
        '<collision><geometry><capsule radius="?"/></geometry></collision>',
        '<visual><geometry><box size="1 1 1"/></geometry><material name="m"><color rgba="1 2 3"/></material></visual>',
        '<visual><geometry><box size="1 1 1"/></geometry><material/></visual>',
    ],
)
def test_what_is_no_kinematics_of_a_link_stops_no_arm(tmp_path: Path, inside: str) -> None:
    robot = robot_from_urdf(write(tmp_path, '<link name="upper"/>', f'<link name="upper">{inside}</link>'), "tool")
    np.testing.assert_array_equal(tool_by_screws(robot, Q), good_tool(tmp_path))


def test_an_entity_of_the_file_is_filled_in_and_none_from_outside(tmp_path: Path) -> None:
    inside = GOOD.replace("<robot", '<!DOCTYPE robot [<!ENTITY h "0.3">]><robot', 1).replace("0.1 0 0.3", "0.1 0 &h;")
    (path := tmp_path / "entity.urdf").write_text(inside, "utf-8")
    np.testing.assert_array_equal(tool_by_screws(robot_from_urdf(path, "tool"), Q), good_tool(tmp_path))
    (tmp_path / "secret").write_text("here it is", "utf-8")
    outside = f'<!DOCTYPE robot [<!ENTITY h SYSTEM "file://{tmp_path}/secret">]><robot'
    for what in ('name="arm"', '<link name="tool"/>'):
        text = GOOD.replace("<robot", outside, 1).replace(what, what.replace("arm", "&h;").replace("/>", ">&h;</link>"))
        path.write_text(text, "utf-8")
        try:
            words = robot_from_urdf(path, "tool").title.en
        except HelicoideError as error:
            words = error.text.en
        assert "here it is" not in words


def test_entities_of_entities_end_soon(tmp_path: Path) -> None:
    many = "".join(f'<!ENTITY a{i} "{10 * f"&a{i - 1};"}">' for i in range(1, 12))
    text = GOOD.replace("<robot", f'<!DOCTYPE robot [<!ENTITY a0 "lol">{many}]><robot', 1).replace('"arm"', '"&a11;"')
    (path := tmp_path / "laughs.urdf").write_text(text, "utf-8")
    with pytest.raises(HelicoideError):
        robot_from_urdf(path, "tool")


def test_a_robot_without_a_name_is_called_as_its_file(tmp_path: Path) -> None:
    for robot in ("<robot>", '<robot name="">'):
        assert robot_from_urdf(write(tmp_path, '<robot name="arm">', robot)).title.en == "arm"


def test_commas_between_numbers_are_read(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, 'xyz="0.1 0 0.3"', 'xyz="0.1, 0,0.3"'), "tool")
    np.testing.assert_array_equal(tool_by_screws(robot, Q), good_tool(tmp_path))
    with pytest.raises(HelicoideError, match="origin xyz"):
        robot_from_urdf(write(tmp_path, 'xyz="0.1 0 0.3"', 'xyz="0,1 0 0,3"'))


def test_a_type_in_capitals_is_that_type(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, 'type="prismatic"', 'type=" PRISMATIC"'), "tool")
    np.testing.assert_array_equal(tool_by_screws(robot, Q), good_tool(tmp_path))


def test_an_unknown_type_is_not_passed_over_by_the_default_tip(tmp_path: Path) -> None:
    with pytest.raises(HelicoideError, match=r"'two'.*'hinge'.*revolute, continuous, prismatic, fixed, planar, float"):
        robot_from_urdf(write(tmp_path, 'type="prismatic"', 'type="hinge"'))
    assert robot_from_urdf(write(tmp_path, 'type="prismatic"', 'type="hinge"'), "upper").tool_link == "upper"


@pytest.mark.parametrize(
    ("limits", "expected"),
    [
        ("", (-SLIDE, SLIDE)),
        ('<limit effort="1" velocity="0.5"/>', (-SLIDE, SLIDE)),
        ('<limit lower="-inf" upper="inf" velocity="0.5"/>', (-SLIDE, SLIDE)),
        ('<limit lower="-1e16" upper="1e16"/>', (-SLIDE, SLIDE)),
        ('<limit lower="-1e6" upper="1e6"/>', (-SLIDE, SLIDE)),
        ('<limit lower="0" upper="1e6"/>', (0, SLIDE)),
        ('<limit lower="-1e6" upper="30"/>', (-SLIDE, 30)),
    ],
)
def test_limits_of_a_slide_that_bound_nothing_are_no_lengths(
    tmp_path: Path, limits: str, expected: tuple[float, float]
) -> None:
    robot = robot_from_urdf(write(tmp_path, LIMIT, limits), "tool")
    assert (robot.lower[1], robot.upper[1]) == expected
    assert [joint.assumed for joint in robot.joints] == [False, True]
    assert "limits" in robot.assumed
    assert "two" in said(robot)
    assert robot.reach == pytest.approx(0.6)  # 0.2 m and 0.4 m of links, whatever the slide does


def test_a_long_slide_that_is_bounded_is_a_length(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, 'upper="2"', 'upper="60"'), "tool")
    assert (robot.upper[1], robot.remarks, robot.assumed) == (60, (), ())
    assert robot.reach == pytest.approx(60.6)


@pytest.mark.parametrize("limits", ["", '<limit velocity="1"/>', '<limit lower="-1e16" upper="1e16"/>'])
def test_limits_of_a_turn_that_bound_nothing_are_two_turns(tmp_path: Path, limits: str) -> None:
    path = write(tmp_path, '<limit lower="-1.5" upper="1.5" velocity="1" effort="1"></limit>', limits)
    robot = robot_from_urdf(path, "tool")
    assert (robot.lower[0], robot.upper[0]) == pytest.approx((-2 * np.pi, 2 * np.pi))
    assert "one -360…360°" in said(robot)


def test_of_a_joint_that_turns_without_end_nothing_needs_to_be_said(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, 'type="revolute"', 'type="continuous"'), "tool")
    assert robot.remarks == ()
    assert robot.joints[0].assumed
    assert "limits" in robot.assumed


def test_a_limit_that_is_left_out_beside_another_is_zero(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, 'lower="-1" ', ""), "tool")
    assert (robot.lower[1], robot.upper[1], robot.remarks) == (0, 2, ())


@pytest.mark.parametrize("velocity", ["inf", "nan", "fast", "1e16"])
def test_a_speed_that_is_none_is_ours(tmp_path: Path, velocity: str) -> None:
    robot = robot_from_urdf(write(tmp_path, 'velocity="0.5"', f'velocity="{velocity}"'), "tool")
    assert robot.assumed == ("speeds",)
    assert np.isfinite(robot.speed).all()


def test_a_joint_whose_limits_are_one_value_stands_there(tmp_path: Path) -> None:
    for value in (0.0, 0.35):
        robot = robot_from_urdf(write(tmp_path, 'lower="-1" upper="2"', f'lower="{value}" upper="{value}"'), "tool")
        assert [joint.name for joint in robot.joints] == ["one"]
        tool = tool_by_screws(robot, np.array([0.7]))
        np.testing.assert_allclose(tool, good_tool(tmp_path, np.array([0.7, value])), atol=1e-15)
        assert "two" in said(robot)


def test_an_arm_that_its_limits_hold_says_so(tmp_path: Path) -> None:
    path = write(tmp_path)
    text = GOOD.replace('lower="-1" upper="2"', 'lower="1" upper="1"').replace("-1.5", "1.5")
    path.write_text(text, "utf-8")
    with pytest.raises(HelicoideError, match="lower and upper of one, two are the same"):
        robot_from_urdf(path)


@pytest.mark.parametrize("kind", ["planar", "floating"])
def test_an_arm_on_a_free_base_begins_above_it(tmp_path: Path, kind: str) -> None:
    text = GOOD.replace("<link ", '<link name="world"/><link ', 1)
    joint = f'<joint name="free" type="{kind}"><parent link="world"/><child link="base"/><origin xyz="9 9 9"/></joint>'
    (path := tmp_path / "free.urdf").write_text(text.replace("</robot>", f"{joint}</robot>"), "utf-8")
    for base in (None, "base"):
        robot = robot_from_urdf(path, "tool", base)
        assert robot.base_link == "base"
        np.testing.assert_array_equal(tool_by_screws(robot, Q), good_tool(tmp_path))
        assert ("free" in said(robot)) == (base is None)
    with pytest.raises(HelicoideError, match=f"'free' is of type '{kind}'"):
        robot_from_urdf(path, "tool", "world")


def test_a_base_begins_the_chain_later(tmp_path: Path) -> None:
    whole, later = robot_from_urdf(write(tmp_path), "tool"), robot_from_urdf(write(tmp_path), "tool", "upper")
    assert [joint.name for joint in later.joints] == ["two"]
    upper = tool_by_screws(robot_from_urdf(write(tmp_path), "upper"), Q[:1])
    for road in FORMULATIONS.values():
        np.testing.assert_allclose(upper @ road(later, Q[1:]), tool_by_screws(whole, Q), atol=1e-14)
    for tip, base in (("upper", "tool"), ("tool", "nowhere"), (None, "nowhere"), (None, "tool")):
        with pytest.raises(HelicoideError, match=base):
            robot_from_urdf(write(tmp_path), tip, base)


def test_a_link_that_no_joint_holds_is_left_out(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, "</robot>", '<link name="table"/></robot>'), "tool")
    assert "table" in said(robot)


@pytest.mark.parametrize("height", [0.0, 0.3])
def test_an_arm_that_reaches_nowhere_has_a_size(tmp_path: Path, height: float) -> None:
    text = chain_of(["base", "plate"]).replace('xyz="0.1 0 0"', f'xyz="0 0 {height}"')
    (path := tmp_path / "plate.urdf").write_text(f'<robot name="plate">{text}</robot>', "utf-8")
    robot = robot_from_urdf(path)
    assert robot.stretched_length < SMALLEST_REACH
    assert robot.fixed_tool_point
    assert robot.reach == pytest.approx(height or 0.5)
    assert not robot_from_urdf(write(tmp_path), "tool").fixed_tool_point


def test_millimetres_are_suspected(tmp_path: Path) -> None:
    assert "millimetres" in said(robot_from_urdf(write(tmp_path, 'xyz="0.2 0 0"', 'xyz="420 0 0"'), "tool"))
