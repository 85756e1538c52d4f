"""Joints that follow others: on the arm, beside it, one after another; their leaders are its variables."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.benchmarks.corpus_tree import Tree
from tests.kinematics.arms import postures, twist_by_differences
from tests.kinematics.chains import TIP, led_from_beside, random_arm
from tests.kinematics.urdfs import chain_of, said

from helicoide.kinematics import differential
from helicoide.kinematics.chain import Mimic
from helicoide.kinematics.forward import FORMULATIONS, link_poses, tool_by_screws
from helicoide.kinematics.urdf_chain import robot_from_urdf
from helicoide.text import HelicoideError

KINDS = ("revolute", "prismatic")
LIMIT_OF_LEADER = '<limit lower="-0.25" upper="0.25" velocity="1"/>'
FOUR = chain_of(["base", "a", "b", "c", "d"])
BESIDE = '<link name="x"/><joint name="base-x" type="revolute"><parent link="base"/><child link="x"/>{limit}</joint>'


def following(folder: Path, mimics: dict[str, str], more: str = "") -> Path:
    """An arm of four joints a-b and so on, of which some follow others."""
    text = FOUR
    for child, mimic in mimics.items():
        text = text.replace(f'<child link="{child}"/>', f'<child link="{child}"/><mimic {mimic}/>')
    (path := folder / "four.urdf").write_text(f'<robot name="four">{text}{more}</robot>', "utf-8")
    return path


def test_what_follows_a_follower_follows_its_leader(tmp_path: Path) -> None:
    """x_c = −x_b + 0.3 and x_b = 2 x_a + 0.1: x_c = −2 x_a + 0.2."""
    mimics = {"c": 'joint="a-b" multiplier="-1" offset="0.3"', "b": 'joint="base-a" multiplier="2" offset="0.1"'}
    robot = robot_from_urdf(following(tmp_path, mimics))
    assert [joint.mimic for joint in robot.joints[:2]] == [None, Mimic(0, 2.0, 0.1)]
    third = robot.joints[2].mimic
    assert third is not None
    assert (third.driver, third.multiplier) == (0, -2.0)
    assert third.offset == pytest.approx(0.2)
    assert [joint.name for joint in robot.variables] == ["base-a", "c-d"]


def test_a_leader_may_come_after(tmp_path: Path) -> None:
    robot = robot_from_urdf(following(tmp_path, {"b": 'joint="c-d" multiplier="0.5"'}))
    assert robot.joints[1].mimic == Mimic(2, 0.5, 0.0)


LED = {"b": 'joint="base-x" multiplier="2" offset="0.1"', "d": 'joint="base-x" offset="-0.2"'}


def test_the_leader_beside_the_arm_is_one_variable(tmp_path: Path) -> None:
    """x_b = 2 z + 0.1 and x_d = z − 0.2 for z of −0.2 to 0.3, and |x| ≤ 1."""
    limit = '<limit lower="-0.2" upper="0.3" velocity="0.7"/>'
    robot = robot_from_urdf(following(tmp_path, LED, BESIDE.format(limit=limit)), "d")
    assert [variable.name for variable in robot.variables] == ["base-a", "b-c", "base-x"]
    assert [joint.mimic for joint in robot.joints] == [None, Mimic(2, 2.0, 0.1), None, Mimic(2, 1.0, -0.2)]
    assert (robot.lower[2], robot.upper[2], robot.speed[2]) == (-0.2, 0.3, 0.7)
    assert said(robot) == "the variable is base-x, which is not between base and tip; it is followed by a-b, c-d"


@pytest.mark.parametrize(
    ("limit", "lower", "upper"),
    [('<limit lower="-2" upper="2" velocity="1"/>', -0.55, 0.45), ('<limit lower="-2" upper="0.1"/>', -0.55, 0.1)],
)
def test_followers_narrow_a_leader_beside_the_arm(tmp_path: Path, limit: str, lower: float, upper: float) -> None:
    """−1 ≤ 2 z + 0.1 ≤ 1, and −1 ≤ z − 0.2 ≤ 1."""
    robot = robot_from_urdf(following(tmp_path, LED, BESIDE.format(limit=limit)), "d")
    assert (robot.lower[2], robot.upper[2]) == pytest.approx((lower, upper))
    assert ("speeds" in robot.assumed) == ("velocity" not in limit)


def test_a_range_that_followers_give_is_not_ours(tmp_path: Path) -> None:
    """−1 ≤ 2 z + 0.1 ≤ 1, and −1 ≤ z − 0.2 ≤ 1: the file bounds the leader, though not where it stands."""
    robot = robot_from_urdf(following(tmp_path, LED, BESIDE.format(limit='<limit velocity="1"/>')), "d")
    assert (robot.lower[2], robot.upper[2]) == pytest.approx((-0.55, 0.45))
    assert robot.assumed == ()
    assert "assumed" not in said(robot)


def test_limits_of_a_follower_that_leave_no_range_are_left_out_and_said(tmp_path: Path) -> None:
    """−1 ≤ 2 z + 0.1 ≤ 1 and −1 ≤ z − 0.2 ≤ 1, where the leader has 0.6 ≤ z ≤ 2: the first is left out."""
    robot = robot_from_urdf(
        following(tmp_path, LED, BESIDE.format(limit='<limit lower="0.6" upper="2" velocity="1"/>')), "d"
    )
    assert (robot.lower[2], robot.upper[2]) == pytest.approx((0.6, 1.2))
    assert "the limits of a-b leave no range for base-x, which it follows; they are ignored" in said(robot)


def test_a_follower_without_bounds_narrows_nothing(tmp_path: Path) -> None:
    follows = '<mimic joint="base-a" multiplier="0.1"/><limit lower="-1e16" upper="1e16"/>'
    path = following(tmp_path, {})
    at = '<child link="d"/><origin xyz="0.1 0 0"/><axis xyz="0 0 1"/>'
    text = path.read_text("utf-8").replace(f'{at}<limit lower="-1" upper="1" velocity="1"/>', at + follows)
    path.write_text(text.replace('lower="-1" upper="1"', 'lower="-100" upper="100"', 1), "utf-8")
    assert (robot_from_urdf(path).lower[0], robot_from_urdf(path).upper[0]) == (-100, 100)


def test_what_follows_a_follower_of_a_joint_beside_the_arm_follows_that(tmp_path: Path) -> None:
    """x_c = −x_b + 0.3 and x_b = 2 z + 0.1: x_c = −2 z + 0.2, whichever of b and c the arm has."""
    limit = '<limit lower="-0.2" upper="0.3" velocity="1"/>'
    mimics = {"b": LED["b"], "c": 'joint="a-b" multiplier="-1" offset="0.3"'}
    for base in (None, "b"):
        robot = robot_from_urdf(following(tmp_path, mimics, BESIDE.format(limit=limit)), "d", base)
        assert [variable.name for variable in robot.variables][-2:] == ["c-d", "base-x"]
        led = robot.joints[-2].mimic
        assert led is not None
        assert (led.driver, led.multiplier, led.offset) == (len(robot.variables) - 1, -2.0, pytest.approx(0.2))


def test_a_leader_above_the_base_is_a_variable(tmp_path: Path) -> None:
    robot = robot_from_urdf(following(tmp_path, {"c": 'joint="base-a" multiplier="2"'}), "d", "b")
    assert [variable.name for variable in robot.variables] == ["c-d", "base-a"]
    assert (robot.lower[1], robot.upper[1]) == (-0.5, 0.5)


@pytest.mark.parametrize("slides", [False, True])
def test_a_slide_that_follows_is_as_long_as_its_leader_lets_it(tmp_path: Path, slides: bool) -> None:
    """0.4 m of links, and |x_d| ≤ 0.5 m for |z| ≤ 0.25, rad or m."""
    path = following(tmp_path, {"d": 'joint="base-x" multiplier="-2"'}, BESIDE.format(limit=LIMIT_OF_LEADER))
    text = path.read_text("utf-8").replace('name="c-d" type="revolute"', 'name="c-d" type="prismatic"')
    path.write_text(text.replace('name="base-x" type="revolute"', f'name="base-x" type="{KINDS[slides]}"'), "utf-8")
    robot = robot_from_urdf(path, "d")
    assert robot.variables[-1].is_prismatic == slides
    assert robot.periodic.tolist() == [True, True, True, False]
    assert robot.reach == pytest.approx(0.3 + 0.5)


@settings(max_examples=30)
@given(st.integers(0, 2**32 - 1))
def test_arms_that_are_led_from_beside_move_as_their_files_say(seed: int) -> None:
    """Beside a reading that shares nothing with this one: all roads, the kernel, limits; and the Jacobian, derived."""
    robot, tree = random_arm(seed, beside=True), Tree(led_from_beside(seed))
    size = max(1.0, robot.reach)
    for q in postures(robot, 3, seed):
        values = {variable.name: float(x) for variable, x in zip(robot.variables, q, strict=True)}
        T = tree.pose(TIP, values)
        for pose in (
            *(road(robot, q) for road in FORMULATIONS.values()),
            link_poses(robot.chain, q)[-1] @ robot.T_link_tool,
        ):
            np.testing.assert_allclose(pose, T, rtol=0, atol=1e-11 * size)
        assert tree.beyond(TIP, values) < 1e-12 * size
        by_differences = twist_by_differences(lambda q: tool_by_screws(robot, q), q)
        np.testing.assert_allclose(differential.frame_jacobian(robot, q), by_differences, rtol=0, atol=1e-7 * size)


def test_what_follows_a_joint_that_is_fixed_is_fixed(tmp_path: Path) -> None:
    limit = '<limit lower="0.4" upper="0.4" velocity="1"/>'
    mimics = {"b": 'joint="base-x" multiplier="2" offset="0.1"'}
    robot = robot_from_urdf(following(tmp_path, mimics, BESIDE.format(limit=limit)), "d")
    assert [joint.name for joint in robot.joints] == ["base-a", "b-c", "c-d"]
    free = robot_from_urdf(following(tmp_path, {}), "d")
    np.testing.assert_allclose(
        tool_by_screws(robot, np.array([0.1, 0.2, 0.3])),
        tool_by_screws(free, np.array([0.1, 0.9, 0.2, 0.3])),
        atol=1e-15,
    )


@pytest.mark.parametrize(
    "mimics", [{"b": 'joint="a-b"'}, {"b": 'joint="b-c"', "c": 'joint="a-b"'}, {"b": 'joint="gone"'}, {"b": ""}]
)
def test_who_follows_nobody_is_refused_where_it_counts(tmp_path: Path, mimics: dict[str, str]) -> None:
    with pytest.raises(HelicoideError, match=r"'a-b' follows"):
        robot_from_urdf(following(tmp_path, mimics), "d")
    assert len(robot_from_urdf(following(tmp_path, mimics), "a").variables) == 1
