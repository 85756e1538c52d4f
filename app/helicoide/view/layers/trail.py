"""The trail of the tool."""

from __future__ import annotations

from math import dist

import numpy as np
import viser

from helicoide.text import Text
from helicoide.view.colours import PURPLE
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "trail"
SHARED = False
TITLE = Text(en="End-effector trail", pt_BR="Rastro do efetuador")
SHOWN = True
KIND = "arm"
SAID = Text(
    en="Where the end effector has been: its last 200 points, a few millimetres apart.",
    pt_BR="Por onde o efetuador passou: os últimos 200 pontos, a poucos milímetros um do outro.",
)

LENGTH = 200
APART = 6e-3
COLOUR = PURPLE


def build(stage: Stage) -> Trail:
    """An empty trail."""
    line = stage.scene.add_line_segments("/trail", np.zeros((1, 2, 3)), COLOUR, thickness=0.003 * stage.size)
    return Trail(line, APART * stage.size)


class Trail:
    """The last points of the tool, a few millimetres apart."""

    def __init__(self, line: viser.LineSegmentsHandle, spacing: float) -> None:
        self.line, self.apart = line, spacing
        self.points: list[np.ndarray] = []

    def update(self, old: View | None, new: View) -> None:
        """Add the position of the tool."""
        shown = new.seat.visible_layers[NAME]
        if self.line.visible != shown:
            self.line.visible = shown
        if old is not None and old.state.arm.q is new.state.arm.q:
            return
        tool = new.state.T_world_tool[:3, 3].astype(np.float32)
        if self.points and dist(tool, self.points[-1]) < self.apart:
            return
        self.points = [*self.points[-LENGTH:], tool]
        if shown and len(self.points) > 1:
            points = np.array(self.points)
            self.line.points = np.stack([points[:-1], points[1:]], axis=1)
