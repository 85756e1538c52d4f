"""The compared arm: the outline of a second arm that follows the same target by another method."""

from __future__ import annotations

from helicoide.view.colours import PURPLE
from helicoide.view.layers import Stage
from helicoide.view.outline import Outline
from helicoide.view.rows import View

NAME = "beside"
SHARED = True

COLOUR = PURPLE


def build(stage: Stage) -> ComparedOutline:
    """The outline of the second arm, hidden until there is one."""
    return ComparedOutline(Outline(stage, NAME, COLOUR))


class ComparedOutline:
    """The second arm's outline."""

    def __init__(self, outline: Outline) -> None:
        self.outline = outline

    def update(self, old: View | None, new: View) -> None:
        """Follow the second arm."""
        beside = new.state.compared
        if old is not None and old.state.compared is beside:
            return
        self.outline.show(beside is not None)
        if beside is not None:
            self.outline.write(beside.arm.poses, new.state.arm.gripper)
