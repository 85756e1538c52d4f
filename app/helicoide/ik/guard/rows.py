"""The bounds of one tick: how far each joint may move, and how fast points may approach planes and bodies."""

from __future__ import annotations

from typing import NamedTuple

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
    PlacedArm,
)
from helicoide.kernels import kernel_into
from helicoide.kinematics.tool_kernels import ANGLE_RATIO, DRIVER, SLIDE_RATIO

Indices = NDArray[np.int64]
# J (r, n), v (r,), weights (r,), damping d (n,).
Task = tuple[Array, Array, Array, Array]
Vector = tuple[float, float, float]

DAMPER_GAIN = 10.0
# The fraction of the joints' deceleration that the damper of one point uses; the rest is for other points.
BRAKING = 0.5
BY_POSITION, BY_SPEED, BY_ACCELERATION = 0, 1, 2
# Rows of `MotionBox.bounds`: the bounds of Δq, those by position and speed alone, and the kind of limit that sets each.
DOWN, UP, HARD_DOWN, HARD_UP, DOWN_BY, UP_BY, BOX = range(7)
# Column of the points (p, 4), after their position: the clearance beyond which no bound limits the tick, m.
FAR = 3


class MotionBox(NamedTuple):
    """How far each joint may move in one tick.

    bounds (6, n), rad or m, with the rows named above; rates (n,): q̇ of the tick before, per s; dt: of the tick, s.
    """

    bounds: Array
    rates: Array
    dt: float


@kernel_into
def braking(distance: float, deceleration: float, dt: float) -> float:
    """The largest displacement of one tick after which the rest of `room` suffices to stop: v dt + v²/2a = room.

    v²/2a suffices whatever the duration of later ticks. Args: room, rad or m; deceleration: a, per s²; dt, s.
    """
    v = deceleration * (np.sqrt(dt * dt + 2.0 * distance / deceleration) - dt)
    return float(v * dt)


@kernel_into
def bound_motion(placed: PlacedArm, motion: MotionBox) -> None:
    """Write how far each joint may move in a tick from the posture, and which limit sets each bound.

    Position and speed come first, then `braking`, so that the joint can stop before its limit. The result is narrowed
    to |v − q̇| ≤ a dt. A joint beyond its limit may stay or come back, but not go further.
    """
    (arm, at, q, _, _), (box, rates, dt) = placed, motion
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
    """The first three numbers of a row; in a kernel scalars cost less than an array slice."""
    return points[which, 0], points[which, 1], points[which, 2]


@kernel_into
def point_displacement(arm: Array, i: int, poses: Array, axes: Array, point: Vector) -> Vector:
    """Velocity of a point that joint i moves, for q̇ = 1 of its variable: a sᵢ × (p − pᵢ), or a sᵢ if prismatic.

    a is the ratio of the joint to its variable.
    Args: poses and axes of `PlacedArm`, which as a whole would cost more to pass than this; point: p, m, world.
    """
    joint, (x, y, z) = FIRST + i, point
    turn, slide = arm[joint, ANGLE_RATIO], arm[joint, SLIDE_RATIO]
    sx, sy, sz = axes[i, 0], axes[i, 1], axes[i, 2]
    rx, ry, rz = x - poses[i + 1, 0, 3], y - poses[i + 1, 1, 3], z - poses[i + 1, 2, 3]
    return (
        turn * (sy * rz - sz * ry) + slide * sx,
        turn * (sz * rx - sx * rz) + slide * sy,
        turn * (sx * ry - sy * rx) + slide * sz,
    )


@kernel_into
def add_point(row: Array, normal: Vector, point: Vector, first: int, link: int, placed: PlacedArm) -> None:
    """Add nᵀ J_p of a point of a link to a row (n,), for the joints from number `first` on, counted from 0.

    Args: normal: n, of any length, and point, m, world.
    """
    arm, _, _, poses, axes = placed
    for i in range(first, link):
        x, y, z = point_displacement(arm, i, poses, axes, point)
        row[int(arm[FIRST + i, DRIVER])] += normal[0] * x + normal[1] * y + normal[2] * z


@kernel_into
def from_origin(poses: Array, link: int, x: float, y: float, z: float) -> float:
    """Distance of a point from the origin of a link, m; poses (m + 1, 4, 4)."""
    x, y, z = x - poses[link, 0, 3], y - poses[link, 1, 3], z - poses[link, 2, 3]
    return float(np.sqrt(x * x + y * y + z * z))


@kernel_into
def unmoved_rows(placed: PlacedArm, points: Array, dt: float, ways: Array) -> None:
    """Write column `FAR` of points (p, 4): the clearance beyond which no bound on a point limits the tick, m.

    In one tick a point moves by at most s = Σ |Δqᵢ| times its distance from axis i, itself at most the distance along
    the links. A bound −κ dt l is inactive from l = s / κ dt on. The braking bound, v dt with v dt + v²/2D = l, is
    inactive from l = s + s²/2D dt² on. As s ≤ Σ |rowᵢ| ωᵢ dt and D = ½ Σ |rowᵢ| aᵢ, this is at most
    s (1 + max ω / a dt). Args: ways (m + 1, 4): temporary values of each link.
    """
    arm, at, _, poses, _ = placed
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
def damper(distance: float, rows: Array, which: int, arm: Array, at: At, dt: float) -> float:
    """The velocity damper of one of rows (r, n), its lower bound in a tick: −κ dt room, less where it must brake; m.

    Args: room: the clearance, m; without any the bound is 0.
    """
    if distance <= 0.0:
        return 0.0
    way = min(1.0, arm[SETTING, GAIN] * dt) * distance
    deceleration = 0.0
    for i in range(at.n):
        if rows[which, i] != 0.0:
            deceleration += BRAKING * abs(rows[which, i]) * arm[at.limits + i, ACCELERATION]
        if deceleration == np.inf:
            return float(-way)
    if deceleration > 0.0:
        way = min(way, braking(distance, deceleration, dt))
    return float(-way)
