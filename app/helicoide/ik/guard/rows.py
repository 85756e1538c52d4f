"""The rows that bound one tick: how far each joint may move, and how fast points of the arm may approach."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.ik.guard.packed import (
    ACCELERATION,
    FIRST,
    GAIN,
    LINK,
    LOWER,
    SETTING,
    SPEED,
    At,
)
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import ANGLE_RATIO, DRIVER, SLIDE_RATIO

Indices = NDArray[np.int64]
# J (r, n), v (r,), weights (r,), damping d (n,).
Task = tuple[Array, Array, Array, Array]
Vector = tuple[float, float, float]

DAMPER_GAIN = 10.0
# The share of all joints' braking that a point may count on: what is left over is for the other points.
BRAKING = 0.5
BY_POSITION, BY_SPEED, BY_ACCELERATION = 0, 1, 2
# Rows of `motion_box`: the bounds of Δq, the same upon position and speed alone, and the limit that gives each bound.
DOWN, UP, HARD_DOWN, HARD_UP, DOWN_BY, UP_BY, BOX = range(7)
# Of the points (p, 4) in a tick, behind where they are: the room beyond which nothing holds them.
FAR = 3


@kernel_into
def braking(room: float, deceleration: float, dt: float) -> float:
    """The farthest way of one tick after which a room is still enough to stop: v dt with v dt + v²/2a = room.

    v²/2a holds for every later tick, however short. Args: room, rad or m; a, per s²; dt, s.
    """
    v = deceleration * (np.sqrt(dt * dt + 2.0 * room / deceleration) - dt)
    return float(v * dt)


@kernel_into
def motion_box(arm: Array, at: At, q: Array, rates: Array, dt: float, box: Array) -> None:
    """Write how far each joint may move in a tick, and which of its limits says so.

    Position and speed come first, then v ≤ √(2 a room), from which a joint can stop before its limit; what is left is
    narrowed to |v − q̇| ≤ a dt. A joint beyond its limit may stay or come back, never go further.
    Args: q (n,), rad; rates (n,), of the tick before, rad/s; dt, s; box (6, n), with the rows named above.
    """
    for i in range(at.n):
        limit = at.limits + i
        reach, a = arm[limit, SPEED] * dt, arm[limit, ACCELERATION]
        for side in range(2):
            sign = 2 * side - 1
            room = max(0.0, sign * (arm[limit, LOWER + side] - q[i]))
            way, by = (room, BY_POSITION) if room < reach else (reach, BY_SPEED)
            box[HARD_DOWN + side, i] = sign * way
            if a < np.inf and braking(room, a, dt) < way:
                way, by = braking(room, a, dt), BY_ACCELERATION
            box[DOWN + side, i], box[DOWN_BY + side, i] = sign * way, by
        if a < np.inf:
            down, up = box[DOWN, i], box[UP, i]
            slowest = min(max((rates[i] - a * dt) * dt, down), up)
            fastest = min(max((rates[i] + a * dt) * dt, down), up)
            if slowest > down:
                box[DOWN, i], box[DOWN_BY, i] = slowest, BY_ACCELERATION
            if fastest < up:
                box[UP, i], box[UP_BY, i] = fastest, BY_ACCELERATION


@kernel_into
def at_row(points: Array, which: int) -> Vector:
    """The first three numbers of a row; numbers by themselves cost a kernel less than a piece of an array."""
    return points[which, 0], points[which, 1], points[which, 2]


@kernel_into
def point_displacement(arm: Array, i: int, poses: Array, axes: Array, x: float, y: float, z: float) -> Vector:
    """How fast joint i moves a point behind it, for its variable's q̇ = 1: a sᵢ × (p − pᵢ), or a sᵢ where it slides.

    Args: the point, m, world; poses (m + 1, 4, 4) and axes (m, 3) of `packed.stand`.
    """
    joint = FIRST + i
    turn, slide = arm[joint, ANGLE_RATIO], arm[joint, SLIDE_RATIO]
    sx, sy, sz = axes[i, 0], axes[i, 1], axes[i, 2]
    rx, ry, rz = x - poses[i + 1, 0, 3], y - poses[i + 1, 1, 3], z - poses[i + 1, 2, 3]
    return (
        turn * (sy * rz - sz * ry) + slide * sx,
        turn * (sz * rx - sx * rz) + slide * sy,
        turn * (sx * ry - sy * rx) + slide * sz,
    )


@kernel_into
def add_point(
    rows: Array, which: int, normal: Vector, point: Vector, first: int, link: int, arm: Array, poses: Array, axes: Array
) -> None:
    """Add nᵀ J_p, by which a point moves along n, to one of rows (r, n): what the joints `first` to `link` do to it.

    Args: normal, of any length, and point, m, world; first: 0 for all joints; poses and axes of `packed.stand`.
    """
    for i in range(first, link):
        x, y, z = point_displacement(arm, i, poses, axes, point[0], point[1], point[2])
        rows[which, int(arm[FIRST + i, DRIVER])] += normal[0] * x + normal[1] * y + normal[2] * z


@kernel_into
def from_origin(poses: Array, link: int, x: float, y: float, z: float) -> float:
    """How far a point is from the origin of a link, m; poses (m + 1, 4, 4)."""
    x, y, z = x - poses[link, 0, 3], y - poses[link, 1, 3], z - poses[link, 2, 3]
    return float(np.sqrt(x * x + y * y + z * z))


@kernel_into
def unmoved_rows(arm: Array, at: At, poses: Array, points: Array, dt: float, ways: Array) -> None:
    """Write the room beyond which no bound on a point can hold a tick, m, behind its place in points (p, 4).

    However the joints turn, a point moves by no more than s = Σ |Δqᵢ| times its distance from axis i, which is at most
    that along the links. A bound −κ dt l holds nothing from l = s / κ dt on. What a brake allows, v dt with
    v dt + v²/2D = l, holds nothing from l = s + s²/2D dt² on, where s ≤ Σ |rowᵢ| ωᵢ dt and D = ½ Σ |rowᵢ| aᵢ make it
    at most s (1 + max ω / a dt). Args: ways (m + 1, 4): room for what is known of each link.
    """
    turned, way = 0.0, 0.0
    beyond = 1.0 / min(1.0, arm[SETTING, GAIN] * dt)
    for i in range(at.n):
        limit = at.limits + i
        beyond = max(beyond, 1.0 + arm[limit, SPEED] / (2.0 * BRAKING * arm[limit, ACCELERATION] * dt))
    ways[0, 0] = ways[0, 1] = 0.0
    for i in range(at.m):
        joint = FIRST + i
        most = arm[at.limits + int(arm[joint, DRIVER]), SPEED] * dt
        slide = abs(arm[joint, SLIDE_RATIO]) * most
        long = from_origin(poses, i, poses[i + 1, 0, 3], poses[i + 1, 1, 3], poses[i + 1, 2, 3])
        way += turned * (long + slide) + slide
        turned += abs(arm[joint, ANGLE_RATIO]) * most
        ways[i + 1, 0], ways[i + 1, 1] = way, turned
    for k in range(points.shape[0]):
        link = int(arm[at.points + k, LINK])
        far = from_origin(poses, link, points[k, 0], points[k, 1], points[k, 2])
        points[k, FAR] = beyond * (ways[link, 0] + ways[link, 1] * far)


@kernel_into
def damper(room: float, rows: Array, which: int, arm: Array, at: At, dt: float) -> float:
    """The velocity damper of one of rows (r, n): how near it may come in a tick, −κ dt room, if it can brake; m.

    Args: room: distance left, m.
    """
    if room <= 0.0:
        return 0.0
    way = min(1.0, arm[SETTING, GAIN] * dt) * room
    deceleration = 0.0
    for i in range(at.n):
        if rows[which, i] != 0.0:
            deceleration += BRAKING * abs(rows[which, i]) * arm[at.limits + i, ACCELERATION]
        if deceleration == np.inf:
            return float(-way)
    if deceleration > 0.0:
        way = min(way, braking(room, deceleration, dt))
    return float(-way)
