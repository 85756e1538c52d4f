"""An initial posture for an arm whose file names none."""

from __future__ import annotations

from itertools import chain

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.generic_rank import generic_rank
from helicoide.kinematics.manipulability import twist_manipulability
from helicoide.kinematics.robot import Robot

BENDS = (0.0, 0.35, 0.7, 1.05)
WELL_CONDITIONED = 20.0
_PATTERN = (0.0, 1.0, -1.0, 0.5, 1.0, 0.0)


def find_ready_posture(robot: Robot) -> Array:
    """A well-conditioned posture near the middle of the range, with the tool high; (n,), rad or m.

    The middle of a joint is zero if at least a tenth of its range lies on each side. From there the joints are bent
    further and further, elbow up, until the Jacobian is well conditioned: stretched arms are singular. If no posture is
    well conditioned, the one with the smallest condition number is returned.
    """
    lower, upper = robot.lower, robot.upper
    margin = 0.1 * (upper - lower)
    middle = np.where((lower + margin <= 0) & (upper - margin >= 0), 0.0, (lower + upper) / 2)
    pattern = np.resize(_PATTERN, len(middle)) * [not joint.is_prismatic for joint in robot.variables]
    tried = [
        [np.clip(middle + sign * bend * pattern, lower + margin, upper - margin) for sign in (1, -1)] for bend in BENDS
    ]
    for pair in tried:
        if good := [q for q in pair if _condition(robot, q) < WELL_CONDITIONED]:
            return frozen(max(good, key=lambda q: float(tool_by_screws(robot, q)[2, 3])))
    return frozen(min(chain.from_iterable(tried), key=lambda q: _condition(robot, q)))


def _condition(robot: Robot, q: Array) -> float:
    """Condition number of the tool's Jacobian within its usual rank, a radian counted as one reach."""
    sigma = twist_manipulability(robot, q, robot.reach).sigma
    return float(sigma[0] / max(sigma[generic_rank(robot) - 1], 1e-12))
