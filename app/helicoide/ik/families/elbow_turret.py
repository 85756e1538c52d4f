"""Arms on a turret as in the Motoman L-3: the shoulder axis crosses the waist axis, the roll axis the bend axis."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import atan2, hypot

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.families.elbow import Annulus
from helicoide.ik.families.turret import MEETING, Turret, turret
from helicoide.kinematics.robot import Robot


@dataclass(frozen=True, eq=False)
class ElbowTurret:
    """An arm like the Motoman L-3 in the frames of the source: θ = signs q + shifts, rad.

    T_wrist_tool: the tool in the frame {W}, whose origin is where the bend and roll axes cross.
    """

    turret: Turret
    T_world_base: Array
    links: Annulus
    signs: Array
    shifts: Array
    T_wrist_tool: Array


@lru_cache(maxsize=16)
def elbow_turret(robot: Robot) -> ElbowTurret | None:
    """The robot as an `ElbowTurret`, or None."""
    if (base := turret(robot)) is None:
        return None
    T = base.T_world_base.copy()
    x, y, hand = T[:3, 0], T[:3, 1], robot.directions[4]
    T[:3, 3] += ((robot.points[1] - T[:3, 3]) @ T[:3, 2]) * T[:3, 2]
    wrist = robot.points[3] - ((robot.points[3] - T[:3, 3]) @ y) * y
    upper, fore = _seen(T, robot.points[2] - T[:3, 3]), _seen(T, wrist - robot.points[2])
    links = Annulus(hypot(*upper), hypot(*fore))
    crosses_waist = abs((robot.points[1] - T[:3, 3]) @ x) < MEETING
    crosses_bend = np.linalg.norm(np.cross(wrist - robot.points[4], hand)) < MEETING
    if not (crosses_waist and crosses_bend and min(links.l1, links.l2) > MEETING):
        return None
    shoulder, bend = atan2(-upper[1], upper[0]), atan2(-fore[1], fore[0])
    pointing = atan2(*_seen(T, hand))
    W = np.eye(4)
    W[:3] = np.column_stack([np.cross(y, hand), y, hand, wrist])
    return ElbowTurret(
        turret=base,
        T_world_base=frozen(T),
        links=links,
        signs=frozen([1, *np.sign(robot.directions[1:4] @ y), 1]),
        shifts=frozen([0, shoulder, bend - shoulder, pointing - bend, 0]),
        T_wrist_tool=frozen(np.linalg.inv(W) @ robot.T_world_tool_0),
    )


def _seen(T_world_base: Array, way: Array) -> tuple[float, float]:
    """The components of a vector (3,) along x (front) and z (up) of the base."""
    return float(way @ T_world_base[:3, 0]), float(way @ T_world_base[:3, 2])
