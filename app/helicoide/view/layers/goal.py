"""The accepted goal: the arm's outline where it will stop, coloured by whether it reaches the target."""

from __future__ import annotations

import numpy as np

from helicoide.command import FollowPath, HoldPosition
from helicoide.readout import SHORT
from helicoide.state import State
from helicoide.view.colours import GREEN, VERMILION
from helicoide.view.layers import Stage
from helicoide.view.outline import Outline
from helicoide.view.window_view import View

NAME = "goal"
SHARED = True

MET, MISSED = GREEN, VERMILION
AWAY = 0.02


def build(stage: Stage) -> GoalLayer:
    """The outline of the arm, hidden until there is a goal."""
    return GoalLayer(Outline(stage, NAME, MET))


class GoalLayer:
    """The outline at the goal."""

    def __init__(self, outline: Outline) -> None:
        self.outline = outline

    def update(self, old: View | None, new: View) -> None:
        """Follow the goal."""
        state = new.state
        if old is not None and old.state.request.goal is state.request.goal and old.state.arm.q is state.arm.q:
            return
        goal = state.request.goal
        self.outline.show(goal is not None and _is_away(state))
        if goal is not None and self.outline.shown:
            self.outline.write(goal.poses, state.arm.gripper)
            self.outline.paint(MET if goal.position_error <= SHORT else MISSED)


def _is_away(state: State) -> bool:
    """Whether the goal is far enough from the arm to be drawn; not for a path, nor while the arm holds its position."""
    if state.request.goal is None or isinstance(state.request.command, HoldPosition | FollowPath):
        return False
    return bool(np.max(np.abs(state.request.goal.q - state.arm.q)) > AWAY)
