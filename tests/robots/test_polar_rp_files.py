"""The polar arm's files say what its source says: Campos 1998, s.31-34."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.kinematics import forward
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

ROBOT = Path(__file__).parents[2] / "robots" / "polar_rp"
Road = Callable[[Robot, Array], Array]
roads = st.sampled_from(list(forward.FORMULATIONS.values()))


@pytest.fixture(scope="module")
def polar() -> Robot:
    return robot_from_folder(ROBOT)


def bounds(part: str) -> Array:
    corners: Array = trimesh.load_scene(ROBOT / "meshes" / f"{part}.glb").bounds
    return corners


@given(angle=st.floats(-np.pi, np.pi), rho=st.floats(0.05, 5), road=roads)
def test_tool_is_the_matrix_of_the_subspace(polar: Robot, angle: float, rho: float, road: Road) -> None:
    """s.32-34: position (x, y, 0) forces the orientation; θ1 = atan2(-x, y), d2 = ρ."""
    x, y = rho * np.cos(angle), rho * np.sin(angle)
    expected = [[y / rho, 0, x / rho, x], [-x / rho, 0, y / rho, y], [0, -1, 0, 0], [0, 0, 0, 1]]
    T = road(polar, np.array([np.arctan2(-x, y), rho]))
    assert np.abs(T - expected).max() < 1e-12


def test_rows_give_the_matrix(polar: Robot) -> None:
    """Modified rows (α, a, d, θ) = (0, 0, 0, θ1), (-90°, 0, ρ, 0)."""
    assert polar.dh.convention == "modified"
    rows = [(np.degrees(row.alpha), row.a, row.d, row.theta) for row in polar.dh.rows]
    assert rows == [(0, 0, 0, 0), (-90, 0, 0, 0)]
    assert [joint.kind for joint in polar.joints] == ["revolute", "prismatic"]


def test_limits_keep_off_the_axis(polar: Robot) -> None:
    """At ρ = 0 the angle is undefined."""
    assert polar.lower[1] > 0


def test_point_of_the_ram_is_the_tool() -> None:
    assert bounds("ram")[1, 1] == pytest.approx(0, abs=1e-6)


def test_ram_stays_in_its_housing_over_the_whole_stroke(polar: Robot) -> None:
    ram, housing = bounds("ram"), bounds("turret")
    assert ram[0, 1] + polar.upper[1] < housing[1, 1] - 0.1
    assert ram[1, 1] + polar.lower[1] > housing[1, 1]
