"""The screw axes of the joints as lines through the arm, named J1 … Jn; hidden by default."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.text import Text
from helicoide.view.colours import BLUE
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "axes"
SHARED = False
TITLE = Text(en="Joint screw axes", pt_BR="Eixos helicoidais das juntas")
SHOWN = False
KIND = "algebra"
SAID = Text(
    en="The screw axis of each joint, with an arrow for the positive sense of rotation or sliding.",
    pt_BR="O eixo helicoidal de cada junta, com uma seta no sentido positivo da rotação ou do deslizamento.",
)

HALF, TIP = 0.6, 0.28  # half the line, and the length of the arrow that shows the sense of the axis, × size, m
COLOUR = BLUE


def build(stage: Stage) -> Axes:
    """A line and an arrow along the axis of each joint, with its name at the head of the arrow."""
    scene, size, n = stage.scene, stage.size, len(stage.robot.joints)
    none = np.zeros((n, 2, 3))
    return Axes(
        scene.add_line_segments("/axes/lines", none, COLOUR, thickness=0.004 * size, visible=False),
        scene.add_arrows(
            "/axes/arrows",
            none,
            COLOUR,
            shaft_radius=0.004 * size,
            head_radius=0.011 * size,
            head_length=0.035 * size,
            visible=False,
        ),
        [scene.add_label(f"/axes/J{i + 1}", f"J{i + 1}", anchor="bottom-center", visible=False) for i in range(n)],
        size,
    )


class Axes:
    """The lines, the arrows and the names."""

    def __init__(
        self,
        lines: viser.LineSegmentsHandle,
        arrows: viser.ArrowsHandle,
        names: list[viser.LabelHandle],
        size: float,
    ) -> None:
        self.lines, self.arrows, self.names, self.size = lines, arrows, names, size

    def update(self, old: View | None, new: View) -> None:
        """Follow the joints while shown."""
        shown = new.seat.visible_layers[NAME]
        if shown and (old is None or old.state.arm.q is not new.state.arm.q or not self.lines.visible):
            axes, points = new.state.axes, new.state.arm.poses[1:, :3, 3]
            heads = points + TIP * self.size * axes
            far = HALF * self.size * axes
            self.lines.points = np.stack([points - far, points + far], axis=1).astype(np.float32)
            self.arrows.points = np.stack([points, heads], axis=1).astype(np.float32)
            for name, head in zip(self.names, heads, strict=True):
                name.position = head
        for part in (self.lines, self.arrows, *self.names):
            if shown != part.visible:
                part.visible = shown
