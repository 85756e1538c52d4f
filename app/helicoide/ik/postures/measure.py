"""How far a posture is from a goal: after the fact, from its joint values alone, in a way that made no posture."""

from __future__ import annotations

from functools import lru_cache
from math import atan2, hypot, sqrt

import numpy as np

from helicoide.geometry import rotation
from helicoide.kernels import kernel
from helicoide.kinematics.chain import Array, Chain, frozen
from helicoide.kinematics.robot import Robot


def left(robot: Robot, q: Array, T_world_goal: Array, with_orientation: bool = True) -> tuple[float, float]:
    """What the tool at q (n,), rad or m, leaves of a goal (4, 4), m: a distance, m, and the angle of a turn, rad.

    The angle is 0 where the orientation does not count. Searches follow poses as matrices and closed forms solve for
    angles; here quaternions turn the links, so that no fault of theirs is repeated.
    """
    place, turn = _goal(T_world_goal)
    missed, turned = _left(robot.chain, *_tool(robot), np.ascontiguousarray(q), place, turn)
    return missed, turned if with_orientation else 0.0


def _goal(T: Array) -> tuple[Array, Array]:
    return np.ascontiguousarray(T[:3, 3]), rotation.from_matrix(T[:3, :3])


@lru_cache(maxsize=64)
def _tool(robot: Robot) -> tuple[Array, Array]:
    """The tool in the frame of the last link: its place (3,), m, and its quaternion (4,)."""
    place, turn = _goal(robot.T_link_tool)
    return frozen(place), frozen(turn)


@kernel
def _left(chain: Chain, place: Array, turn: Array, q: Array, goal: Array, goal_turn: Array) -> tuple[float, float]:
    """‖p − p_g‖ and 2 atan2(‖v‖, |w|) of h̄_g h, with h ← h (cos ½x, sin ½x s) and p ← p + h o h̄ along the chain.

    Args: chain (m,) of `chain.CHAIN`; place (3,), m, and turn (4,): the tool on the last link; q (n,), rad or m; goal
    (3,), m, and goal_turn (4,). Joint i stands at x = ratio · q[driver] + shift; where it slides, o takes x s up.
    """
    w, x, y, z = 1.0, 0.0, 0.0, 0.0
    px, py, pz = 0.0, 0.0, 0.0
    for i in range(chain.shape[0] + 1):
        if i < chain.shape[0]:
            joint = chain[i]
            value = joint["ratio"] * q[joint["driver"]] + joint["shift"]
            sx, sy, sz = joint["direction"][0], joint["direction"][1], joint["direction"][2]
            ox, oy, oz = joint["offset"][0], joint["offset"][1], joint["offset"][2]
            if joint["slides"]:
                ox, oy, oz, value = ox + value * sx, oy + value * sy, oz + value * sz, 0.0
            c, s = np.cos(0.5 * value), np.sin(0.5 * value)
            b, bx, by, bz = c, s * sx, s * sy, s * sz
        else:
            ox, oy, oz = place[0], place[1], place[2]
            b, bx, by, bz = turn[0], turn[1], turn[2], turn[3]
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
    g, gx, gy, gz = goal_turn[0], goal_turn[1], goal_turn[2], goal_turn[3]
    cosine = g * w + gx * x + gy * y + gz * z
    vx = g * x - gx * w - gy * z + gz * y
    vy = g * y + gx * z - gy * w - gz * x
    vz = g * z - gx * y + gy * x - gz * w
    missed = sqrt((px - goal[0]) ** 2 + (py - goal[1]) ** 2 + (pz - goal[2]) ** 2)
    return missed, 2 * atan2(hypot(hypot(vx, vy), vz), abs(cosine))
