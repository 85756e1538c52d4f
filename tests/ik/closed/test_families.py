"""The families of methods of s.37: screws, dual quaternions, geometry and inverse transforms find the same postures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.ik.closed.small_arms import moved, reversed_axes

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler
from helicoide.ik import closed
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import LENGTHS, puma_with_lengths
from helicoide.text import HelicoideError

FAMILIES = {
    "puma560": ("puma560", "pieper", "geometry", "screws", "dual_quaternions"),
    "zebra_zero": ("pieper", "geometry", "screws", "dual_quaternions"),
    "movemaster": ("movemaster", "inverse_transform", "screws", "dual_quaternions"),
    "motoman_l3": ("motoman_l3", "movemaster", "screws", "dual_quaternions"),
}
BY = [(name, family) for name, families in FAMILIES.items() for family in families]


def found(family: str, robot: Robot, T: Array, q: Array) -> Answer:
    return closed.solve_closed_form(closed.closed_forms()[family], robot, T, q)


def apart(one: Answer, other: Answer) -> float:
    """The farthest that a posture of either is from the nearest of the other, rad."""
    ways = [[np.abs(wrap(a.q - b.q)).max() for b in other.branches] for a in one.branches]
    return float(max(np.min(ways, axis=0).max(), np.min(ways, axis=1).max()))


def random_kin(name: str, seed: int) -> Robot:
    """An arm as that one with other lengths, standing anywhere, with joints that count the other way."""
    draw = np.random.default_rng(seed)
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = euler.euler_matrix(draw.uniform(-1.5, 1.5, 3), "zyx"), draw.uniform(-1, 1, 3)
    if name == "puma560":
        robot = puma_with_lengths(
            *draw.uniform(0.1, 0.6, 4) * draw.choice([-1, 1], 4) * [0, 1, 1, 1] + [draw.uniform(0.2, 0.6), 0, 0, 0]
        )
        return reversed_axes(robot, *np.flatnonzero(draw.integers(0, 2, 6)))
    robot = load_robot(name)
    stretch = np.array([draw.uniform(0.5, 2), 1, draw.uniform(0.5, 2)])
    joints = tuple(replace(joint, point=frozen(joint.point * stretch)) for joint in robot.joints)
    T = robot.T_world_tool_0.copy()
    T[:3, 3] *= stretch
    robot = replace(robot, joints=joints, T_world_tool_0=frozen(T))
    return moved(reversed_axes(robot, *np.flatnonzero(draw.integers(0, 2, 5))), place)


@pytest.mark.parametrize("name", FAMILIES)
def test_which_apply_and_which_comes_first(name: str) -> None:
    assert tuple(closed.of(load_robot(name))) == FAMILIES[name]


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("seed", range(8))
def test_all_find_the_same_postures(name: str, seed: int) -> None:
    robot = load_robot(name)
    q = np.random.default_rng(seed).uniform(-3, 3, len(robot.joints))
    T = tool_at(robot, q)
    first, *others = (found(family, robot, T, np.zeros(len(q))) for family in FAMILIES[name])
    assert min(float(np.abs(wrap(branch.q - q)).max()) for branch in first.branches) < 1e-8
    for answer in others:
        assert apart(first, answer) < 1e-8
        assert max(max(branch.missed, branch.turned) for branch in answer.branches) < 1e-9
        assert len(answer.values) == len(answer.branches)


@given(st.sampled_from(["puma560", "movemaster", "motoman_l3"]), st.integers(0, 2**32 - 1))
def test_arms_by_chance_are_solved_by_screws_and_by_dual_quaternions(name: str, seed: int) -> None:
    robot = random_kin(name, seed)
    q = np.random.default_rng(seed).uniform(-3, 3, len(robot.joints))
    T = tool_at(robot, q)
    for family in ("screws", "dual_quaternions"):
        answer = found(family, robot, T, np.zeros(len(q)))
        assert min(float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches) < 1e-4
        assert max(max(branch.missed, branch.turned) for branch in answer.branches) < 1e-6


@pytest.mark.parametrize(("name", "family"), BY)
def test_out_of_reach_there_is_none_and_it_is_said_by_how_much(name: str, family: str) -> None:
    robot = load_robot(name)
    T = tool_at(robot, robot.poses["ready"]).copy()
    T[:3, 3] += [9, 1, 0]
    answer = found(family, robot, T, robot.poses["ready"])
    assert answer.branches == ()
    assert answer.short > 5


@pytest.mark.parametrize(("name", "family"), [(n, f) for n, f in BY if n in ("puma560", "zebra_zero")])
def test_a_singular_wrist_keeps_its_fourth_joint(name: str, family: str) -> None:
    robot = load_robot(name)
    q = np.array([0.3, -0.7, 0.4, 0.5, 0.0, -0.2])
    answer = found(family, robot, tool_at(robot, q), q)
    assert min(float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches) < 1e-6


@pytest.mark.parametrize("family", ["geometry", "inverse_transform", "screws", "dual_quaternions"])
def test_other_arms_are_refused_in_words(family: str) -> None:
    robot = load_robot("scara")
    assert closed.closed_forms()[family].applies(robot) is not None
    with pytest.raises(HelicoideError, match="This form needs"):
        found(family, robot, np.eye(4), robot.poses["ready"])


def test_three_data_sets_of_the_puma_have_eight_postures_by_every_family() -> None:
    for lengths in LENGTHS:
        robot = puma_with_lengths(*lengths)
        T = tool_at(robot, np.array([0.3, -0.5, 0.7, 0.4, 0.9, -1.1]))
        for family in ("geometry", "screws", "dual_quaternions"):
            assert len(found(family, robot, T, np.zeros(6)).branches) == 8
