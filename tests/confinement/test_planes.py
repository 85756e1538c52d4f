"""Planes and the panes that show them."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from helicoide.confinement import pane_axes
from helicoide.kinematics.robot import Robot


@given(st.integers(0, 2**32 - 1))
def test_the_axes_of_a_pane_are_a_rotation_with_its_normal_last(seed: int) -> None:
    normal = np.random.default_rng(seed).normal(size=3)
    R = pane_axes(normal)
    np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-12)
    assert np.linalg.det(R) > 0
    np.testing.assert_allclose(R[:, 2], normal / np.linalg.norm(normal), atol=1e-12)


def test_the_first_size_of_a_pane_runs_along_x(robot: Robot) -> None:
    """As the robot's file says of size_mm."""
    for pane in robot.panes:
        assert abs(pane_axes(pane.normal)[0, 0]) > 0.99
