"""One posture as an answer gives it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.ik.postures.answer import Found, Words, answer_as_found
from helicoide.ik.postures.branch import Branch
from helicoide.kinematics.robot import Robot
from helicoide.text import Text


def branch_of(robot: Robot, name: Text, q: ArrayLike, T: Array) -> Branch:
    """The branch of joint values (n,), rad or m, that were found for a tool pose (4, 4), m."""
    (branch,) = answer_as_found(robot, Found(np.array([q], dtype=np.float64), T, Words([name], name)), T).branches
    return branch
