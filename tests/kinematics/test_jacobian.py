"""Every Jacobian is the derivative of what it says, for every robot; the numbers that the sources print."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest
from tests.kinematics.arms import MIXED, NAMES, arm, derivative, frame_by_screws, postures, twist_by_differences

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.kinematics import differential, jacobian
from helicoide.kinematics.forward import link_poses, tool_by_screws
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import Frame

each_arm = pytest.mark.parametrize("name", NAMES)


def assert_derivative(found: Array, expected: Array) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-7 * np.abs(expected).max())


@each_arm
def test_the_jacobian_of_the_tool_is_the_derivative(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 10):
        by_differences = twist_by_differences(lambda q: tool_by_screws(robot, q), q)
        assert_derivative(differential.frame_jacobian(robot, q), by_differences)


@each_arm
def test_the_jacobian_in_the_tool_is_the_derivative_seen_from_it(name: str) -> None:
    """R⁻¹ dp, and the antisymmetric part of Rᵀ dR."""
    robot = arm(name)
    for q in postures(robot, 5):
        R = tool_by_screws(robot, q)[:3, :3]
        rate = np.einsum("ji,jlk->ilk", R, derivative(lambda q: tool_by_screws(robot, q)[:3], q))
        by_differences = np.concatenate([rate[:, 3], rate[[2, 0, 1], [1, 2, 0]]])
        assert_derivative(differential.body_jacobian(robot, q), by_differences)


@each_arm
def test_the_jacobian_of_any_frame_of_any_link_is_the_derivative(name: str) -> None:
    robot = arm(name)
    random = np.random.default_rng(1)
    for link in range(len(robot.joints) + 1):
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = rotation.exponential(random.normal(size=3)), random.uniform(-0.3, 0.3, 3)
        frame = Frame("wrist", link, frozen(T))
        for q in postures(robot, 2, seed=link):
            np.testing.assert_allclose(
                differential.frame_pose(robot, q, frame), frame_by_screws(robot, q, frame), rtol=0, atol=1e-12
            )
            by_differences = twist_by_differences(partial(frame_by_screws, robot, frame=frame), q)
            J = differential.frame_jacobian(robot, q, frame)
            np.testing.assert_allclose(J, by_differences, rtol=0, atol=1e-7)
            np.testing.assert_array_equal(J, differential.point_jacobian(robot, q, T[:3, 3], link))


@each_arm
def test_quaternion_rates_of_the_source(name: str) -> None:
    """η̇ = −½ εᵀω, ε̇ = ½ (η I − [ε]ₓ) ω (Vargas 2013, eqs. 2.45–2.46)."""
    robot = arm(name)
    for q in postures(robot, 5):
        eta, *epsilon = rotation.from_matrix(tool_by_screws(robot, q)[:3, :3])
        J = differential.frame_jacobian(robot, q)
        rates = rotation.quaternion_jacobian(np.array([eta, *epsilon])) @ J[3:]
        np.testing.assert_allclose(rates[0], -np.array(epsilon) @ J[3:] / 2, rtol=0, atol=1e-14)
        E = eta * np.eye(3) - rotation.skew(epsilon)
        np.testing.assert_allclose(rates[1:], E @ J[3:] / 2, rtol=0, atol=1e-14)


def test_the_measure_of_a_quaternion_error_falls_as_the_source_says() -> None:
    """V = 2 (1 − Δη) changes by −e_oᵀ Λ e_o when q̇ makes ω = Λ e_o (Vargas 2013, eqs. 2.43, 2.47–2.48)."""
    robot, gain = arm("zebra_zero"), 3.0
    goals = postures(robot, 10, seed=1)
    for q, goal in zip(postures(robot, 10), goals, strict=True):
        target = rotation.from_matrix(tool_by_screws(robot, goal)[:3, :3])

        def measure(q: Array, target: Array = target) -> Array:
            here = rotation.from_matrix(tool_by_screws(robot, q)[:3, :3])
            return np.asarray(2 * (1 - abs(target @ here)))

        error = rotation.quaternion_error(target, rotation.from_matrix(tool_by_screws(robot, q)[:3, :3]))
        rates = np.linalg.solve(differential.frame_jacobian(robot, q), [0, 0, 0, *(gain * error)])
        assert derivative(measure, q) @ rates == pytest.approx(-gain * error @ error, rel=1e-6)


@each_arm
def test_adjoints_change_the_frame_of_a_jacobian(name: str) -> None:
    """V_world = Ad(T_world_tool) V_tool at the base's origin; there and back again; Ad of a product is the product."""
    robot = arm(name)
    q, other = postures(robot, 2)
    T, J = tool_by_screws(robot, q), differential.frame_jacobian(robot, q)
    at_origin = differential.adjoint(T) @ differential.body_jacobian(robot, q)
    carried = np.vstack([J[:3] + rotation.skew(T[:3, 3]) @ J[3:], J[3:]])  # v of the point that is at the origin
    np.testing.assert_allclose(carried, at_origin, rtol=0, atol=1e-13)
    back = differential.adjoint(np.asarray(np.linalg.inv(T)))
    np.testing.assert_allclose(back @ differential.adjoint(T), np.eye(6), rtol=0, atol=1e-12)
    product = differential.adjoint(T @ tool_by_screws(robot, other))
    factors = differential.adjoint(T) @ differential.adjoint(tool_by_screws(robot, other))
    np.testing.assert_allclose(product, factors, rtol=0, atol=1e-12)


def test_a_slide_and_a_joint_that_follows_have_the_columns_of_the_definition() -> None:
    """b slides along its axis and takes e along at half its rate; d turns back by 0.7 of what c turns."""
    robot = arm(MIXED)
    q = postures(robot, 1)[0]
    poses = link_poses(robot.chain, q)
    axes = jacobian.joint_axes(poses, robot.chain)
    J, p = differential.frame_jacobian(robot, q), tool_by_screws(robot, q)[:3, 3]
    np.testing.assert_allclose(J[:, 1], np.hstack([axes[1] + 0.5 * axes[4], np.zeros(3)]), rtol=0, atol=1e-14)
    lever = np.cross(axes[2], p - poses[3, :3, 3]) - 0.7 * np.cross(axes[3], p - poses[4, :3, 3])
    np.testing.assert_allclose(J[:, 2], np.hstack([lever, axes[2] - 0.7 * axes[3]]), rtol=0, atol=1e-14)


# Recomputed from tab. 8 and eq. 67 of Cerbaro 2022, in the posture of its example: first three rows in mm.
EXAMPLE: list[list[float]] = [
    [-271.6025, 86.6025, 274.1025, 187.5000, 0],
    [470.4294, 50.0000, 158.2532, 108.2532, 0],
    [0, 423.2051, 298.2051, 125.0000, 0],
    [0, 0.5, 0.5, 0.5, 0.4330],
    [0, -0.8660, -0.8660, -0.8660, 0.25],
    [1, 0, 0, 0, -0.8660],
]
ORCA: list[list[float]] = [[-309.3212, -225.5262, 0], [318.1399, 87.9152, 170], [1, 1, 1]]


def test_the_jacobian_of_the_example(robot: Robot) -> None:
    J = differential.frame_jacobian(robot, robot.poses["example"])
    J[:3] *= 1000
    np.testing.assert_allclose(J, EXAMPLE, rtol=0, atol=5.1e-5)


def test_the_planar_jacobian_of_the_example() -> None:
    """Recomputed from tab. 7 of Cerbaro 2022: x, y and φ of the ORCA at (20, 90, −110)°."""
    J = differential.frame_jacobian(arm("orca"), np.radians([20, 90, -110]))
    np.testing.assert_allclose(np.vstack([1000 * J[:2], J[5]]), ORCA, rtol=0, atol=5.1e-5)
    np.testing.assert_allclose(J[2:5], 0, atol=1e-15)
