"""The rows that bound one tick: how far each joint may move, and how fast points of the arm may approach."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain

Indices = NDArray[np.int64]
# The chain of joints, points (m, 3), m, on the links (m,) that carry them: first those that are guarded from planes.
Arm = tuple[Chain, Array, Indices]
# Lower, upper (n,), rad, speed (n,), rad/s, acceleration (n,), rad/s².
LimitArrays = tuple[Array, Array, Array, Array]
# Normals (k, 3), offsets (k,), m, critical distance, m.
PlaneArrays = tuple[Array, Array, float]
# How many points are guarded from planes; of each pair, the points where its two bodies begin and end (p, 4); and how
# far apart their axes must stay, (p,), m.
Pairs = tuple[int, Indices, Array]
# The link that carries the shaft, 0 for none; a point of the shaft, m, and its direction in the frame of the link; the
# entry point, m, world.
Entry = tuple[int, Array, Array, Array]
# All of these, and the gain κ of the dampers, 1/s.
Guard = tuple[Arm, LimitArrays, PlaneArrays, Pairs, Entry, float]

DAMPER_GAIN = 10.0
# The share of all joints' braking that a point may count on: what is left over is for the other points.
BRAKING = 0.5
POSITION, SPEED, ACCELERATION = 0, 1, 2


@kernel
def braking(room: float, deceleration: float, dt: float) -> float:
    """The farthest way of one tick after which a room is still enough to stop: v dt with v dt + v²/2a = room.

    v²/2a holds for every later tick, however short. Args: room, rad or m; a, per s²; dt, s.
    """
    v = deceleration * (np.sqrt(dt * dt + 2.0 * room / deceleration) - dt)
    return float(v * dt)


@kernel
def motion_box(q: Array, rates: Array, limits: LimitArrays, dt: float) -> tuple[Array, Indices]:
    """How far each joint may move in a tick, and which of its limits says so.

    Position and speed come first, then v ≤ √(2 a room), from which a joint can stop before its limit; what is left is
    narrowed to |v − q̇| ≤ a dt. A joint beyond its limit may stay or come back, never go further.
    Args: q (n,), rad; rates (n,), of the tick before, rad/s; limits: lower, upper (n,), rad, speed (n,), rad/s,
    acceleration (n,), rad/s²; dt, s. Returns the bounds of Δq, lower and upper, and the same upon position and speed
    alone, (4, n), and the limit that gives the lower and the upper one, (2, n).
    """
    lower, upper, speed, acceleration = limits
    n = q.shape[0]
    box, kinds = np.empty((4, n)), np.empty((2, n), dtype=np.int64)
    for i in range(n):
        reach, a = speed[i] * dt, acceleration[i]
        for side in range(2):
            sign = 2 * side - 1
            room = max(0.0, sign * ((upper if side else lower)[i] - q[i]))
            way, kinds[side, i] = (room, POSITION) if room < reach else (reach, SPEED)
            box[2 + side, i] = sign * way
            if a < np.inf and braking(room, a, dt) < way:
                way, kinds[side, i] = braking(room, a, dt), ACCELERATION
            box[side, i] = sign * way
        if a < np.inf:
            down, up = box[0, i], box[1, i]
            slowest = min(max((rates[i] - a * dt) * dt, down), up)
            fastest = min(max((rates[i] + a * dt) * dt, down), up)
            if slowest > down:
                box[0, i], kinds[0, i] = slowest, ACCELERATION
            if fastest < up:
                box[1, i], kinds[1, i] = fastest, ACCELERATION
    return box, kinds


@kernel
def add_point(
    row: Array, factor: float, normal: Array, poses: Array, chain: Chain, axes: Array, point: Array, link: int
) -> None:
    """Add to a row (n,) a factor times nᵀ J_p, by which a point of a link moves along a normal.

    Args: normal, point (3,), world; poses (m + 1, 4, 4); axes (m, 3) of `jacobian.joint_axes`.
    """
    if factor == 0.0:
        return
    for i in range(link):
        joint = chain[i]
        x, y, z = axes[i, 0], axes[i, 1], axes[i, 2]
        if not joint["slides"]:
            rx, ry, rz = point[0] - poses[i + 1, 0, 3], point[1] - poses[i + 1, 1, 3], point[2] - poses[i + 1, 2, 3]
            x, y, z = y * rz - z * ry, z * rx - x * rz, x * ry - y * rx
        row[joint["driver"]] += factor * joint["ratio"] * (normal[0] * x + normal[1] * y + normal[2] * z)


@kernel
def plane_rows(
    rows: Array, poses: Array, chain: Chain, axes: Array, points: Array, links: Indices, normals: Array
) -> None:
    """Fill the rows (g k, n) by which points move along the normals of planes, point after point: `add_point` of each.

    Args: points (m, 3), m, world, on links (m,), the first g of them; normals (k, 3).
    """
    k = normals.shape[0]
    for r in range(rows.shape[0] // max(k, 1)):
        for i in range(links[r]):
            joint = chain[i]
            x, y, z = axes[i, 0], axes[i, 1], axes[i, 2]
            if not joint["slides"]:
                rx, ry = points[r, 0] - poses[i + 1, 0, 3], points[r, 1] - poses[i + 1, 1, 3]
                rz = points[r, 2] - poses[i + 1, 2, 3]
                x, y, z = y * rz - z * ry, z * rx - x * rz, x * ry - y * rx
            ratio, column = joint["ratio"], joint["driver"]
            for p in range(k):
                rows[r * k + p, column] += ratio * (normals[p, 0] * x + normals[p, 1] * y + normals[p, 2] * z)


@kernel
def damper(room: float, row: Array, acceleration: Array, gain: float, dt: float) -> float:
    """The velocity damper of a row: how near it may come in a tick, −κ dt room, no faster than it can brake; m.

    Args: room: distance left, m; row (n,); acceleration (n,), rad/s²; gain: κ, 1/s.
    """
    if room <= 0.0:
        return 0.0
    way = min(1.0, gain * dt) * room
    deceleration = 0.0
    for i in range(row.shape[0]):
        if row[i] != 0.0:
            deceleration += BRAKING * abs(row[i]) * acceleration[i]
        if deceleration == np.inf:
            return -way
    if deceleration > 0.0:
        way = min(way, braking(room, deceleration, dt))
    return -way
