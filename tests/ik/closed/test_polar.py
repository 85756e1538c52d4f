"""The polar arm: Campos 1998, s.31–34."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.ik.closed.rows import worst
from tests.ik.closed.small_arms import moved

from helicoide.arrays import frozen
from helicoide.geometry import euler
from helicoide.ik import closed
from helicoide.ik.closed import polar
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.library import load_robot
from helicoide.studies._campos_arms import planar_pose
from helicoide.text import LANGUAGES, HelicoideError

ROBOT = load_robot("polar_rp")
angles = st.floats(-np.pi, np.pi)


@given(x=st.floats(-2, 2), y=st.floats(-2, 2), z=st.floats(-1, 1), turn=st.tuples(angles, st.floats(-1.5, 1.5), angles))
def test_a_goal_takes_the_matrix_of_the_subspace(x: float, y: float, z: float, turn: tuple[float, ...]) -> None:
    """s.31–36: x' = x, y' = y, z' = 0, and the forced orientation."""
    rho = np.hypot(x, y)
    assume(rho > 1e-6)
    T = planar_pose(x, y, z=z)
    T[:3, :3] = euler.euler_matrix(list(turn), "zyx")
    answer = closed.solve_closed_form(polar, ROBOT, T, np.zeros(2))
    expected = [[y / rho, 0, x / rho, x], [-x / rho, 0, y / rho, y], [0, -1, 0, 0], [0, 0, 0, 1]]
    np.testing.assert_allclose(answer.T_world_goal, expected, atol=1e-12)
    assert (answer.moved, answer.turned) == pytest.approx(between(T, np.array(expected)), abs=1e-9)
    (branch,) = answer.branches
    assert np.exp(1j * branch.q[0]) == pytest.approx(complex(y, -x) / rho, abs=1e-12)
    assert branch.q[1] == pytest.approx(rho, abs=1e-12)
    assert worst(ROBOT, answer) < 1e-12


@given(theta1=st.floats(-3.1, 3.1), rho=st.floats(0.3, 0.8))
def test_every_posture_is_found_again(theta1: float, rho: float) -> None:
    answer = closed.solve_closed_form(polar, ROBOT, tool_at(ROBOT, frozen([theta1, rho])), np.zeros(2))
    np.testing.assert_allclose(answer.branches[0].q, [theta1, rho], atol=1e-12)
    assert answer.branches[0].within
    assert (answer.moved, answer.turned) == pytest.approx((0, 0), abs=1e-12)


@given(theta1=st.floats(-3.1, 3.1))
def test_on_the_axis_theta_1_is_kept_and_it_is_said(theta1: float) -> None:
    answer = closed.solve_closed_form(polar, ROBOT, planar_pose(0, 0), np.array([theta1, 0.5]))
    (branch,) = answer.branches
    assert answer.free == (0,)
    np.testing.assert_allclose(branch.q, [theta1, 0], atol=1e-12)
    assert not branch.within
    assert worst(ROBOT, answer) < 1e-12
    for language, axis in zip(LANGUAGES, ("axis of joint 1", "eixo da junta 1"), strict=True):
        assert "ρ = 0" in answer.words[language]
        assert axis in answer.words[language]


@pytest.mark.parametrize(("rho", "far"), [(0.9, "100 mm"), (0.25, "50 mm"), (0.6, None)])
def test_a_point_beyond_the_stroke_is_told(rho: float, far: str | None) -> None:
    answer = closed.solve_closed_form(polar, ROBOT, planar_pose(rho, 0), np.zeros(2))
    assert answer.branches[0].within == (far is None)
    for language, stroke in zip(LANGUAGES, ("stroke", "curso"), strict=True):
        assert (stroke in answer.words[language]) == (far is not None)
        assert far is None or far in answer.words[language]


def test_an_arm_that_stands_elsewhere_with_its_tool_ahead() -> None:
    T = ROBOT.T_world_tool_0.copy()
    T[:3, 3] = 0, 0.15, 0.2
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = euler.euler_matrix([0.4, -0.9, 2.0], "zyx"), (0.3, -0.2, 0.5)
    robot = moved(replace(ROBOT, T_world_tool_0=frozen(T)), place)
    for q in np.random.default_rng(0).uniform([-3, 0.3], [3, 0.8], (20, 2)):
        answer = closed.solve_closed_form(polar, robot, tool_at(robot, q), np.zeros(2))
        np.testing.assert_allclose(answer.branches[0].q, q, atol=1e-12)
        assert worst(robot, answer) < 1e-12


def test_a_tool_beside_the_axis_is_another_arm() -> None:
    T = ROBOT.T_world_tool_0.copy()
    T[0, 3] = 0.01
    assert polar.applies(ROBOT) is None
    assert polar.applies(replace(ROBOT, T_world_tool_0=frozen(T))) is not None


@pytest.mark.parametrize("name", ["planar2r", "scara"])
def test_other_arms_are_refused_in_words(name: str) -> None:
    robot = load_robot(name)
    assert polar.applies(robot) is not None
    with pytest.raises(HelicoideError, match="This form needs"):
        closed.solve_closed_form(polar, robot, np.eye(4), np.zeros(len(robot.variables)))


def test_a_goal_that_is_no_pose_is_refused() -> None:
    with pytest.raises(HelicoideError, match="pose"):
        closed.solve_closed_form(polar, ROBOT, planar_pose(0.5, np.nan), np.zeros(2))
