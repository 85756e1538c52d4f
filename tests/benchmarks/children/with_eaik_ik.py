"""EAIK's closed form of a 6R arm: every posture of a pose, from the axes and the points on them.

What it gives as the nearest by least squares, where there is no posture, is left out.
"""

from __future__ import annotations

import numpy as np
from eaik.pybindings.EAIK import Robot
from turns import Numbers, Turn, take_turns, timed


def prepared(directions: Numbers, ways: Numbers, tool_turn: Numbers, poses: Numbers) -> Turn:
    arm = Robot(np.array(directions).T, np.array(ways).T, np.array(tool_turn), [], True)
    targets = np.array(poses)

    def turn(first: int, beyond: int) -> tuple[list[float], Numbers]:
        seconds, found = timed(lambda k: arm.calculate_IK(targets[k]), range(first, beyond))
        return seconds, [
            [q for q, nearest in zip(answer.Q, answer.is_LS, strict=True) if not nearest] for answer in found
        ]

    return turn


take_turns(prepared)
