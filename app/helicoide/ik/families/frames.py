"""A pose expressed in the frames of an arm: kernels."""

from __future__ import annotations

from helicoide.arrays import Array
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import Row, tool_row

# A pose as its rows (R, p), m.
Tool = tuple[Row, Row, Row]


@kernel_into
def first_four(a: Array) -> Row:
    """The first four numbers of a row."""
    return a[0], a[1], a[2], a[3]


@kernel_into
def pose_rows(T: Array) -> Tool:
    """A pose (4, 4), m, as its rows."""
    return first_four(T[0]), first_four(T[1]), first_four(T[2])


@kernel_into
def framed(T_base_world: Array, T_world_tool: Array, T_tool_end: Array) -> Tool:
    """T_base_end = T_base_world T_world_tool T_tool_end, of poses (4, 4), m."""
    tool, end = pose_rows(T_world_tool), pose_rows(T_tool_end)
    x, y, z = pose_rows(T_base_world)
    return tool_row(tool_row(x, tool), end), tool_row(tool_row(y, tool), end), tool_row(tool_row(z, tool), end)
