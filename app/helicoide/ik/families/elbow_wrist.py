"""Six turning joints as in the PUMA: a shoulder that the waist crosses, an elbow alongside it, a spherical wrist."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.solvability import meeting_point
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Axes are parallel, or square, below this sine; links have no length below this distance, m.
SQUARE, NO_LINK = 1e-9, 1e-6


@dataclass(frozen=True, eq=False)
class ElbowWrist:
    """Such an arm at q = 0, base frame, m.

    shoulder (3,): where axes 1 and 2 cross; wrist (3,): where axes 4, 5 and 6 do. T_world_shoulder (4, 4): there, z
    along the first axis, y along the second.
    """

    shoulder: Array
    wrist: Array
    T_world_shoulder: Array


@lru_cache(maxsize=16)
def elbow_wrist(robot: Robot) -> ElbowWrist | None:
    """The robot as such an arm, or None: axes 1 ⟂ 2 ∥ 3, and 4 ⟂ 5 ⟂ 6."""
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
    en="This form is for six turning joints as in the PUMA: a shoulder square to the waist that it crosses, an elbow "
    "alongside it, and three axes at right angles that meet in the wrist.",
    pt_BR="Esta forma vale para seis juntas de revolução como no PUMA: ombro perpendicular à cintura, que ele cruza, "
    "cotovelo paralelo a ele, e três eixos em ângulo reto que se cruzam no punho.",
)
