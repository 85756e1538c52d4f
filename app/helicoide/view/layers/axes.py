"""The screw axes of the joints as arrows, on request."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.rows import View

NAME = "axes"
SHARED = False
TITLE = Text(en="Screw axes of the joints", pt_BR="Eixos helicoidais das juntas")
SHOWN = False

HALF = 0.16
COLOUR = (21, 101, 192)


def build(stage: Stage) -> Axes:
    """An arrow along each joint's axis."""
    size = stage.size
    return Axes(
        stage.scene.add_arrows(
            "/axes",
            np.zeros((len(stage.robot.joints), 2, 3)),
            COLOUR,
            shaft_radius=0.004 * size,
            head_radius=0.011 * size,
            head_length=0.035 * size,
            visible=False,
        ),
        HALF * size,
    )


class Axes:
    """The arrows."""

    def __init__(self, arrows: viser.ArrowsHandle, half: float) -> None:
        self.arrows, self.half = arrows, half

    def update(self, old: View | None, new: View) -> None:
        """Follow the joints while shown."""
        shown = new.seat.shows[NAME]
        if shown and (old is None or old.state.arm.q is not new.state.arm.q or not self.arrows.visible):
            axes, centres = new.state.axes, new.state.arm.poses[1:, :3, 3]
            ends = np.stack([centres - self.half * axes, centres + self.half * axes], axis=1)
            self.arrows.points = ends.astype(np.float32)
        if shown != self.arrows.visible:
            self.arrows.visible = shown
