"""Which chain of a URDF is the arm, and what its file leaves open."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.kinematics.urdfs import chain_of, write

from helicoide.kinematics.chain import Mimic
from helicoide.kinematics.forward import FORMULATIONS
from helicoide.kinematics.urdf_chain import SLIDE_SPEED, SPEED, robot_from_urdf
from helicoide.text import HelicoideError

MIMIC = '<mimic joint="one" multiplier="-2" offset="0.5"/>'
LIMIT = '<limit lower="-1" upper="2" velocity="0.5"/>'


def urdf(folder: Path, *chains: list[str], more: str = "") -> Path:
    """A robot of chains that begin at links of chains before."""
    known: set[str] = set()
    parts = []
    for chain in chains:
        part = chain_of(chain)
        for link in known & set(chain):
            part = part.replace(f'<link name="{link}"/>', "", 1)
        parts.append(part)
        known |= set(chain)
    (path := folder / "robot.urdf").write_text(f'<robot name="robot">{"".join(parts)}{more}</robot>', "utf-8")
    return path


def fixed(parent: str, child: str) -> str:
    joint = f'<joint name="{child}" type="fixed"><parent link="{parent}"/><child link="{child}"/></joint>'
    return f'<link name="{child}"/>{joint}'


def test_the_chain_is_read_as_it_is_written(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path), "tool")
    one, two = robot.joints
    assert (robot.name, robot.title.en, robot.source) == ("arm", "arm", "arm.urdf: tool")
    assert [joint.name for joint in robot.variables] == ["one", "two"]
    assert (one.kind, one.link, one.lower, one.upper, one.speed) == ("revolute", "upper", -1.5, 1.5, 1)
    assert (two.kind, two.link, two.lower, two.upper, two.speed) == ("prismatic", "lower", -1, 2, 0.5)
    np.testing.assert_allclose(robot.points, [[0.1, 0, 0.3], [0.3, 0, 0.3]], atol=1e-15)


def test_the_tool_of_the_small_arm_by_hand(tmp_path: Path) -> None:
    """A turn by q1, then q2 along y' and 0.4 m along z' of axes that roll, pitch and yaw give."""
    robot, (q1, q2) = robot_from_urdf(write(tmp_path), "tool"), (0.7, 0.35)
    (cr, cp, cy), (sr, sp, sy) = np.cos([0.1, 0.2, 0.3]), np.sin([0.1, 0.2, 0.3])
    along_y = np.array([sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, sr * cp])
    along_z = np.array([cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp])
    x, y, z = np.array([0.2, 0, 0]) + q2 * along_y + 0.4 * along_z
    c, s = np.cos(q1), np.sin(q1)
    for road in FORMULATIONS.values():
        position = road(robot, np.array([q1, q2]))[:3, 3]
        np.testing.assert_allclose(position, [0.1 + c * x - s * y, s * x + c * y, 0.3 + z], atol=1e-12)


def test_axes_become_unit_vectors(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, '<axis xyz="0 0 1"/>', '<axis xyz="0 0 20"/>'))
    np.testing.assert_allclose(robot.joints[0].direction, [0, 0, 1])


def test_an_axis_that_is_not_given_is_x(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, '<axis xyz="0 0 1"/>', ""))
    np.testing.assert_allclose(robot.joints[0].direction, [1, 0, 0])


def test_the_arm_follows_the_longest_branch(tmp_path: Path) -> None:
    path = urdf(tmp_path, ["base", "a", "b", "c"], ["a", "camera"])
    assert robot_from_urdf(path).tool_link == "c"
    assert [joint.link for joint in robot_from_urdf(path, "camera").joints] == ["a", "camera"]


def test_the_arm_ends_where_fingers_begin(tmp_path: Path) -> None:
    path = urdf(tmp_path, ["base", "a", "b", "left"], ["b", "right"])
    assert robot_from_urdf(path).tool_link == "b"


@pytest.mark.parametrize(
    ("link", "expected"), [("tool0", "tool0"), ("b_tcp", "b_tcp"), ("cover", "b"), ("footool", "b")]
)
def test_a_fixed_link_that_is_called_a_tool_is_the_tool(tmp_path: Path, link: str, expected: str) -> None:
    path = urdf(tmp_path, ["base", "a", "b"], more=fixed("b", "plate") + fixed("plate", link))
    assert robot_from_urdf(path).tool_link == expected


@pytest.mark.parametrize(
    ("tip", "words"),
    [(None, ["--tip", "left", "right"]), ("arm", ["'arm'", "base, left, right"]), ("base", ["'base'", "0 moving"])],
)
def test_where_the_arm_ends_must_be_clear(tmp_path: Path, tip: str | None, words: list[str]) -> None:
    path = urdf(tmp_path, ["base", "left"], ["base", "right"])
    with pytest.raises(HelicoideError) as caught:
        robot_from_urdf(path, tip)
    for text in (caught.value.text.en, caught.value.text.pt_BR):
        assert len(text.splitlines()) == 1
        assert str(path) in text
    assert [word for word in words if word not in caught.value.text.en] == []


def test_a_robot_that_cannot_move_is_no_arm(tmp_path: Path) -> None:
    with pytest.raises(HelicoideError, match="no moving joints"):
        robot_from_urdf(urdf(tmp_path, ["base"], more=fixed("base", "tool")))


@pytest.mark.parametrize(("count", "fits"), [(30, True), (31, False)])
def test_an_arm_has_at_most_thirty_joints(tmp_path: Path, count: int, fits: bool) -> None:
    path = urdf(tmp_path, [f"link{i}" for i in range(count + 1)])
    if fits:
        assert len(robot_from_urdf(path).variables) == count
        return
    with pytest.raises(HelicoideError, match="31 moving joints"):
        robot_from_urdf(path)


@pytest.mark.parametrize("velocity", ["", 'velocity="0"', 'velocity="-1"'])
def test_a_speed_that_is_missing_is_ours(tmp_path: Path, velocity: str) -> None:
    assert robot_from_urdf(write(tmp_path, 'velocity="0.5"', velocity)).speed.tolist() == [1, SLIDE_SPEED]
    assert robot_from_urdf(write(tmp_path, 'velocity="1"', velocity)).speed.tolist() == [SPEED, 0.5]


def test_a_continuous_joint_turns_twice(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, 'type="revolute"', 'type="continuous"'))
    assert (robot.lower[0], robot.upper[0]) == pytest.approx((-2 * np.pi, 2 * np.pi))


def test_a_joint_that_follows_narrows_what_it_follows(tmp_path: Path) -> None:
    """−1 ≤ −2 q + 0.5 ≤ 2 leaves −0.75 ≤ q ≤ 0.75 of ±1.5."""
    robot = robot_from_urdf(write(tmp_path, LIMIT, LIMIT + MIMIC))
    assert robot.joints[1].mimic == Mimic(0, -2.0, 0.5)
    assert [joint.name for joint in robot.variables] == ["one"]
    assert (robot.lower[0], robot.upper[0]) == (-0.75, 0.75)


def test_followers_are_not_counted_among_the_variables(tmp_path: Path) -> None:
    path = urdf(tmp_path, ["base", "a", "b", "c", "d"])
    text = path.read_text("utf-8")
    for link, driver in (("b", "base-a"), ("d", "b-c")):
        text = text.replace(f'<child link="{link}"/>', f'<child link="{link}"/><mimic joint="{driver}"/>')
    path.write_text(text, "utf-8")
    robot = robot_from_urdf(path)
    assert [joint.link for joint in robot.variables] == ["a", "c"]
    assert [joint.mimic for joint in robot.joints] == [None, Mimic(0, 1.0, 0.0), None, Mimic(1, 1.0, 0.0)]


def test_ratio_and_shift_of_a_follower_may_be_left_out(tmp_path: Path) -> None:
    robot = robot_from_urdf(write(tmp_path, LIMIT, LIMIT + '<mimic joint="one"/>'))
    assert robot.joints[1].mimic == Mimic(0, 1.0, 0.0)


@pytest.mark.parametrize(
    ("limits", "value"), [('lower="-1" upper="2"', 0), ('lower="0" upper="2"', 1), ('lower="-3" upper="-1"', -2)]
)
def test_ready_is_zero_or_the_middle_of_the_range(tmp_path: Path, limits: str, value: float) -> None:
    robot = robot_from_urdf(write(tmp_path, 'lower="-1" upper="2"', limits))
    assert robot.poses["ready"].tolist() == [0, value]
