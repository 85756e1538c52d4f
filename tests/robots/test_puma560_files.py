"""The PUMA 560's file says what its source says: Campos 1998, s.19–21 and s.55, after Craig."""

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

A2, A3, D3, D4 = 0.4318, 0.0203, 0.1244, 0.4318
TEST_POSE = np.array([0.3, -0.5, 0.7, 0.4, 0.9, -1.1])
# The eight solutions of the test pose, in degrees.
EIGHT = (
    (17.1887, -28.6479, 40.1070, 22.9183, 51.5662, -63.0254),
    (17.1887, -28.6479, 40.1070, -157.0817, -51.5662, 116.9746),
    (17.1887, 98.8955, 145.2762, 79.3309, 161.9162, 30.4899),
    (17.1887, 98.8955, 145.2762, -100.6691, -161.9162, -149.5101),
    (-119.4674, 81.1045, 40.1070, -103.7593, 125.3785, 52.1355),
    (-119.4674, 81.1045, 40.1070, 76.2407, -125.3785, -127.8645),
    (-119.4674, -151.3521, 145.2762, -113.4273, 59.6660, -64.3108),
    (-119.4674, -151.3521, 145.2762, 66.5727, -59.6660, 115.6892),
)
# Each angle is known to 5e-5 degrees, six of them on an arm that reaches about a metre.
KNOWN = 6 * np.radians(5e-5)
Array = NDArray[np.float64]
angles = st.lists(st.floats(-np.pi, np.pi), min_size=6, max_size=6).map(np.array)


@pytest.fixture(scope="module")
def puma() -> Robot:
    return robot_from_folder(Path(__file__).parents[2] / "robots" / "puma560")


def product(puma: Robot, q: Array) -> Array:
    """The product of the file's DH rows."""
    return dh.dh_poses(puma.dh, puma.joints, q)[-1]


def closed_form(q: Array) -> Array:
    """Frame 6 as the source writes it out, r11 to pz."""
    (c1, c2, _, c4, c5, c6), (s1, s2, _, s4, s5, s6) = np.cos(q), np.sin(q)
    c23, s23 = np.cos(q[1] + q[2]), np.sin(q[1] + q[2])
    u, w = c4 * c5 * c6 - s4 * s6, s4 * c5 * c6 + c4 * s6
    v, t = -c4 * c5 * s6 - s4 * c6, c4 * c6 - s4 * c5 * s6
    reach = A2 * c2 + A3 * c23 - D4 * s23
    return np.array([
        [c1 * (c23 * u - s23 * s5 * c6) + s1 * w, c1 * (c23 * v + s23 * s5 * s6) + s1 * t,
         -c1 * (c23 * c4 * s5 + s23 * c5) - s1 * s4 * s5, c1 * reach - D3 * s1],
        [s1 * (c23 * u - s23 * s5 * c6) - c1 * w, s1 * (c23 * v + s23 * s5 * s6) - c1 * t,
         -s1 * (c23 * c4 * s5 + s23 * c5) + c1 * s4 * s5, s1 * reach + D3 * c1],
        [-s23 * u - c23 * s5 * c6, -s23 * v + c23 * s5 * s6, s23 * c4 * s5 - c23 * c5, -A3 * s23 - A2 * s2 - D4 * c23],
        [0, 0, 0, 1],
    ])  # fmt: skip


def test_the_rows_are_those_of_the_table(puma: Robot) -> None:
    """Campos 1998 after Craig, the PUMA's DH table: α and a of i − 1, d of i."""
    assert puma.dh.convention == "modified"
    rows = [(np.degrees(row.alpha), row.a, row.d, row.theta) for row in puma.dh.rows]
    table = [(0, 0, 0, 0), (-90, 0, 0, 0), (0, A2, D3, 0), (-90, A3, D4, 0), (90, 0, 0, 0), (-90, 0, 0, 0)]
    np.testing.assert_allclose(rows, table, atol=1e-12)


@given(angles)
def test_the_rows_multiply_to_the_closed_form(puma: Robot, q: Array) -> None:
    """Campos 1998 after Craig, r11 … pz of the PUMA."""
    np.testing.assert_allclose(product(puma, q), closed_form(q), atol=1e-12)


def test_the_tool_is_frame_6_at_the_wrist_centre(puma: Robot) -> None:
    np.testing.assert_array_equal(puma.dh.T_dh_tool, np.eye(4))
    np.testing.assert_allclose(puma.T_world_tool_0, closed_form(np.zeros(6)), atol=1e-15)
    np.testing.assert_array_equal(puma.frames["wrist"].T_link_frame, puma.frames["tool"].T_link_frame)


def test_the_test_pose(puma: Robot) -> None:
    """Test pose of Campos 1998 after Craig, known to a micrometre."""
    np.testing.assert_allclose(product(puma, TEST_POSE)[:3, 3], [0.262305, 0.211356, -0.220210], atol=5.1e-7)
    np.testing.assert_allclose(puma.poses["example"], TEST_POSE, atol=1e-9)


@pytest.mark.parametrize("solution", EIGHT)
def test_all_eight_solutions_give_the_test_pose(puma: Robot, solution: tuple[float, ...]) -> None:
    """Campos 1998, s.19–20: four postures of the arm, two of the wrist; known to 0.0001°."""
    np.testing.assert_allclose(product(puma, np.radians(solution)), product(puma, TEST_POSE), atol=KNOWN)


def test_two_of_the_eight_are_inside_the_limits(puma: Robot) -> None:
    """Whole turns allowed: the first and the last row, and these are the file's two poses."""
    turns = 2 * np.pi * np.arange(-1, 2)[:, None]
    fit = [
        index
        for index, solution in enumerate(EIGHT)
        if np.any(
            (np.radians(solution) + turns >= puma.lower) & (np.radians(solution) + turns <= puma.upper), axis=0
        ).all()
    ]
    assert fit == [0, 7]
    other = puma.poses["example_other"]
    assert np.all((other >= puma.lower) & (other <= puma.upper))
    np.testing.assert_allclose(product(puma, other), product(puma, TEST_POSE), atol=KNOWN)


@given(angles)
def test_flipping_the_wrist_leaves_the_tool(puma: Robot, q: Array) -> None:
    """Campos 1998, s.20: θ4 + 180°, −θ5, θ6 + 180°."""
    flipped = q * [1, 1, 1, 1, -1, 1] + [0, 0, 0, np.pi, 0, np.pi]
    np.testing.assert_allclose(product(puma, flipped), product(puma, q), atol=1e-12)


@given(angles)
def test_the_wrist_centre_stays_in_its_range(puma: Robot, q: Array) -> None:
    """Wrist centre of the PUMA in the plane of the arm: 0.0005 … 0.8641 m, and px² + py² ≥ d3²."""
    x, y, z = product(puma, q)[:3, 3]
    assert x**2 + y**2 >= D3**2 - 1e-12
    assert 0.0005 - 5e-5 <= np.sqrt(max(x**2 + y**2 + z**2 - D3**2, 0)) <= 0.8641 + 5e-5


@pytest.mark.parametrize(("lift", "distance"), [(-np.pi / 2, 0.8641), (np.pi / 2, 0.0005)])
def test_the_range_ends_where_the_elbow_is_singular(puma: Robot, lift: float, distance: float) -> None:
    """K² = a3² + d4² at θ3 = Atan2(a3, d4) ∓ 90°: the arm stretched and the arm folded onto itself."""
    q = np.array([0.4, -0.7, np.arctan2(A3, D4) + lift, 0, 0.5, 0])
    p = product(puma, q)[:3, 3]
    assert np.sqrt(p @ p - D3**2) == pytest.approx(distance, abs=5e-5)
    k = (p @ p - A2**2 - A3**2 - D3**2 - D4**2) / (2 * A2)
    assert k**2 == pytest.approx(A3**2 + D4**2)


@given(angles, st.floats(-np.pi, np.pi))
def test_at_the_wrist_singularity_only_the_sum_of_the_rolls_counts(puma: Robot, q: Array, turn: float) -> None:
    """Singular cases of the PUMA: s5 = 0."""
    straight = q * [1, 1, 1, 1, 0, 1]
    moved = straight + turn * np.array([0, 0, 0, 1, 0, -1])
    np.testing.assert_allclose(product(puma, moved), product(puma, straight), atol=1e-12)
