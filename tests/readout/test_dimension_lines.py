"""Dimension lines against the clearances of the guarded step and a search for nearer points."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize
from tests.kinematics.arms import NAMES, arm, postures

from helicoide import readout
from helicoide.arrays import Array, frozen
from helicoide.confinement import Zone
from helicoide.contributions.trials import with_joints
from helicoide.geometry import rigid
from helicoide.ik.guard.collision import clearances
from helicoide.ik.packing import packed
from helicoide.kinematics.forward import link_motors
from helicoide.readout.dimension_lines import closest_points, dimension_lines
from helicoide.readout.partial_products import partial_displacements
from helicoide.state import State, initial_state, with_problem

segments = st.lists(st.floats(-2, 2), min_size=12, max_size=12).map(lambda x: np.array(x).reshape(2, 2, 3))


def among_obstacles(name: str) -> State:
    """An arm with a sphere and a capsule."""
    state = initial_state(arm(name))
    reach = state.robot.reach
    obstacles = state.problem.obstacles.with_sphere(reach * np.array([0.9, 0.8, 0.7]), 0.05 * reach)
    obstacles = obstacles.with_capsule(reach * np.array([-1.0, 0.5, 0]), reach * np.array([-1.0, 0.5, 1]), 0.04 * reach)
    return with_problem(state, replace(state.problem, obstacles=obstacles))


@pytest.mark.parametrize("name", NAMES)
def test_lengths_are_the_smallest_clearances_and_lines_have_them(name: str) -> None:
    state = among_obstacles(name)
    moving = sum(max(body.links) > 0 for body in state.robot.bodies)
    planes, points = len(state.problem.planes.normals), len(state.robot.monitored_points)
    for q in postures(state.robot, 10):
        there = with_joints(state, frozen(q))
        found = dimension_lines(there)
        left = clearances(packed(there.problem), q)
        zones = there.problem.zones
        heights = left[: points * planes].reshape(points, planes).min(axis=0) + zones.critical
        pairs = left[points * planes + len(state.robot.self_collision) :].reshape(moving, 2).min(axis=0)
        expected = np.concatenate([heights, pairs + zones.body_clearance])
        np.testing.assert_allclose(found.lengths, expected, rtol=0, atol=1e-9)
        drawn = np.linalg.norm(found.ends[:, 1] - found.ends[:, 0], axis=1)
        np.testing.assert_allclose(drawn, np.abs(found.lengths), rtol=0, atol=1e-9)
        assert found.zones[:planes] == readout.zones(there)
        assert set(found.zones[planes:]) <= {Zone.FREE, Zone.CRITICAL}


@given(segments)
def test_no_other_points_are_closer(pair: Array) -> None:
    a, b = pair
    found = closest_points(a[None], b[None])[0]

    def apart(shares: Array) -> float:
        return float(np.sum((a[0] + shares[0] * (a[1] - a[0]) - b[0] - shares[1] * (b[1] - b[0])) ** 2))

    other = min(minimize(apart, start, bounds=[(0, 1), (0, 1)]).fun for start in ([0.5, 0.5], [0, 1], [1, 0]))
    assert np.linalg.norm(found[1] - found[0]) <= np.sqrt(max(other, 0)) + 1e-6


def test_without_planes_and_obstacles_there_are_no_lines() -> None:
    bare = initial_state(arm("planar2r"))
    assert dimension_lines(bare).ends.shape == (0, 2, 3)
    parked = among_obstacles("movemaster")
    parked = replace(parked, arm=replace(parked.arm, parked=True))
    assert len(dimension_lines(parked).lengths) == 2


@pytest.mark.parametrize("name", NAMES)
def test_partial_products_are_those_of_the_motors(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 5):
        state = with_joints(initial_state(robot), frozen(q))
        motors = link_motors(robot, q)[1:]
        for drawn, motor in zip(partial_displacements(state), motors, strict=True):
            np.testing.assert_allclose(drawn, rigid.pose_from_motor(motor), rtol=0, atol=1e-9)
