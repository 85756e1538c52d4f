"""Polar arms in the frames of the source: a revolute joint and a prismatic joint at a right angle to its axis."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot import Robot

SQUARE, MEETING = 1e-9, 1e-9


@dataclass(frozen=True, eq=False)
class PolarArm:
    """A polar arm: ρ = q₂ + stretch, m.

    T_world_base (4, 4), m: z along the first axis, y along the second at q₁ = 0. T_wrist_tool (4, 4), m: the tool in
    the frame of the matrix of the source, which has the same origin.
    """

    T_world_base: Array
    stretch: float
    T_wrist_tool: Array

    def tool(self, theta1: float, rho: float) -> Array:
        """T_world_tool (4, 4), m, at θ₁, rad, and ρ, m: x = −ρs₁, y = ρc₁, Ẑ along (x, y, 0), Ŷ down, X̂ = Ŷ × Ẑ.

        Source: Campos 1998, s.31–34.
        """
        return np.asarray(self.T_world_base @ _wrist(theta1, rho) @ self.T_wrist_tool)

    def place(self, T_world_tool: Array) -> tuple[float, float]:
        """(x, y), m, of the tool in the base frame."""
        x, y = (np.linalg.inv(self.T_world_base) @ T_world_tool)[:2, 3]
        return float(x), float(y)


@lru_cache(maxsize=16)
def polar_arm(robot: Robot) -> PolarArm | None:
    """The robot as a `PolarArm`, or None: a revolute and a prismatic axis at a right angle, the tool in their plane."""
    if [joint.is_prismatic for joint in robot.joints] != [False, True] or any(joint.mimic for joint in robot.joints):
        return None
    z, y = robot.directions
    way = robot.T_world_tool_0[:3, 3] - robot.points[0]
    x = np.cross(y, z)
    if abs(y @ z) > SQUARE or abs(way @ x) > MEETING:
        return None
    base = np.eye(4)
    base[:3] = np.column_stack([x, y, z, robot.points[0] + (way @ z) * z])
    stretch = float(way @ y)
    return PolarArm(frozen(base), stretch, frozen(np.linalg.inv(base @ _wrist(0.0, stretch)) @ robot.T_world_tool_0))


def _wrist(theta1: float, rho: float) -> Array:
    c, s = np.cos(theta1), np.sin(theta1)
    return np.array([[c, 0, -s, -rho * s], [s, 0, c, rho * c], [0, -1, 0, 0], [0, 0, 0, 1]])
