"""The choice between postures: Campos 1998, s.15–18."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.ik.postures.branches import branch_of

from helicoide.arrays import Array, frozen
from helicoide.confinement import Obstacles
from helicoide.ik import closed
from helicoide.ik.closed import motoman_l3, planar3r
from helicoide.ik.postures import choice
from helicoide.ik.postures.branch import Branch, tool_at
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar_pose, planar_with_lengths, with_joint_limits
from helicoide.studies.campos_planar3r import NOW
from helicoide.text import HelicoideError, untranslated

L3 = 0.2
# Both postures of the example, and by weights what the nearer and the farther one cost, and which is nearer.
A, B = (-2.6971, 1.4202, -0.1232), (-1.5780, -1.4202, 1.5982)
COSTS = {"alike": ((1, 1, 1), (5.183, 6.296), A), "falling": ((3, 2, 1), (12.073, 12.576), B)}
ROBOT = planar_with_lengths("planar3r", 1.0, 0.7, L3)


def example(robot: Robot = ROBOT) -> tuple[Branch, ...]:
    """The third axis at (−0.7, −1.1), φ = −1.4; recomputed from the formulas of the source."""
    phi = -1.4
    T = planar_pose(-0.7 + L3 * np.cos(phi), -1.1 + L3 * np.sin(phi), phi)
    return closed.solve_closed_form(planar3r, robot, T, NOW).branches


@pytest.mark.parametrize(("weights", "costs", "chosen"), COSTS.values())
def test_weights_turn_the_choice(
    weights: tuple[float, ...], costs: tuple[float, ...], chosen: tuple[float, ...]
) -> None:
    rows = choice.ranked(ROBOT, example(), NOW, weights)
    assert [row.cost for row in rows] == pytest.approx(costs, abs=6e-4)
    best = choice.first_usable(rows)
    assert best is not None
    np.testing.assert_allclose(best.branch.q, chosen, atol=5.1e-5)


def test_an_obstacle_rules_a_posture_out_and_the_other_is_chosen() -> None:
    """s.17–18: a post where the elbow of the nearer posture stands."""
    near, far = choice.ranked(ROBOT, example(), NOW, (1, 1, 1))
    post = Obstacles().with_sphere(link_poses(ROBOT.chain, near.branch.q)[2][:3, 3], 0.1)
    rows = choice.ranked(ROBOT, example(), NOW, (1, 1, 1), choice.touching(ROBOT, post))
    assert [row.branch.name for row in rows] == [far.branch.name, near.branch.name]
    assert [row.dropped for row in rows] == [None, choice.COLLIDES]
    assert choice.first_usable(rows) is rows[0]


@pytest.mark.parametrize("name", ["puma560", "movemaster", "planar3r"])
def test_what_touches_is_nearer_than_both_radii(name: str) -> None:
    robot = load_robot(name)
    q = robot.poses["ready"]
    body = robot.bodies[-1]
    middle = body.axis_at(link_poses(robot.chain, q)).mean(axis=0)
    way = np.array([0.0, 0.0, 5.0]) if name == "planar3r" else np.array([5.0, 0.0, 0.0])
    assert choice.touching(robot, Obstacles().with_sphere(middle, 0.01))(q)
    assert not choice.touching(robot, Obstacles().with_sphere(middle + way, 0.01))(q)
    assert not choice.touching(robot, Obstacles())(q)


def test_limits_rule_a_posture_out_before_it_is_asked_whether_it_collides() -> None:
    robot = with_joint_limits(ROBOT, [-3.1, -1.5, -3], [3.1, 1.3, 3])
    asked: list[Array] = []

    def touches(q: Array) -> bool:
        asked.append(q)
        return False

    rows = choice.ranked(robot, example(robot), NOW, (1, 1, 1), touches)
    assert [row.dropped for row in rows] == [None, choice.OUT_OF_LIMITS]
    np.testing.assert_allclose(asked, [B], atol=5.1e-5)


def test_where_all_are_ruled_out_there_is_none() -> None:
    rows = choice.ranked(ROBOT, example(), NOW, (1, 1, 1), lambda q: True)
    assert len(rows) == 2
    assert choice.first_usable(rows) is None
    assert choice.first_usable(choice.ranked(ROBOT, (), NOW, (1, 1, 1))) is None


def test_the_way_round_is_taken_where_the_limits_leave_it() -> None:
    """From 170° to −170° it is 20°: to 190°, or, where the joint ends at 180°, to −170° all the same."""
    now, there = np.radians([170.0, 0, 0]), np.radians([-170.0, 0, 0])
    for robot, end in ((ROBOT, 190.0), (with_joint_limits(ROBOT, [-np.pi] * 3, [np.pi] * 3), -170.0)):
        branch = branch_of(robot, untranslated("there"), there, tool_at(robot, there))
        (row,) = choice.ranked(robot, [branch], now, (1, 1, 1))
        assert np.degrees(row.change) == pytest.approx([20, 0, 0])
        assert row.cost == pytest.approx(np.radians(20))
        assert np.degrees(row.q[0]) == pytest.approx(end)


def test_slides_are_not_wrapped() -> None:
    slow = load_robot("polar_rp")
    joints = (slow.joints[0], replace(slow.joints[1], upper=9.0))
    robot = replace(slow, joints=joints)
    branch = branch_of(robot, untranslated("out"), [0.0, 8.0], tool_at(robot, frozen([0.0, 8.0])))
    (row,) = choice.ranked(robot, [branch], np.array([0.0, 0.5]), (1, 2))
    assert row.change == pytest.approx([0, 7.5])
    assert row.cost == pytest.approx(15)
    assert row.q == pytest.approx([0, 8])


@given(
    q=st.tuples(*[st.floats(-2, 2)] * 5),
    now=st.tuples(*[st.floats(-2, 2)] * 5),
    weights=st.tuples(*[st.floats(0, 9)] * 5),
)
@settings(max_examples=30)
def test_the_ranking_goes_by_cost_and_no_branch_is_lost(
    q: tuple[float, ...], now: tuple[float, ...], weights: tuple[float, ...]
) -> None:
    robot = load_l3()
    branches = closed.solve_closed_form(motoman_l3, robot, tool_at(robot, np.array(q)), np.array(now)).branches
    rows = choice.ranked(robot, branches, np.array(now), weights)
    assert {id(row.branch) for row in rows} == {id(branch) for branch in branches}
    assert [row.dropped is None for row in rows] == sorted((row.dropped is None for row in rows), reverse=True)
    for kept in (True, False):
        costs = [row.cost for row in rows if (row.dropped is None) == kept]
        assert costs == sorted(costs)
    for row in rows:
        turn = np.angle(np.exp(1j * (row.branch.q - np.array(now))))
        assert row.cost == pytest.approx(np.array(weights) @ np.abs(turn), abs=1e-9)


def load_l3() -> Robot:
    return load_robot("motoman_l3")


@pytest.mark.parametrize("weights", [(1, 1), (1, 1, -1), (1, np.nan, 1), (1, 1, np.inf), 1])
def test_wrong_weights_are_refused(weights: object) -> None:
    with pytest.raises(HelicoideError, match="3 finite numbers"):
        choice.ranked(ROBOT, example(), NOW, weights)  # type: ignore[arg-type]


def test_wrong_joint_values_are_refused() -> None:
    with pytest.raises(HelicoideError, match="finite joint values"):
        choice.ranked(ROBOT, example(), np.array([0, np.nan, 0]), (1, 1, 1))
