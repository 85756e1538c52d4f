"""Planar arms in the frames of the source: revolute joints with parallel axes, links of lengths l₁, l₂, …"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.families.elbow import Annulus
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Axes are parallel below this sine; links are longer than this, m.
PARALLEL, NO_LINK = 1e-9, 1e-9


@dataclass(frozen=True, eq=False)
class Planar:
    """A planar arm and the frames in which its closed form is written.

    T_world_base (4, 4), m: z along the first axis, x along the first link at q = 0. lengths (n,), m: of all links.
    θ = signs q + shifts, rad. T_end_tool (4, 4), m: the tool in the frame {E}, which is at (x, y), rotated by the sum
    of all θ. Its origin is on the third axis; with two joints, it is the tool point projected to the plane of the arm.
    """

    T_world_base: Array
    lengths: Array
    signs: Array
    shifts: Array
    T_end_tool: Array

    @property
    def links(self) -> Annulus:
        """The first two links, which carry the frame {E}."""
        return Annulus(float(self.lengths[0]), float(self.lengths[1]))

    def angles(self, q: Array) -> Array:
        """θ (n,), rad, of joint values q (n,), rad."""
        return np.asarray(self.signs * q + self.shifts)

    def joints(self, theta: Array) -> Array:
        """Joint values q (n,), rad, of θ (n,), rad."""
        return np.asarray(self.signs * (theta - self.shifts))

    def end(self, T_world_tool: Array) -> tuple[float, float, float]:
        """(x, y, φ), m and rad, of the frame {E}: T_base_end = T_base_world · T_world_tool · (T_end_tool)⁻¹.

        Source: Campos 1998, s.14 (with the names wrist and station), s.42.
        """
        T = np.linalg.inv(self.T_world_base) @ T_world_tool @ np.linalg.inv(self.T_end_tool)
        return float(T[0, 3]), float(T[1, 3]), float(np.arctan2(T[1, 0], T[0, 0]))

    def tool(self, x: float, y: float, phi: float) -> Array:
        """T_world_tool (4, 4), m, for {E} at (x, y), m, rotated by φ, rad. Source: Campos 1998, s.29."""
        return np.asarray(self.T_world_base @ _turned(x, y, phi) @ self.T_end_tool)


@lru_cache(maxsize=16)
def planar(robot: Robot, count: int) -> Planar | Text:
    """The robot as a planar arm with `count` revolute joints, two or three, or why it is not one."""
    if len(robot.joints) != count or any(joint.is_prismatic or joint.mimic for joint in robot.joints):
        return _JOINTS.format(count=count)
    if np.linalg.norm(np.cross(robot.directions[0], robot.directions), axis=1).max() > PARALLEL:
        return _AXES
    z = robot.directions[0]
    ways = _across(np.diff([*robot.points, robot.T_world_tool_0[:3, 3]], axis=0), z)
    lengths = np.linalg.norm(ways, axis=1)
    if lengths[:2].min() < NO_LINK:
        return _LINKS
    return _planar(robot, ways, lengths)


def _planar(robot: Robot, ways: Array, lengths: Array) -> Planar:
    z, x = robot.directions[0], ways[0] / lengths[0]
    base = np.eye(4)
    base[:3] = np.column_stack([x, np.cross(z, x), z, robot.points[0]])
    bend = float(np.arctan2(np.cross(x, ways[1]) @ z, x @ ways[1]))
    shifts = np.array([0.0, bend, -bend])[: len(ways)]
    end = base @ _turned(0, 0, shifts.sum())
    end[:3, 3] += ways[0] + ways[1]
    return Planar(
        T_world_base=frozen(base),
        lengths=frozen(lengths),
        signs=frozen(np.sign(robot.directions @ z)),
        shifts=frozen(shifts),
        T_end_tool=frozen(np.linalg.inv(end) @ robot.T_world_tool_0),
    )


def _across(ways: Array, z: Array) -> Array:
    return np.asarray(ways - np.outer(ways @ z, z))


def _turned(x: float, y: float, phi: float) -> Array:
    c, s = np.cos(phi), np.sin(phi)
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]])


_JOINTS = Text(
    en="This form needs {count} revolute joints, each moving independently.",
    pt_BR="Esta forma exige {count} juntas de revolução, cada uma com movimento independente.",
)
_AXES = Text(en="This form needs parallel axes.", pt_BR="Esta forma exige eixos paralelos entre si.")
_LINKS = Text(
    en="This form needs two links of nonzero length.",
    pt_BR="Esta forma exige dois elos de comprimento não nulo.",
)
