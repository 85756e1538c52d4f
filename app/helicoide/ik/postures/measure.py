"""The error of a posture against a goal, computed from its joint values independently of all solvers."""

from __future__ import annotations

from functools import lru_cache
from math import atan2, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.trigonometry import cosine_and_sine

# A position (three) and a rotation as a quaternion (four).
Stand = tuple[float, float, float, float, float, float, float]

# Columns of a joint: its axis s (three), its offset (three), the number of its variable, ratio and shift, and whether
# it is prismatic. The last row is the tool on the last link: its position and its quaternion.
AXIS, WAY, DRIVER, RATIO, SHIFT, SLIDES = 0, 3, 6, 7, 8, 9
COLUMNS = 10


def left(robot: Robot, q: Array, T_world_goal: Array, with_orientation: bool = True) -> tuple[float, float]:
    """The error of the tool at q (n,), rad or m, against a goal (4, 4), m: a distance, m, and an angle, rad.

    The angle is 0 where the orientation does not count. Searches use matrices and closed forms use angles; here the
    links are rotated by quaternions, so that an error of theirs is not repeated.
    """
    missed, turned = left_of(measured(robot), np.ascontiguousarray(q), np.ascontiguousarray(T_world_goal))
    return missed, turned if with_orientation else 0.0


@lru_cache(maxsize=64)
def measured(robot: Robot) -> Array:
    """The joints and the tool of a robot packed for these kernels, (m + 1, 10), at q = 0, rad and m."""
    chain, arm = robot.chain, np.zeros((len(robot.joints) + 1, COLUMNS))
    joints = arm[:-1]
    joints[:, AXIS:WAY], joints[:, WAY:DRIVER], joints[:, DRIVER] = chain["direction"], chain["offset"], chain["driver"]
    joints[:, RATIO], joints[:, SHIFT], joints[:, SLIDES] = chain["ratio"], chain["shift"], chain["slides"]
    arm[-1, :7] = stand_of(robot.T_link_tool)
    return arm


@kernel_into
def stand_of(T: Array) -> Stand:
    """The position of a pose (4, 4), m, and its quaternion, from the largest of w, x, y, z. Source: Shepperd 1978."""
    xx, yy, zz = T[0, 0], T[1, 1], T[2, 2]
    x, y, z = T[2, 1] - T[1, 2], T[0, 2] - T[2, 0], T[1, 0] - T[0, 1]
    if xx + yy + zz >= max(xx, yy, zz):
        w = 1.0 + xx + yy + zz
    elif xx >= yy and xx >= zz:
        w, x, y, z = x, 1.0 + xx - yy - zz, T[1, 0] + T[0, 1], T[0, 2] + T[2, 0]
    elif yy >= zz:
        w, x, y, z = y, T[1, 0] + T[0, 1], 1.0 - xx + yy - zz, T[2, 1] + T[1, 2]
    else:
        w, x, y, z = z, T[0, 2] + T[2, 0], T[2, 1] + T[1, 2], 1.0 - xx - yy + zz
    size = sqrt(w * w + x * x + y * y + z * z)
    return T[0, 3], T[1, 3], T[2, 3], w / size, x / size, y / size, z / size


@kernel_into
def left_of(arm: Array, q: Array, T_world_goal: Array) -> tuple[float, float]:
    """`remains` for a goal (4, 4), m."""
    return remains(arm, q, stand_of(T_world_goal))


@kernel_into
def remains(arm: Array, q: Array, goal: Stand) -> tuple[float, float]:
    """‖p − p_g‖ and 2 atan2(‖v‖, |w|) of h̄_g h, with h ← h (cos ½x, sin ½x s) and p ← p + h o h̄ along the chain.

    Args: arm of `measured`; q (n,), rad or m; goal of `stand_of`. Joint i has the value x = ratio · q[driver] + shift
    and the offset o; if it is prismatic, x s is added to o instead of the rotation.
    """
    w, x, y, z = 1.0, 0.0, 0.0, 0.0
    px, py, pz = 0.0, 0.0, 0.0
    last = arm.shape[0] - 1
    for i in range(last + 1):
        if i < last:
            value = arm[i, RATIO] * q[int(arm[i, DRIVER])] + arm[i, SHIFT]
            sx, sy, sz = arm[i, 0], arm[i, 1], arm[i, 2]
            ox, oy, oz = arm[i, 3], arm[i, 4], arm[i, 5]
            if arm[i, SLIDES] > 0.0:
                ox, oy, oz, value = ox + value * sx, oy + value * sy, oz + value * sz, 0.0
            c, s = cosine_and_sine(0.5 * value)
            b, bx, by, bz = c, s * sx, s * sy, s * sz
        else:
            ox, oy, oz = arm[i, 0], arm[i, 1], arm[i, 2]
            b, bx, by, bz = arm[i, 3], arm[i, 4], arm[i, 5], arm[i, 6]
        tx, ty, tz = 2 * (y * oz - z * oy), 2 * (z * ox - x * oz), 2 * (x * oy - y * ox)
        px += ox + w * tx + y * tz - z * ty
        py += oy + w * ty + z * tx - x * tz
        pz += oz + w * tz + x * ty - y * tx
        w, x, y, z = (
            w * b - x * bx - y * by - z * bz,
            w * bx + x * b + y * bz - z * by,
            w * by - x * bz + y * b + z * bx,
            w * bz + x * by - y * bx + z * b,
        )
    g, gx, gy, gz = goal[3], goal[4], goal[5], goal[6]
    cosine = g * w + gx * x + gy * y + gz * z
    vx = g * x - gx * w - gy * z + gz * y
    vy = g * y + gx * z - gy * w - gz * x
    vz = g * z - gx * y + gy * x - gz * w
    missed = sqrt((px - goal[0]) ** 2 + (py - goal[1]) ** 2 + (pz - goal[2]) ** 2)
    return missed, 2 * atan2(sqrt(vx * vx + vy * vy + vz * vz), abs(cosine))
