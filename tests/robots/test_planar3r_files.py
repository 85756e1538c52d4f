"""The planar 3R's files say what its source says: Vargas 2013, section 2.3 and appendix C, for any lengths."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.kinematics import forward
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.kinematics.urdf_file import parse_urdf

ROBOT = Path(__file__).parents[2] / "robots" / "planar3r"
Road = Callable[[Robot, Array], Array]
LENGTHS = (2.0, 1.0, 1.0)
angles = st.lists(st.floats(-4, 4), min_size=3, max_size=3).map(np.array)
lengths = st.tuples(*[st.floats(200, 3000)] * 3)
roads = st.sampled_from(list(forward.FORMULATIONS.values()))


@pytest.fixture(scope="module")
def planar() -> Robot:
    return robot_from_folder(ROBOT)


def with_lengths(lengths_mm: tuple[float, float, float]) -> Robot:
    return robot_from_folder(ROBOT, dict(zip(("l1", "l2", "l3"), lengths_mm, strict=True)))


def closed_form(q: Array, lengths: tuple[float, ...] | Array) -> Array:
    """The tool in the plane: φ = q₁ + q₂ + q₃ turns it, x and y add up the links."""
    a = np.cumsum(q)
    c, s = np.cos(a[-1]), np.sin(a[-1])
    x, y = np.cos(a) @ lengths, np.sin(a) @ lengths
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]])


def drawn(urdf: yourdfpy.URDF, link: str) -> Array:
    """The vertices of what is drawn of a link, in its frame, m."""
    parts = []
    for visual in urdf.link_map[link].visuals:
        file = visual.geometry.mesh
        mesh = trimesh.load_scene(ROBOT / file.filename).to_mesh()
        scale = 1.0 if file.scale is None else file.scale
        origin = np.eye(4) if visual.origin is None else visual.origin
        parts.append(trimesh.transform_points(mesh.vertices * scale, origin))
    return np.vstack(parts)


@given(q=angles, road=roads)
def test_tool_is_the_closed_form(planar: Robot, q: Array, road: Road) -> None:
    """Section 5.1: orientation q1 + q2 + q3, links 2, 1, 1."""
    np.testing.assert_allclose(road(planar, q), closed_form(q, LENGTHS), atol=1e-12)


@given(q=angles, lengths_mm=lengths, road=roads)
def test_tool_follows_changed_lengths(q: Array, lengths_mm: tuple[float, float, float], road: Road) -> None:
    expected = closed_form(q, np.array(lengths_mm) / 1000)
    np.testing.assert_allclose(road(with_lengths(lengths_mm), q), expected, atol=1e-12)


def test_trajectory_4_starts_at_the_stretched_arm(planar: Robot) -> None:
    """Eq. C.4 at t = 0, simulation 6: (0, 4) with q = (π/2, 0, 0)."""
    np.testing.assert_allclose(forward.tool_by_dh(planar, planar.poses["simulation_6"])[:2, 3], [0, 4], atol=1e-15)


def test_folded_arm_reaches_the_origin_within_its_limits(planar: Robot) -> None:
    """Trajectory 4 at t = 32 s."""
    folded = np.array([np.pi / 2, np.pi, 0])
    assert ((planar.lower < folded) & (folded < planar.upper)).all()
    np.testing.assert_allclose(forward.tool_by_screws(planar, folded)[:2, 3], [0, 0], atol=1e-15)


def test_simulation_1_is_within_reach(planar: Robot) -> None:
    """Trajectory 1 with φ = π/2: its wrist stays between the circles of radius l1 - l2 and l1 + l2."""
    t = np.linspace(0, 10 * np.pi, 500)
    wrist = np.hypot(2 + 0.5 * np.sin(0.4 * t), 0.5 * np.cos(0.2 * t) - planar.parameters["l3"])
    l1, l2 = planar.parameters["l1"], planar.parameters["l2"]
    assert (wrist > l1 - l2).all()
    assert (wrist < l1 + l2).all()


@pytest.mark.parametrize(
    ("simulation", "q"), [(1, [np.pi / 6] * 3), (6, [np.pi / 2, 0, 0]), (7, [np.pi / 2, 0.1, 0.1])]
)
def test_starts_of_the_simulations(planar: Robot, simulation: int, q: list[float]) -> None:
    """Simulations 1 and 2, 6 and 7."""
    np.testing.assert_allclose(planar.poses[f"simulation_{simulation}"], q, atol=1e-15)


@pytest.mark.parametrize("lengths_mm", [(2000, 1000, 1000), (700, 2500, 400)])
def test_links_are_drawn_as_long_as_they_are(lengths_mm: tuple[float, float, float]) -> None:
    robot = with_lengths(lengths_mm)
    urdf = parse_urdf(robot.urdf, robot.parameters)
    links = [drawn(urdf, f"link{i}") for i in (1, 2, 3)]
    assert links[2][:, 0].max() == pytest.approx(robot.parameters["l3"], abs=1e-6)
    for link, after, length in zip(links, links[1:], lengths_mm, strict=False):
        end = link[np.hypot(link[:, 0] - length / 1000, link[:, 1]) < 0.1]
        start = after[np.hypot(after[:, 0], after[:, 1]) < 0.1]
        assert end[:, 2].max() >= start[:, 2].min() - 1e-6
