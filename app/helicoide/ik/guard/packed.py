"""The packed arm: all that bounds a step, and how the tool is led to a pose, as one table of numbers.

A kernel takes one array in a tenth of the time of a tuple of tuples. A row is a joint, a variable, a point, a plane or
a pair of bodies; columns have names.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import (
    ANGLE_OFFSET,
    ANGLE_RATIO,
    AXIS,
    AXIS_OFFSET,
    DRIVER,
    SLIDE_OFFSET,
    SLIDE_RATIO,
    X,
    Y,
    Z,
    dot,
    row_after_joint,
    write_pose,
)
from helicoide.kinematics.trigonometry import cosine_and_sine

WIDTH = 16
# The first rows; from FIRST on the joints, with the columns of `tool.packed`, then the other parts.
SETTING, TOOL, INSTRUMENT, FIRST = range(4)
# Of the setting: how many joints, variables, points (the first of them guarded from planes), planes and pairs; the
# critical distance, m; κ of the dampers, 1/s; ℓ, m; λ² and the weight of orientation, for lengths in ℓ; whether
# orientation is asked for in what the position leaves free; the link that carries an instrument, 0 for none.
(
    JOINTS, VARIABLES, POINTS, GUARDED, PLANES, PAIRS,
    CRITICAL, GAIN, REACH, DAMPING, ORIENTATION, POSITION_FIRST, CARRIER,
) = range(13)  # fmt: skip
# Of the tool: (R, p) on the last link, row by row. Of the instrument: a point of its shaft and the direction, in the
# frame of its link, and the entry point, m.
SHAFT, DIRECTION, ENTRY = 0, 3, 6
# Of a variable: rad, rad/s and rad/s², or m, m/s and m/s².
LOWER, UPPER, SPEED, ACCELERATION = range(4)
# Of a point: its place in the frame of the link that carries it (three), m. Of a plane: normal · p ≥ offset, m.
LINK, OFFSET = 3, 3
# Of a pair: the points where the axes of its two bodies begin and end (four), and how far apart these stay, m.
LEAST = 4


class At(NamedTuple):
    """How many joints and variables a packed arm has, m and n, and the rows where its parts begin.

    by_planes: how many distances from planes are kept, each guarded point's from each plane; clearances: how many
    distances in all, with those between the bodies of pairs behind.
    """

    m: int
    n: int
    limits: int
    points: int
    planes: int
    pairs: int
    end: int
    by_planes: int
    clearances: int


@kernel_into
def array_parts(arm: Array) -> At:
    """Where the parts of a packed arm begin."""
    m, n = int(arm[SETTING, JOINTS]), int(arm[SETTING, VARIABLES])
    k, b = int(arm[SETTING, PLANES]), int(arm[SETTING, PAIRS])
    limits = FIRST + m
    points = limits + n
    planes = points + int(arm[SETTING, POINTS])
    by_planes = k * int(arm[SETTING, GUARDED])
    return At(m, n, limits, points, planes, planes + k, planes + k + b, by_planes, by_planes + b)


@kernel_into
def place_links(arm: Array, m: int, q: Array, poses: Array, axes: Array) -> None:
    """Write where the links of m joints are and which way their axes point, as `forward.link_poses` and `joint_axes`.

    Args: q (n,), rad or m; poses (m + 1, 4, 4), m; axes (m, 3).
    """
    x, y, z = X, Y, Z
    write_pose(poses[0], x, y, z)
    for i in range(m):
        joint = FIRST + i
        axis = (arm[joint, AXIS], arm[joint, AXIS + 1], arm[joint, AXIS + 2])
        way = (arm[joint, AXIS_OFFSET], arm[joint, AXIS_OFFSET + 1], arm[joint, AXIS_OFFSET + 2])
        value = q[int(arm[joint, DRIVER])]
        slid = arm[joint, SLIDE_RATIO] * value + arm[joint, SLIDE_OFFSET]
        c, s = cosine_and_sine(arm[joint, ANGLE_RATIO] * value + arm[joint, ANGLE_OFFSET])
        axes[i, 0], axes[i, 1], axes[i, 2] = dot(x, axis), dot(y, axis), dot(z, axis)
        x, y, z = (
            row_after_joint(x, axis, way, slid, c, s),
            row_after_joint(y, axis, way, slid, c, s),
            row_after_joint(z, axis, way, slid, c, s),
        )
        write_pose(poses[i + 1], x, y, z)


def packed_rows(setting: list[float], *rows: Array) -> Array:
    """One table of the setting and of all other rows, each (k, at most `WIDTH`)."""
    every = [np.array([setting]), *rows]
    arm = np.zeros((sum(map(len, every)), WIDTH))
    first = 0
    for part in every:
        arm[first : first + len(part), : part.shape[1]] = part
        first += len(part)
    arm.flags.writeable = False
    return arm
