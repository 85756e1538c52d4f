"""The source's method to measure an enclosure: from three postures the wrist camera measures one plane each."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import pane_on_plane, planes_of
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.perception.camera import DepthCamera, SimulatedCamera
from helicoide.perception.cloud import PointCloud
from helicoide.perception.planes import FoundPlane, find_plane
from helicoide.state import FittedCloud, State
from helicoide.text import LANGUAGES, Text

# Noise of a simulated depth camera at half a metre: σ, m, and the share of wrong readings.
NOISE, OUTLIERS = 0.002, 0.1
FOUND = Text(
    en="{title}: {share:.0f} % of {k} points on the plane, rms {rms:.1f} mm, {angle:.1f}° from the axis",
    pt_BR="{title}: {share:.0f} % de {k} pontos no plano, rms {rms:.1f} mm, a {angle:.1f}° do eixo",
)
NOT_FOUND = Text(en="{title}: {why}", pt_BR="{title}: {why}")


@dataclass(frozen=True, eq=False)
class PlaneReading:
    """A plane to be measured: the posture, the plane's name and title, and its approximate inward normal, (3,)."""

    pose: str
    name: str
    title: Text
    normal: Array


PLANE_READINGS = (
    PlaneReading("reading_ceiling", "+z", Text(en="ceiling", pt_BR="teto"), frozen([0, 0, -1])),
    PlaneReading("reading_left", "+y", Text(en="left wall", pt_BR="parede esquerda"), frozen([0, -1, 0])),
    PlaneReading("reading_right", "-y", Text(en="right wall", pt_BR="parede direita"), frozen([0, 1, 0])),
)


def available_readings(robot: Robot) -> tuple[PlaneReading, ...]:
    """The planes that an arm can measure, those for which it has a posture. Source: Cerbaro 2022, §6.1."""
    return tuple(reading for reading in PLANE_READINGS if reading.pose in robot.poses)


def camera_cloud(camera: DepthCamera, state: State) -> PointCloud:
    """The cloud of a camera in the posture of the state; a simulated camera measures the planes of the robot's file."""
    if isinstance(camera, SimulatedCamera):
        enclosure = replace(state.problem, planes=planes_of(state.robot.panes))
        state = replace(state, problem=enclosure)
    return camera.cloud(state)


def plane_in_cloud(
    cloud: PointCloud, reading: PlaneReading, inside: Array, seed: int = 0
) -> tuple[FittedCloud, PlanePane | None]:
    """The plane of a reading in a cloud: its display, and its pane, or None if no plane is found.

    inside (3,), m: a point on the side of the arm.
    """
    found = find_plane(cloud.points, reading.normal, inside, seed=seed)
    if isinstance(found, Text):
        none = np.zeros(len(cloud.points), dtype=bool)
        return FittedCloud(
            cloud.points, none, _found_in_words(NOT_FOUND.format(title=reading.title, why=found), cloud)
        ), None
    words = FOUND.format(
        title=reading.title,
        share=100 * found.share,
        k=len(cloud.points),
        rms=1000 * found.rms,
        angle=np.degrees(found.angle),
    )
    return FittedCloud(cloud.points, found.on_plane, _found_in_words(words, cloud)), _pane(found, cloud, reading)


def _found_in_words(words: Text, cloud: PointCloud) -> Text:
    """The result, with the notes of the cloud."""
    if not cloud.notes:
        return words
    sentences = {
        language: " ".join([f"{words[language].rstrip('.')}.", *(note[language] for note in cloud.notes)])
        for language in LANGUAGES
    }
    return Text(**sentences)


def _pane(found: FoundPlane, cloud: PointCloud, reading: PlaneReading) -> PlanePane:
    """A pane as large as the measured part of the plane."""
    spread = np.sort(np.ptp(cloud.points[found.on_plane], axis=0))[1:]
    size = (float(max(spread[1], 0.3)), float(max(spread[0], 0.3)))
    return pane_on_plane(found.plane, reading.name, reading.title, found.centre, size)
