"""Poses and Jacobians of the tool in many postures: the kernels of `tool` on blocks of postures.

In a block, each entry of a frame is stored contiguously for all postures. Loops over a block have neither branches nor
calls, so that they compile to vector instructions.
"""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel
from helicoide.kinematics.tool_kernels import (
    ANGLE_OFFSET,
    ANGLE_RATIO,
    DRIVER,
    SLIDE_OFFSET,
    SLIDE_RATIO,
    Row,
    Triple,
    axis_and_offset,
    cross,
    dot,
    joint_twist,
    row_after_joint,
    tool_row,
    tool_rows,
    write_pose,
)
from helicoide.kinematics.trigonometry import cosine_and_sine

# A block holds the twelve entries of the frame, then x and θ of the joint, each for this many postures.
BLOCK = 128
SLIDES, ANGLES, BLOCK_LENGTH = 12 * BLOCK, 13 * BLOCK, 14 * BLOCK


@kernel
def block_row(block: Array, a: int, k: int) -> Row:
    """Row a of the frame in posture k."""
    i = 4 * BLOCK * a + k
    return block[i], block[i + BLOCK], block[i + 2 * BLOCK], block[i + 3 * BLOCK]


@kernel
def set_block_row(block: Array, a: int, k: int, row: Row) -> None:
    """Write row a of the frame in posture k."""
    i = 4 * BLOCK * a + k
    block[i], block[i + BLOCK], block[i + 2 * BLOCK], block[i + 3 * BLOCK] = row


@kernel
def start_at_base(block: Array) -> None:
    """Write the base frame for all postures."""
    for number in range(12):
        block[number * BLOCK : (number + 1) * BLOCK] = 1.0 if number % 5 == 0 else 0.0


@kernel
def joint_motions(block: Array, joint: Array, qs: Array) -> None:
    """Write the displacement x and the rotation θ of a joint in each posture."""
    turn, turn_shift, slide, slide_shift = (
        joint[ANGLE_RATIO],
        joint[ANGLE_OFFSET],
        joint[SLIDE_RATIO],
        joint[SLIDE_OFFSET],
    )
    j = int(joint[DRIVER])
    for k in range(qs.shape[0]):
        block[SLIDES + k], block[ANGLES + k] = slide * qs[k, j] + slide_shift, turn * qs[k, j] + turn_shift


@kernel
def pass_joint(block: Array, joint: Array) -> None:
    """Replace the frame before a joint by the frame after it."""
    axis, way = axis_and_offset(joint)
    for k in range(BLOCK):
        x, (c, s) = block[SLIDES + k], cosine_and_sine(block[ANGLES + k])
        set_block_row(block, 0, k, row_after_joint(block_row(block, 0, k), axis, way, x, c, s))
        set_block_row(block, 1, k, row_after_joint(block_row(block, 1, k), axis, way, x, c, s))
        set_block_row(block, 2, k, row_after_joint(block_row(block, 2, k), axis, way, x, c, s))


@kernel
def end_at_tool(block: Array, end: Array) -> None:
    """Replace the frame of the last link by the tool's."""
    tool = tool_rows(end)
    for k in range(BLOCK):
        set_block_row(block, 0, k, tool_row(block_row(block, 0, k), tool))
        set_block_row(block, 1, k, tool_row(block_row(block, 1, k), tool))
        set_block_row(block, 2, k, tool_row(block_row(block, 2, k), tool))


@kernel
def tool_poses_into(arm: Array, qs: Array, Ts: Array) -> None:
    """Write the poses of `tool_poses` into Ts (k, 4, 4)."""
    block, last = np.zeros(BLOCK_LENGTH), arm.shape[0] - 1
    for first in range(0, qs.shape[0], BLOCK):
        some = qs[first : first + BLOCK]
        start_at_base(block)
        for i in range(last):
            joint_motions(block, arm[i], some)
            pass_joint(block, arm[i])
        end_at_tool(block, arm[last])
        for k in range(some.shape[0]):
            write_pose(Ts[first + k], block_row(block, 0, k), block_row(block, 1, k), block_row(block, 2, k))


@kernel
def twist_behind_joint(x: Row, y: Row, z: Row, axis: Triple, turn: float, slide: float) -> tuple[Triple, Triple]:
    """A joint's `twist` from the frame after it: the joint's own motion leaves its axis unchanged."""
    return joint_twist((x[3], y[3], z[3]), (dot(x, axis), dot(y, axis), dot(z, axis)), turn, slide)


@kernel
def add_joint_twists(column: Array, block: Array, joint: Array) -> None:
    """Add the twists of a joint, at the origin of the base, to the column of its variable."""
    (axis, _), turn, slide = axis_and_offset(joint), joint[ANGLE_RATIO], joint[SLIDE_RATIO]
    for k in range(BLOCK):
        v, w = twist_behind_joint(
            block_row(block, 0, k), block_row(block, 1, k), block_row(block, 2, k), axis, turn, slide
        )
        add_triple(column, 0, k, v)
        add_triple(column, 3, k, w)


@kernel
def add_triple(column: Array, a: int, k: int, v: Triple) -> None:
    """Add a triple to the rows a to a + 2 of posture k."""
    i = a * BLOCK + k
    column[i] += v[0]
    column[i + BLOCK] += v[1]
    column[i + 2 * BLOCK] += v[2]


@kernel
def shift_to_tool(column: Array, block: Array) -> None:
    """Move the twists from the origin of the base to the tool: v ← v + ω × p."""
    for k in range(BLOCK):
        p = (block_row(block, 0, k)[3], block_row(block, 1, k)[3], block_row(block, 2, k)[3])
        w = (column[3 * BLOCK + k], column[4 * BLOCK + k], column[5 * BLOCK + k])
        add_triple(column, 0, k, cross(w, p))


@kernel
def tool_jacobians_into(arm: Array, qs: Array, Js: Array) -> None:
    """Write the Jacobians of `tool_jacobians` into Js (k, 6, n)."""
    block, last, columns = np.zeros(BLOCK_LENGTH), arm.shape[0] - 1, np.empty((qs.shape[1], 6 * BLOCK))
    for first in range(0, qs.shape[0], BLOCK):
        some = qs[first : first + BLOCK]
        start_at_base(block)
        columns[:] = 0.0
        for i in range(last):
            joint_motions(block, arm[i], some)
            pass_joint(block, arm[i])
            add_joint_twists(columns[int(arm[i, DRIVER])], block, arm[i])
        end_at_tool(block, arm[last])
        for j in range(qs.shape[1]):
            shift_to_tool(columns[j], block)
            for k in range(some.shape[0]):
                for a in range(6):
                    Js[first + k, a, j] = columns[j, a * BLOCK + k]


def tool_poses(arm: Array, qs: Array) -> Array:
    """Tool poses of many postures: `tool_pose` of each row of qs (k, n); returns Ts_world_tool (k, 4, 4), m."""
    Ts = np.empty((qs.shape[0], 4, 4))
    tool_poses_into(arm, qs, Ts)
    return Ts


def tool_jacobians(arm: Array, qs: Array) -> Array:
    """Jacobians of many postures: `tool_jacobian` of each row of qs (k, n); returns Js_world (k, 6, n)."""
    Js = np.empty((qs.shape[0], 6, qs.shape[1]))
    tool_jacobians_into(arm, qs, Js)
    return Js
