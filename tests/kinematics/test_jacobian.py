"""Every Jacobian is the derivative of what it says, for every robot; the numbers that the sources print."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import MIXED, NAMES, arm, derivative, frame_by_screws, postures, twist_by_differences

from helicoide.geometry import euler, rigid, rotation
from helicoide.kinematics import differential, jacobian
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_motors, link_poses, tool_by_screws
from helicoide.kinematics.representation import (
    QUATERNION,
    REPRESENTATIONS,
    ROTATION_VECTOR,
    coordinates,
    rotation_vector_jacobian,
)
from helicoide.kinematics.robot import Frame, Robot
from helicoide.text import HelicoideError

each_arm = pytest.mark.parametrize("name", NAMES)
triples = st.lists(st.floats(-2.5, 2.5), min_size=3, max_size=3).map(np.array)


def assert_derivative(found: Array, expected: Array) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-7 * np.abs(expected).max())


@each_arm
def test_the_jacobian_of_the_tool_is_the_derivative(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 10):
        by_differences = twist_by_differences(lambda q: tool_by_screws(robot, q), q)
        assert_derivative(differential.geometric(robot, q), by_differences)


@each_arm
def test_the_jacobian_in_the_tool_is_the_derivative_seen_from_it(name: str) -> None:
    """R⁻¹ dp, and the antisymmetric part of Rᵀ dR."""
    robot = arm(name)
    for q in postures(robot, 5):
        R = tool_by_screws(robot, q)[:3, :3]
        rate = np.einsum("ji,jlk->ilk", R, derivative(lambda q: tool_by_screws(robot, q)[:3], q))
        by_differences = np.concatenate([rate[:, 3], rate[[2, 0, 1], [1, 2, 0]]])
        assert_derivative(differential.body(robot, q), by_differences)


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
            J = differential.geometric(robot, q, frame)
            np.testing.assert_allclose(J, by_differences, rtol=0, atol=1e-7)
            np.testing.assert_array_equal(J, differential.point_jacobian(robot, q, T[:3, 3], link))


def change(representation: str, phi: Array, centre: Array) -> Array:
    """Coordinates as far as they are from others that are near: the other quaternion, or a whole turn, taken back."""
    if representation == QUATERNION:
        return phi * np.sign(phi @ centre)
    if representation == ROTATION_VECTOR:
        return phi
    return np.asarray(centre + euler.orientation_error(phi, centre))


def is_smooth(R: Array, representation: str) -> bool:
    """Whether coordinates neither jump nor become singular within the step of the differences."""
    if representation == QUATERNION:
        return True
    if representation == ROTATION_VECTOR:
        return bool(np.linalg.norm(rotation.logarithm(R)) < 3.0)
    return bool(euler.angles(R, representation).margin > 0.3)


@pytest.mark.parametrize("representation", REPRESENTATIONS)
@each_arm
def test_the_analytic_jacobian_is_the_derivative_of_the_coordinates(name: str, representation: str) -> None:
    robot = arm(name)
    T = robot.frames["tool"].T_link_frame.copy()
    T[:3, :3] = T[:3, :3] @ rotation.exponential([0.7, -0.5, 0.4])  # a plain tool is singular in all of a planar arm
    frame = replace(robot.frames["tool"], T_link_frame=frozen(T))
    smooth = [q for q in postures(robot, 20) if is_smooth(frame_by_screws(robot, q, frame)[:3, :3], representation)]
    assert len(smooth) >= 3
    for q in smooth[:3]:
        centre = coordinates(frame_by_screws(robot, q, frame)[:3, :3], representation)

        def position_and_coordinates(q: Array, centre: Array = centre) -> Array:
            pose = frame_by_screws(robot, q, frame)
            return np.hstack([pose[:3, 3], change(representation, coordinates(pose[:3, :3], representation), centre)])

        assert_derivative(
            differential.analytic(robot, q, representation, frame), derivative(position_and_coordinates, q, 3e-4)
        )


def test_an_unknown_representation_is_refused_with_those_there_are(robot: Robot) -> None:
    with pytest.raises(HelicoideError, match="quaternion, rotation vector, xyx"):
        differential.analytic(robot, robot.poses["ready"], "roll")


@given(v=triples, w=triples)
def test_the_rates_of_a_rotation_vector(v: Array, w: Array) -> None:
    """Turning by ω dt changes v by J_R ω dt: also near no turn, where its formula is a series."""
    for scale in (1.0, 1e-2, 1e-3, 0.0):
        vector = scale * v * min(1.0, 3.0 / (float(np.linalg.norm(v)) + 1e-9))
        turned = [rotation.logarithm(rotation.exponential(h * w) @ rotation.exponential(vector)) for h in (1e-5, -1e-5)]
        np.testing.assert_allclose((turned[0] - turned[1]) / 2e-5, rotation_vector_jacobian(vector) @ w, atol=1e-7)


@each_arm
def test_quaternion_rates_of_the_source(name: str) -> None:
    """η̇ = −½ εᵀω, ε̇ = ½ (η I − [ε]ₓ) ω (Vargas 2013, eqs. 2.45–2.46)."""
    robot = arm(name)
    for q in postures(robot, 5):
        eta, *epsilon = rotation.from_matrix(tool_by_screws(robot, q)[:3, :3])
        J, rates = differential.geometric(robot, q), differential.analytic(robot, q, QUATERNION)[3:]
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
        rates = np.linalg.solve(differential.geometric(robot, q), [0, 0, 0, *(gain * error)])
        assert derivative(measure, q) @ rates == pytest.approx(-gain * error @ error, rel=1e-6)


@each_arm
def test_adjoints_change_the_frame_of_a_jacobian(name: str) -> None:
    """V_world = Ad(T_world_tool) V_tool at the base's origin; there and back again; Ad of a product is the product."""
    robot = arm(name)
    q, other = postures(robot, 2)
    T, J = tool_by_screws(robot, q), differential.geometric(robot, q)
    at_origin = differential.adjoint(T) @ differential.body(robot, q)
    np.testing.assert_allclose(differential.at_point(J, -T[:3, 3]), at_origin, rtol=0, atol=1e-13)
    np.testing.assert_allclose(differential.at_point(at_origin, T[:3, 3]), J, rtol=0, atol=1e-13)
    back = differential.adjoint(np.asarray(np.linalg.inv(T)))
    np.testing.assert_allclose(back @ differential.adjoint(T), np.eye(6), rtol=0, atol=1e-12)
    product = differential.adjoint(T @ tool_by_screws(robot, other))
    factors = differential.adjoint(T) @ differential.adjoint(tool_by_screws(robot, other))
    np.testing.assert_allclose(product, factors, rtol=0, atol=1e-12)


@each_arm
def test_at_point_is_the_jacobian_of_that_point(name: str) -> None:
    robot = arm(name)
    frame = robot.frames["tool"]
    way = np.array([0.1, -0.2, 0.3])
    for q in postures(robot, 3):
        J = differential.at_point(differential.geometric(robot, q), tool_by_screws(robot, q)[:3, :3] @ way)
        beyond = frame.T_link_frame[:3, :3] @ way + frame.T_link_frame[:3, 3]
        np.testing.assert_allclose(J, differential.point_jacobian(robot, q, beyond, frame.link), rtol=0, atol=1e-13)


@each_arm
def test_the_jacobian_of_a_line_is_the_derivative_of_the_moved_line(name: str) -> None:
    robot = arm(name)
    direction, through = rotation.unit([0.3, -0.5, 0.8]), np.array([0.1, 0.2, -0.1])
    for link, joint in enumerate(robot.joints, start=1):
        at_zero = rigid.line(direction, through + joint.point)

        def moved(q: Array, at_zero: Array = at_zero, link: int = link) -> Array:
            return np.hstack(rigid.direction_and_moment(rigid.move(link_motors(robot, q)[link], at_zero)))

        q = postures(robot, 1, seed=link)[0]
        line, rate = differential.line_jacobian(robot, q, direction, through, link)
        np.testing.assert_allclose(line, moved(q), rtol=0, atol=1e-12)
        np.testing.assert_allclose(rate, derivative(moved, q), rtol=0, atol=1e-7)


def test_a_slide_and_a_joint_that_follows_have_the_columns_of_the_definition() -> None:
    """b slides along its axis and takes e along at half its rate; d turns back by 0.7 of what c turns."""
    robot = arm(MIXED)
    q = postures(robot, 1)[0]
    poses = link_poses(robot.chain, q)
    axes = jacobian.joint_axes(poses, robot.chain)
    J, p = differential.geometric(robot, q), tool_by_screws(robot, q)[:3, 3]
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
    J = differential.geometric(robot, robot.poses["example"])
    J[:3] *= 1000
    np.testing.assert_allclose(J, EXAMPLE, rtol=0, atol=5.1e-5)


def test_the_planar_jacobian_of_the_example() -> None:
    """Recomputed from tab. 7 of Cerbaro 2022: x, y and φ of the ORCA at (20, 90, −110)°."""
    J = differential.geometric(arm("orca"), np.radians([20, 90, -110]))
    np.testing.assert_allclose(np.vstack([1000 * J[:2], J[5]]), ORCA, rtol=0, atol=5.1e-5)
    np.testing.assert_allclose(J[2:5], 0, atol=1e-15)
