"""An arm drawn by its sharp edges alone, for the goal and for a compared arm."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.view.colours import Colour
from helicoide.view.layers import Stage
from helicoide.view.layers.arm import LinkNodes

THICKNESS = 0.0016


class Outline:
    """The frames and lines of an outline, hidden at first."""

    def __init__(self, stage: Stage, name: str, colour: Colour) -> None:
        scene, thickness = stage.scene, THICKNESS * stage.size
        drawn = [shape for shape in stage.shapes if len(shape.edges)]
        self.frames = [scene.add_frame(f"/{name}/{shape.name}", show_axes=False, visible=False) for shape in drawn]
        self.lines = [
            scene.add_line_segments(f"/{name}/{shape.name}/edges", shape.edges, colour, thickness=thickness)
            for shape in drawn
        ]
        self.placed = LinkNodes(drawn, self.frames)
        self.shown, self.colour = False, colour

    def show(self, shown: bool) -> None:
        """Show or hide the outline."""
        if shown != self.shown:
            self.shown = shown
            for frame in self.frames:
                frame.visible = shown

    def write(self, poses: Array, gripper: float) -> None:
        """Move the outline to link poses (m + 1, 4, 4), m; gripper: 0 closed to 1 open."""
        self.placed.write(np.asarray(poses), gripper)

    def paint(self, colour: Colour) -> None:
        """Change the colour."""
        if colour != self.colour:
            self.colour = colour
            for line in self.lines:
                line.colors = np.array(colour, dtype=np.uint8)
