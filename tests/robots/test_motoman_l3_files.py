"""The L-3 of Campos 1998, slide 55: its files against the closed form and the example worked out for it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.kinematics import forward
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

ROBOT = robot_from_folder(Path(__file__).parents[2] / "robots" / "motoman_l3")
L2, L3 = 0.4, 0.5
# The four solutions for one goal, degrees; the last lays the upper arm down behind the waist.
SOLUTIONS = {
    "elbow_up": (21.8014, -83.1026, 94.3012, 98.9770, 0.6431),
    "elbow_down": (21.8014, 24.8595, -94.3012, 179.6174, 0.6431),
    "over_the_back": (-158.1986, -96.8974, -94.3012, 81.0230, -179.3569),
    "behind": (-158.1986, 155.1405, 94.3012, 0.3826, -179.3569),
}
POSTURES = st.tuples(*[st.floats(-np.pi, np.pi)] * 5).map(np.array)
Road = Callable[[Robot, Array], Array]


@pytest.fixture(params=forward.FORMULATIONS.values(), ids=list(forward.FORMULATIONS))
def road(request: pytest.FixtureRequest) -> Road:
    tool: Road = request.param
    return tool


def closed_form(q: Array) -> Array:
    """The last frame by sines and cosines, a = θ₂ + θ₃ + θ₄, (4, 4), m."""
    c1, c2, c23, ca, c5 = np.cos([q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4]])
    s1, s2, s23, sa, s5 = np.sin([q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4]])
    run = L2 * c2 + L3 * c23
    return np.array(
        [
            [c1 * ca * c5 - s1 * s5, -c1 * ca * s5 - s1 * c5, c1 * sa, c1 * run],
            [s1 * ca * c5 + c1 * s5, -s1 * ca * s5 + c1 * c5, s1 * sa, s1 * run],
            [-sa * c5, sa * s5, ca, -L2 * s2 - L3 * s23],
            [0, 0, 0, 1],
        ]
    )


@given(q=POSTURES)
def test_rows_and_closed_form_give_the_same_frame(q: Array) -> None:
    assert ROBOT.dh.convention == "modified"
    np.testing.assert_allclose(forward.tool_by_dh(ROBOT, q), closed_form(q), atol=1e-12)


@given(q=POSTURES)
def test_the_hand_points_in_the_plane_of_the_arm(q: Array) -> None:
    """p_x r₂₃ = p_y r₁₃: five joints leave one direction that the hand cannot take."""
    T = forward.tool_by_screws(ROBOT, q)
    assert T[0, 3] * T[1, 2] == pytest.approx(T[1, 3] * T[0, 2], abs=1e-12)


@pytest.mark.parametrize("solution", SOLUTIONS)
def test_every_solution_reaches_the_goal(road: Road, solution: str) -> None:
    """Joint angles are printed with four decimals of a degree."""
    T = road(ROBOT, np.radians(SOLUTIONS[solution]))
    np.testing.assert_allclose(T[:3, 3], [0.5, 0.2, 0.3], atol=2e-6)
    np.testing.assert_allclose(T[:3, 2], [0.871505, 0.348602, -0.344899], atol=3e-6)


@pytest.mark.parametrize("solution", [name for name in SOLUTIONS if name != "behind"])
def test_three_solutions_are_poses_within_the_limits(solution: str) -> None:
    pose = ROBOT.poses[solution]
    np.testing.assert_allclose(np.degrees(pose), SOLUTIONS[solution], atol=1e-9)
    assert np.all((ROBOT.lower <= pose) & (pose <= ROBOT.upper))


def test_at_zero_the_arm_is_stretched_and_the_hand_points_up(road: Road) -> None:
    T = road(ROBOT, ROBOT.poses["zero"])
    np.testing.assert_allclose(T[:3, 3], [L2 + L3, 0, 0], atol=1e-12)
    np.testing.assert_allclose(T[:3, :3], np.eye(3), atol=1e-12)
