"""The front door: the closed form where there is one, else searches, and every way by its name."""

from __future__ import annotations

import re
from contextlib import nullcontext

import numpy as np
import pytest
from tests.kinematics.arms import arm, postures

from helicoide.arrays import Array
from helicoide.ik import closed, methods
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.branch import between, tool_at, wrap
from helicoide.ik.postures.solve import EXACT, NUMERIC, answer_status, solve, solve_by, ways
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError

CLOSED = ("puma560", "motoman_l3", "planar3r", "movemaster", "ur5")
SEARCHED = ("panda",)


def robot_of(name: str) -> Robot:
    return load_robot(name) if name in (*SEARCHED, "ur5") else arm(name)


def errors(robot: Robot, T: Array, answer: Answer) -> list[tuple[float, float]]:
    return [between(T, tool_at(robot, branch.q)) for branch in answer.branches]


@pytest.mark.parametrize("name", CLOSED + SEARCHED)
def test_a_reachable_pose_gets_one_posture_and_every_posture(name: str) -> None:
    robot = robot_of(name)
    for q in postures(robot, 3, seed=7):
        T = tool_at(robot, q)
        one, every = solve(robot, T, q), solve(robot, T, q, every=True)
        assert bool(closed.of(robot)) == (name in CLOSED)
        assert len(one.branches) == 1 <= len(every.branches)
        assert one.branches[0].within
        np.testing.assert_allclose(wrap(one.branches[0].q - q), 0, atol=1e-6)
        assert all(EXACT.holds(*left) for left in errors(robot, T, one) + errors(robot, T, every))
        assert answer_status(one).en == answer_status(every).en == "reached"


def test_the_nearest_posture_turns_the_shorter_way() -> None:
    robot = load_robot("ur5")
    q = robot.poses["ready"] + np.array([0, 0, 0, 0, 0, 5.0])
    near = solve(robot, tool_at(robot, q), q).branches[0]
    np.testing.assert_allclose(near.q, q, atol=1e-5)
    assert np.abs(solve(robot, tool_at(robot, q), q, every=True).branches[0].q - q).max() < 1e-6


@pytest.mark.parametrize("name", ["puma560", "panda"])
def test_numeric_and_the_closed_forms_agree_on_all_postures(name: str) -> None:
    robot = robot_of(name)
    for q in postures(robot, 3, seed=8):
        T = tool_at(robot, q)
        expected = solve_by("numeric", robot, T, q, every=True)
        for form in closed.of(robot):
            answer = solve_by(form, robot, T, q, every=True)
            apart = [[np.abs(wrap(a.q - b.q)).max() for b in expected.branches] for a in answer.branches]
            assert np.min(apart, axis=1).max() < 1e-6
            assert len(answer.branches) == len(expected.branches)


@pytest.mark.parametrize("method", methods.names())
def test_every_method_comes_to_a_goal_that_is_near(method: str) -> None:
    robot = arm("puma560")
    q = robot.poses["ready"]
    T = tool_at(robot, q + np.array([0.1, -0.1, 0.1, 0.2, -0.1, 0.1]))
    answer = solve_by(method, robot, T, q)
    assert len(answer.branches) == 1
    assert all(EXACT.holds(*left) for left in errors(robot, T, answer))
    assert answer_status(answer).en == "reached"
    assert "Converged" in answer.words.en


def test_a_goal_that_five_joints_cannot_take_is_projected() -> None:
    """By searches, a method and the closed form alike: `moved` and `turned` lead from the asked pose to the goal."""
    robot = arm("movemaster")
    q = robot.poses["ready"]
    T = tool_at(robot, q).copy()
    T[:3, :3] = T[:3, :3] @ np.array([[np.cos(0.2), -np.sin(0.2), 0], [np.sin(0.2), np.cos(0.2), 0], [0, 0, 1]])
    for answer in (solve(robot, T, q), *(solve_by(way, robot, T, q) for way in ("numeric", "damped"))):
        moved, turned = between(T, answer.T_world_goal)
        assert (answer.moved, answer.turned) == pytest.approx((moved, turned), abs=1e-9)
        assert turned > 0.05
        assert all(EXACT.holds(*left) for left in errors(robot, answer.T_world_goal, answer))
        assert answer_status(answer).en.startswith(f"projected by {np.degrees(turned):.3f}°")
        assert answer_status(answer).en.endswith(": reached")
        assert answer_status(answer).pt_BR.endswith(": alcançado")


def test_what_is_moved_by_a_projection_is_said() -> None:
    robot = arm("scara")
    q = robot.poses["ready"]
    T = tool_at(robot, q).copy()
    T[:3, :3] = T[:3, :3] @ np.array([[1, 0, 0], [0, np.cos(0.2), -np.sin(0.2)], [0, np.sin(0.2), np.cos(0.2)]])
    answer = solve_by("numeric", robot, T, q)
    assert (answer.moved, answer.turned) == pytest.approx((0, 0.2), abs=1e-9)
    flat = arm("planar2r")
    q = flat.poses["ready"]
    T = tool_at(flat, q).copy()
    T[:3, 3] += [0, 0, 0.05]
    answer = solve_by("numeric", flat, T, q)
    assert (answer.moved, answer.turned) == pytest.approx((0.05, 0), abs=1e-9)
    assert "50.000 mm" in answer_status(answer).en


def test_the_form_of_one_arm_comes_before_that_of_many() -> None:
    robot = arm("puma560")
    q = robot.poses["ready"]
    T = tool_at(robot, q + 0.1)
    names = [
        [branch.name.en for branch in answer.branches]
        for answer in (
            solve(robot, T, q, every=True),
            solve_by("puma560", robot, T, q, every=True),
            solve_by("pieper", robot, T, q, every=True),
        )
    ]
    assert names[0] == names[1] != names[2]


@pytest.mark.parametrize("name", CLOSED[:2] + SEARCHED)
def test_out_of_reach_the_nearest_posture_is_given_with_what_it_misses(name: str) -> None:
    robot = robot_of(name)
    T = tool_at(robot, robot.poses["ready"]).copy()
    T[:3, 3] *= 3 * robot.reach / np.linalg.norm(T[:3, 3])
    answer = solve(robot, T, robot.poses["ready"])
    branch = answer.branches[0]
    assert branch.within
    assert branch.missed > robot.reach
    assert answer_status(answer).en.startswith(f"out of reach by {1000 * branch.missed:.3f} mm")
    assert answer_status(answer).pt_BR.startswith("fora do alcance por")


def test_a_goal_that_only_postures_beyond_the_limits_reach() -> None:
    robot = arm("puma560")
    beyond = np.array([0.1, -1.0, 0.3, 0.2, 2.6, 0.1])
    T = tool_at(robot, beyond)
    every = solve(robot, T, robot.poses["ready"], every=True)
    assert every.branches
    assert not any(branch.within for branch in every.branches)
    assert answer_status(every).en == "reached only outside the joint limits"
    one = solve(robot, T, robot.poses["ready"])
    assert one.branches[0].within
    assert "outside the joint limits" in one.words.en
    assert answer_status(one).en.startswith(("not reached", "out of reach"))


@pytest.mark.parametrize("with_orientation", [True, False])
@pytest.mark.parametrize("name", ["puma560", "planar3r", "scara", "panda", "polar_rp"])
def test_the_ways_of_an_arm_are_those_that_answer(name: str, with_orientation: bool) -> None:
    robot = load_robot(name)
    q = robot.poses["ready"]
    known = ways(robot, with_orientation)
    for way in (*closed.closed_forms(), NUMERIC, *methods.names()):
        refused = nullcontext() if way in known else pytest.raises(HelicoideError, match=re.escape(", ".join(known)))
        with refused:
            solve_by(way, robot, tool_at(robot, q), q, with_orientation=with_orientation)


def test_names_that_do_not_apply_list_those_that_do() -> None:
    robot = load_robot("panda")
    T, q = tool_at(robot, robot.poses["ready"]), robot.poses["ready"]
    for name in ("nonsense", "planar2r", "inverse"):
        with pytest.raises(HelicoideError) as caught:
            solve_by(name, robot, T, q)
        assert all(way in caught.value.text.pt_BR for way in ways(robot))
        assert "\n" not in caught.value.text.en
    assert "inverse" not in ways(robot)
    assert "puma560" in ways(arm("puma560"))
    assert "puma560" not in ways(robot)
    with pytest.raises(HelicoideError, match="orientation"):
        solve_by("puma560", arm("puma560"), np.eye(4), arm("puma560").poses["ready"], with_orientation=False)


def test_a_point_for_two_joints_is_solved_in_closed_form() -> None:
    robot = arm("planar2r")
    for q in postures(robot, 20, seed=11):
        T = np.eye(4)
        T[:3, 3] = tool_at(robot, q)[:3, 3]
        every = solve(robot, T, q, every=True, with_orientation=False)
        assert "Two postures" in every.words.en
        assert len(every.branches) == 2
        assert all(EXACT.holds(branch.missed, branch.turned) for branch in every.branches)
        (one,) = solve(robot, T, q, with_orientation=False).branches
        np.testing.assert_allclose(one.q, q, atol=1e-9)
        assert solve_by("planar2r", robot, T, q, with_orientation=False).branches[0].turned == 0


@pytest.mark.parametrize(
    ("name", "place", "off"),
    [("polar_rp", (0.3, 0.4), 0.1), ("planar2r", (1.0, 0.8), 0.05), ("planar3r", (1, 0.4), 0.2)],
)
def test_a_point_off_the_plane_of_an_arm_is_projected(name: str, place: tuple[float, float], off: float) -> None:
    robot = arm(name)
    T = np.eye(4)
    T[:3, 3] = (*place, robot.T_world_tool_0[2, 3] + off)
    for way in ("front", "numeric"):
        asked = (robot, T, robot.poses["ready"], False, False)
        answer = solve(*asked) if way == "front" else solve_by(way, *asked)
        assert (answer.moved, answer.turned) == (pytest.approx(off), 0)
        assert (
            answer_status(answer).en
            == f"projected by 0.000° and {1000 * off:.3f} mm onto the poses of the arm: reached"
        )
        np.testing.assert_allclose(tool_at(robot, answer.branches[0].q)[:2, 3], place, atol=1e-6)
        assert answer.branches[0].missed == pytest.approx(off)
