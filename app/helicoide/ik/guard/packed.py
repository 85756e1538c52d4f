"""The packed arm: its joints, all that limits a step, and the settings of the step, as one table of numbers.

One array is passed to a kernel in a tenth of the time of a tuple of tuples. A row is a joint, a variable, a point, a
plane or a pair of bodies; columns have names.
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
# The first rows; from FIRST on the joints, with the columns of `tool_kernels.arm_array`, then the other parts.
SETTING, TOOL, INSTRUMENT, FIRST = range(4)
# Columns of the setting: the numbers of joints, variables, points, monitored points (the first ones), planes and pairs;
# the critical distance, m; κ of the dampers, 1/s; the reach ℓ, m; λ² and the weight of orientation, for lengths divided
# by ℓ; whether orientation is solved in the null space of the position; the link with an instrument, 0 for none.
(
    JOINTS, VARIABLES, POINTS, GUARDED, PLANES, PAIRS,
    CRITICAL, GAIN, REACH, DAMPING, ORIENTATION, POSITION_FIRST, CARRIER,
) = range(13)  # fmt: skip
# Columns of the tool: (R, p) on the last link, row by row. Of the instrument: a point of its shaft, m, and the
# direction, in the frame of its link, and the entry point, m, world.
SHAFT, DIRECTION, ENTRY = 0, 3, 6
# Columns of a variable: its limits, rad, rad/s and rad/s², or m, m/s and m/s².
LOWER, UPPER, SPEED, ACCELERATION = range(4)
# Columns of a point: its position in the frame of its link (three), m, and the link. Of a plane, normal · p ≥ offset:
# the normal (three) and the offset, m.
LINK, OFFSET = 3, 3
# Columns of a pair: the points at the axis ends of its two bodies (four), and the smallest distance of the axes, m.
LEAST = 4


class At(NamedTuple):
    """The numbers of joints m and variables n of a packed arm, and the first row of each part.

    by_planes: number of distances from monitored points to planes; clearances: number of all distances, those of the
    pairs of bodies last.
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


class PlacedArm(NamedTuple):
    """A packed arm in a posture.

    arm: the table; at: its parts; q (n,), rad or m; poses (m + 1, 4, 4), m, of the links and axes (m, 3) of the joints,
    world, of `place_links`.
    """

    arm: Array
    at: At
    q: Array
    poses: Array
    axes: Array


@kernel_into
def array_parts(arm: Array) -> At:
    """The parts of a packed arm: their sizes and first rows."""
    m, n = int(arm[SETTING, JOINTS]), int(arm[SETTING, VARIABLES])
    k, b = int(arm[SETTING, PLANES]), int(arm[SETTING, PAIRS])
    limits = FIRST + m
    points = limits + n
    planes = points + int(arm[SETTING, POINTS])
    by_planes = k * int(arm[SETTING, GUARDED])
    return At(m, n, limits, points, planes, planes + k, planes + k + b, by_planes, by_planes + b)


@kernel_into
def place_links(placed: PlacedArm) -> None:
    """Write the link poses and the joint axes of an arm at its q, as `forward.link_poses` and `jacobian.joint_axes`."""
    arm, at, q, poses, axes = placed
    x, y, z = X, Y, Z
    write_pose(poses[0], x, y, z)
    for i in range(at.m):
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
    """One read-only table of the setting and all other rows, each (k, at most `WIDTH`)."""
    every = [np.array([setting]), *rows]
    arm = np.zeros((sum(map(len, every)), WIDTH))
    first = 0
    for part in every:
        arm[first : first + len(part), : part.shape[1]] = part
        first += len(part)
    arm.flags.writeable = False
    return arm
