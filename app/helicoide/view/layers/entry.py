"""The entry point of the instrument: a ball at the point through which its shaft must pass."""

from __future__ import annotations

import viser

from helicoide.view.colours import PURPLE
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "entry"
SHARED = True

COLOUR = PURPLE
RADIUS = 0.014


def build(stage: Stage) -> EntryLayer:
    """The ball, hidden until an entry point is held."""
    ball = stage.scene.add_icosphere(
        "/entry", RADIUS * stage.size, COLOUR, opacity=0.7, cast_shadow=False, visible=False
    )
    return EntryLayer(ball)


class EntryLayer:
    """The ball."""

    def __init__(self, ball: viser.IcosphereHandle) -> None:
        self.ball = ball

    def update(self, old: View | None, new: View) -> None:
        """Follow the entry point."""
        entry = new.state.problem.entry
        if old is not None and old.state.problem.entry is entry:
            return
        self.ball.visible = entry is not None
        if entry is not None:
            self.ball.position = entry.point
