"""The kernels of the tool agree with the long way, in one posture and in many; their cosine and sine with NumPy's."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import NAMES, arm, postures

from helicoide.arrays import Array
from helicoide.kinematics import differential, tool_blocks, tool_kernels
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.trigonometry import cosine_and_sine

each_arm = pytest.mark.parametrize("name", NAMES)
COUNTS = (0, 1, tool_blocks.BLOCK - 1, tool_blocks.BLOCK, 2 * tool_blocks.BLOCK + 3)
LARGEST = 1e4
UNITS = 3.0  # ours are within 2½, NumPy's within one half, and differences of floats are whole


def cosines_and_sines(angles: Array) -> Array:
    return np.array([cosine_and_sine(angle) for angle in angles.tolist()]).T


def worst(angles: Array) -> float:
    """The largest difference from NumPy, in units in the last place of each value."""
    expected = np.array([np.cos(angles), np.sin(angles)])
    return float(np.max(np.abs(cosines_and_sines(angles) - expected) / np.spacing(np.abs(expected))))


@each_arm
def test_one_posture_agrees_with_the_long_way(name: str) -> None:
    robot = arm(name)
    packed, T = tool_kernels.arm_array(robot), np.full((4, 4), np.nan)
    for q in postures(robot, 20):
        J = np.full((6, q.size), np.nan)
        tool_kernels.tool_pose_into(packed, q, T)
        tool_kernels.tool_jacobian_into(packed, q, J)
        np.testing.assert_allclose(T, tool_by_screws(robot, q), rtol=0, atol=1e-12)
        np.testing.assert_allclose(J, differential.frame_jacobian(robot, q), rtol=0, atol=1e-12)
        np.testing.assert_array_equal(tool_kernels.tool_pose(packed, q), T)
        np.testing.assert_array_equal(tool_kernels.tool_jacobian(packed, q), J)


@pytest.mark.parametrize("count", COUNTS)
@each_arm
def test_many_postures_agree_with_one(name: str, count: int) -> None:
    robot = arm(name)
    packed = tool_kernels.arm_array(robot)
    qs = np.array(postures(robot, count)).reshape(count, len(robot.variables))
    Ts, Js = tool_blocks.tool_poses(packed, qs), tool_blocks.tool_jacobians(packed, qs)
    assert Ts.shape == (count, 4, 4)
    assert Js.shape == (count, 6, len(robot.variables))
    for q, T, J in zip(qs, Ts, Js, strict=True):
        np.testing.assert_allclose(T, tool_kernels.tool_pose(packed, q), rtol=0, atol=1e-14)
        np.testing.assert_allclose(J, tool_kernels.tool_jacobian(packed, q), rtol=0, atol=1e-14)


def test_postures_may_be_columns_of_a_larger_array() -> None:
    robot = arm("movemaster")
    packed, qs = tool_kernels.arm_array(robot), np.array(postures(robot, 100))
    np.testing.assert_array_equal(
        tool_blocks.tool_poses(packed, np.asfortranarray(qs)), tool_blocks.tool_poses(packed, qs)
    )


def test_random_angles() -> None:
    random = np.random.default_rng(0)
    for size in (1e-300, 1e-8, 1.0, 10.0, 100.0, LARGEST):
        assert worst(random.uniform(-size, size, 100_000)) <= UNITS


def test_angles_around_the_multiples_of_an_eighth_of_a_turn() -> None:
    """Where one of the two vanishes, and where the quadrant changes: the floats next to them, up to the largest."""
    at = np.arange(-(2 * LARGEST // np.pi) * 2, (2 * LARGEST // np.pi) * 2 + 1) * (np.pi / 4)
    below, above = np.nextafter(at, -np.inf), np.nextafter(at, np.inf)
    assert worst(np.concatenate([at, below, above])) <= UNITS


@given(st.floats(-LARGEST, LARGEST))
def test_any_angle(angle: float) -> None:
    assert worst(np.array([angle])) <= UNITS


def test_what_is_no_angle_has_no_sine() -> None:
    assert np.isnan(cosines_and_sines(np.array([np.inf, -np.inf, np.nan]))).all()
