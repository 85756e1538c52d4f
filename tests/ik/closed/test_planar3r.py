"""The planar 3R: Campos 1998, s.29 (subspace), s.38–49 (algebraic road), s.50–54 (geometric road)."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.ik.closed.rows import worst
from tests.ik.closed.small_arms import end_of, moved, recovered, reversed_axes, with_points

from helicoide.arrays import Array
from helicoide.geometry import euler
from helicoide.ik import closed
from helicoide.ik.closed import planar3r
from helicoide.ik.families import elbow
from helicoide.ik.families import planar as frames
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar_pose, planar_with_lengths
from helicoide.studies.campos_dexterous import orientation_share
from helicoide.text import LANGUAGES, HelicoideError

L3 = 0.2
ROBOT = planar_with_lengths("planar3r", 1.0, 0.7, L3)
ORCA = load_robot("orca")
angles = st.floats(-np.pi, np.pi)


def of_wrist(x: float, y: float, phi: float) -> Array:
    """The tool pose whose third axis stands at (x, y): the source has no third link."""
    return planar_pose(x + L3 * np.cos(phi), y + L3 * np.sin(phi), phi)


def test_the_numbers_of_the_source() -> None:
    """(x, y, φ) = (1, 0.8, 0.5) of the third axis; recomputed from the formulas of the source."""
    answer = closed.solve_closed_form(planar3r, ROBOT, of_wrist(1, 0.8, 0.5), np.zeros(3))
    expected = [[0.100185, 1.463447, -1.063633], [1.249296, -1.463447, 0.714151]]
    np.testing.assert_allclose([branch.q for branch in answer.branches], expected, atol=5e-7)
    assert [branch.name.pt_BR for branch in answer.branches] == ["cotovelo para baixo", "cotovelo para cima"]
    assert worst(ROBOT, answer) < 1e-12


@pytest.mark.parametrize("robot", [ROBOT, ORCA, load_robot("planar3r")], ids=["(1, 0.7, 0.2)", "orca", "(2, 1, 1)"])
@given(theta=st.tuples(angles, st.floats(0.001, 3.14), angles), sign=st.sampled_from([-1, 1]))
@settings(max_examples=50)
def test_every_posture_is_found_again(robot: Robot, theta: tuple[float, float, float], sign: int) -> None:
    q = np.array([theta[0], sign * theta[1], theta[2]])
    answer = closed.solve_closed_form(planar3r, robot, tool_at(robot, q), np.zeros(3))
    assert len(answer.branches) == 2
    assert worst(robot, answer) < 1e-12
    assert recovered(answer, q) < 1e-9
    assert (answer.moved, answer.turned, answer.short) == pytest.approx((0, 0, 0), abs=1e-9)


@given(x=st.floats(-1.7, 1.7), y=st.floats(-1.7, 1.7), phi=angles)
def test_each_step_follows_from_those_before(x: float, y: float, phi: float) -> None:
    """s.43–49 and s.52–54, with the numbers that a page shows."""
    answer = closed.solve_closed_form(planar3r, ROBOT, of_wrist(x, y, phi), np.zeros(3))
    assert (len(answer.branches) == 0) == (answer.short > 0)
    assert len(answer.values) == max(1, len(answer.branches))
    for branch, steps in zip(answer.branches, answer.values, strict=False):
        one, two, three = steps["θ₁"], steps["θ₂"], steps["θ₃"]
        # on an edge θ₂ is exactly 0 or π, and near one it keeps half of its digits
        near = 1e-12 / max(abs(np.sin(two)), 1e-6)
        assert end_of(one, two, elbow.Annulus(1, 0.7)) == pytest.approx((x, y), abs=1e-11)
        assert np.exp(1j * (one + two + three)) == pytest.approx(np.exp(1j * phi), abs=1e-12)
        psi = steps["ψ"] if two < 0 else -steps["ψ"]
        assert np.exp(1j * (steps["β"] + psi)) == pytest.approx(np.exp(1j * one), abs=near)
        np.testing.assert_allclose(np.exp(1j * branch.q), np.exp(1j * np.array([one, two, three])), atol=1e-12)


@pytest.mark.parametrize(("r", "expected"), [(0.49, 0.92), (0.51, 1.0), (1.0, 1.0), (1.49, 1.0), (1.51, 0.89)])
def test_share_of_orientations_around_the_dexterous_region(r: float, expected: float) -> None:
    """s.6–10, s.53: L = (1, 0.7, 0.2), limits 0.5 and 1.5."""
    assert orientation_share(r, L3, 3600) == pytest.approx(expected, abs=0.005)


@given(tilt=st.tuples(st.floats(-1, 1), st.floats(-1, 1)), z=st.floats(-2, 2), phi=angles)
@settings(max_examples=40)
def test_a_tilted_goal_is_laid_into_the_plane(tilt: tuple[float, float], z: float, phi: float) -> None:
    """s.29, s.36: z is dropped, φ' = Atan2(r₂₁ − r₁₂, r₁₁ + r₂₂), which no other φ comes nearer to."""
    T = planar_pose(0.9, 0.4, z=z)
    T[:3, :3] = euler.euler_matrix([phi, *tilt], "zyx")
    R = T[:3, :3]
    answer = closed.solve_closed_form(planar3r, ROBOT, T, np.zeros(3))
    expected = planar_pose(0.9, 0.4, np.arctan2(R[1, 0] - R[0, 1], R[0, 0] + R[1, 1]))
    np.testing.assert_allclose(answer.T_world_goal, expected, atol=1e-9)
    assert answer.moved == pytest.approx(abs(z), abs=1e-9)
    others = [between(T, planar_pose(0.9, 0.4, other))[1] for other in np.linspace(-np.pi, np.pi, 73)]
    assert answer.turned <= min(others) + 1e-9


def test_out_of_reach_is_a_value_with_words() -> None:
    answer = closed.solve_closed_form(planar3r, ROBOT, of_wrist(0.6 * 2, 0.8 * 2, 1.0), np.zeros(3))
    assert answer.branches == ()
    assert answer.short == pytest.approx(0.3)
    for language in LANGUAGES:
        assert "300 mm" in answer.words[language]


@given(kept=st.floats(-3, 3), phi=angles)
def test_the_wrist_over_the_first_axis_leaves_theta_1_free(kept: float, phi: float) -> None:
    robot = planar_with_lengths("planar3r", 0.8, 0.8, L3)
    answer = closed.solve_closed_form(planar3r, robot, of_wrist(0, 0, phi), np.array([kept, 0.1, 0.2]))
    (branch,) = answer.branches
    assert answer.free == (0,)
    assert branch.q[0] == pytest.approx(kept)
    assert worst(robot, answer) < 1e-12


@given(x=st.floats(-2, 2), y=st.floats(-2, 2), phi=angles)
@settings(max_examples=50)
def test_from_the_tool_to_the_wrist_and_back(x: float, y: float, phi: float) -> None:
    """s.14: {W} = B_S · S_G · (W_T)⁻¹; the person thinks of the tool, the form of the third axis."""
    arm = frames.planar(ORCA, 3)
    assert isinstance(arm, frames.Planar)
    T = planar_pose(x, y, phi)
    np.testing.assert_allclose(arm.tool(*arm.end(T)), T, atol=1e-12)
    assert arm.end(T)[:2] == pytest.approx((x - 0.17 * np.cos(phi), y - 0.17 * np.sin(phi)), abs=1e-12)


@pytest.mark.parametrize("numbers", [(0,), (1,), (2,), (0, 2)])
def test_an_arm_that_stands_elsewhere_and_counts_the_other_way(numbers: tuple[int, ...]) -> None:
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = euler.euler_matrix([0.4, -0.9, 2.0], "zyx"), (0.3, -0.2, 0.5)
    robot = moved(reversed_axes(ROBOT, *numbers), place)
    for q in np.random.default_rng(0).uniform(-3, 3, (20, 3)):
        answer = closed.solve_closed_form(planar3r, robot, tool_at(robot, q), np.zeros(3))
        assert worst(robot, answer) < 1e-12
        assert recovered(answer, q) < 1e-9


def test_an_arm_bent_at_zero() -> None:
    """Where the file counts from a bent arm the angles of the source are shifted."""
    bent = with_points(ROBOT, [(0, 0, 0), (1, 0, 0.3), (1.2, 0.5, 0.1)], planar_pose(1.3, 0.9, 0.4, z=-0.2))
    for q in np.random.default_rng(1).uniform(-3, 3, (20, 3)):
        answer = closed.solve_closed_form(planar3r, bent, tool_at(bent, q), np.zeros(3))
        assert worst(bent, answer) < 1e-12
        assert recovered(answer, q) < 1e-9


def test_limits_are_told() -> None:
    """ORCA's elbow holds ±150°: a point nearer than that allows is met outside the limits only."""
    q = np.radians([10.0, 155.0, 20.0])
    answer = closed.solve_closed_form(planar3r, ORCA, tool_at(ORCA, q), np.zeros(3))
    assert [branch.within for branch in answer.branches] == [False, False]
    q = np.radians([10.0, 145.0, 20.0])
    assert closed.solve_closed_form(planar3r, ORCA, tool_at(ORCA, q), np.zeros(3)).branches[0].within


@pytest.mark.parametrize("name", ["planar2r", "scara", "motoman_l3", "puma560"])
def test_other_arms_are_refused_in_words(name: str) -> None:
    robot = load_robot(name)
    assert planar3r.applies(robot) is not None
    with pytest.raises(HelicoideError, match="This form needs"):
        closed.solve_closed_form(planar3r, robot, np.eye(4), np.zeros(len(robot.variables)))


def test_a_goal_that_is_no_pose_is_refused() -> None:
    with pytest.raises(HelicoideError, match="pose"):
        closed.solve_closed_form(planar3r, ROBOT, planar_pose(0.5, np.nan), np.zeros(3))
