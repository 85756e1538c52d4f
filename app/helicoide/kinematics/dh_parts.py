"""The four numbers of each Denavit-Hartenberg row as segments and arcs between its two frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.chain import joint_positions
from helicoide.kinematics.robot import Robot

ARC_POINTS = 25
_SHARES = np.linspace(0.0, 1.0, ARC_POINTS)[:, None]


class DhValues(NamedTuple):
    """The numbers of one row at a posture: θ, rad, d, m, a, m, α, rad."""

    theta: float
    d: float
    a: float
    alpha: float


class DhParts(NamedTuple):
    """One DH row in the world: d and a as segments (2, 3), m; θ and α as arcs (ARC_POINTS, 3), m.

    d lies on the z axis about which θ turns x to the next x; a lies on the x axis about which α turns z to the next z.
    """

    theta: Array
    d: Array
    a: Array
    alpha: Array
    values: DhValues

    @property
    def drawn(self) -> tuple[Array, Array, Array, Array]:
        """The four parts in the order of `DhValues`."""
        return self.theta, self.d, self.a, self.alpha


def dh_parts(robot: Robot, q: Array, frames: Sequence[Array], radius: float) -> list[DhParts]:
    """The parts of each DH row at q (n,), rad or m, by the convention of the robot.

    The rotation β of Hayati, between nearly parallel axes, is not drawn.
    Args: frames: those of `forward.dh_frames` at q, (4, 4) each, m; radius of the arcs, m.
    """
    parts_of = _standard if robot.dh.convention == "standard" else _modified
    values = joint_positions(robot.chain, q).tolist()
    parts = []
    for k, (row, joint, value) in enumerate(zip(robot.dh.rows, robot.joints, values, strict=True)):
        theta, d = (row.theta, row.d + value) if joint.is_prismatic else (row.theta + value, row.d)
        parts.append(parts_of(frames[k], frames[k + 1], DhValues(theta, d, row.a, row.alpha), radius))
    return parts


def _standard(before: Array, after: Array, row: DhValues, radius: float) -> DhParts:
    """θ about and d along the old z, then a along and α about the new x. Args: the two frames (4, 4), m."""
    origin, z, x = before[:3, 3], before[:3, 2], _turned_x(before, row.theta)
    corner = origin + row.d * z
    end = corner + row.a * x
    return DhParts(
        arc(corner, before[:3, 0], z, row.theta, radius),
        np.array([origin, corner]),
        np.array([corner, end]),
        arc(end, z, x, row.alpha, radius),
        row,
    )


def _modified(before: Array, after: Array, row: DhValues, radius: float) -> DhParts:
    """a along and α about the old x, then θ about and d along the new z. Args: the two frames (4, 4), m."""
    origin, x, z = before[:3, 3], before[:3, 0], after[:3, 2]
    corner = origin + row.a * x
    return DhParts(
        arc(corner, _turned_x(after, -row.theta), z, row.theta, radius),
        np.array([corner, corner + row.d * z]),
        np.array([origin, corner]),
        arc(corner, before[:3, 2], x, row.alpha, radius),
        row,
    )


def _turned_x(frame: Array, angle: float) -> Array:
    """The x axis of a frame (4, 4) after a rotation about its z, (3,)."""
    return np.asarray(np.cos(angle) * frame[:3, 0] + np.sin(angle) * frame[:3, 1])


def arc(centre: Array, start: Array, axis: Array, angle: float, radius: float) -> Array:
    """Points of an arc (ARC_POINTS, 3), m: from the unit vector `start`, perpendicular to the axis, through an angle.

    Args: centre (3,), m; axis (3,), a unit vector; angle, rad; radius, m.
    """
    x, y, z = start.tolist()
    a, b, c = axis.tolist()
    across = [b * z - c * y, c * x - a * z, a * y - b * x]
    angles = angle * _SHARES
    return np.asarray(centre + radius * (np.hstack([np.cos(angles), np.sin(angles)]) @ np.array([start, across])))
