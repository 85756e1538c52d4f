"""The compared arm: the outline of a second arm that follows the same target by another method."""

from __future__ import annotations

from helicoide.text import Text
from helicoide.view.colours import PURPLE
from helicoide.view.layers import Stage
from helicoide.view.outline import Outline
from helicoide.view.window_view import View

NAME = "compared"
SHARED = False
TITLE = Text(en="Second arm", pt_BR="Segundo braço")
SHOWN = True
KIND = "comparison"
SAID = Text(
    en="The edges of the second arm, which follows the same target by the compared method.",
    pt_BR="As arestas do segundo braço, que segue o mesmo alvo pelo método comparado.",
)

COLOUR = PURPLE


def build(stage: Stage) -> ComparedOutline:
    """The layer, which draws nothing without a second arm."""
    return ComparedOutline(stage)


class ComparedOutline:
    """The second arm's outline."""

    def __init__(self, stage: Stage) -> None:
        self.outline = Outline(stage, NAME, COLOUR)

    def update(self, old: View | None, new: View) -> None:
        """Follow the second arm."""
        second = new.state.compared
        shown = second is not None and new.seat.visible_layers[NAME]
        appears = shown and not self.outline.shown
        self.outline.show(shown)
        if second is not None and shown and (appears or old is None or old.state.compared is not second):
            self.outline.write(second.arm.poses, new.state.arm.gripper)
