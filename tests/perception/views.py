"""What a depth camera sees from the poses in which the source read its planes."""

from __future__ import annotations

import numpy as np
from tests.driving import with_joints

from helicoide.arrays import Array
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.perception.camera import SimulatedCamera
from helicoide.perception.cloud import PointCloud
from helicoide.perception.planes import FoundPlane, find_plane
from helicoide.state import State
from helicoide.text import Text

# The pose, and the inward normal that is looked for (Cerbaro 2022, section 6.1; the walls as in the robot's file).
READINGS = {
    "+z": ("reading_ceiling", np.array([0.0, 0, -1])),
    "+y": ("reading_left", np.array([0.0, -1, 0])),
    "-y": ("reading_right", np.array([0.0, 1, 0])),
}
INSIDE = np.array([0.52, 0.0, 0.23])


def reading(state: State, name: str) -> State:
    """The arm where it reads a plane."""
    return with_joints(state, state.robot.poses[READINGS[name][0]])


def read(
    state: State, name: str, seed: int, noise: float = 0.002, outliers: float = 0.3
) -> tuple[PointCloud, FoundPlane | Text]:
    """A cloud from where a plane is read, and the plane found in it."""
    cloud = SimulatedCamera(noise=noise, outliers=outliers, seed=seed).cloud(reading(state, name))
    return cloud, find_plane(cloud.points, READINGS[name][1], INSIDE, seed=seed)


def pane(state: State, name: str) -> PlanePane:
    (found,) = [pane for pane in state.robot.panes if pane.name == name]
    return found


def misses(state: State, name: str, seed: int) -> tuple[float, float]:
    """How far the plane that is found is from the printed one: at the centroid of the cloud, m, and in angle, rad."""
    cloud, found = read(state, name, seed)
    assert isinstance(found, FoundPlane), found
    true = pane(state, name)
    centroid = cloud.points.mean(axis=0)
    there = distance(true.normal, true.offset, centroid) - distance(found.plane.normal, found.plane.offset, centroid)
    return abs(there), between(found.plane.normal, true.normal)


def distance(normal: Array, offset: float, point: Array) -> float:
    return float(normal @ point) - offset


def between(a: Array, b: Array) -> float:
    """The angle between two unit vectors, rad."""
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))
