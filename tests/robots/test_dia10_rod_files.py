"""The DIA10 with a rod: Coutinho 2015, fig. 4.1, with the torso at rest, and the figures worked out for a start."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.kinematics import forward
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

ROBOTS = Path(__file__).parents[2] / "robots"
START = np.array([0.4, -0.9, -0.5, 1.3, 0.4, -0.7, 0.0])
Road = Callable[[Robot, Array], Array]


@pytest.fixture(scope="module")
def rod() -> Robot:
    return robot_from_folder(ROBOTS / "dia10_rod")


@pytest.fixture(scope="module")
def dia10() -> Robot:
    return robot_from_folder(ROBOTS / "dia10")


@pytest.fixture(params=forward.FORMULATIONS.values(), ids=list(forward.FORMULATIONS))
def road(request: pytest.FixtureRequest) -> Road:
    tool: Road = request.param
    return tool


def above_floor(robot: Robot, point: Array) -> Array:
    """A point as seen from the floor, where the base frame of the source stands."""
    return np.asarray(point - [0, 0, robot.floor])


def test_tip_and_shaft_at_the_start(rod: Robot, road: Road) -> None:
    """The rod reaches 0.51 m beyond the centre of joint 7, along y of the effector."""
    T = road(rod, START)
    np.testing.assert_allclose(above_floor(rod, T[:3, 3]), [0.199762, 1.29668, 0.511625], atol=6e-7)
    np.testing.assert_allclose(T[:3, 1], [0.144749, 0.78587, -0.601212], atol=6e-7)


def test_entry_point_at_the_start(rod: Robot) -> None:
    """The rod enters 0.15 m up the shaft."""
    rcm = rod.frames["rcm"]
    assert rcm.link == 7
    T = forward.link_poses(rod.chain, START)[rcm.link] @ rcm.T_link_frame
    np.testing.assert_allclose(above_floor(rod, T[:3, 3]), [0.178049, 1.1788, 0.601807], atol=6e-7)


def test_ready_is_the_start(rod: Robot) -> None:
    np.testing.assert_allclose(rod.poses["ready"], START, atol=1e-8)


def test_it_is_the_arm_with_its_torso_at_rest(rod: Robot, dia10: Robot, road: Road) -> None:
    """Joint 1 of the dia10 stays at zero; the rod adds 0.30 m along the effector's y."""
    assert [joint.name for joint in rod.joints] == [joint.name for joint in dia10.joints[1:]]
    np.testing.assert_array_equal(rod.lower, dia10.lower[1:])
    np.testing.assert_array_equal(rod.upper, dia10.upper[1:])
    np.testing.assert_array_equal(rod.speed, dia10.speed[1:])
    random = np.random.default_rng(2015)
    for q in random.uniform(rod.lower, rod.upper, (50, 7)):
        T, flange = road(rod, q), forward.tool_by_screws(dia10, np.array([0.0, *q]))
        np.testing.assert_allclose(T[:3, :3], flange[:3, :3], atol=1e-12)
        np.testing.assert_allclose(above_floor(rod, T[:3, 3]), flange[:3, 3] + 0.3 * flange[:3, 1], atol=1e-12)
