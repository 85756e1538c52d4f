"""The DIA10's files say what its source says: Coutinho 2015, fig. 4.1, tab. 4.2, and a posture that reproduces them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.kinematics import dh, forward
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.studies._coutinho_runs import START as SIMULATED

ROBOT = Path(__file__).parents[2] / "robots" / "dia10"
# The source gives no joint angles for its start; these bring the effector to its p_0e(0), as those of the file do.
START = np.array([0.731912, -0.229593, -1.110216, -1.636104, 0.676517, 1.117805, -0.616407, 1.5708])
Road = Callable[[Robot, Array], Array]


@pytest.fixture(scope="module")
def dia10() -> Robot:
    return robot_from_folder(ROBOT)


@pytest.fixture(params=forward.FORMULATIONS.values(), ids=list(forward.FORMULATIONS))
def road(request: pytest.FixtureRequest) -> Road:
    tool: Road = request.param
    return tool


def frame(robot: Robot, name: str, q: Array) -> Array:
    """Pose of a named frame, (4, 4), m."""
    given = robot.frames[name]
    pose: Array = forward.link_poses(robot.chain, q)[given.link] @ given.T_link_frame
    return pose


def test_the_stretched_arm_lies_along_y(dia10: Robot, road: Road) -> None:
    """Fig. 4.1: 0.38 to the shoulder, 0.39 + 0.33 + 0.21 = 0.93 from there, 1.037 high."""
    T = road(dia10, np.zeros(8))
    np.testing.assert_allclose(T[:3, 3], [0, 1.31, 1.037], atol=1e-12)
    np.testing.assert_allclose(T[:3, :3], np.eye(3), atol=1e-12)
    shoulder = dia10.joints[2].point
    assert np.linalg.norm(T[:3, 3] - shoulder) == pytest.approx(0.93, abs=1e-12)


def test_axes_alternate_from_the_torso(dia10: Robot) -> None:
    """§3.3: joint 6 turns about the restricted link, y, joint 7 about z; the others follow in turn."""
    z, y = [0, 0, 1], [0, 1, 0]
    np.testing.assert_array_equal(dia10.directions, [z, y] * 4)


def test_the_restricted_link_is_330_mm_with_150_mm_outside(dia10: Robot) -> None:
    """Tab. 4.2: the entry point lies at l_a = 0.15 m, l_b = 0.18 m, on link 6."""
    rcm = dia10.frames["rcm"]
    assert rcm.link == 6
    np.testing.assert_allclose(rcm.T_link_frame[:3, 3], [0, 0.15, 0], atol=1e-12)
    np.testing.assert_allclose(dia10.joints[6].point - dia10.joints[5].point, [0, 0.33, 0], atol=1e-12)


def test_effector_at_the_start_of_the_simulations(dia10: Robot, road: Road) -> None:
    """Tab. 4.2: p_0e(0) = (19.4, 101.9, 95.8) cm, with its rotation recomputed."""
    T = road(dia10, START)
    np.testing.assert_allclose(T[:3, 3], [0.194001, 1.019, 0.958], atol=6e-7)
    np.testing.assert_allclose(
        T[:3, :3],
        [[0.359711, 0.823193, 0.439273], [-0.594187, 0.56508, -0.572387], [-0.719409, -0.055116, 0.692396]],
        atol=6e-7,
    )
    quat = rotation.from_matrix(T[:3, :3])
    expected = [0.808886, 0.159871, 0.35811, -0.438065]
    np.testing.assert_allclose(quat * rotation.hemisphere_sign(quat), expected, atol=6e-7)


def test_entry_point_at_the_start_of_the_simulations(dia10: Robot) -> None:
    """Tab. 4.2 (l_a(0) = 0.15 m), recomputed from the same joint angles."""
    np.testing.assert_allclose(frame(dia10, "rcm", START)[:3, 3], [-0.054064, 0.757776, 1.04972], atol=6e-7)


def test_the_named_start_is_that_of_the_simulations(dia10: Robot) -> None:
    """Tab. 4.2, to its last digit."""
    np.testing.assert_allclose(dia10.poses["start"], SIMULATED, atol=1e-8)
    np.testing.assert_allclose(forward.tool_by_screws(dia10, SIMULATED)[:3, 3], [0.194, 1.019, 0.958], atol=1e-6)


def test_rows_and_axes_give_the_same_effector(dia10: Robot) -> None:
    """The modified rows end with a turn of 90° about x."""
    assert dia10.dh.convention == "modified"
    random = np.random.default_rng(2015)
    for q in random.uniform(dia10.lower, dia10.upper, (200, 8)):
        T = dh.dh_poses(dia10.dh, dia10.joints, q)[-1] @ dia10.dh.T_dh_tool
        np.testing.assert_allclose(T, forward.tool_by_screws(dia10, q), atol=1e-12)


def test_the_last_three_axes_meet_at_the_wrist(dia10: Robot) -> None:
    """Fig. 4.1: the wrist stays where it is while joints 6, 7 and 8 turn."""
    moved = np.array([*START[:5], 0.4, -0.3, 0.8])
    np.testing.assert_allclose(frame(dia10, "wrist", moved)[:3, 3], frame(dia10, "wrist", START)[:3, 3], atol=1e-12)
