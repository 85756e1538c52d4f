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
# J (r, n), v (r,), weights (r,), damping d (n,).
Task = tuple[Array, Array, Array, Array]
Vector = tuple[float, float, float]

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
def at(points: Array, which: int) -> Vector:
    """One of points (m, 3); numbers by themselves cost a kernel less than a piece of an array."""
    return points[which, 0], points[which, 1], points[which, 2]


@kernel
def add_point(
    rows: Array, which: int, normal: Vector, point: Vector, link: int, poses: Array, chain: Chain, axes: Array
) -> None:
    """Add nᵀ J_p, by which a point of a link moves along n, to one of rows (m, n).

    Args: normal, of any length, and point, m, world; poses (m + 1, 4, 4); axes (m, 3) of `jacobian.joint_axes`.
    """
    for i in range(link):
        joint = chain[i]
        x, y, z = axes[i, 0], axes[i, 1], axes[i, 2]
        if not joint["slides"]:
            rx, ry, rz = point[0] - poses[i + 1, 0, 3], point[1] - poses[i + 1, 1, 3], point[2] - poses[i + 1, 2, 3]
            x, y, z = y * rz - z * ry, z * rx - x * rz, x * ry - y * rx
        rows[which, joint["driver"]] += joint["ratio"] * (normal[0] * x + normal[1] * y + normal[2] * z)


@kernel
def from_origin(poses: Array, link: int, x: float, y: float, z: float) -> float:
    """How far a point is from the origin of a link, m; poses (m + 1, 4, 4)."""
    x, y, z = x - poses[link, 0, 3], y - poses[link, 1, 3], z - poses[link, 2, 3]
    return float(np.sqrt(x * x + y * y + z * z))


@kernel
def unfelt(
    chain: Chain, links: Indices, speed: Array, acceleration: Array, gain: float, poses: Array, points: Array, dt: float
) -> Array:
    """The room beyond which no bound on a point can hold a tick, (m,), m.

    However the joints turn, a point moves by no more than s = Σ |Δqᵢ| times its distance from axis i, which is at most
    that along the links. A bound −κ dt l holds nothing from l = s / κ dt on. What a brake allows, v dt with
    v dt + v²/2D = l, holds nothing from l = s + s²/2D dt² on, where s ≤ Σ |rowᵢ| ωᵢ dt and D = ½ Σ |rowᵢ| aᵢ make it
    at most s (1 + max ω / a dt). Args: poses (j + 1, 4, 4); points (m, 3), m, world.
    """
    ways = np.empty((chain.shape[0] + 1, 2))
    far, turn, way = np.empty(points.shape[0]), 0.0, 0.0
    beyond = 1.0 / min(1.0, gain * dt)
    for i in range(speed.shape[0]):
        beyond = max(beyond, 1.0 + speed[i] / (2.0 * BRAKING * acceleration[i] * dt))
    ways[0, 0] = ways[0, 1] = 0.0
    for i in range(chain.shape[0]):
        joint = chain[i]
        most = abs(joint["ratio"]) * speed[joint["driver"]] * dt
        slide = most if joint["slides"] else 0.0
        long = from_origin(poses, i, poses[i + 1, 0, 3], poses[i + 1, 1, 3], poses[i + 1, 2, 3])
        way += turn * (long + slide) + slide
        turn += most - slide
        ways[i + 1, 0], ways[i + 1, 1] = way, turn
    for k in range(points.shape[0]):
        link = links[k]
        far[k] = beyond * (
            ways[link, 0] + ways[link, 1] * from_origin(poses, link, points[k, 0], points[k, 1], points[k, 2])
        )
    return far


@kernel
def damper(room: float, rows: Array, which: int, acceleration: Array, gain: float, dt: float) -> float:
    """The velocity damper of a row: how near it may come in a tick, −κ dt room, no faster than it can brake; m.

    Args: room: distance left, m; which of rows (m, n); acceleration (n,), rad/s²; gain: κ, 1/s.
    """
    if room <= 0.0:
        return 0.0
    way = min(1.0, gain * dt) * room
    deceleration = 0.0
    for i in range(acceleration.shape[0]):
        if rows[which, i] != 0.0:
            deceleration += BRAKING * abs(rows[which, i]) * acceleration[i]
        if deceleration == np.inf:
            return -way
    if deceleration > 0.0:
        way = min(way, braking(room, deceleration, dt))
    return -way
