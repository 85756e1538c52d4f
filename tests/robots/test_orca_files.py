"""The ORCA's files say what its source says: Cerbaro 2022, sections 3.1 and 4.2 to 4.4."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy

from helicoide.arrays import Array
from helicoide.kinematics import forward
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

ROBOT = Path(__file__).parents[2] / "robots" / "orca"
Road = Callable[[Robot, Array], Array]


@pytest.fixture(scope="module")
def orca() -> Robot:
    return robot_from_folder(ROBOT)


@pytest.fixture(params=forward.FORMULATIONS.values(), ids=list(forward.FORMULATIONS))
def road(request: pytest.FixtureRequest) -> Road:
    tool: Road = request.param
    return tool


def planar_mm(T: Array) -> list[float]:
    """Position in mm and angle in degrees of a pose in the plane."""
    return [*(1000 * T[:2, 3]), np.degrees(np.arctan2(T[1, 0], T[0, 0]))]


@pytest.mark.parametrize(
    ("pose", "x_mm", "y_mm", "angle_deg"),
    [
        ("zero", 655, 0, 0),
        ("example", 318.139858, 309.321164, 0),
        ("home", 275.665409, -5.470932, -28),
        ("same_point_a", 583.241161, 173.241161, 0),
    ],
)
def test_tool_of_the_source(orca: Robot, road: Road, pose: str, x_mm: float, y_mm: float, angle_deg: float) -> None:
    """Tab. 7, eqs. 1-3, tab. 1 and fig. 27."""
    np.testing.assert_allclose(planar_mm(road(orca, orca.poses[pose])), [x_mm, y_mm, angle_deg], atol=6e-7)


def test_second_posture_of_the_same_point(orca: Robot, road: Road) -> None:
    """Fig. 27, posture B, whose radians are printed with four decimals."""
    np.testing.assert_allclose(orca.poses["same_point_b"], [0.0087, 0.7852, -0.7942], atol=1e-8)
    np.testing.assert_allclose(planar_mm(road(orca, orca.poses["same_point_b"]))[:2], [583.2474, 173.2228], atol=6e-5)


def test_displacement_of_the_example(orca: Robot) -> None:
    """Eqs. 3 and 7: the screws' product does not turn the tool."""
    H = forward.screw_displacements(orca, orca.poses["example"])[-1]
    np.testing.assert_allclose(H[:3, :3], np.eye(3), atol=1e-15)
    np.testing.assert_allclose(1000 * H[:3, 3], [-336.860142, 309.321164, 0], atol=6e-7)


@pytest.mark.parametrize(("pose", "wrist_mm"), [("example", (148.140, 309.321)), ("home", (125.564, 74.339))])
def test_wrist_point(orca: Robot, pose: str, wrist_mm: tuple[float, float]) -> None:
    """The third joint of the worked poses."""
    wrist = forward.dh_frames(orca, orca.poses[pose])[2]
    np.testing.assert_allclose(1000 * wrist[:2, 3], wrist_mm, atol=6e-4)


def test_home_of_the_source_in_radians(orca: Robot) -> None:
    """Section 4.4.3."""
    np.testing.assert_allclose(orca.poses["home"], [-0.6981, 2.5307, -2.3213], atol=5e-5)


def test_solution_of_the_convergence_example(orca: Robot, road: Road) -> None:
    """Section 4.4.3, fig. 30: target (260, 180) mm, 0°; the angles have four decimals."""
    T = road(orca, np.radians([-0.7608, 130.9822, -130.2214]))
    np.testing.assert_allclose(planar_mm(T), [260, 180, 0], atol=1e-3)


def test_circle_of_the_source_lies_inside_the_limits(orca: Robot) -> None:
    """Section 4.4.3, experiment 2: the limits are ours, its joint ranges are not."""
    assert (np.degrees(orca.lower) < [-40.76, 83.55, -130.22]).all()
    assert (np.degrees(orca.upper) > [11.59, 141.06, -76.69]).all()


def test_fingers_close_on_the_tool_point(orca: Robot) -> None:
    finger = trimesh.load_scene(ROBOT / "meshes" / "finger.glb").to_mesh()
    slide = yourdfpy.URDF.load(str(orca.urdf), load_meshes=False).joint_map["grip"].origin
    assert 0 <= finger.bounds[0, 1] < 0.0005
    assert finger.bounds[0, 0] < orca.T_link_tool[0, 3] - slide[0, 3] < finger.bounds[1, 0]
