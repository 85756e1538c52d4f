"""Arms with five revolute joints on a turret: three parallel joints move a hand in a plane that the first one rotates.

The tool can take positions in space, but it can only point within that plane: M·Ẑ = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import cos, sin, sqrt

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.families.frames import Tool, pose_rows
from helicoide.ik.families.pointing import Pointing, turned_into_plane
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import Triple, dot

# Axes are parallel, or at right angles, below this sine or cosine; lines meet below this distance, m.
SQUARE, MEETING = 1e-9, 1e-9
# A tool nearer to the first axis than this fraction of the reach is over it: its position does not give the plane.
OVER = 1e-10


@dataclass(frozen=True, eq=False)
class Turret:
    """An arm on a turret at q = 0.

    T_world_base (4, 4), m: z along the first axis, y along the shoulder axis, x towards the tool. hand (3,): the
    direction in which the tool points, that of the last axis, in the frame of the tool; over: the distance from the
    first axis, m, below which the tool is over it.
    """

    T_world_base: Array
    hand: Array
    over: float

    def seen(self, T_world_tool: Array) -> Array:
        """The tool (4, 4), m, in the base frame."""
        return np.ascontiguousarray(np.linalg.inv(self.T_world_base) @ T_world_tool)

    def normal(self, T_base_tool: Array, theta1: float) -> tuple[Array, bool]:
        """M = (−p_y, p_x, 0)/√(p_x² + p_y²), (3,), and whether the first joint is free.

        Where the tool is over the first axis, the plane is the one in which it points. If it also points along the
        axis, θ₁, rad, is kept. Source: Campos 1998, s.55; Craig, ch. 4.
        """
        M, is_free = normal_of(pose_rows(T_base_tool), tuple(self.hand.tolist()), self.over, theta1)
        return np.array(M), is_free

    def pointed(self, T_world_tool: Array, theta1: float) -> tuple[Pointing, Array]:
        """The rotation, base frame, of a pose (4, 4), m, about its own point into the subspace, and the new pose."""
        T = self.seen(T_world_tool)
        turn = turned_into_plane(T, self.hand, self.normal(T, theta1)[0])
        goal = T_world_tool.copy()
        goal[:3, :3] = self.T_world_base[:3, :3] @ turn.R
        return turn, goal


@kernel_into
def normal_of(tool: Tool, hand: Triple, over: float, theta1: float) -> tuple[Triple, bool]:
    """`Turret.normal` for a tool in the base frame, m."""
    (x, y, _), upright = tool, False
    ahead, aside = x[3], y[3]
    if sqrt(ahead * ahead + aside * aside) < over:
        ahead, aside = dot(x, hand), dot(y, hand)
        upright = sqrt(ahead * ahead + aside * aside) < SQUARE
        if upright:
            ahead, aside = cos(theta1), sin(theta1)
    size = sqrt(ahead * ahead + aside * aside)
    return (-aside / size, ahead / size, 0.0), upright


@lru_cache(maxsize=64)
def turret(robot: Robot) -> Turret | None:
    """The robot as a `Turret`, or None: the last axis passes through the tool point and is in the plane of the arm."""
    if len(robot.joints) != 5 or any(joint.is_prismatic or joint.mimic for joint in robot.joints):
        return None
    z, shoulder, hand = robot.directions[0], robot.directions[1], robot.directions[4]
    tool, way = robot.T_world_tool_0, robot.T_world_tool_0[:3, 3] - robot.points[0]
    parallel = np.linalg.norm(np.cross(shoulder, robot.directions[2:4]), axis=1).max() < SQUARE
    square = max(abs(shoulder @ z), abs(shoulder @ hand)) < SQUARE
    at_tip = np.linalg.norm(np.cross(tool[:3, 3] - robot.points[4], hand)) < MEETING
    if not (parallel and square and at_tip and abs(way @ shoulder) < MEETING):
        return None
    y = -shoulder if way @ np.cross(shoulder, z) < -MEETING else shoulder
    base = np.eye(4)
    base[:3] = np.column_stack([np.cross(y, z), y, z, robot.points[0]])
    return Turret(frozen(base), frozen(tool[:3, :3].T @ hand), OVER * robot.reach)
