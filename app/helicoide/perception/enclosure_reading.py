"""Measuring an enclosure as in Cerbaro 2022: in each of three postures the wrist camera measures one plane."""

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

# Simulated depth camera: standard deviation of the depth, m, as at a distance of 0.5 m, and fraction of outliers.
NOISE, OUTLIERS = 0.002, 0.1
FOUND = Text(
    en="{title}: {share:.0f} % of {k} points on the plane, rms {rms:.1f} mm, {angle:.1f}° from the axis",
    pt_BR="{title}: {share:.0f} % de {k} pontos no plano, rms {rms:.1f} mm, a {angle:.1f}° do eixo",
)
NOT_FOUND = Text(en="{title}: {why}", pt_BR="{title}: {why}")


@dataclass(frozen=True, eq=False)
class PlaneReading:
    """A plane to be measured, with its name and title. pose: name of the posture; normal: rough inward normal, (3,)."""

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
    """The planes that an arm can measure: its file must have the posture for each. Source: Cerbaro 2022, §6.1."""
    return tuple(reading for reading in PLANE_READINGS if reading.pose in robot.poses)


def camera_cloud(camera: DepthCamera, state: State) -> PointCloud:
    """The cloud of a camera in the current posture. A simulated camera sees the planes of the robot's file."""
    if isinstance(camera, SimulatedCamera):
        enclosure = replace(state.problem, planes=planes_of(state.robot.panes))
        state = replace(state, problem=enclosure)
    return camera.cloud(state)


def plane_in_cloud(
    cloud: PointCloud, reading: PlaneReading, inside: Array, seed: int = 0
) -> tuple[FittedCloud, PlanePane | None]:
    """Find the plane of a reading in a cloud. Returns the cloud for display, and the plane, None if none is found.

    inside (3,), m, world: a point on the same side of the plane as the arm. seed: of the random search.
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
    """The result of the search in words, followed by the notes of the cloud."""
    if not cloud.notes:
        return words
    sentences = {
        language: " ".join([f"{words[language].rstrip('.')}.", *(note[language] for note in cloud.notes)])
        for language in LANGUAGES
    }
    return Text(**sentences)


def _pane(found: FoundPlane, cloud: PointCloud, reading: PlaneReading) -> PlanePane:
    """The plane, drawn as large as its measured part, with sides of at least 0.3 m."""
    spread = np.sort(np.ptp(cloud.points[found.on_plane], axis=0))[1:]
    size = (float(max(spread[1], 0.3)), float(max(spread[0], 0.3)))
    return pane_on_plane(found.plane, reading.name, reading.title, found.centre, size)
