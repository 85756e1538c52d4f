"""Velocities and forces at the tool, for all arms, against finite differences and virtual work."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tests.kinematics.arms import NAMES, arm, postures

from helicoide import readout
from helicoide.arrays import Array, frozen
from helicoide.contributions.trials import with_joints
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.robot import Robot
from helicoide.state import State, initial_state

EPSILON = 1e-6
each_arm = pytest.mark.parametrize("name", NAMES)


def moving(name: str, seed: int = 0) -> State:
    """An arm in a random posture with random joint velocities."""
    robot = arm(name)
    state = with_joints(initial_state(robot), frozen(postures(robot, seed + 1)[-1]))
    velocities = np.random.default_rng(seed).uniform(-robot.speed, robot.speed)
    return replace(state, arm=replace(state.arm, velocities=frozen(velocities)))


def differences(robot: Robot, q: Array, way: Array) -> Array:
    """The twist of the tool for joint velocities, by central differences of its pose."""
    before, after = (tool_by_screws(robot, q + sign * EPSILON * way) for sign in (-1, 1))
    turn = Rotation.from_matrix(after[:3, :3] @ before[:3, :3].T).as_rotvec()
    return np.concatenate([after[:3, 3] - before[:3, 3], turn]) / (2 * EPSILON)


@each_arm
def test_the_twist_is_the_derivative_of_the_pose_and_its_axis_carries_it(name: str) -> None:
    state = moving(name)
    twist = readout.tool_twist(state)
    np.testing.assert_allclose(twist, differences(state.robot, state.arm.q, state.arm.velocities), rtol=0, atol=1e-6)
    axis = readout.twist_axis(state)
    assert axis is not None
    there = twist[:3] + np.cross(twist[3:], axis.point - state.T_world_tool[:3, 3])
    np.testing.assert_allclose(there, axis.along * axis.direction, rtol=0, atol=1e-9)
    assert readout.twist_axis(initial_state(state.robot)) is None


@each_arm
def test_balancing_torques_do_no_virtual_work(name: str) -> None:
    """For each joint motion the work of the torques and that of the wrench cancel."""
    state = moving(name)
    wrench = np.random.default_rng(1).normal(size=6) * 10
    torques = readout.balancing_torques(state, wrench)
    for i, way in enumerate(np.eye(len(torques))):
        work = torques[i] + wrench @ differences(state.robot, state.arm.q, way)
        assert abs(work) < 1e-5
    axis = readout.wrench_axis(state, wrench)
    assert axis is not None
    moment = wrench[3:] - np.cross(axis.point - state.T_world_tool[:3, 3], wrench[:3])
    np.testing.assert_allclose(moment, axis.along * axis.direction, rtol=0, atol=1e-9)


@each_arm
def test_unit_joint_velocities_give_velocities_on_or_in_the_ellipsoid(name: str) -> None:
    state = moving(name)
    units = np.array([state.robot.reach if joint.is_prismatic else 1.0 for joint in state.robot.variables])
    found = readout.position_analysis(state)
    J = readout.world_jacobian(state)[:3] * units
    sigma = np.linalg.svd(J, compute_uv=False)
    np.testing.assert_allclose(found.velocity_ellipsoid.lengths[: len(sigma)], sigma, rtol=0, atol=1e-9)
    kept = found.velocity_ellipsoid.lengths > 1e-9
    random = np.random.default_rng(2)
    for _ in range(20):
        way = random.normal(size=len(units))
        parts = found.U.T @ (J @ way / np.linalg.norm(way))
        np.testing.assert_allclose(parts[~kept], 0, rtol=0, atol=1e-9)
        assert np.linalg.norm(parts[kept] / found.velocity_ellipsoid.lengths[kept]) < 1 + 1e-9


@each_arm
def test_slow_directions_are_hardly_reached_and_missing_in_most_postures(name: str) -> None:
    robot = arm(name)
    state = initial_state(robot)
    assert readout.slow_directions(state).shape == (6, 0)
    for q in [np.zeros(len(robot.variables)), *postures(robot, 20)]:
        there = with_joints(state, frozen(q))
        slow = readout.slow_directions(there)
        np.testing.assert_allclose(slow.T @ slow, np.eye(slow.shape[1]), rtol=0, atol=1e-9)
        scale = np.where([joint.is_prismatic for joint in robot.variables], robot.reach, 1.0)
        J = readout.world_jacobian(there) * scale / np.array([robot.reach] * 3 + [1.0] * 3)[:, None]
        assert np.linalg.norm(slow.T @ J, axis=1).max(initial=0.0) < 0.2


def test_the_stretched_planar_arm_has_lost_the_direction_along_itself() -> None:
    robot = arm("planar2r")
    stretched = with_joints(initial_state(robot), frozen(np.zeros(2)))
    slow = readout.slow_directions(stretched)
    base, tool = stretched.arm.poses[1, :3, 3], stretched.T_world_tool[:3, 3]
    along = (tool - base) / np.linalg.norm(tool - base)
    assert slow.shape == (6, 1)
    assert abs(slow[:3, 0] @ along) == pytest.approx(1.0, abs=1e-9)
