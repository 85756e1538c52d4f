"""The planar 2R's files say what its source says: Campos 1998, s.6-12 and s.38-49, for any lengths."""

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
from helicoide.kinematics.urdf_file import parse_urdf

ROBOT = Path(__file__).parents[2] / "robots" / "planar2r"
Road = Callable[[Robot, Array], Array]
roads = st.sampled_from(list(forward.FORMULATIONS.values()))
angle = st.floats(-np.pi, np.pi)
length_mm = st.floats(200, 2000)


@pytest.fixture(scope="module")
def planar() -> Robot:
    return robot_from_folder(ROBOT)


def position(robot: Robot, q: Array) -> Array:
    return forward.tool_by_dh(robot, q)[:2, 3]


@given(q1=angle, q2=angle, l1=length_mm, l2=length_mm, road=roads)
def test_tool_is_the_closed_form(q1: float, q2: float, l1: float, l2: float, road: Road) -> None:
    """The first two links of s.41: x = l1 c1 + l2 c12, y = l1 s1 + l2 s12."""
    T = road(robot_from_folder(ROBOT, {"l1": l1, "l2": l2}), np.array([q1, q2]))
    c, s = np.cos(q1 + q2), np.sin(q1 + q2)
    x, y = l1 * np.cos(q1) + l2 * c, l1 * np.sin(q1) + l2 * s
    expected = [[c, -s, 0, x / 1000], [s, c, 0, y / 1000], [0, 0, 1, 0], [0, 0, 0, 1]]
    np.testing.assert_allclose(T, expected, atol=1e-12)


def test_rows_are_those_of_the_source(planar: Robot) -> None:
    """The first two rows of s.40, modified convention: (0, 0, 0, θ1), (0, L1, 0, θ2)."""
    assert planar.dh.convention == "modified"
    rows = [(row.alpha, row.a, row.d, row.theta) for row in planar.dh.rows]
    assert rows == [(0, 0, 0, 0), (0, planar.parameters["l1"], 0, 0)]


def test_edges_of_the_workspace(planar: Robot) -> None:
    """s.10: an annulus from |L1 - L2| to L1 + L2."""
    assert np.linalg.norm(position(planar, planar.poses["zero"])) == pytest.approx(1.7)
    assert np.linalg.norm(position(planar, planar.poses["folded"])) == pytest.approx(0.3)


def test_equal_links_reach_the_origin() -> None:
    """s.8: with L1 = L2 the hole closes."""
    equal = robot_from_folder(ROBOT, {"l1": 850, "l2": 850})
    np.testing.assert_allclose(position(equal, equal.poses["folded"]), [0, 0], atol=1e-15)


@pytest.mark.parametrize(("pose", "q"), [("elbow_right", (0.100185, 1.463447)), ("elbow_left", (1.249296, -1.463447))])
def test_two_postures_for_one_point(planar: Robot, pose: str, q: tuple[float, float]) -> None:
    """The check of section 3.2, printed with six decimals: the point (1, 0.8) with l = (1, 0.7)."""
    np.testing.assert_allclose(planar.poses[pose], q, atol=6e-7)
    np.testing.assert_allclose(position(planar, np.array(q)), [1, 0.8], atol=2e-6)
    np.testing.assert_allclose(position(planar, planar.poses[pose]), [1, 0.8], atol=2e-8)


@given(q1=angle, q2=angle)
def test_both_elbow_postures_exist(planar: Robot, q1: float, q2: float) -> None:
    """s.10: every point is reached with the elbow on either side, inside the limits."""
    l1, l2 = planar.parameters["l1"], planar.parameters["l2"]
    bend = np.arctan2(l2 * np.sin(q2), l1 + l2 * np.cos(q2))
    other = np.array([np.angle(np.exp(1j * (q1 + 2 * bend))), -q2])
    assert ((planar.lower <= other) & (other <= planar.upper)).all()
    np.testing.assert_allclose(position(planar, other), position(planar, np.array([q1, q2])), atol=1e-12)


@pytest.mark.parametrize("l2", [700.0, 1600.0])
def test_the_drawing_ends_at_the_tool(l2: float) -> None:
    robot = robot_from_folder(ROBOT, {"l2": l2})
    tube = next(v.geometry.mesh for v in parse_urdf(robot.urdf, robot.parameters).link_map["link2"].visuals[1:])
    bounds = trimesh.load_scene(ROBOT / tube.filename).bounds * tube.scale
    np.testing.assert_allclose(bounds[:, 0], [0, l2 / 1000], atol=1e-6)
