"""The path that Play follows."""

from __future__ import annotations

import numpy as np
import viser

from helicoide import gate
from helicoide.command import FollowPath, PathChoice
from helicoide.text import Text
from helicoide.view.colours import GREY
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "path"
SHARED = False
TITLE = Text(en="Path curve", pt_BR="Curva da trajetória")
SHOWN = False
KIND = "arm"
SAID = Text(
    en="The path that the end effector follows with “Play”.",
    pt_BR="A trajetória que o efetuador segue com “Reproduzir”.",
)

COLOUR = GREY
PIECES = 200


def build(stage: Stage) -> PathLayer:
    """The line, hidden and without a path at first."""
    line = stage.scene.add_line_segments("/path", np.zeros((1, 2, 3)), COLOUR, thickness=0.002 * stage.size)
    line.visible = False
    return PathLayer(stage, line)


class PathLayer:
    """The path as a curve."""

    def __init__(self, stage: Stage, line: viser.LineSegmentsHandle) -> None:
        self.stage, self.line = stage, line
        self.course: PathChoice | None = None

    def update(self, old: View | None, new: View) -> None:
        """Show the path if the layer is on or the arm follows the path."""
        shown = new.seat.visible_layers[NAME] or isinstance(new.state.request.command, FollowPath)
        if shown and self.course != new.state.request.path_choice:
            self.course = new.state.request.path_choice
            path = gate.path_of(self.stage.robot, self.course)
            points = np.array([path.pose(s)[:3, 3] for s in np.linspace(0, path.duration, PIECES + 1)])
            self.line.points = np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)
        if shown != self.line.visible:
            self.line.visible = shown
