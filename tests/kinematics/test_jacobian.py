"""The Jacobian is the derivative of the pose."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.kinematics import jacobian
from helicoide.kinematics.forward import carried_points, link_poses, tool_by_screws
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot

STEP = 1e-5
joints = st.lists(st.floats(-2.5, 2.5), min_size=5, max_size=5).map(frozen)


def tool_jacobian(robot: Robot, q: Array) -> Array:
    poses = link_poses(robot.chain, q)
    axes = jacobian.joint_axes(poses, robot.chain)
    return jacobian.geometric(poses, axes, tool_by_screws(robot, q)[:3, 3].copy(), 5)


def derivative(robot: Robot, q: Array) -> Array:
    """Central differences, extrapolated (error of fourth order); turning as the antisymmetric part of R' Rᵀ."""
    R = tool_by_screws(robot, q)[:3, :3]
    columns = []
    for i in range(5):
        near, far = (
            (tool_by_screws(robot, q + h * np.eye(5)[i]) - tool_by_screws(robot, q - h * np.eye(5)[i])) / (2 * h)
            for h in (100 * STEP, 200 * STEP)
        )
        rate = (4 * near - far) / 3
        spin = rate[:3, :3] @ R.T
        columns.append([*rate[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]])
    return np.array(columns).T


@given(q=joints)
def test_the_jacobian_is_the_derivative(robot: Robot, q: Array) -> None:
    J = tool_jacobian(robot, q)
    np.testing.assert_allclose(derivative(robot, q), J, rtol=0, atol=1e-7 * np.abs(J).max())


@given(q=joints, j=st.integers(0, 4))
def test_the_jacobian_of_a_guarded_point_is_its_derivative(robot: Robot, q: Array, j: int) -> None:
    def point(q: Array) -> Array:
        poses = link_poses(robot.chain, frozen(q))
        return carried_points(poses, robot.guarded_points, robot.guarded_joints)[j]

    poses = link_poses(robot.chain, q)
    axes = jacobian.joint_axes(poses, robot.chain)
    J = jacobian.geometric(poses, axes, point(q), int(robot.guarded_joints[j]))
    for i in range(5):
        step = STEP * np.eye(5)[i]
        np.testing.assert_allclose((point(q + step) - point(q - step)) / (2 * STEP), J[:3, i], rtol=0, atol=1e-9)
    assert not J[:, robot.guarded_joints[j] :].any()


# Digest of Cerbaro 2022, section 8, "Jacobian, Movemaster example" (eq. 67): first three rows in mm.
EXAMPLE = [
    [-271.6025, 86.6025, 274.1025, 187.5000, 0],
    [470.4294, 50.0000, 158.2532, 108.2532, 0],
    [0, 423.2051, 298.2051, 125.0000, 0],
    [0, 0.5, 0.5, 0.5, 0.4330],
    [0, -0.8660, -0.8660, -0.8660, 0.25],
    [1, 0, 0, 0, -0.8660],
]


def test_the_jacobian_of_the_digest(robot: Robot) -> None:
    J = tool_jacobian(robot, robot.poses["example"])
    J[:3] *= 1000
    np.testing.assert_allclose(J, EXAMPLE, rtol=0, atol=5.1e-5)


def test_the_manipulability_of_the_digest(robot: Robot) -> None:
    """Digest section 8: 7.23266155e7 mm³ for the position part of joints 2 to 4 and 1, √det(J Jᵀ)."""
    J = 1000 * tool_jacobian(robot, robot.poses["example"])[:3]
    assert np.sqrt(np.linalg.det(J @ J.T)) == pytest.approx(7.23266155e7, rel=1e-8)
