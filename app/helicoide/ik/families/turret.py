"""Arms of five turning joints on a turret: three parallel joints move a hand in a plane that the first one turns.

Their tool can take positions in space, but it can point only within that plane: M·Ẑ = 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import cos, sin, sqrt

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.families.frames import Tool, rows_of
from helicoide.ik.families.pointing import Pointing, turned_into_plane
from helicoide.kernels import kernel_into
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.tool_kernels import Triple, dot

# Axes count as parallel, or as square, below this sine; lines as meeting below this distance, m.
SQUARE, MEETING = 1e-9, 1e-9
# A tool nearer to the first axis than this part of the reach stands over it: no direction leads there.
OVER = 1e-10


@dataclass(frozen=True, eq=False)
class Turret:
    """Such an arm at q = 0. T_world_base (4, 4), m: z up the first axis, y along the shoulder's, x towards the tool.

    hand (3,): the direction in which the tool points, that of the last axis, in the frame of the tool; over: the
    distance from the first axis, m, below which the tool counts as standing over it.
    """

    T_world_base: Array
    hand: Array
    over: float

    def seen(self, T_world_tool: Array) -> Array:
        """The tool (4, 4), m, from the base."""
        return np.ascontiguousarray(np.linalg.inv(self.T_world_base) @ T_world_tool)

    def normal(self, T_base_tool: Array, theta1: float) -> tuple[Array, bool]:
        """M = (−p_y, p_x, 0)/√(p_x² + p_y²), (3,), and whether the first joint is free.

        Where the tool stands over the first axis, the plane is the one in which it points; if it points along the axis
        too, the one of θ₁, rad, as it is. Source: Campos 1998, s.55; Craig, ch. 4.
        """
        M, is_free = normal_of(rows_of(T_base_tool), tuple(self.hand.tolist()), self.over, theta1)
        return np.array(M), is_free

    def pointed(self, T_world_tool: Array, theta1: float) -> tuple[Pointing, Array]:
        """How a pose (4, 4), m, is turned about its own point into the subspace, seen from the base, and the pose."""
        T = self.seen(T_world_tool)
        turn = turned_into_plane(T, self.hand, self.normal(T, theta1)[0])
        goal = T_world_tool.copy()
        goal[:3, :3] = self.T_world_base[:3, :3] @ turn.R
        return turn, goal


@kernel_into
def normal_of(tool: Tool, hand: Triple, over: float, theta1: float) -> tuple[Triple, bool]:
    """The normal of `Turret.normal` for a tool seen from the base, m."""
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
    """The robot as such an arm, or None: its last axis carries the tool point and lies in the plane of the arm."""
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
