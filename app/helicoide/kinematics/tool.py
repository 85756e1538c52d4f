"""The tool's pose and Jacobian in one call, for one posture or many: kernels for scripts, which the page leaves alone.

A frame is held as three rows (R, p) of four numbers, which stay in registers.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain

Triple = tuple[float, float, float]
Row = tuple[float, float, float, float]

X, Y, Z = (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0)


@kernel
def motion(joint: Any, q: Array) -> tuple[Triple, Triple, float, float]:
    """What a joint does: its axis s, the way s₀ᵢ − s₀ᵢ₋₁ + x s that it puts between the links, cos θ and sin θ."""
    axis, way = joint["direction"], joint["offset"]
    value = joint["ratio"] * q[joint["driver"]] + joint["shift"]
    x = value if joint["slides"] else 0.0
    angle = 0.0 if joint["slides"] else value
    return (
        (axis[0], axis[1], axis[2]),
        (way[0] + x * axis[0], way[1] + x * axis[1], way[2] + x * axis[2]),
        np.cos(angle),
        np.sin(angle),
    )


@kernel
def along(row: Row, v: Triple) -> float:
    """A component of R v."""
    return row[0] * v[0] + row[1] * v[1] + row[2] * v[2]


@kernel
def carried(row: Row, axis: Triple, way: Triple, c: float, s: float) -> Row:
    """A row (r, p) behind a joint: r cos θ + (1 − cos θ)(r·s) s + sin θ r × s and p + r·way. Source: Rodrigues."""
    v = (1.0 - c) * along(row, axis)
    return (
        c * row[0] + v * axis[0] + s * (row[1] * axis[2] - row[2] * axis[1]),
        c * row[1] + v * axis[1] + s * (row[2] * axis[0] - row[0] * axis[2]),
        c * row[2] + v * axis[2] + s * (row[0] * axis[1] - row[1] * axis[0]),
        row[3] + along(row, way),
    )


@kernel
def place(chain: Chain, T_link_tool: Array, q: Array, T: Array) -> None:
    """Write the pose of `tool_pose` into T (4, 4)."""
    x, y, z = X, Y, Z
    for i in range(chain.shape[0]):
        axis, way, c, s = motion(chain[i], q)
        x, y, z = carried(x, axis, way, c, s), carried(y, axis, way, c, s), carried(z, axis, way, c, s)
    for b in range(4):
        column = (T_link_tool[0, b], T_link_tool[1, b], T_link_tool[2, b])
        T[0, b], T[1, b], T[2, b], T[3, b] = along(x, column), along(y, column), along(z, column), 0.0
    T[0, 3] += x[3]
    T[1, 3] += y[3]
    T[2, 3] += z[3]
    T[3, 3] = 1.0


@kernel
def differentiate(chain: Chain, T_link_tool: Array, q: Array, J: Array) -> None:
    """Write the Jacobian of `tool_jacobian` into J (6, n).

    On the way along the chain the columns belong to the base's origin, [pᵢ × sᵢ; sᵢ]; at its end v ← v + ω × p takes
    them to the tool, so that no link's pose has to be kept.
    """
    J[:] = 0.0
    x, y, z = X, Y, Z
    for i in range(chain.shape[0]):
        axis, way, c, s = motion(chain[i], q)
        x, y, z = carried(x, axis, way, c, s), carried(y, axis, way, c, s), carried(z, axis, way, c, s)
        column, ratio = chain[i]["driver"], chain[i]["ratio"]
        direction = (ratio * along(x, axis), ratio * along(y, axis), ratio * along(z, axis))
        if chain[i]["slides"]:
            add(J, 0, column, direction)
        else:
            add(J, 3, column, direction)
            add(J, 0, column, cross((x[3], y[3], z[3]), direction))
    tool = (T_link_tool[0, 3], T_link_tool[1, 3], T_link_tool[2, 3])
    p = (x[3] + along(x, tool), y[3] + along(y, tool), z[3] + along(z, tool))
    for j in range(J.shape[1]):
        add(J, 0, j, cross((J[3, j], J[4, j], J[5, j]), p))


@kernel
def cross(a: Triple, b: Triple) -> Triple:
    """a × b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@kernel
def add(J: Array, row: int, column: int, v: Triple) -> None:
    """Add three numbers to a column, from a row on."""
    J[row, column] += v[0]
    J[row + 1, column] += v[1]
    J[row + 2, column] += v[2]


@kernel
def tool_pose(chain: Chain, T_link_tool: Array, q: Array) -> Array:
    """Tool pose in a posture: T = (Πᵢ Tr(s₀ᵢ − s₀ᵢ₋₁) Rot(sᵢ, xᵢ)) T_link_tool, with Tr(xᵢ sᵢ) where joint i slides.

    Args: chain (m,) of `chain.CHAIN`; T_link_tool (4, 4), m; q (n,), rad or m. Returns T_world_tool (4, 4), m.
    Source: Cerbaro 2022, App. D, with the link frames of `forward.link_poses`.
    """
    T = np.empty((4, 4))
    place(chain, T_link_tool, q, T)
    return T


@kernel
def tool_jacobian(chain: Chain, T_link_tool: Array, q: Array) -> Array:
    """Geometric Jacobian of the tool in a posture: column i is [sᵢ × (p − pᵢ); sᵢ], or [sᵢ; 0] where joint i slides.

    Args: chain (m,) of `chain.CHAIN`; T_link_tool (4, 4), m; q (n,), rad or m.
    Returns J_world (6, n), rows vx vy vz ωx ωy ωz. Source: Cerbaro 2022, eq. 67; Vargas 2013, eqs. 2.16–2.21.
    """
    J = np.empty((6, q.size))
    differentiate(chain, T_link_tool, q, J)
    return J


@kernel
def tool_poses(chain: Chain, T_link_tool: Array, qs: Array) -> Array:
    """Tool poses of many postures: `tool_pose` of each row of qs (k, n); returns Ts_world_tool (k, 4, 4), m."""
    Ts = np.empty((qs.shape[0], 4, 4))
    for k in range(qs.shape[0]):
        place(chain, T_link_tool, qs[k], Ts[k])
    return Ts


@kernel
def tool_jacobians(chain: Chain, T_link_tool: Array, qs: Array) -> Array:
    """Jacobians of many postures: `tool_jacobian` of each row of qs (k, n); returns Js_world (k, 6, n)."""
    Js = np.empty((qs.shape[0], 6, qs.shape[1]))
    for k in range(qs.shape[0]):
        differentiate(chain, T_link_tool, qs[k], Js[k])
    return Js
