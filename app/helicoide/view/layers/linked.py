"""The posture of a link that was opened, as an outline: a question, until its reader lets the arm go there."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.kernels import python_function
from helicoide.kinematics.forward import link_poses
from helicoide.view.colours import BLUE
from helicoide.view.layers import Stage
from helicoide.view.outline import Outline
from helicoide.view.window_view import View

NAME = "linked"
SHARED = False

COLOUR = BLUE


def build(stage: Stage) -> LinkedOutline:
    """The outline, hidden until a link is opened."""
    return LinkedOutline(Outline(stage, NAME, COLOUR))


class LinkedOutline:
    """The outline at the posture of the link."""

    def __init__(self, outline: Outline) -> None:
        self.outline = outline

    def update(self, old: View | None, new: View) -> None:
        """Show the posture of a link about this arm."""
        if old is not None and old.seat.linked is new.seat.linked:
            return
        q = new.linked_here()
        self.outline.show(q is not None)
        if q is not None:
            poses: Array = python_function(link_poses)(new.state.robot.chain, np.array(q))
            self.outline.write(poses, new.state.arm.gripper)
