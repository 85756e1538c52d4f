"""Six revolute joints as in the PUMA: crossing waist and shoulder axes, a parallel elbow axis, a spherical wrist."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.solvability import meeting_point
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Axes are parallel, or at right angles, below this sine or cosine; links are longer than this, m.
SQUARE, NO_LINK = 1e-9, 1e-6


@dataclass(frozen=True, eq=False)
class ElbowWrist:
    """An arm like the PUMA at q = 0, base frame, m.

    shoulder (3,): where axes 1 and 2 cross; wrist (3,): where axes 4, 5 and 6 cross. T_world_shoulder (4, 4): origin at
    the shoulder, z along the first axis, y along the second.
    """

    shoulder: Array
    wrist: Array
    T_world_shoulder: Array


@lru_cache(maxsize=16)
def elbow_wrist(robot: Robot) -> ElbowWrist | None:
    """The robot as an `ElbowWrist`, or None: axes 1 ⟂ 2 ∥ 3, and 4 ⟂ 5 ⟂ 6."""
    if len(robot.joints) != 6 or any(joint.is_prismatic or joint.mimic for joint in robot.joints):
        return None
    s, points = robot.directions, robot.points
    square = max(abs(s[0] @ s[1]), abs(s[3] @ s[4]), abs(s[4] @ s[5])) < SQUARE
    if not square or np.linalg.norm(np.cross(s[1], s[2])) > SQUARE:
        return None
    shoulder, wrist = meeting_point(robot, (0, 1)), meeting_point(robot, (3, 4, 5))
    if shoulder is None or wrist is None:
        return None
    upper, fore = (np.linalg.norm(np.cross(s[1], way)) for way in (points[2] - shoulder, wrist - points[2]))
    if min(upper, fore) < NO_LINK:
        return None
    T = np.eye(4)
    T[:3] = np.column_stack([np.cross(s[1], s[0]), s[1], s[0], shoulder])
    return ElbowWrist(shoulder, wrist, frozen(T))


ELSE = Text(
    en="This form needs six revolute joints as in the PUMA: a shoulder axis that crosses the waist axis at a right "
    "angle, an elbow axis parallel to it, and a spherical wrist with axes at right angles.",
    pt_BR="Esta forma exige seis juntas de revolução como no PUMA: eixo do ombro que cruza o da cintura em ângulo "
    "reto, eixo do cotovelo paralelo a ele, e punho esférico com eixos em ângulo reto.",
)
