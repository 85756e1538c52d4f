"""The SCARA's files describe an arm whose tool always points down and never meets table or column."""

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

ROBOT = Path(__file__).parents[2] / "robots" / "scara"
Road = Callable[[Robot, Array], Array]
roads = st.sampled_from(list(forward.FORMULATIONS.values()))
angle = st.floats(-6, 6)


@pytest.fixture(scope="module")
def scara() -> Robot:
    return robot_from_folder(ROBOT)


def vertices(part: str) -> Array:
    points: Array = trimesh.load_scene(ROBOT / "meshes" / f"{part}.glb").to_mesh().vertices
    return points


@given(q1=angle, q2=angle, d3=st.floats(-1, 1), q4=angle, road=roads)
def test_tool_is_the_closed_form(scara: Robot, q1: float, q2: float, d3: float, q4: float, road: Road) -> None:
    """Links of 325 and 225 mm, the tool 230 mm above the table at d3 = 0, turned by θ1 + θ2 - θ4 and pointing down."""
    c, s = np.cos(q1 + q2 - q4), np.sin(q1 + q2 - q4)
    x = 0.325 * np.cos(q1) + 0.225 * np.cos(q1 + q2)
    y = 0.325 * np.sin(q1) + 0.225 * np.sin(q1 + q2)
    expected = [[c, s, 0, x], [s, -c, 0, y], [0, 0, -1, 0.23 - d3], [0, 0, 0, 1]]
    np.testing.assert_allclose(road(scara, np.array([q1, q2, d3, q4])), expected, atol=1e-12)


def test_both_arms_hold_the_tool_alike(scara: Robot) -> None:
    right, left = (forward.tool_by_dh(scara, scara.poses[name]) for name in ("right_arm", "left_arm"))
    np.testing.assert_allclose(right, left, atol=1e-8)


def test_tool_stays_above_the_table(scara: Robot) -> None:
    lowest = forward.tool_by_dh(scara, np.array([0, 0, scara.upper[2], 0]))[2, 3]
    assert lowest == pytest.approx(0.03)


def test_folded_arm_passes_the_column(scara: Robot) -> None:
    base = vertices("base")
    column = base[(base[:, 2] > 0.04) & (base[:, 0] > -0.12)]
    fold = np.linalg.norm(forward.tool_by_dh(scara, np.array([0, scara.upper[1], 0, 0]))[:2, 3])
    assert fold - np.hypot(*vertices("spindle")[:, :2].T).max() > np.hypot(*column[:, :2].T).max()


def test_quill_ends_at_the_tool_and_stops_above_its_bearing(scara: Robot) -> None:
    assert vertices("spindle")[:, 2].min() == pytest.approx(scara.T_link_tool[2, 3], abs=1e-6)
    arm = vertices("outer_arm")
    bearing = arm[np.hypot(arm[:, 0] - 0.225, arm[:, 1]) < 0.035]
    assert vertices("quill")[:, 2].min() - scara.upper[2] > bearing[:, 2].max()
