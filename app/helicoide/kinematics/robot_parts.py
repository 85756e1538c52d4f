"""The parts of a robot other than its joints: frames, monitored points, bodies, planes of its file, gripper."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.text import Text

FRAME_TITLES = {
    "station": Text(en="station", pt_BR="estação"),
    "wrist": Text(en="wrist", pt_BR="punho"),
    "tool": Text(en="end effector", pt_BR="efetuador"),
    "rcm": Text(en="remote centre of motion", pt_BR="centro remoto de movimento"),
}


@dataclass(frozen=True, eq=False)
class Frame:
    """A named frame on a link: station (where goals are given), wrist, tool or rcm (remote centre of motion)."""

    name: str
    link: int
    T_link_frame: Array

    @property
    def title(self) -> Text:
        """Its name in words."""
        return FRAME_TITLES[self.name]


@dataclass(frozen=True)
class MonitoredPoint:
    """A point of the arm that keeps its distance from planes."""

    name: str
    title: Text


@dataclass(frozen=True, eq=False)
class Capsule:
    """A body of the arm: all points within `radius`, m, of the segment between two points.

    ends (2, 3), m, in the frames of the links (2,) that carry them: two links if a prismatic joint lies between them.
    """

    name: str
    title: Text
    ends: Array
    links: tuple[int, int]
    radius: float

    def axis_at(self, poses: Array) -> Array:
        """End points of its axis, (2, 3), m, base frame. Args: poses (m + 1, 4, 4) of `forward.link_poses`."""
        carriers = poses[list(self.links)]
        return np.asarray(np.einsum("eij,ej->ei", carriers[:, :3, :3], self.ends) + carriers[:, :3, 3])


@dataclass(frozen=True, eq=False)
class PlanePane:
    """A confinement plane n·r = d (d in m, inward normal) of the robot's file, with the pane that shows it.

    as_printed: the plane as its source prints it, "" if none does.
    """

    name: str
    title: Text
    normal: Array
    offset: float
    centre: Array
    size: tuple[float, float]
    movable: bool
    as_printed: str = ""


@dataclass(frozen=True)
class Gripper:
    """The URDF joint of the gripper and its full opening between the fingers, in m."""

    joint: str
    opening: float
