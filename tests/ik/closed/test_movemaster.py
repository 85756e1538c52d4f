"""The four postures of the Movemaster: there and back again, goals outside its subspace, edges and singular places."""

from __future__ import annotations

from math import asin, pi

import numpy as np
import pytest
from tests.ik.closed.rows import distance, worst

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik import closed
from helicoide.ik.closed import motoman_l3, movemaster
from helicoide.ik.families.movemaster_arm import side_of
from helicoide.ik.postures.branch import between, tool_at, wrap
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError

HERE = np.zeros(5)


def turned(T: Array, vector: list[float]) -> Array:
    """A pose turned about its own point by a rotation vector of the world."""
    there = T.copy()
    there[:3, :3] = rotation.exponential(np.array(vector)) @ T[:3, :3]
    return there


def there_and_back(robot: Robot, count: int, seed: int) -> tuple[float, float, set[int]]:
    """The worst miss of any posture, the worst distance of the generating one, rad, and the numbers of postures."""
    missed, apart, counts = 0.0, 0.0, set()
    for q in np.random.default_rng(seed).uniform(-pi, pi, (count, 5)):
        answer = closed.solve_closed_form(movemaster, robot, tool_at(robot, q), HERE)
        missed, apart = max(missed, worst(robot, answer)), max(apart, distance(answer, q))
        counts.add(len(answer.branches))
        assert answer.turned < 1e-7
    return missed, apart, counts


def test_there_and_back_again(robot: Robot) -> None:
    """The short form of the count in the soak tests."""
    missed, apart, counts = there_and_back(robot, 200, seed=1)
    assert missed < 1e-9
    assert apart < 1e-7
    assert counts == {2, 4}


def test_the_example_of_the_source(robot: Robot) -> None:
    """Cerbaro 2022, eqs. 4-8."""
    T = np.eye(4)
    T[:3] = [[0.433, 0.750, 0.500, 0.470429], [0.250, 0.433, -0.866, 0.271602], [-0.866, 0.500, 0.000, 0.300000]]
    u, _, v = np.linalg.svd(T[:3, :3])
    T[:3, :3] = u @ v
    answer = closed.solve_closed_form(movemaster, robot, T, HERE)
    assert distance(answer, np.radians([30, 60, -90, -30, 90])) < 2e-3
    answer = closed.solve_closed_form(movemaster, robot, tool_at(robot, robot.poses["example"]), HERE)
    assert distance(answer, robot.poses["example"]) < 1e-12


def test_names_say_where_waist_and_elbow_are(robot: Robot) -> None:
    """The front of the waist shows towards the tool or away from it; the elbow above or below shoulder and wrist."""
    seen = set()
    for q in np.random.default_rng(2).uniform(-pi, pi, (100, 5)):
        answer = closed.solve_closed_form(movemaster, robot, T := tool_at(robot, q), HERE)
        for branch in answer.branches:
            poses = link_poses(robot.chain, branch.q)
            shoulder, elbow, wrist = poses[2:5, :3, 3]
            ahead = (wrist - shoulder) * [1, 1, 0]
            above = ((wrist - shoulder) @ ahead) * (elbow - shoulder)[2] > (wrist - shoulder)[2] * (
                (elbow - shoulder) @ ahead
            )
            front = poses[1, :3, 0] @ T[:3, 3] > 0
            assert ("elbow up" in branch.name.en) == ("cotovelo para cima" in branch.name.pt_BR) == above
            assert ("front" in branch.name.en) == ("de frente" in branch.name.pt_BR) == front
            seen.add(branch.name.en)
    assert len(seen) == 4


def test_over_backwards_all_four(robot: Robot) -> None:
    """Near the waist the arm gets there turned back too."""
    q = np.radians([20, 130, -100, 60, 10])
    answer = closed.solve_closed_form(movemaster, robot, tool_at(robot, q), HERE)
    assert len({branch.name.en for branch in answer.branches}) == len(answer.branches) == 4
    assert distance(answer, q) < 1e-12
    headings = wrap([branch.q[0] - answer.branches[0].q[0] for branch in answer.branches])
    np.testing.assert_allclose(np.abs(headings), [0, 0, pi, pi], rtol=0, atol=1e-12)


def test_a_goal_outside_the_subspace_is_turned_into_it(robot: Robot) -> None:
    """By asin|M·Ẑ|, about its own point; what is then solved lies in the subspace."""
    draw = np.random.default_rng(3)
    for q in draw.uniform(robot.lower, robot.upper, (30, 5)):
        goal = turned(tool_at(robot, q), list(draw.normal(size=3)))
        x, y = goal[:2, 3] / np.linalg.norm(goal[:2, 3])
        answer = closed.solve_closed_form(movemaster, robot, goal, HERE)
        assert answer.turned == pytest.approx(asin(abs(goal[:3, 0] @ [-y, x, 0])), abs=1e-9)
        assert answer.turned == pytest.approx(between(goal, answer.T_world_goal)[1], abs=1e-12)
        assert answer.moved == pytest.approx(0, abs=1e-12)
        assert not answer.branches or worst(robot, answer) < 1e-9
        assert all(branch.turned == pytest.approx(answer.turned, abs=1e-9) for branch in answer.branches)
        assert f"{np.degrees(answer.turned):.3g}°" in answer.words.en


def test_no_posture_points_nearer(robot: Robot) -> None:
    """A search about the answer finds no tool orientation that is nearer to the goal with the tool at its point."""
    q = np.radians([20, 30, -75, -15, 40])
    goal = turned(tool_at(robot, q), [0.5, -0.3, 0.7])
    answer = closed.solve_closed_form(movemaster, robot, goal, q)
    best = answer.branches[0].q
    for shift in np.random.default_rng(4).uniform(-0.3, 0.3, (200, 2)):
        moved = tool_at(robot, best + np.array([0, 0, 0, *shift])).copy()
        moved[:3, 3] = goal[:3, 3]
        again = closed.solve_closed_form(movemaster, robot, moved, q)
        assert again.turned < 1e-9
        assert between(goal, again.T_world_goal)[1] >= answer.turned - 1e-12


def test_stretched_there_is_one_elbow(robot: Robot) -> None:
    q = np.radians([20, 30, 0, -15, 40])
    answer = closed.solve_closed_form(movemaster, robot, tool_at(robot, q), HERE)
    assert len(answer.branches) == 1
    assert distance(answer, q) < 1e-6
    assert worst(robot, answer) < 1e-9


def beside_an_edge(robot: Robot, elbow: float, far: float) -> Array:
    """A level tool pose with the wrist `far` m beyond where it stands with that elbow, away from the shoulder."""
    q = np.radians([20, 30, elbow, -30 - elbow, 40])
    poses, T = link_poses(robot.chain, q), tool_at(robot, q).copy()
    out = poses[4, :3, 3] - poses[2, :3, 3]
    T[:3, 3] += far * out / np.linalg.norm(out)
    return T


def test_out_of_reach_by_how_much(robot: Robot) -> None:
    answer = closed.solve_closed_form(movemaster, robot, beside_an_edge(robot, 0, 0.07), HERE)
    assert answer.branches == ()
    assert answer.short == pytest.approx(0.07, abs=1e-9)
    assert "70 mm" in answer.words.en
    assert "70 mm" in answer.words.pt_BR


def test_what_is_too_near_the_shoulder_is_reached_turned_back(robot: Robot) -> None:
    """The hole is 50 mm wide, and the shoulder then stands 240 mm away on the other side of the waist."""
    assert side_of(robot).links.inner == pytest.approx(0.05)  # type: ignore[union-attr]
    answer = closed.solve_closed_form(movemaster, robot, beside_an_edge(robot, 180, -0.03), HERE)
    assert ["to the back" in branch.name.en for branch in answer.branches] == [True, True]
    assert worst(robot, answer) < 1e-9
    assert answer.short == 0


def test_upright_over_the_waist_joint_1_is_kept(robot: Robot) -> None:
    a2 = np.radians(140)
    a3 = np.arccos(-(0.12 + 0.25 * np.cos(a2)) / 0.2)
    T = tool_at(robot, np.array([0, a2, a3 - a2, pi / 2 - a3, 0.3]))
    assert np.linalg.norm(T[:2, 3]) < 1e-12
    for kept in (0.0, 1.2):
        answer = closed.solve_closed_form(movemaster, robot, T, np.array([kept, 0, 0, 0, 0]))
        assert answer.free == (0,)
        assert {round(float(abs(wrap(branch.q[0] - kept))), 9) for branch in answer.branches} == {0, round(pi, 9)}
        assert worst(robot, answer) < 1e-9
        assert "θ₁" in answer.words.en


def test_tilted_over_the_waist_the_hand_gives_the_plane(robot: Robot) -> None:
    """Tool point on the axis of the waist, hand not along it: the plane is the one in which the hand points."""
    a4, a2 = np.radians([150, 60])
    a3 = np.arccos(-(0.12 + 0.25 * np.cos(a2) + 0.25 * np.cos(a4)) / 0.2)
    q = np.array([0.4, a2, a3 - a2, a4 - a3, 0.3])
    T = tool_at(robot, q)
    assert np.linalg.norm(T[:2, 3]) < 1e-12
    answer = closed.solve_closed_form(movemaster, robot, T, HERE)
    assert answer.free == ()
    assert distance(answer, q) < 1e-9


def test_the_motoman_by_both_forms() -> None:
    robot = load_robot("motoman_l3")
    for q in np.random.default_rng(5).uniform(robot.lower, robot.upper, (20, 5)):
        one, other = (
            closed.solve_closed_form(form, robot, tool_at(robot, q), HERE) for form in (movemaster, motoman_l3)
        )
        assert len(one.branches) == len(other.branches) == 4
        assert max(distance(other, branch.q) for branch in one.branches) < 1e-9


def test_within_the_limits(robot: Robot) -> None:
    answer = closed.solve_closed_form(movemaster, robot, tool_at(robot, robot.poses["ready"]), HERE)
    expected = [np.all((robot.lower <= branch.q) & (branch.q <= robot.upper)) for branch in answer.branches]
    assert [branch.within for branch in answer.branches] == expected == [True, False]


def test_what_the_equations_gave_on_the_way(robot: Robot) -> None:
    """u = 120 + 250 cos a2 + 200 cos a3 + 250 cos a4, Cerbaro 2022, tab. 8; angles about the axis to the left."""
    q = robot.poses["example"]
    answer = closed.solve_closed_form(movemaster, robot, tool_at(robot, q), HERE)
    values = answer.values[int(np.argmin([np.abs(wrap(branch.q - q)).max() for branch in answer.branches]))]
    assert values["u"] == pytest.approx(0.12 + 0.25 * 0.5 + 0.2 * np.cos(-pi / 6) + 0.25 * 0.5)
    assert values["α"] == pytest.approx(pi / 3)
    assert values["θ₂"] + values["θ₃"] + values["θ₄"] == pytest.approx(values["α"])


@pytest.mark.parametrize("name", ["puma560", "zebra_zero", "scara", "planar3r", "orca"])
def test_other_arms_are_refused(name: str) -> None:
    other = load_robot(name)
    assert movemaster.applies(other) is not None
    with pytest.raises(HelicoideError):
        closed.solve_closed_form(movemaster, other, np.eye(4), np.zeros(len(other.variables)))


def test_the_form_is_known_by_its_geometry(robot: Robot) -> None:
    assert movemaster.applies(robot) is None
