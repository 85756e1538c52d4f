"""The Zebra-ZERO's file says what its source says: Vargas 2013, appendix B (lengths there in mm and cm)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from helicoide.kinematics import dh
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

L1, L2, LE = 0.2794, 0.2286, 0.165
HALF_MM = 0.5e-4 + 1e-12  # positions are printed to 0.1 mm
Array = NDArray[np.float64]
angles = st.lists(st.floats(-np.pi, np.pi), min_size=6, max_size=6).map(np.array)


@pytest.fixture(scope="module")
def zebra() -> Robot:
    return robot_from_folder(Path(__file__).parents[2] / "robots" / "zebra_zero")


def product(zebra: Robot, q: Array) -> Array:
    """The product of the file's DH rows."""
    return dh.dh_poses(zebra.dh, zebra.joints, q)[-1]


def approach(q: Array) -> Array:
    """The axis of the effector as the source writes it out."""
    (c1, _, _, c4, c5, _), (s1, _, _, s4, s5, _) = np.cos(q), np.sin(q)
    c23, s23 = np.cos(q[1] + q[2]), np.sin(q[1] + q[2])
    return np.array([
        -c1 * (c23 * c4 * s5 + s23 * c5) + s1 * s4 * s5,
        -s1 * (c23 * c4 * s5 + s23 * c5) - c1 * s4 * s5,
        -s23 * c4 * s5 + c23 * c5,
    ])  # fmt: skip


def wrist(q: Array) -> Array:
    """The wrist centre as the source writes it out."""
    run = L1 * np.cos(q[1]) - L2 * np.sin(q[1] + q[2])
    return np.array([np.cos(q[0]) * run, np.sin(q[0]) * run, L1 * np.sin(q[1]) + L2 * np.cos(q[1] + q[2])])


def about(axis: int, angle: float) -> Array:
    """Elementary rotation, Vargas 2013, eq. 2.8."""
    c, s = np.cos(angle), np.sin(angle)
    R = np.eye(3)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    R[j, j], R[j, k], R[k, j], R[k, k] = c, -s, s, c
    return R


def jacobian(zebra: Robot, q: Array) -> Array:
    """Geometric Jacobian of the wrist centre, Vargas 2013, eqs. 2.16 to 2.21."""
    frames = dh.dh_poses(zebra.dh, zebra.joints, q)
    centre = frames[4][:3, 3]
    columns = [np.hstack([np.cross(T[:3, 2], centre - T[:3, 3]), T[:3, 2]]) for T in frames[:-1]]
    return np.column_stack(columns)


def test_the_rows_are_those_of_the_table(zebra: Robot) -> None:
    """Vargas 2013, table B.1: a, α, d and an offset of zero."""
    assert zebra.dh.convention == "standard"
    rows = [(row.a, np.degrees(row.alpha), row.d, row.theta) for row in zebra.dh.rows]
    table = [(0, 90, 0, 0), (L1, 0, 0, 0), (0, -90, 0, 0), (0, 90, L2, 0), (0, -90, 0, 0), (0, 0, LE, 0)]
    np.testing.assert_allclose(rows, table, atol=1e-12)


@given(angles)
def test_the_rows_multiply_to_the_closed_form(zebra: Robot, q: Array) -> None:
    """Vargas 2013, eqs. B.5 to B.7: approach axis, wrist centre, effector."""
    T = product(zebra, q)
    np.testing.assert_allclose(T[:3, 2], approach(q), atol=1e-9)
    np.testing.assert_allclose(dh.dh_poses(zebra.dh, zebra.joints, q)[4][:3, 3], wrist(q), atol=1e-9)
    np.testing.assert_allclose(T[:3, 3], wrist(q) + LE * approach(q), atol=1e-9)


@given(angles)
def test_the_orientation_is_that_of_the_six_turns(zebra: Robot, q: Array) -> None:
    """Vargas 2013, eqs. B.3 and B.4 hold the other two axes: the arm turns about z, -y, -y, z, -y, z."""
    turns = [about(2, q[0]), about(1, -q[1] - q[2]), about(2, q[3]), about(1, -q[4]), about(2, q[5])]
    np.testing.assert_allclose(product(zebra, q)[:3, :3], np.linalg.multi_dot(turns), atol=1e-9)


def test_the_effector_of_the_folded_arm(zebra: Robot) -> None:
    """Vargas 2013, start of simulations 10 to 13."""
    q = np.array([0, np.pi / 2, -np.pi, 0, 0, 0])
    np.testing.assert_allclose(product(zebra, q)[:3, 3], [0.3936, 0, 0.2794], atol=HALF_MM)
    np.testing.assert_allclose(zebra.poses["folded"], q, atol=1e-9)


def test_the_effector_of_the_folded_arm_that_points_down(zebra: Robot) -> None:
    """Vargas 2013, start of simulation 14."""
    q = np.array([0, np.pi / 2, -np.pi, 0, -np.pi / 2, 0])
    np.testing.assert_allclose(product(zebra, q)[:3, :3], about(1, np.pi), atol=1e-12)
    np.testing.assert_allclose(product(zebra, q)[:3, 3], [0.2286, 0, 0.1144], atol=HALF_MM)
    np.testing.assert_allclose(zebra.poses["folded_down"], q, atol=1e-9)


def test_the_ill_conditioned_start(zebra: Robot) -> None:
    """Vargas 2013, figs. 4.18 and 4.19: q = (0, π/2 − 0.1, 0.1 − π/2)."""
    np.testing.assert_allclose(
        zebra.poses["ill_conditioned"], [0, np.pi / 2 - 0.1, 0.1 - np.pi / 2, 0, 0, 0], atol=1e-9
    )


def test_every_start_of_the_source_is_inside_the_limits(zebra: Robot) -> None:
    for name in ("folded", "folded_down", "ill_conditioned"):
        assert np.all((zebra.poses[name] > zebra.lower) & (zebra.poses[name] < zebra.upper)), name


@pytest.mark.parametrize(("q", "w"), [((0, np.pi / 2, -np.pi), 43285), ((0, np.pi / 2 - 0.1, 0.1 - np.pi / 2), 306)])
def test_manipulability_of_the_effector_with_the_wrist_held(zebra: Robot, q: tuple[float, ...], w: float) -> None:
    """Vargas 2013, eq. 3.5 at the starts of simulations 10 and 11b: w = √det(J Jᵀ) in cm³."""
    frames = dh.dh_poses(zebra.dh, zebra.joints, np.array([*q, 0, 0, 0]))
    J = np.column_stack([np.cross(T[:3, 2], frames[-1][:3, 3] - T[:3, 3]) for T in frames[:3]]) * 100
    assert np.sqrt(np.linalg.det(J @ J.T)) == pytest.approx(w, abs=0.5)


@given(angles)
def test_shoulder_elbow_and_wrist_each_have_a_factor_of_the_determinant(zebra: Robot, q: Array) -> None:
    """Vargas 2013, eq. 3.9: det J = l1 l2 c3 (l1 c2 − l2 s23) s5 at the wrist centre."""
    shoulder = L1 * np.cos(q[1]) - L2 * np.sin(q[1] + q[2])
    factors = L1 * L2 * np.cos(q[2]) * shoulder * np.sin(q[4])
    assert np.linalg.det(jacobian(zebra, q)) == pytest.approx(factors, abs=1e-12)


@given(angles)
def test_the_wrist_frame_is_where_its_three_axes_meet(zebra: Robot, q: Array) -> None:
    """Vargas 2013, App. B: a spherical wrist; the tool is l_e = 165 mm in front of it."""
    frames = dh.dh_poses(zebra.dh, zebra.joints, q)
    np.testing.assert_allclose(frames[4][:3, 3], frames[5][:3, 3], atol=1e-12)
    before = zebra.frames["tool"].T_link_frame[:3, 3] - zebra.frames["wrist"].T_link_frame[:3, 3]
    np.testing.assert_allclose(before, [0, 0, LE], atol=1e-12)
