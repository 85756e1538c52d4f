"""Singular values and what follows from them: identities for every robot, and the numbers of the sources."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import NAMES, arm, postures

from helicoide.arrays import Array
from helicoide.kinematics import differential
from helicoide.kinematics.manipulability import (
    JacobianAnalysis,
    analyse_jacobian,
    position_manipulability,
    scaled_jacobian,
    twist_manipulability,
)
from helicoide.kinematics.robot import Robot

LENGTH = 0.3
each_arm = pytest.mark.parametrize("name", NAMES)
matrices = st.tuples(st.integers(1, 6), st.integers(1, 8), st.integers(1, 6), st.integers(0, 10**6)).map(
    lambda drawn: of_rank(*drawn)
)


def of_rank(m: int, n: int, rank: int, seed: int) -> Array:
    """A random matrix (m, n) of at most that rank."""
    random = np.random.default_rng(seed)
    return np.asarray(random.normal(size=(m, rank)) @ random.normal(size=(rank, n)))


def both(name: str) -> list[JacobianAnalysis]:
    """Position and whole twist in some postures, and at zero, where many arms are singular."""
    robot = arm(name)
    qs = [*postures(robot, 5), np.zeros(len(robot.variables))]
    return [found for q in qs for found in (position_manipulability(robot, q), twist_manipulability(robot, q, LENGTH))]


@given(J=matrices)
def test_the_pseudoinverse_meets_penrose(J: Array) -> None:
    found = analyse_jacobian(J)
    P, size = found.pseudoinverse, np.abs(J).max()
    tolerance = 1e-13 * found.sigma[0] / found.sigma[found.rank - 1]
    np.testing.assert_allclose(J @ P @ J, J, rtol=0, atol=tolerance * size)
    np.testing.assert_allclose(P @ J @ P, P, rtol=0, atol=tolerance * np.abs(P).max())
    np.testing.assert_allclose(J @ P, (J @ P).T, rtol=0, atol=tolerance)
    np.testing.assert_allclose(P @ J, (P @ J).T, rtol=0, atol=tolerance)


@each_arm
def test_null_motions_leave_the_tool_where_it_is(name: str) -> None:
    random = np.random.default_rng(2)
    for found in both(name):
        n = found.J.shape[1]
        assert found.null_space.shape == (n, n - found.rank)
        q0 = random.normal(size=n)
        np.testing.assert_allclose(found.J @ found.null_projector @ q0, 0, rtol=0, atol=1e-12)
        np.testing.assert_allclose(found.null_projector, np.eye(n) - found.pseudoinverse @ found.J, rtol=0, atol=1e-12)
        assert found.lost_velocities.shape == (len(found.J), len(found.J) - found.rank)
        np.testing.assert_allclose(found.lost_velocities.T @ found.J, 0, rtol=0, atol=1e-12)


@each_arm
def test_the_pseudoinverse_gives_the_shortest_rates(name: str) -> None:
    """Any other q̇ with the same velocity is longer, by what it has in the null space."""
    random = np.random.default_rng(3)
    for found in both(name):
        any_rates = random.normal(size=(found.J.shape[1],))
        shortest = found.pseudoinverse @ (found.J @ any_rates)
        np.testing.assert_allclose(found.J @ shortest, found.J @ any_rates, rtol=0, atol=1e-12)
        extra = found.null_projector @ any_rates
        assert np.sum(shortest**2) + np.sum(extra**2) == pytest.approx(np.sum(any_rates**2), rel=1e-9)


@each_arm
def test_the_ellipsoids_are_images_of_the_unit_sphere(name: str) -> None:
    """Unit q̇ stays inside the velocity ellipsoid and reaches each end; τ = Jᵀ f is of length one on the other one."""
    for found in both(name):
        velocity, force = found.velocity_ellipsoid, found.force_ellipsoid
        np.testing.assert_allclose(velocity.axes.T @ velocity.axes, np.eye(len(found.J)), rtol=0, atol=1e-13)
        ends = (velocity.axes * velocity.lengths)[:, : found.rank]
        np.testing.assert_allclose(np.linalg.norm(found.pseudoinverse @ ends, axis=0), 1, rtol=1e-6)
        held = (force.axes * np.where(np.isfinite(force.lengths), force.lengths, 0))[:, : found.rank]
        np.testing.assert_allclose(np.linalg.norm(found.J.T @ held, axis=0), 1, rtol=1e-6)
        assert np.isinf(force.lengths[found.rank :]).all()
        rates = np.random.default_rng(4).normal(size=(found.J.shape[1], 50))
        seen = velocity.axes.T @ found.J @ (rates / np.linalg.norm(rates, axis=0))
        inside = np.sum((seen[: found.rank].T / velocity.lengths[: found.rank]) ** 2, axis=1)
        assert (inside <= 1 + 1e-9).all()
        np.testing.assert_allclose(seen[found.rank :], 0, rtol=0, atol=1e-12)


@each_arm
def test_manipulability_is_the_root_of_the_determinant(name: str) -> None:
    robot = arm(name)
    for q in postures(robot, 5):
        J = differential.frame_jacobian(robot, q)[:3]
        square = J @ J.T if J.shape[1] >= 3 else J.T @ J
        assert position_manipulability(robot, q).w == pytest.approx(np.sqrt(max(np.linalg.det(square), 0)), abs=1e-9)


def test_the_characteristic_length_scales_the_turning_rows_alone(robot: Robot) -> None:
    q = robot.poses["example"]
    J = differential.frame_jacobian(robot, q)
    np.testing.assert_array_equal(twist_manipulability(robot, q, 2.0).J, np.vstack([J[:3], 2 * J[3:]]))
    np.testing.assert_array_equal(scaled_jacobian(J, 1.0), J)
    arm6 = arm("puma560")
    ready = arm6.poses["ready"]
    assert twist_manipulability(arm6, ready, 2.0).w == pytest.approx(8 * twist_manipulability(arm6, ready, 1.0).w)


def test_the_condition_number_is_infinite_where_rank_is_lost(robot: Robot) -> None:
    assert position_manipulability(arm("planar3r"), np.zeros(3)).condition_number == np.inf
    found = position_manipulability(robot, robot.poses["example"])
    assert found.condition_number == pytest.approx(np.linalg.cond(found.J))


# Recomputed from tab. 8 and eq. 11 of Cerbaro 2022.


def test_the_manipulability_of_the_movemaster(robot: Robot) -> None:
    assert 1e9 * position_manipulability(robot, robot.poses["example"]).w == pytest.approx(7.23266155e7, rel=1e-8)


def test_the_null_space_of_the_movemaster(robot: Robot) -> None:
    found = position_manipulability(robot, robot.poses["example"])
    projector = np.zeros((5, 5))
    projector[1:4, 1:4] = [[0.0353, -0.1116, 0.1468], [-0.1116, 0.3532, -0.4647], [0.1468, -0.4647, 0.6116]]
    projector[4, 4] = 1
    np.testing.assert_allclose(found.null_projector, projector, rtol=0, atol=5.1e-5)
    for basis in ([0, 0.1878, -0.5943, 0.7820, 0], [0, 0, 0, 0, 1]):
        np.testing.assert_allclose(found.null_projector @ basis, basis, rtol=0, atol=1e-4)
    assert found.null_space.shape == (5, 2)


def test_the_null_spaces_of_the_features_table(robot: Robot) -> None:
    """One for the ORCA in its plane; none for the Movemaster when pitch and roll are asked for too."""
    orca = differential.frame_jacobian(arm("orca"), np.radians([20, 90, -110]))[:2]
    assert analyse_jacobian(orca).null_space.shape == (3, 1)
    J = differential.frame_jacobian(robot, robot.poses["example"])
    pitch_and_roll = [[0, 1, 1, 1, 0], [0, 0, 0, 0, 1]]
    assert analyse_jacobian(np.vstack([J[:3], np.multiply(LENGTH, pitch_and_roll)])).null_space.shape == (5, 0)


def test_the_manipulability_of_the_orca() -> None:
    J = differential.frame_jacobian(arm("orca"), np.radians([20, 90, -110]))
    assert 1e6 * analyse_jacobian(J[:2]).w == pytest.approx(78868.179, rel=1e-8)


# Vargas 2013, sections 5.1 and 8: the Zebra-ZERO with its last three joints fixed at 0, the position of the effector.


def three_joints(pose: str) -> JacobianAnalysis:
    robot = arm("zebra_zero")
    return analyse_jacobian(100 * differential.frame_jacobian(robot, robot.poses[pose])[:3, :3])


def test_the_zebra_zero_at_the_start_of_simulation_10() -> None:
    found = three_joints("folded")
    assert found.w == pytest.approx(43285, abs=0.5)
    np.testing.assert_allclose(found.sigma, [59.5, 39.4, 18.5], rtol=0, atol=0.05)


def test_the_zebra_zero_near_its_shoulder_singularity() -> None:
    assert three_joints("ill_conditioned").w == pytest.approx(306, abs=0.5)


# A start of the arm of Coutinho 2015, with the tool where its table 4.2 has it.
Q0 = [0.731912, -0.229593, -1.110216, -1.636104, 0.676517, 1.117805, -0.616407, 1.5708]


def test_the_first_six_joints_of_the_dia10() -> None:
    """w_i = |det J_0i| of the link that passes the entry point, the same in every frame of it, and that point."""
    robot = arm("dia10")
    rcm = robot.frames["rcm"]
    assert rcm.link == 6
    for J in (differential.body_jacobian(robot, Q0, rcm), differential.point_jacobian(robot, Q0, [0, 0, 0], 6)):
        np.testing.assert_array_equal(J[:, 6:], 0)
        assert analyse_jacobian(J[:, :6]).w == pytest.approx(0.02828, abs=5e-6)
    pose = differential.frame_pose(robot, Q0, rcm)
    np.testing.assert_allclose(pose[:3, 3], [-0.054064, 0.757776, 1.049720], rtol=0, atol=2e-6)


def test_the_stack_of_the_dia10_has_the_manipulability_of_its_parts() -> None:
    """|det of [J_0e; lateral rows of the entry point]| = w_i l_b² |sin θ7| (Coutinho 2015, §2, "zy" wrist, r = 2)."""
    robot = arm("dia10")
    lateral = differential.body_jacobian(robot, Q0, robot.frames["rcm"])[[0, 2]]
    stack = np.vstack([differential.body_jacobian(robot, Q0), lateral])
    w_i = analyse_jacobian(differential.body_jacobian(robot, Q0, robot.frames["rcm"])[:, :6]).w
    assert analyse_jacobian(stack).w == pytest.approx(w_i * 0.18**2 * abs(np.sin(Q0[6])), rel=1e-9)
