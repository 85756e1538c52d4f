"""The Motoman L-3: Campos 1998, s.36 and s.55, worked out after Craig, ch. 4."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.ik.closed.rows import worst
from tests.ik.closed.small_arms import moved, recovered, reversed_axes, with_points

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler, rotation
from helicoide.ik import closed
from helicoide.ik.closed import motoman_l3
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies.campos_l3 import goal
from helicoide.text import LANGUAGES, HelicoideError, Text

ROBOT = load_robot("motoman_l3")
# Of the goal of the study, recomputed from the formulas of the book by other code: the turn, °, where the hand then
# points, and the postures, °.
ANGLE, POINTING = -16.6918, (0.871505, 0.348602, -0.344899)
SOLUTIONS = {
    "front, elbow up": (21.8014, -83.1026, 94.3012, 98.9770, 0.6431),
    "front, elbow down": (21.8014, 24.8595, -94.3012, 179.6174, 0.6431),
    "back, elbow down": (-158.1986, 155.1405, 94.3012, 0.3826, -179.3569),
    "back, elbow up": (-158.1986, -96.8974, -94.3012, 81.0230, -179.3569),
}
NOW = np.zeros(5)
angles = st.floats(-np.pi, np.pi)
points = st.tuples(*[st.floats(-0.8, 0.8)] * 3)


def pose(p: tuple[float, ...] | Array, R: Array) -> Array:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


@cache
def equal_links() -> Robot:
    """An L-3 whose forearm is as long as its upper arm."""
    points = [(0, 0, 0), (0, 0, 0), (0.4, 0, 0), (0.8, 0, 0), (0.8, 0, 0)]
    return with_points(ROBOT, points, pose((0.8, 0, 0), np.eye(3)))


def test_an_arm_bent_at_zero_on_a_pedestal() -> None:
    """Where the file counts from a bent arm, with joints beside its plane, the angles of the source are shifted."""
    R = euler.euler_matrix([0, 0.3, 0], "zyx")
    points = [(0, 0, -0.2), (0, 0.1, 0.4), (0.2, -0.1, 0.7), (0.6, 0.3, 0.9), (0.6, 0, 0.9)]
    turned = replace(ROBOT.joints[4], direction=frozen(R[:, 2]))
    robot = with_points(replace(ROBOT, joints=(*ROBOT.joints[:4], turned)), points, pose((0.6, 0, 0.9), R))
    assert motoman_l3.applies(robot) is None
    for q in np.random.default_rng(3).uniform(-3, 3, (20, 5)):
        answer = closed.solve_closed_form(motoman_l3, robot, tool_at(robot, q), NOW)
        assert worst(robot, answer) < 1e-9
        assert recovered(answer, q) < 1e-9


def test_the_four_postures_of_the_test_goal() -> None:
    answer = closed.solve_closed_form(motoman_l3, ROBOT, goal(), NOW)
    assert [branch.name.en for branch in answer.branches] == list(SOLUTIONS)
    np.testing.assert_allclose([np.degrees(b.q) for b in answer.branches], list(SOLUTIONS.values()), atol=5.1e-5)
    assert [branch.within for branch in answer.branches] == [True, True, False, True]
    assert worst(ROBOT, answer) < 1e-12
    assert (answer.moved, answer.short, answer.free) == (0, 0, ())
    assert [name for name, pose in ROBOT.poses.items() if np.abs(answer.branches[0].q - pose).max() < 1e-6] == [
        "elbow_up"
    ]


def test_the_projection_of_the_test_goal() -> None:
    turn = motoman_l3.pointed(ROBOT, goal(), NOW)
    assert np.degrees(turn.angle) == pytest.approx(ANGLE, abs=5e-5)
    np.testing.assert_allclose(turn.Z, POINTING, atol=5e-7)
    answer = closed.solve_closed_form(motoman_l3, ROBOT, goal(), NOW)
    np.testing.assert_allclose(answer.T_world_goal[:3, 2], turn.Z, atol=1e-12)
    assert answer.turned == pytest.approx(abs(turn.angle), abs=1e-12)
    assert answer.values[0]["θ"] == pytest.approx(turn.angle)
    assert ("16.7°" in answer.words.en, "16,7°" in answer.words.pt_BR) == (True, True)


@given(p=points, turn=st.tuples(angles, st.floats(-1.5, 1.5), angles))
@settings(max_examples=40)
def test_the_projection_is_the_smallest_turn_into_the_plane(
    p: tuple[float, ...], turn: tuple[float, float, float]
) -> None:
    T = pose(p, euler.euler_matrix(list(turn), "zyx"))
    steps = motoman_l3.pointed(ROBOT, T, NOW)
    np.testing.assert_allclose(steps.R.T @ steps.R, np.eye(3), atol=1e-12)
    assert steps.M @ steps.R[:, 2] == pytest.approx(0, abs=1e-12)
    # the slope of asin rises without bound where its argument comes to 1
    assert np.sin(abs(steps.angle)) == pytest.approx(abs(steps.M @ T[:3, 2]), abs=1e-12)
    goal = closed.solve_closed_form(motoman_l3, ROBOT, T, NOW).T_world_goal
    np.testing.assert_allclose(goal, pose(p, steps.R), atol=1e-12)
    turned = between(T, goal)[1]
    up, out = np.array([0, 0, 1.0]), np.cross(steps.M, [0, 0, 1.0])
    for tilt in np.linspace(-3, 3, 7):
        Z = np.cos(tilt) * out + np.sin(tilt) * up
        for spin in np.linspace(0, np.pi, 5):
            other = np.cos(spin) * steps.M + np.sin(spin) * np.cross(Z, steps.M)
            assert between(T, pose(p, np.column_stack([np.cross(other, Z), other, Z])))[1] >= turned - 1e-9


@given(q=st.tuples(angles, angles, st.floats(0.01, 3.1), angles, angles), sign=st.sampled_from([-1, 1]))
def test_every_posture_is_found_again(q: tuple[float, ...], sign: int) -> None:
    theta = np.array(q) * [1, 1, sign, 1, 1]
    answer = closed.solve_closed_form(motoman_l3, ROBOT, tool_at(ROBOT, theta), theta)
    assert len(answer.branches) == 4
    assert worst(ROBOT, answer) < 1e-9
    reach = np.hypot(*tool_at(ROBOT, theta)[:2, 3])
    assert recovered(answer, theta) < 1e-9 + 1e-14 / reach
    assert (answer.moved, answer.turned, answer.short) == pytest.approx((0, 0, 0), abs=1e-9)


def test_each_step_follows_from_those_before() -> None:
    """The steps: u, c₃, θ₂ and the sum a = θ₂ + θ₃ + θ₄."""
    l2, l3 = 0.4, 0.5
    for steps in closed.solve_closed_form(motoman_l3, ROBOT, goal(), NOW).values:
        u, p_z = steps["u"], steps["p_z"]
        assert u == pytest.approx(np.cos(steps["θ₁"]) * steps["p_x"] + np.sin(steps["θ₁"]) * steps["p_y"])
        assert steps["c₃"] == pytest.approx((u**2 + p_z**2 - l2**2 - l3**2) / (2 * l2 * l3))
        lift = -np.arctan2(p_z, u) - np.arctan2(l3 * steps["s₃"], l2 + l3 * steps["c₃"])
        assert np.exp(1j * steps["θ₂"]) == pytest.approx(np.exp(1j * lift))
        total = steps["θ₂"] + steps["θ₃"] + steps["θ₄"]
        assert np.exp(1j * steps["a"]) == pytest.approx(np.exp(1j * total))


@pytest.mark.parametrize(("d", "count"), [(-1e-6, 4), (0, 2), (1e-6, 0)])
@pytest.mark.parametrize(("edge", "outward"), [(0.9, 1), (0.1, -1)])
def test_postures_meet_on_the_edges(edge: float, outward: int, d: float, count: int) -> None:
    r = edge + outward * d
    answer = closed.solve_closed_form(motoman_l3, ROBOT, pose((0.6 * r, 0, 0.8 * r), np.eye(3)), NOW)
    assert len(answer.branches) == count
    assert answer.short == pytest.approx(max(d, 0), rel=1e-6, abs=1e-12)


def test_out_of_reach_is_a_value_with_words() -> None:
    answer = closed.solve_closed_form(motoman_l3, ROBOT, pose((900, 0, 1200), np.eye(3)), NOW)
    assert answer.branches == ()
    assert answer.short == pytest.approx(1499.1)
    for language, edge in zip(LANGUAGES, ("outer radius", "raio externo"), strict=True):
        assert edge in answer.words[language]


@given(z=st.floats(0.15, 0.85), heading=angles, tilt=st.floats(0.01, 3.1), now=angles)
@settings(max_examples=40)
def test_over_the_waist_the_hand_gives_the_plane(z: float, heading: float, tilt: float, now: float) -> None:
    """At p_x = p_y = 0 every plane of the arm holds the point; the one in which the hand points needs no turn."""
    T = pose((0, 0, z), euler.euler_matrix([heading, tilt, 0.3], "zyz"))
    answer = closed.solve_closed_form(motoman_l3, ROBOT, T, np.array([now, 0, 0, 0, 0]))
    assert (answer.turned, answer.free) == (pytest.approx(0, abs=1e-9), ())
    assert len(answer.branches) == 4
    assert worst(ROBOT, answer) < 1e-9
    assert np.exp(1j * answer.branches[0].q[0]) == pytest.approx(np.exp(1j * heading), abs=1e-9)


@given(z=st.floats(0.15, 0.85), roll=angles, now=st.floats(-2.9, 2.9), down=st.booleans())
@settings(max_examples=40)
def test_upright_over_the_waist_theta_1_is_free_and_kept(z: float, roll: float, now: float, down: bool) -> None:
    T = pose((0, 0, z), euler.euler_matrix([0, np.pi * down, roll], "zyz"))
    answer = closed.solve_closed_form(motoman_l3, ROBOT, T, np.array([now, 0, 0, 0, 0]))
    assert answer.free == (0,)
    assert answer.branches[0].q[0] == pytest.approx(now)
    assert worst(ROBOT, answer) < 1e-9
    assert "θ₁" in answer.words.pt_BR


@pytest.mark.parametrize("side", [-1, 1])
def test_a_hand_square_to_the_plane_is_turned_outward(side: int) -> None:
    """Ẑ ∥ M: every direction of the plane is 90° away."""
    p = np.array([0.3, 0.4, 0.2])
    M = np.array([-0.8, 0.6, 0])
    T = pose(p, np.column_stack([np.cross([0, 0, 1.0], side * M), [0, 0, 1.0], side * M]))
    answer = closed.solve_closed_form(motoman_l3, ROBOT, T, NOW)
    np.testing.assert_allclose(answer.T_world_goal[:3, 2], [0.6, 0.8, 0], atol=1e-12)
    assert answer.turned == pytest.approx(np.pi / 2)
    assert len(answer.branches) == 4
    assert worst(ROBOT, answer) < 1e-12


@pytest.mark.parametrize("side", [-1e-9, 1e-7])
def test_nearly_square_to_the_plane_the_turn_stays_a_rotation(side: float) -> None:
    M = np.array([-0.8, 0.6, 0])
    R = rotation.exponential(side * np.array([0.3, 0.5, 0.8])) @ np.column_stack(
        [np.cross([0, 0, 1.0], M), [0, 0, 1.0], M]
    )
    answer = closed.solve_closed_form(motoman_l3, ROBOT, pose((0.3, 0.4, 0.2), R), NOW)
    assert answer.turned == pytest.approx(np.pi / 2, abs=1e-6)
    assert worst(ROBOT, answer) < 1e-12


def test_equal_links_folded_leave_the_upper_arm_free() -> None:
    robot = equal_links()
    now = np.array([0.4, -1.1, 0, 0, 0])
    answer = closed.solve_closed_form(
        motoman_l3, robot, pose((0, 0, 0), euler.euler_matrix([0.2, 0.5, 0.1], "zyz")), now
    )
    assert answer.free == (1,)
    assert {round(float(branch.q[1]), 9) for branch in answer.branches} == {-1.1}
    assert worst(robot, answer) < 1e-12


def test_actuators_count_every_posture_that_they_can_hold() -> None:
    """A → θ → A and back, for the branches that the ball screws hold."""
    assert ROBOT.actuators is not None
    held = {}
    for branch in closed.solve_closed_form(motoman_l3, ROBOT, goal(), NOW).branches:
        try:
            pulses = ROBOT.actuators.from_joints(branch.q)
        except HelicoideError:
            continue
        held[branch.name.en] = branch
        np.testing.assert_allclose(ROBOT.actuators.to_joints(pulses), branch.q, atol=1e-9)
        back = ROBOT.actuators.from_joints(ROBOT.actuators.to_joints(pulses))
        np.testing.assert_allclose(back, pulses, rtol=1e-12, atol=1e-6)
    assert list(held) == ["front, elbow up", "front, elbow down"]


@pytest.mark.parametrize("numbers", [(0,), (1,), (2, 4), (1, 2, 3), (3,)])
def test_an_arm_that_stands_elsewhere_and_counts_the_other_way(numbers: tuple[int, ...]) -> None:
    place = pose((0.3, -0.2, 0.5), euler.euler_matrix([0.4, -0.9, 2.0], "zyx"))
    robot = moved(reversed_axes(ROBOT, *numbers), place)
    assert motoman_l3.applies(robot) is None
    for q in np.random.default_rng(0).uniform(-3, 3, (8, 5)):
        answer = closed.solve_closed_form(motoman_l3, robot, tool_at(robot, q), NOW)
        assert worst(robot, answer) < 1e-9
        assert recovered(answer, q) < 1e-9


@pytest.mark.parametrize("numbers", [(1,), (1, 2, 3, 4)])
def test_the_front_is_where_the_tool_stands_at_zero(numbers: tuple[int, ...]) -> None:
    """Also where the shoulder counts the other way, so that its axis points to the right."""
    answer = closed.solve_closed_form(motoman_l3, reversed_axes(ROBOT, *numbers), goal(), NOW)
    assert [branch.name.en for branch in answer.branches] == list(SOLUTIONS)
    heading = [np.degrees(branch.q[0]) for branch in answer.branches]
    assert heading == pytest.approx([21.8014, 21.8014, -158.1986, -158.1986], abs=1e-4)


def test_a_tool_ahead_of_the_wrist_keeps_its_point() -> None:
    """The wrist's plane is that of a tool point on its axis: {W} = {G} (T_wrist_tool)⁻¹, s.14."""
    longer = replace(ROBOT, T_world_tool_0=frozen(pose((0.9, 0, 0.12), euler.euler_matrix([0.7, 0, 0], "zyx"))))
    answer = closed.solve_closed_form(motoman_l3, longer, goal(), NOW)
    assert answer.moved == 0
    assert answer.turned == pytest.approx(np.radians(16.6918), abs=1e-6)
    assert len(answer.branches) == 4
    assert worst(longer, answer) < 1e-12
    beside = replace(ROBOT, T_world_tool_0=frozen(pose((0.95, 0, 0.12), np.eye(3))))
    assert motoman_l3.applies(beside) is not None


@pytest.mark.parametrize("name", ["planar3r", "movemaster", "puma560"])
def test_other_arms_are_refused_in_words(name: str) -> None:
    robot = load_robot(name)
    assert isinstance(motoman_l3.applies(robot), Text)
    with pytest.raises(HelicoideError, match="This form needs"):
        closed.solve_closed_form(motoman_l3, robot, np.eye(4), np.zeros(len(robot.variables)))


def test_a_goal_that_is_no_pose_is_refused() -> None:
    T = goal()
    T[0, 3] = np.nan
    for function in (partial(closed.solve_closed_form, motoman_l3), motoman_l3.pointed):
        with pytest.raises(HelicoideError, match="pose"):
            function(ROBOT, T, NOW)
        with pytest.raises(HelicoideError, match="finite joint values"):
            function(ROBOT, goal(), np.zeros(4))
