"""The path that Play follows."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.state import PATH, Along
from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.rows import View

NAME = "path"
SHARED = False
TITLE = Text(en="Path of eq. 33", pt_BR="Trajetória da eq. 33")
SHOWN = False

COLOUR = (194, 24, 91)
PIECES = 96


def build(stage: Stage) -> Path:
    """The whole curve as line pieces."""
    points = np.array([PATH.pose(s)[:3, 3] for s in np.linspace(0, PATH.duration, PIECES + 1)])
    segments = np.stack([points[:-1], points[1:]], axis=1)
    return Path(stage.scene.add_line_segments("/path", segments, COLOUR, thickness=0.002, visible=False))


class Path:
    """The curve."""

    def __init__(self, line: viser.LineSegmentsHandle) -> None:
        self.line = line

    def update(self, old: View | None, new: View) -> None:
        """Show on request, and whenever the arm follows it."""
        shown = new.seat.shows[NAME] or isinstance(new.state.command, Along)
        if shown != self.line.visible:
            self.line.visible = shown
