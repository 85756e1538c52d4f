"""The error of a posture against a goal, and its derivatives in the joints: kernels.

The chain is evaluated from the tool to the base, in the axes of the last frame. Shapes are not checked.
"""

from __future__ import annotations

from helicoide.arrays import Array
from helicoide.ik.postures.blocks import Error
from helicoide.ik.postures.packed import (
    BASE,
    DRIVER,
    FIRST,
    HAND,
    JOINTS,
    PLACE,
    REACH,
    SETTING,
    SLIDE,
    SLIDE_SHIFT,
    SLIDES,
    TILT,
    TURN,
    TURN_SHIFT,
    TURNING,
    TURNS,
    WAY,
)
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import Row, Rows, Triple, dot, rotation_between
from helicoide.kinematics.trigonometry import cosine_and_sine

ANGLES, COSINES, SINES, COLUMNS = range(4)  # rows of `room`; from COLUMNS on, one row −∂e/∂q for each variable

# The goal of the last frame, in the first frame: the columns of its rotation, and the tool position divided by ℓ.
Goal = tuple[Rows, Triple]


@kernel_into
def rotation(a: Array) -> Rows:
    """The rotation in a row of the table."""
    return (a[0], a[1], a[2]), (a[3], a[4], a[5]), (a[6], a[7], a[8])


@kernel_into
def rotated_vector(R: Rows, v: Triple) -> Triple:
    """R v."""
    return dot(R[0], v), dot(R[1], v), dot(R[2], v)


@kernel_into
def goal_of(table: Array, T: Array) -> Goal:
    """The goal for a pose of the tool (4, 4), m."""
    base, (x, y, z) = rotation(table[BASE]), rotation(table[HAND])
    R = (T[0, 0], T[0, 1], T[0, 2]), (T[1, 0], T[1, 1], T[1, 2]), (T[2, 0], T[2, 1], T[2, 2])
    scale = 1.0 / table[SETTING, REACH]
    p = (scale * T[0, 3], scale * T[1, 3], scale * T[2, 3])
    return (
        rotated_vector(base, rotated_vector(R, x)),
        rotated_vector(base, rotated_vector(R, y)),
        rotated_vector(base, rotated_vector(R, z)),
    ), rotated_vector(base, p)


@kernel_into
def before(row: Row, joint: Array, slid: float, c: float, s: float) -> Row:
    """A row (r, p) of the frame before a joint, from the frame after it: slide, rotation, twist, offset are undone."""
    x, y = c * row[0] - s * row[1], s * row[0] + c * row[1]
    y, z = joint[TILT] * y - joint[TILT + 1] * row[2], joint[TILT + 1] * y + joint[TILT] * row[2]
    way = x * joint[WAY] + y * joint[WAY + 1] + z * joint[WAY + 2]
    return x, y, z, row[3] - slid * row[2] - way


@kernel_into
def linearised(table: Array, goal: Goal, q: Array, buffers: Array) -> Error:
    """The error e of a posture; the columns −∂e/∂q are written into `room`.

    For a joint at p, from the tool, with axis z the column is (p × z, z), or (z, 0) if prismatic. It is per unit of the
    variable: 1 rad, or ℓ. Args: table of `packed`; q (n,), rad or m; room of `packed.room_for`.
    """
    m, columns = int(table[SETTING, JOINTS]), buffers[COLUMNS:]
    angles, cosines, sines = buffers[ANGLES], buffers[COSINES], buffers[SINES]
    for i in range(m):
        joint = table[FIRST + i]
        angles[i] = joint[TURN] * q[int(joint[DRIVER])] + joint[TURN_SHIFT]
    for i in range(angles.shape[0]):
        cosines[i], sines[i] = cosine_and_sine(angles[i])
    columns[:] = 0.0
    tip, weight = table[HAND, PLACE:], table[SETTING, TURNING]
    x, y, z = (1.0, 0.0, 0.0, -tip[0]), (0.0, 1.0, 0.0, -tip[1]), (0.0, 0.0, 1.0, -tip[2])
    for k in range(1, m + 1):
        i = m - k
        joint = table[FIRST + i]
        j = int(joint[DRIVER])
        column, turns, slides = columns[j], joint[TURNS], joint[SLIDES]
        column[0] += turns * (y[3] * z[2] - z[3] * y[2]) + slides * x[2]
        column[1] += turns * (z[3] * x[2] - x[3] * z[2]) + slides * y[2]
        column[2] += turns * (x[3] * y[2] - y[3] * x[2]) + slides * z[2]
        turns *= weight
        column[3] += turns * x[2]
        column[4] += turns * y[2]
        column[5] += turns * z[2]
        slid, c, s = joint[SLIDE] * q[j] + joint[SLIDE_SHIFT], cosines[i], sines[i]
        x, y, z = before(x, joint, slid, c, s), before(y, joint, slid, c, s), before(z, joint, slid, c, s)
    (gx, gy, gz), p = goal
    r = rotation_between((x, y, z), gx, gy, gz)
    return dot(x, p) + x[3], dot(y, p) + y[3], dot(z, p) + z[3], weight * r[0], weight * r[1], weight * r[2]


@kernel_into
def squares(e: Error) -> tuple[float, float]:
    """The squared errors of position and of orientation."""
    return e[0] * e[0] + e[1] * e[1] + e[2] * e[2], e[3] * e[3] + e[4] * e[4] + e[5] * e[5]
