"""The tool's pose and Jacobian in one call, for scripts.

The functions take the arm as one array, made by `packed`. The kernels whose names end in `_combined` write into an
array of the caller, as numba takes longer to return a new array than to compute its numbers. Shapes are not checked. A
frame is three rows (R, p) of four numbers, which stay in registers.
"""

from __future__ import annotations

import numpy as np
from numpy import empty

from helicoide.arrays import Array
from helicoide.kernels import kernel, kernel_into
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.trigonometry import cosine_and_sine

Triple = tuple[float, float, float]
Row = tuple[float, float, float, float]
Rows = tuple[Triple, Triple, Triple]

# Columns of a joint: its axis s (three), the offset s₀ᵢ − s₀ᵢ₋₁ (three), the number of its variable q, its rotation
# θ = TURN q + TURN_SHIFT and its displacement x = SLIDE q + SLIDE_SHIFT.
AXIS, AXIS_OFFSET, DRIVER, ANGLE_RATIO, ANGLE_OFFSET, SLIDE_RATIO, SLIDE_OFFSET = 0, 3, 6, 7, 8, 9, 10
COLUMNS = 12  # the last row is the tool: (R, p) on the last link, row by row

X, Y, Z = (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0)  # the base


def arm_array(robot: Robot) -> Array:
    """An arm as one array for these kernels: its m joints and its tool, (m + 1, 12), at q = 0, base frame, rad, m.

    Unlike other arrays it is not read-only, because numba takes longer to recognise a read-only one.
    """
    chain, arm = robot.chain, np.zeros((len(robot.joints) + 1, COLUMNS))
    joints, turns = arm[:-1], ~chain["slides"]
    joints[:, AXIS:AXIS_OFFSET], joints[:, AXIS_OFFSET:DRIVER], joints[:, DRIVER] = (
        chain["direction"],
        chain["offset"],
        chain["driver"],
    )
    joints[:, ANGLE_RATIO], joints[:, ANGLE_OFFSET] = turns * chain["ratio"], turns * chain["shift"]
    joints[:, SLIDE_RATIO], joints[:, SLIDE_OFFSET] = ~turns * chain["ratio"], ~turns * chain["shift"]
    arm[-1] = robot.T_link_tool[:3].ravel()
    return arm


@kernel
def dot(a: Row | Triple, b: Row | Triple) -> float:
    """a · b of the first three numbers."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@kernel
def cross(a: Triple, b: Triple) -> Triple:
    """a × b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel
def axis_and_offset(column: Array) -> tuple[Triple, Triple]:
    """A joint's axis s, and its offset s₀ᵢ − s₀ᵢ₋₁."""
    return (column[0], column[1], column[2]), (column[3], column[4], column[5])


@kernel
def row_after_joint(row: Row, axis: Triple, way: Triple, x: float, c: float, s: float) -> Row:
    """A row (r, p) after a joint: r cos θ + (1 − cos θ)(r·s) s + sin θ r × s (Rodrigues) and p + r·(way + x s)."""
    height = dot(row, axis)
    v = (1.0 - c) * height
    return (
        c * row[0] + v * axis[0] + s * (row[1] * axis[2] - row[2] * axis[1]),
        c * row[1] + v * axis[1] + s * (row[2] * axis[0] - row[0] * axis[2]),
        c * row[2] + v * axis[2] + s * (row[0] * axis[1] - row[1] * axis[0]),
        row[3] + dot(row, way) + x * height,
    )


@kernel
def joint_motion(joint: Array, q: float) -> tuple[float, float, float]:
    """Displacement x of a joint for the value q of its variable, and cos θ and sin θ of its rotation."""
    c, s = cosine_and_sine(joint[ANGLE_RATIO] * q + joint[ANGLE_OFFSET])
    return joint[SLIDE_RATIO] * q + joint[SLIDE_OFFSET], c, s


@kernel
def tool_row(row: Row, tool: tuple[Row, Row, Row]) -> Row:
    """A row of T_world_link T_link_tool."""
    x, y, z = tool
    return (
        row[0] * x[0] + row[1] * y[0] + row[2] * z[0],
        row[0] * x[1] + row[1] * y[1] + row[2] * z[1],
        row[0] * x[2] + row[1] * y[2] + row[2] * z[2],
        row[0] * x[3] + row[1] * y[3] + row[2] * z[3] + row[3],
    )


@kernel
def tool_rows(a: Array) -> tuple[Row, Row, Row]:
    """The three rows of T_link_tool."""
    return (a[0], a[1], a[2], a[3]), (a[4], a[5], a[6], a[7]), (a[8], a[9], a[10], a[11])


@kernel
def write_pose(T: Array, x: Row, y: Row, z: Row) -> None:
    """Write the rows of a pose into T (4, 4)."""
    T[0, 0], T[0, 1], T[0, 2], T[0, 3] = x
    T[1, 0], T[1, 1], T[1, 2], T[1, 3] = y
    T[2, 0], T[2, 1], T[2, 2], T[2, 3] = z
    T[3, 0], T[3, 1], T[3, 2], T[3, 3] = 0.0, 0.0, 0.0, 1.0


@kernel
def joint_twist(p: Triple, s: Triple, turn: float, slide: float) -> tuple[Triple, Triple]:
    """A joint's twist (v, ω) at the origin of the base for q̇ = 1: ω = TURN s, v = SLIDE s + p × ω, p on its axis s."""
    w = (turn * s[0], turn * s[1], turn * s[2])
    v = cross(p, w)
    return (v[0] + slide * s[0], v[1] + slide * s[1], v[2] + slide * s[2]), w


@kernel
def rotation_to(goal: Array, x: Row, y: Row, z: Row) -> Triple:
    """Rotation vector of `rotation_between` for a goal (4, 4), m."""
    gx, gy = (goal[0, 0], goal[0, 1], goal[0, 2]), (goal[1, 0], goal[1, 1], goal[1, 2])
    return rotation_between((gx, gy, (goal[2, 0], goal[2, 1], goal[2, 2])), x, y, z)


@kernel
def rotation_between(goal: Rows | tuple[Row, Row, Row], x: Row | Triple, y: Row | Triple, z: Row | Triple) -> Triple:
    """Rotation vector θ a of E = R_goal Rᵀ, 0 ≤ θ ≤ π, from the rows of both; near π the axis is a column of E + 1."""
    gx, gy, gz = goal
    a, b, c = dot(y, gz) - dot(z, gy), dot(z, gx) - dot(x, gz), dot(x, gy) - dot(y, gx)
    xx, yy, zz = dot(x, gx), dot(y, gy), dot(z, gz)
    sine, cosine = np.sqrt(a * a + b * b + c * c), xx + yy + zz - 1.0  # both twice
    if sine < 1e-6 and cosine > 0.0:
        return 0.5 * a, 0.5 * b, 0.5 * c
    length = sine
    if sine < 1e-6:
        if xx >= yy and xx >= zz:
            a, b, c = xx + 1.0, dot(x, gy), dot(x, gz)
        elif yy >= zz:
            a, b, c = dot(y, gx), yy + 1.0, dot(y, gz)
        else:
            a, b, c = dot(z, gx), dot(z, gy), zz + 1.0
        length = np.sqrt(a * a + b * b + c * c)
    angle = np.arctan2(sine, cosine) / length
    return angle * a, angle * b, angle * c


@kernel_into
def tool_pose_into(arm: Array, q: Array, T: Array) -> None:
    """Write the pose of `tool_pose` into T (4, 4)."""
    x, y, z = X, Y, Z
    last = arm.shape[0] - 1
    for i in range(last):
        # Written out here: in a separate kernel, LLVM would pass the frames through memory, which takes a tenth longer.
        (axis, way), (slid, c, s) = axis_and_offset(arm[i]), joint_motion(arm[i], q[int(arm[i, DRIVER])])
        x, y, z = (
            row_after_joint(x, axis, way, slid, c, s),
            row_after_joint(y, axis, way, slid, c, s),
            row_after_joint(z, axis, way, slid, c, s),
        )
    tool = tool_rows(arm[last])
    write_pose(T, tool_row(x, tool), tool_row(y, tool), tool_row(z, tool))


@kernel_into
def tool_jacobian_into(arm: Array, q: Array, J: Array) -> None:
    """Write the Jacobian of `tool_jacobian` into J (6, n).

    Along the arm, twists are taken at the origin of the base; at the end v ← v + ω × p moves them to the tool.
    """
    J[:] = 0.0
    x, y, z = X, Y, Z
    last = arm.shape[0] - 1
    for i in range(last):
        j = int(arm[i, DRIVER])
        (axis, way), (slid, c, s) = axis_and_offset(arm[i]), joint_motion(arm[i], q[j])
        turned = (dot(x, axis), dot(y, axis), dot(z, axis))
        x, y, z = (
            row_after_joint(x, axis, way, slid, c, s),
            row_after_joint(y, axis, way, slid, c, s),
            row_after_joint(z, axis, way, slid, c, s),
        )
        v, w = joint_twist((x[3], y[3], z[3]), turned, arm[i, ANGLE_RATIO], arm[i, SLIDE_RATIO])
        for a in range(3):
            J[a, j] += v[a]
            J[3 + a, j] += w[a]
    tool = tool_rows(arm[last])
    p = (tool_row(x, tool)[3], tool_row(y, tool)[3], tool_row(z, tool)[3])
    for j in range(J.shape[1]):
        v = cross((J[3, j], J[4, j], J[5, j]), p)
        for a in range(3):
            J[a, j] += v[a]


def tool_pose(arm: Array, q: Array) -> Array:
    """Tool pose for joint values q: T = (Πᵢ Tr(s₀ᵢ − s₀ᵢ₋₁ + xᵢ sᵢ) Rot(sᵢ, θᵢ)) T_link_tool.

    Args: arm of `packed`; q (n,), rad or m. Returns T_world_tool (4, 4), m.
    Source: Cerbaro 2022, App. D, with the link frames of `forward.link_poses`.
    """
    T = empty((4, 4))
    tool_pose_into(arm, q, T)
    return T


def tool_jacobian(arm: Array, q: Array) -> Array:
    """Geometric Jacobian of the tool: column i is [sᵢ × (p − pᵢ); sᵢ], or [sᵢ; 0] if joint i slides.

    Args: arm of `packed`; q (n,), rad or m. Returns J_world (6, n), rows vx vy vz ωx ωy ωz.
    Source: Cerbaro 2022, eq. 67; Vargas 2013, eqs. 2.16–2.21.
    """
    J = empty((6, len(q)))
    tool_jacobian_into(arm, q, J)
    return J
