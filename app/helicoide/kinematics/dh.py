"""Denavit-Hartenberg rows in both conventions, and rows recovered from screw axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.chain import Joint

Convention = Literal["standard", "modified"]

# Where the angle between two axes has a small sine s, their common normal is about 1/s away, and rounding costs
# 1e-15/s m. Below this sine their row gets a fifth number, β.
NEARLY_PARALLEL = 1e-4
COINCIDENT = 1e-12


@dataclass(frozen=True)
class DhRow:
    """A Denavit-Hartenberg row in rad and m; the joint's variable is added to theta, or to d if the joint slides.

    beta: rotation about y that Hayati adds for nearly parallel axes; 0 elsewhere. Source: Hayati 1983.
    """

    theta: float
    d: float
    a: float
    alpha: float
    beta: float = 0.0


@dataclass(frozen=True, eq=False)
class DhTable:
    """The DH rows of an arm, with the first DH frame T_world_dh (4, 4) and the tool in the last DH frame, T_dh_tool.

    standard: Aᵢ = Rz(θᵢ) Tz(dᵢ) Tx(aᵢ) Rx(αᵢ); modified (Craig): Aᵢ = Rx(αᵢ₋₁) Tx(aᵢ₋₁) Rz(θᵢ) Tz(dᵢ). Where axes are
    nearly parallel Ry(β) follows Rx(α).
    """

    convention: Convention
    rows: tuple[DhRow, ...]
    T_world_dh: Array
    T_dh_tool: Array


def _about_z(theta: float, d: float) -> Array:
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])


def _about_x_and_y(a: float, alpha: float, beta: float) -> Array:
    c, s, cb, sb = np.cos(alpha), np.sin(alpha), np.cos(beta), np.sin(beta)
    return np.array([[cb, 0, sb, a], [s * sb, c, -s * cb, 0], [-c * sb, s, c * cb, 0], [0, 0, 0, 1]])


def dh_transform(convention: Convention, row: DhRow, joint: Joint, value: float) -> Array:
    """Pose of a DH frame in the frame before it, for a joint value.

    A = Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β) in the standard convention, Tx(a) Rx(α) Ry(β) Rz(θ) Tz(d) in the modified one.
    Args: value: rad, or m if the joint slides. Returns (4, 4), m.
    Source: Cerbaro 2022, eq. 57 (standard); Campos 1998, s.40 and Craig (modified); Hayati 1983 (β).
    """
    theta, d = (row.theta, row.d + value) if joint.is_prismatic else (row.theta + value, row.d)
    z, x = _about_z(theta, d), _about_x_and_y(row.a, row.alpha, row.beta)
    return z @ x if convention == "standard" else x @ z


def dh_poses(table: DhTable, joints: Sequence[Joint], values: Array) -> list[Array]:
    """Poses of all DH frames in the base frame: T₀ A₁ … Aᵢ for i = 0 to m, each (4, 4), m.

    Args: values (m,): value of each joint, rad or m.
    """
    frames = [table.T_world_dh]
    for row, joint, value in zip(table.rows, joints, values, strict=True):
        frames.append(frames[-1] @ dh_transform(table.convention, row, joint, value))
    return frames


def dh_from_screws(joints: Sequence[Joint], T_world_tool_0: Array) -> DhTable:
    """Standard DH rows computed from the screw axes of a chain.

    zᵢ₋₁ lies along axis i; xᵢ along the common normal of axes i and i + 1, from the first to the second. If the axes
    are parallel or nearly so, origin i is where axis i + 1 meets the plane through origin i − 1 that is perpendicular
    to axis i; xᵢ points, but for β, from origin i − 1 to origin i, or along xᵢ₋₁ if the two coincide. The last joint
    has a row of zeros.
    Args: joints, base first; T_world_tool_0 (4, 4), m, at q = 0. Source: Denavit and Hartenberg 1955; Hayati 1983.
    """
    first = joints[0]
    frame = _frame(_perpendicular_unit(np.eye(3)[0], first.direction), first.direction, first.point)
    start, rows = frame, []
    for joint, after in zip(joints, [*joints[1:], first], strict=True):
        row, frame = (DhRow(0, 0, 0, 0), frame) if joint is joints[-1] else _row(frame, after)
        rows.append(row)
    return DhTable("standard", tuple(rows), frozen(start), frozen(np.linalg.inv(frame) @ T_world_tool_0))


def _frame(x: Array, z: Array, origin: Array) -> Array:
    frame = np.eye(4)
    frame[:3, :4] = np.column_stack([x, np.cross(z, x), z, origin])
    return frame


def _perpendicular_unit(preferred: Array, z: Array) -> Array:
    """The unit vector perpendicular to z that is nearest to a given vector, or to the y axis if that lies along z."""
    x = preferred - (preferred @ z) * z
    if np.linalg.norm(x) < 1e-3:
        return _perpendicular_unit(np.eye(3)[1], z)
    return np.asarray(x / np.linalg.norm(x))


def _row(frame: Array, after: Joint) -> tuple[DhRow, Array]:
    """The DH row from a frame, whose z is the axis of its joint, to the frame on the next axis; and that frame."""
    x, z, origin = frame[:3, 0], frame[:3, 2], frame[:3, 3]
    across = np.cross(z, after.direction)
    sine = float(np.linalg.norm(across))
    if sine < NEARLY_PARALLEL:
        return _nearly_parallel(frame, after)
    foot, normal, end = _common_normal(z, origin, across / sine, sine, after)
    row = DhRow(
        theta=_angle(x, normal, z),
        d=float((foot - origin) @ z),
        a=float((end - foot) @ normal),
        alpha=_angle(z, after.direction, normal),
    )
    return row, _frame(normal, after.direction, end)


def _angle(start: Array, end: Array, axis: Array) -> float:
    """Angle from one unit vector to another about an axis perpendicular to both, rad."""
    return float(np.arctan2(np.cross(start, end) @ axis, start @ end))


def _nearly_parallel(frame: Array, after: Joint) -> tuple[DhRow, Array]:
    """The row with β and d = 0, and the next frame: its z is (sin β, −sin α cos β, cos α cos β) in the axes after θ."""
    x, z, origin = frame[:3, 0], frame[:3, 2], frame[:3, 3]
    end = after.point + (origin - after.point) @ z / (after.direction @ z) * after.direction
    length = float(np.linalg.norm(end - origin))
    normal = x if length < COINCIDENT else _perpendicular_unit((end - origin) / length, z)
    leans, turns, along = after.direction @ np.column_stack([normal, np.cross(z, normal), z])
    row = DhRow(
        theta=_angle(x, normal, z),
        d=0.0,
        a=float((end - origin) @ normal),
        alpha=float(np.arctan2(-turns, along)),
        beta=float(np.arctan2(leans, np.hypot(turns, along))),
    )
    return row, _frame(_perpendicular_unit(normal, after.direction), after.direction, end)


def _common_normal(z: Array, origin: Array, normal: Array, sine: float, after: Joint) -> tuple[Array, Array, Array]:
    """Common normal of the axis z through origin and the next axis: its foot, its unit direction and its end.

    Args: normal (3,): z × direction of the next axis, divided by its length, the sine.
    """
    between = after.point - origin
    along = np.cross(between, after.direction) @ normal / sine
    after_along = np.cross(between, z) @ normal / sine
    foot, end = origin + along * z, after.point + after_along * after.direction
    return foot, -normal if (end - foot) @ normal < 0 else normal, end
