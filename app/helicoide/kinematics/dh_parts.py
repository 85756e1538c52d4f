"""The four numbers of each Denavit-Hartenberg row as segments and arcs between its two frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.kinematics.chain import joint_positions
from helicoide.kinematics.robot import Robot

ARC_POINTS = 25
_SHARES = np.linspace(0.0, 1.0, ARC_POINTS)


class DhParts(NamedTuple):
    """The m DH rows in the world: d and a as segments (m, 2, 3), m; θ and α as arcs (m, ARC_POINTS, 3), m.

    d lies on the z axis about which θ turns x to the next x; a lies on the x axis about which α turns z to the next z.
    values (m, 4): θ, rad, d, m, a, m, α, rad of each row at the posture.
    """

    theta: Array
    d: Array
    a: Array
    alpha: Array
    values: Array


def dh_parts(robot: Robot, q: Array, frames: Sequence[Array], radius: float) -> DhParts:
    """The parts of all DH rows at q (n,), rad or m, by the convention of the robot.

    The rotation β of Hayati, between nearly parallel axes, is not drawn.
    Args: frames: those of `forward.dh_frames` at q, (4, 4) each, m; radius of the arcs, m.
    """
    values = np.array([[row.theta, row.d, row.a, row.alpha] for row in robot.dh.rows])
    moved = [int(joint.is_prismatic) for joint in robot.joints]
    values[np.arange(len(values)), moved] += joint_positions(robot.chain, q)
    poses = np.array(frames)
    parts_of = _standard if robot.dh.convention == "standard" else _modified
    return parts_of(poses[:-1], poses[1:], values, radius)


def _standard(before: Array, after: Array, values: Array, radius: float) -> DhParts:
    """θ about and d along the old z, then a along and α about the new x. Args: the two frames of each row (m, 4, 4)."""
    theta, d, a, alpha = values.T
    origins, z, x = before[:, :3, 3], before[:, :3, 2], _turned_x(before, theta)
    corners = origins + d[:, None] * z
    ends = corners + a[:, None] * x
    return DhParts(
        arc(corners, before[:, :3, 0], z, theta, radius),
        np.stack([origins, corners], axis=1),
        np.stack([corners, ends], axis=1),
        arc(ends, z, x, alpha, radius),
        values,
    )


def _modified(before: Array, after: Array, values: Array, radius: float) -> DhParts:
    """a along and α about the old x, then θ about and d along the new z. Args: the two frames of each row (m, 4, 4)."""
    theta, d, a, alpha = values.T
    origins, x, z = before[:, :3, 3], before[:, :3, 0], after[:, :3, 2]
    corners = origins + a[:, None] * x
    return DhParts(
        arc(corners, _turned_x(after, -theta), z, theta, radius),
        np.stack([corners, corners + d[:, None] * z], axis=1),
        np.stack([origins, corners], axis=1),
        arc(corners, before[:, :3, 2], x, alpha, radius),
        values,
    )


def _turned_x(frames: Array, angles: Array) -> Array:
    """The x axes of frames (m, 4, 4) after rotations about their z by angles (m,), rad: (m, 3)."""
    return np.asarray(np.cos(angles)[:, None] * frames[:, :3, 0] + np.sin(angles)[:, None] * frames[:, :3, 1])


def arc(centre: Array, start: Array, axis: Array, angle: ArrayLike, radius: float) -> Array:
    """Points of arcs (..., ARC_POINTS, 3), m: from unit vectors `start`, perpendicular to the axes, through angles.

    Args: centre (..., 3), m; start and axis (..., 3), unit vectors; angle (...), rad; radius, m.
    """
    angles = np.asarray(angle)[..., None] * _SHARES
    plane = np.stack([start, np.cross(axis, start)], axis=-2)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return np.asarray(centre[..., None, :] + radius * (circle @ plane))
