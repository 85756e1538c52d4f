"""The planar 2R: Campos 1998, s.6–14 (how many postures, where) and s.44–54 (both roads)."""

from __future__ import annotations

from dataclasses import replace
from math import hypot

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.ik.closed.small_arms import end_of, moved, recovered, reversed_axes

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler
from helicoide.ik import closed
from helicoide.ik.closed import planar2r
from helicoide.ik.families import elbow
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.library import load_robot
from helicoide.studies._campos_arms import planar_pose, planar_with_lengths, with_joint_limits
from helicoide.text import LANGUAGES, HelicoideError, untranslated

ROBOT = load_robot("planar2r")
LENGTHS = [(1.0, 0.7), (0.7, 1.0), (1.0, 1.0), (2.0, 0.3)]
lengths = st.floats(0.1, 3)
angles = st.floats(-np.pi, np.pi)


@pytest.mark.parametrize(("l1", "l2"), LENGTHS)
@pytest.mark.parametrize("heading", [0.0, 1.1, 2.0, -2.9])
def test_two_postures_inside_one_on_an_edge_none_outside(l1: float, l2: float, heading: float) -> None:
    robot, links = planar_with_lengths("planar2r", l1, l2), elbow.Annulus(l1, l2)

    def count(r: float) -> int:
        return len(
            closed.solve_closed_form(
                planar2r, robot, planar_pose(r * np.cos(heading), r * np.sin(heading)), np.zeros(2)
            ).branches
        )

    assert [count(links.outer + d) for d in (-1e-6, 0, 1e-6)] == [2, 1, 0]
    assert count((links.inner + links.outer) / 2) == 2
    if links.inner > 0:
        assert [count(links.inner + d) for d in (-1e-6, 0, 1e-6)] == [0, 1, 2]


@pytest.mark.parametrize(("r", "short"), [(1.75, 0.05), (1e6, 1e6 - 1.7), (0.25, 0.05), (0.0, 0.3)])
def test_out_of_reach_is_said_with_the_distance_to_the_edge(r: float, short: float) -> None:
    """Limits of the annulus: s.10, s.44, s.53."""
    answer = closed.solve_closed_form(planar2r, ROBOT, planar_pose(0.6 * r, -0.8 * r), np.zeros(2))
    assert answer.branches == ()
    assert answer.short == pytest.approx(short, rel=1e-12)
    assert abs(answer.values[0]["c₂"]) > 1
    for language in LANGUAGES:
        assert untranslated("{short:.3g} mm").format(short=1000 * short)[language] in answer.words[language]


@given(l1=lengths, l2=lengths, theta=st.tuples(angles, angles))
def test_both_roads_lead_to_the_same_angles(l1: float, l2: float, theta: tuple[float, float]) -> None:
    links = elbow.Annulus(l1, l2)
    x, y = end_of(*theta, links)
    assume(not links.on_edge(hypot(x, y)) and links.beyond(hypot(x, y)) == 0)
    found = elbow.elbow_postures(x, y, links, kept=0.0)
    assert len(found) == 2
    # θ₂ loses digits where the arm is nearly straight, θ₁ and the point also where they nearly meet the first axis
    nearness = links.outer / hypot(x, y)
    of_angles = 1e-14 * links.outer**2 / (l1 * l2 * abs(np.sin(theta[1]))) * (1 + nearness)
    for posture in found:
        one, two = posture.algebraic, posture.geometric
        np.testing.assert_allclose([two.theta2, np.cos(two.theta1 - one.theta1)], [one.theta2, 1], atol=of_angles)
        assert abs(np.sin(two.theta1 - one.theta1)) < of_angles
        end = end_of(one.theta1, one.theta2, links)
        np.testing.assert_allclose(end, (x, y), atol=1e-14 * links.outer * (1 + nearness))
        sign = 1 if two.theta2 < 0 else -1
        assert np.exp(1j * (two.beta + sign * two.psi)) == pytest.approx(np.exp(1j * one.theta1), abs=of_angles)
        assert one.r == pytest.approx(hypot(x, y), abs=1e-14 * links.outer * (1 + nearness))


@given(l1=lengths, l2=lengths, theta1=angles, theta2=st.sampled_from([0.0, np.pi]))
def test_both_roads_on_the_edges(l1: float, l2: float, theta1: float, theta2: float) -> None:
    links = elbow.Annulus(l1, l2)
    assume(links.inner > 1e-3)
    x, y = end_of(theta1, theta2, links)
    (posture,) = elbow.elbow_postures(x, y, links, kept=0.0)
    one, two = posture.algebraic, posture.geometric
    assert (one.theta2, two.theta2) == (theta2, theta2)
    assert posture.name == (elbow.FOLDED if theta2 else elbow.STRETCHED)
    for theta in (one.theta1, two.theta1):
        assert np.exp(1j * theta) == pytest.approx(np.exp(1j * theta1), abs=1e-11)


@given(theta=st.tuples(angles, st.floats(0.01, 3.1)), sign=st.sampled_from([-1, 1]))
def test_every_posture_comes_to_the_point(theta: tuple[float, float], sign: int) -> None:
    q = np.array([theta[0], sign * theta[1]])
    T = tool_at(ROBOT, q)
    answer = closed.solve_closed_form(planar2r, ROBOT, T, np.zeros(2))
    assert max(branch.missed for branch in answer.branches) < 1e-12
    assert recovered(answer, q) < 1e-9
    # the goal is the asked pose, which one of the two has; the other has the mirrored elbow and another orientation
    np.testing.assert_allclose(answer.T_world_goal, T, atol=1e-9)
    turns = [between(T, tool_at(ROBOT, branch.q))[1] for branch in answer.branches]
    assert sorted(turn < 1e-9 for turn in turns) == [False, True]
    np.testing.assert_allclose([branch.turned for branch in answer.branches], turns, atol=1e-9)
    assert (answer.moved, answer.turned) == pytest.approx((0, 0), abs=1e-9)


def test_the_two_orientations_are_those_of_the_postures() -> None:
    answer = closed.solve_closed_form(planar2r, ROBOT, planar_pose(1, 0.8), np.zeros(2))
    for branch, steps in zip(answer.branches, answer.values, strict=True):
        assert between(tool_at(ROBOT, branch.q), planar_pose(1, 0.8, steps["φ"])) == pytest.approx((0, 0), abs=1e-12)
        for language in LANGUAGES:
            assert (
                untranslated("{phi:.1f}°").format(phi=float(np.degrees(steps["φ"])))[language] in answer.words[language]
            )
    np.testing.assert_allclose(np.degrees(answer.branches[0].q), [5.740205, 83.849360], atol=1e-6)
    assert [branch.name.en for branch in answer.branches] == ["elbow down", "elbow up"]


@given(phi=angles, kept=angles)
def test_equal_links_reach_the_centre_with_every_orientation(phi: float, kept: float) -> None:
    """s.8: the dexterous space is one point, and there θ₁ is free."""
    robot = planar_with_lengths("planar2r", 1.0, 1.0)
    answer = closed.solve_closed_form(planar2r, robot, planar_pose(0, 0, phi), np.array([kept, 0.3]))
    (branch,) = answer.branches
    assert answer.free == (0,)
    np.testing.assert_allclose(np.exp(1j * branch.q), np.exp(1j * np.array([kept, np.pi])), atol=1e-12)
    assert branch.missed < 1e-12
    assert between(tool_at(robot, frozen([phi - np.pi, np.pi])), planar_pose(0, 0, phi)) == pytest.approx(
        (0, 0), abs=1e-9
    )


@given(r=st.floats(0.301, 1.699), heading=angles)
def test_limits_leave_one_posture_for_every_point_inside(r: float, heading: float) -> None:
    """s.12: θ₁ in [0, 360)°, θ₂ in [0, 180]°: the same points, one orientation for each."""
    robot = with_joint_limits(ROBOT, [0, 0], [2 * np.pi, np.pi])
    answer = closed.solve_closed_form(
        planar2r, robot, planar_pose(r * np.cos(heading), r * np.sin(heading)), np.zeros(2)
    )
    (kept,) = [branch for branch in answer.branches if branch.within]
    assert np.all((kept.q >= -1e-9) & (kept.q <= [2 * np.pi, np.pi]))
    assert kept.missed < 1e-12


def test_another_tool_moves_the_edge() -> None:
    """s.13: with a tool 100 mm longer the edge lies 100 mm farther out."""
    T = ROBOT.T_world_tool_0.copy()
    T[0, 3] += 0.1
    longer = replace(ROBOT, T_world_tool_0=frozen(T))
    assert closed.solve_closed_form(planar2r, ROBOT, planar_pose(1.79, 0), np.zeros(2)).short == pytest.approx(0.09)
    assert closed.solve_closed_form(planar2r, longer, planar_pose(1.79, 0), np.zeros(2)).short == 0
    assert closed.solve_closed_form(planar2r, longer, planar_pose(1.81, 0), np.zeros(2)).short == pytest.approx(0.01)


def test_an_arm_that_stands_elsewhere_and_counts_the_other_way(rng: np.random.Generator) -> None:
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = euler.euler_matrix([0.4, -0.9, 2.0], "zyx"), (0.3, -0.2, 0.5)
    bent = ROBOT.T_world_tool_0.copy()
    bent[:3, 3] = (1.3, 0.4, 0.05)
    robot = moved(reversed_axes(replace(ROBOT, T_world_tool_0=frozen(bent)), 1), place)
    for q in rng.uniform(-3, 3, (20, 2)):
        answer = closed.solve_closed_form(planar2r, robot, tool_at(robot, q), q)
        assert max(branch.missed for branch in answer.branches) < 1e-12
        assert recovered(answer, q) < 1e-9


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_goal_that_is_no_pose_is_refused(bad: float) -> None:
    for T in (planar_pose(bad, 0), 2 * planar_pose(0.5, 0), np.eye(3), np.diag([1.0, 1, -1, 1])):
        with pytest.raises(HelicoideError, match="pose"):
            closed.solve_closed_form(planar2r, ROBOT, T, np.zeros(2))
    with pytest.raises(HelicoideError, match="finite joint values"):
        closed.solve_closed_form(planar2r, ROBOT, planar_pose(1, 0), np.array([bad, 0]))


@pytest.mark.parametrize("name", ["planar3r", "polar_rp", "scara", "movemaster"])
def test_other_arms_are_refused_in_words(name: str) -> None:
    robot = load_robot(name)
    reason = planar2r.applies(robot)
    assert reason is not None
    with pytest.raises(HelicoideError, match="This form needs"):
        closed.solve_closed_form(planar2r, robot, np.eye(4), np.zeros(len(robot.variables)))


def test_coinciding_axes_are_refused() -> None:
    joints = (ROBOT.joints[0], replace(ROBOT.joints[1], point=ROBOT.joints[0].point))
    assert planar2r.applies(ROBOT) is None
    assert planar2r.applies(replace(ROBOT, joints=joints)) is not None


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(0)


def test_steps_are_numbers_of_the_source() -> None:
    """Each step of s.44–48 follows from those before it."""
    for steps in closed.solve_closed_form(planar2r, ROBOT, planar_pose(1, 0.8), np.zeros(2)).values:
        x, y, l1, l2 = steps["x"], steps["y"], 1.0, 0.7
        assert steps["c₂"] == pytest.approx((x**2 + y**2 - l1**2 - l2**2) / (2 * l1 * l2))
        assert steps["s₂"] ** 2 + steps["c₂"] ** 2 == pytest.approx(1)
        assert (steps["k₁"], steps["k₂"]) == pytest.approx((l1 + l2 * steps["c₂"], l2 * steps["s₂"]))
        angle = steps["γ"] + steps["θ₁"]
        assert steps["r"] * np.array([np.cos(angle), np.sin(angle)]) == pytest.approx([x, y])


def test_near_the_edge_the_point_is_still_met() -> None:
    for inside in (1e-11, 1e-9, 1e-7):
        answer = closed.solve_closed_form(planar2r, ROBOT, planar_pose(1.7 - inside, 0), np.zeros(2))
        assert max(branch.missed for branch in answer.branches) <= 1e-9
        points: list[Array] = [tool_at(ROBOT, branch.q)[:2, 3] for branch in answer.branches]
        np.testing.assert_allclose(points, [[1.7 - inside, 0]] * len(points), atol=1e-9)
