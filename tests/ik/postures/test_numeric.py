"""The numerical solver: what it answers is where it should be, it finds what there is, and always the same."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import MIXED, NAMES, arm, postures

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.ik import closed
from helicoide.ik.postures import descent, errors, numeric, packed, restarts
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import between, tool_at, wrap
from helicoide.kinematics import tool_kernels
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import tool_jacobian, tool_pose
from helicoide.text import HelicoideError

MEASURED = ("puma560", "panda", "ur5", "movemaster")
each_arm = pytest.mark.parametrize("name", NAMES)


def robot_of(name: str) -> Robot:
    return arm(name) if name in NAMES else load_robot(name)


def failures(robot: Robot, count: int, seed: int = 0) -> list[Array]:
    """Of random reachable poses the postures that led to those that are not found, within the limits and to 10⁻⁶."""
    failed = []
    for q in postures(robot, count, seed):
        goal = tool_at(robot, q)
        found = numeric.first_posture(robot, goal, robot.poses["ready"])[:-4]
        missed, turned = between(goal, tool_at(robot, found))
        kept = (found >= robot.lower - 1e-12) & (found <= robot.upper + 1e-12)
        if missed > 1.001e-6 or turned > 1.001e-6 or not kept.all():
            failed.append(q)
    return failed


def alike(robot: Robot, a: Array, b: Array, tolerance: float) -> bool:
    slides = [joint.is_prismatic for joint in robot.variables]
    return bool(np.abs(np.where(slides, a - b, wrap(a - b))).max() < tolerance)


def same_postures(robot: Robot, one: Answer, other: Answer, tolerance: float) -> bool:
    return len(one.branches) == len(other.branches) and all(
        any(alike(robot, a.q, b.q, tolerance) for b in other.branches) for a in one.branches
    )


@pytest.mark.parametrize("name", MEASURED)
def test_every_reachable_pose_is_reached_within_the_limits(name: str) -> None:
    assert failures(robot_of(name), 200) == []


@each_arm
def test_so_it_is_with_every_robot(name: str) -> None:
    assert failures(arm(name), 20, seed=1) == []


@each_arm
def test_a_position_alone_is_reached(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 20, seed=2):
        goal = tool_at(robot, q)
        branch = numeric.solve_numerically(robot, goal, robot.poses["ready"], with_orientation=False).branches[0]
        assert between(goal, tool_at(robot, branch.q))[0] < 1.001e-6
        assert branch.within
        assert branch.turned < 1e-12


@each_arm
def test_every_listed_posture_reaches_the_goal_and_none_comes_twice(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 3, seed=3):
        goal = tool_at(robot, q)
        branches = numeric.branches(robot, goal, robot.poses["ready"]).branches
        assert branches
        for i, branch in enumerate(branches):
            assert max(between(goal, tool_at(robot, branch.q))) < 2e-9
            assert not any(alike(robot, branch.q, other.q, 1e-3) for other in branches[:i])


@pytest.mark.parametrize("name", ["puma560", "panda", "movemaster"])
def test_the_posture_that_a_pose_comes_from_is_the_first(name: str) -> None:
    robot = robot_of(name)
    for q in postures(robot, 5, seed=4):
        branches = numeric.branches(robot, tool_at(robot, q), q).branches
        assert np.abs(branches[0].q - q).max() < 1e-6
        assert [branch.name.en for branch in branches] == [f"posture {n + 1}" for n in range(len(branches))]
        assert [branch.name.pt_BR for branch in branches] == [f"postura {n + 1}" for n in range(len(branches))]
        kept = [branch.within for branch in branches]
        assert kept == sorted(kept, reverse=True)
        ways = [np.abs(wrap(branch.q - q)).sum() for branch in branches if branch.within]
        assert ways == sorted(ways)


def test_all_eight_postures_of_the_puma_are_found() -> None:
    robot = arm("puma560")
    form = closed.closed_forms()["puma560"]
    for q in postures(robot, 20, seed=5):
        goal = tool_at(robot, q)
        known = closed.solve_closed_form(form, robot, goal, q)
        assert len(known.branches) == 8
        assert same_postures(robot, numeric.branches(robot, goal, q), known, 1e-6)


def test_the_same_question_has_the_same_answer() -> None:
    robot = arm("puma560")
    for q in postures(robot, 5, seed=6):
        goal = tool_at(robot, q)
        np.testing.assert_array_equal(
            numeric.first_posture(robot, goal, robot.poses["ready"]),
            numeric.first_posture(robot, goal, robot.poses["ready"]),
        )
        lists = [numeric.branches(robot, goal, q).branches for _ in range(2)]
        np.testing.assert_array_equal([b.q for b in lists[0]], [b.q for b in lists[1]])


def at(x: float, y: float, z: float) -> Array:
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


def missed(robot: Robot, T: Array) -> float:
    answer = numeric.solve_numerically(robot, T, robot.poses["ready"], with_orientation=False)
    assert answer.branches[0].within
    assert answer.short == pytest.approx(answer.branches[0].missed, rel=1e-12)
    assert between(T, tool_at(robot, answer.branches[0].q))[0] == pytest.approx(answer.short, abs=1e-12)
    return answer.short


@pytest.mark.parametrize("beyond", [1e-3, 0.1, 10.0])
def test_beyond_the_edge_the_nearest_point_is_that_of_geometry(beyond: float) -> None:
    two, five = arm("planar2r"), arm("movemaster")
    l1, l2 = np.linalg.norm(np.diff([*two.points, two.T_world_tool_0[:3, 3]], axis=0), axis=1)
    direction = np.array([np.cos(0.7), np.sin(0.7)])
    assert missed(two, at(*((l1 + l2 + beyond) * direction), 0)) == pytest.approx(beyond, rel=1e-6)
    assert missed(two, at(0.3 * l1, 0, beyond)) == pytest.approx(beyond, rel=1e-6)
    shoulder, length = np.array([0.12, 0, 0.4]), 0.25 + 0.2 + 0.25
    place = shoulder + (length + beyond) * np.array([direction[0], 0, direction[1]])
    assert missed(five, at(*place)) == pytest.approx(beyond, rel=1e-6)


def test_inside_the_hole_of_an_arm_the_nearest_point_is_on_its_rim() -> None:
    robot = arm("planar2r")
    l1, l2 = np.linalg.norm(np.diff([*robot.points, robot.T_world_tool_0[:3, 3]], axis=0), axis=1)
    hole = abs(l1 - l2)
    assert hole > 0.01
    assert missed(robot, at(0.6 * hole, 0, 0)) == pytest.approx(0.4 * hole, rel=1e-5)


def test_of_several_minima_the_least_is_taken() -> None:
    """Behind the Movemaster, which turns by ±90° only: none of many postures within the limits comes nearer."""
    robot = arm("movemaster")
    places = np.array([tool_at(robot, q)[:3, 3] for q in postures(robot, 4000)])
    for place in np.random.default_rng(1).uniform([-0.5, -0.2, 0.1], [-0.25, 0.2, 0.9], (10, 3)):
        assert missed(robot, at(*place)) <= np.linalg.norm(places - place, axis=1).min()


def test_a_slide_stops_at_its_limit() -> None:
    robot = arm("scara")
    goal = tool_at(robot, robot.poses["ready"]).copy()
    low = tool_at(robot, frozen([*robot.poses["ready"][:2], robot.upper[2], robot.poses["ready"][3]]))
    goal[:3, 3] = low[:3, 3] - [0, 0, 0.03]
    answer = numeric.solve_numerically(robot, goal, robot.poses["ready"])
    assert answer.branches[0].within
    assert answer.short == pytest.approx(0.03, rel=1e-6)
    assert answer.branches[0].q[2] == pytest.approx(robot.upper[2], abs=1e-9)


def test_what_only_postures_beyond_the_limits_reach_is_said() -> None:
    robot = arm("movemaster")
    behind = robot.poses["ready"] + np.array([np.pi, 0, 0, 0, 0])
    goal = tool_at(robot, behind)
    answer = numeric.solve_numerically(robot, goal, robot.poses["ready"])
    assert answer.branches[0].within
    assert answer.short > 0.1
    assert "outside the joint limits" in answer.words.en
    every = numeric.branches(robot, goal, robot.poses["ready"]).branches
    assert any(alike(robot, branch.q, behind, 1e-6) for branch in every)
    assert not any(branch.within for branch in every)


def test_the_position_comes_first_where_five_joints_cannot_turn_the_tool() -> None:
    robot = arm("movemaster")
    goal = tool_at(robot, robot.poses["ready"]).copy()
    goal[:3, :3] = rotation.exponential(np.array([0, 0, 0.3])) @ goal[:3, :3]
    branch = numeric.solve_numerically(robot, goal, robot.poses["ready"]).branches[0]
    assert branch.missed < 1e-3
    assert 0.1 < branch.turned < 0.31
    poses = [tool_at(robot, branch.q + 1e-3 * step) for step in np.random.default_rng(0).normal(size=(200, 5))]
    weight = numeric.ORIENTATION_LENGTH * robot.reach
    least = np.hypot(branch.missed, weight * branch.turned)
    assert all(np.hypot(moved, weight * turned) > least for moved, turned in (between(goal, T) for T in poses))


def wrist_aligned() -> tuple[Robot, Array]:
    robot = arm("puma560")
    q = np.array([0.3, -1.0, 0.2, 0.4, 0.0, -0.5])
    return robot, q


def stretched() -> tuple[Robot, Array]:
    return arm("planar2r"), np.array([0.4, 0.0])


def seven_joints() -> tuple[Robot, Array]:
    return load_robot("panda"), load_robot("panda").poses["ready"]


def ordinary() -> tuple[Robot, Array]:
    return arm("puma560"), np.array([0.3, -1.0, 0.2, 0.4, 0.8, -0.5])


@pytest.mark.parametrize(
    ("case", "endless"), [(wrist_aligned, True), (seven_joints, True), (stretched, False), (ordinary, False)]
)
def test_families_of_postures_are_told_from_postures_that_meet(
    case: Callable[[], tuple[Robot, Array]], endless: bool
) -> None:
    robot, q = case()
    answer = numeric.branches(robot, tool_at(robot, q), q)
    assert ("infinitely many" in answer.words.en) == endless
    assert ("infinitas" in answer.words.pt_BR) == endless
    if endless:
        assert len(answer.branches) == numeric.MOST


def test_a_joint_at_half_a_turn_counts_once() -> None:
    """Some searches end at π and some at −π, which is one posture."""
    robot = arm("puma560")
    q = np.array([0.3, -1.0, 0.2, np.pi, 0.8, np.pi])
    assert len(numeric.branches(robot, tool_at(robot, q), q).branches) == 8


def test_two_postures_that_meet_count_once() -> None:
    robot, q = stretched()
    assert len(numeric.branches(robot, tool_at(robot, q), q).branches) == 1


@each_arm
def test_the_columns_are_those_of_the_jacobian(name: str) -> None:
    """As the last frame sees them, of variables in their own units; and at the goal nothing is left."""
    robot = arm(name)
    of = packed.search_of(robot, packed.limited(robot), 0.2, (1e-6, 1e-6), 30, 1)
    R_last_tool, units = of.table[packed.HAND, :9].reshape(3, 3), np.diag(packed.limited(robot)[:, packed.UNIT])
    for q in postures(robot, 5):
        T, room = tool_pose(tool_kernels.arm_array(robot), q), np.zeros(of.buffers)
        e = errors.linearised(of.table, errors.goal_of(of.table, T), q.copy(), room)
        np.testing.assert_allclose(e, 0, atol=1e-14)
        J, R = tool_jacobian(tool_kernels.arm_array(robot), q.copy()) @ units, R_last_tool @ T[:3, :3].T
        seen = np.concatenate([R @ J[:3] / robot.reach, 0.2 * R @ J[3:]])
        np.testing.assert_allclose(room[errors.COLUMNS :, :6].T, seen, rtol=0, atol=1e-14)


@each_arm
def test_the_error_is_the_way_to_the_goal(name: str) -> None:
    """In the length of both of its parts, and by the columns in its first change."""
    robot = arm(name)
    of = packed.search_of(robot, packed.limited(robot), 0.2, (1e-6, 1e-6), 30, 1)
    for q, other in pairwise(postures(robot, 6)):
        T, room = tool_at(robot, other), np.zeros(of.buffers)
        goal = errors.goal_of(of.table, T)
        e = np.array(errors.linearised(of.table, goal, q.copy(), room))
        missed, turned = between(tool_at(robot, q), T)
        assert np.linalg.norm(e[:3]) == pytest.approx(missed / robot.reach, abs=1e-12)
        assert np.linalg.norm(e[3:]) == pytest.approx(0.2 * turned, abs=1e-7)
        pulls = room[errors.COLUMNS :, :6] @ e
        for j, unit in enumerate(packed.limited(robot)[:, packed.UNIT]):
            halves = [
                sum(errors.squares(errors.linearised(of.table, goal, q + step, room)))
                for step in np.outer([1e-6, -1e-6], unit * np.eye(q.size)[j])
            ]
            assert (halves[1] - halves[0]) / 4e-6 == pytest.approx(pulls[j], abs=1e-7)


def nearly_parallel(sine: float) -> Robot:
    """The PUMA with an elbow that stands that much askew to its shoulder."""
    robot = arm("puma560")
    tilted = rotation.exponential(sine * np.array([0.6, 0.0, 0.8])) @ robot.directions[1]
    joints = (*robot.joints[:2], replace(robot.joints[2], direction=frozen(tilted)), *robot.joints[3:])
    return replace(robot, joints=joints)


@pytest.mark.parametrize("sine", [1e-16, 1e-14, 1e-12, 1e-9, 1e-6, 1e-3])
def test_axes_that_are_nearly_parallel_lose_nothing(sine: float) -> None:
    robot = nearly_parallel(sine)
    of = packed.search_of(robot, packed.limited(robot), 1.0, (1e-6, 1e-6), 30, 1)
    for q in postures(robot, 5):
        goal = errors.goal_of(of.table, tool_at(robot, q))
        np.testing.assert_allclose(errors.linearised(of.table, goal, q.copy(), np.zeros(of.buffers)), 0, atol=1e-14)


directions = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1)


@given(directions, st.one_of(st.floats(0, np.pi), st.floats(-12, -5).map(lambda n: np.pi - 10**n), st.just(np.pi)))
def test_the_error_of_orientation_is_the_rotation_vector(direction: tuple[float, ...], angle: float) -> None:
    R = rotation.exponential(np.array([0.3, -0.8, 0.5]))
    axis = np.array(direction) / np.linalg.norm(direction)
    goal = np.eye(4)
    goal[:3, :3] = rotation.exponential(angle * axis) @ R
    r = np.array(tool_kernels.rotation_to(goal, *((*map(float, row), 0.0) for row in R)))
    assert np.linalg.norm(r) == pytest.approx(angle, abs=1e-7)
    np.testing.assert_allclose(rotation.exponential(r) @ R, goal[:3, :3], rtol=0, atol=3e-6)


def test_a_joint_that_is_pushed_against_its_limit_is_left_out_of_the_step() -> None:
    """One that is pulled off its limit, or not held, takes part."""
    robot = arm("puma560")
    columns, e = np.random.default_rng(0).normal(size=(6, 6)), (0.3, -0.2, 0.1, 0.4, -0.5, 0.2)
    pull = columns @ np.array(e)

    def left(at_limit: bool, held: bool) -> Array:
        ranges, given = packed.limited(robot), columns.copy()
        q = ranges[:, packed.LOWER] + 0.1
        q[2] = ranges[2, packed.UPPER if (pull[2] > 0) == at_limit else packed.LOWER]
        ranges[2, packed.HELD] = held
        descent.leave_out(packed.search_of(robot, ranges, 1.0, (0.0, 0.0), 1, 1).table, q, e, given)
        return given

    assert not left(True, True)[2].any()
    np.testing.assert_array_equal(left(True, True)[[0, 1, 3, 4, 5]], columns[[0, 1, 3, 4, 5]])
    np.testing.assert_array_equal(left(False, True), columns)
    np.testing.assert_array_equal(left(True, False), columns)


def test_draws_are_spread_over_the_limits() -> None:
    """No two of a thousand come near each other, and every part of a joint's range holds at least half its share."""
    robot = arm("puma560")
    table, q = packed.search_of(robot, packed.limited(robot), 1.0, (0.0, 0.0), 1, 1).table, np.empty(6)
    shares = np.empty((1000, 6))
    for number in range(1000):
        restarts.draw(table, number, q)
        shares[number] = (q - robot.lower) / (robot.upper - robot.lower)
    assert shares.min() >= 0
    assert shares.max() <= 1
    for i in range(6):
        assert np.histogram(shares[:, i], 10, (0, 1))[0].min() >= 50
    apart = np.linalg.norm(shares[:, None] - shares, axis=2)
    np.fill_diagonal(apart, 1)
    assert apart.min() > 0.2


def test_only_joints_that_stand_alike_after_a_turn_are_unwound() -> None:
    """In the arm of this name b slides, and d follows c by a ratio."""
    robot = arm(MIXED)
    assert (packed.limited(robot)[:, packed.PERIOD] > 0).tolist() == [True, False, False, True]
    assert (packed.limited(robot)[:, packed.HELD] > 0).all()
    assert not (packed.wide(robot)[:, packed.HELD] > 0).any()


@pytest.mark.parametrize("seed", range(3))
def test_a_start_beyond_the_limits_leads_back_into_them(seed: int) -> None:
    robot = arm("movemaster")
    goal = tool_at(robot, postures(robot, 1, seed)[0])
    branch = numeric.solve_numerically(robot, goal, robot.poses["home"]).branches[0]
    assert branch.within
    assert branch.missed < 1.001e-6


@pytest.mark.parametrize("solve", [numeric.solve_numerically, numeric.branches])
def test_what_is_no_pose_or_no_posture_is_refused(solve: Callable[..., Answer]) -> None:
    robot = arm("puma560")
    for T in (2 * np.eye(4), np.full((4, 4), np.nan), np.eye(3)):
        with pytest.raises(HelicoideError):
            solve(robot, T, robot.poses["ready"])
    for q in (np.zeros(5), np.full(6, np.nan)):
        with pytest.raises(HelicoideError):
            solve(robot, np.eye(4), q)
