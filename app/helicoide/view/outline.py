"""An arm drawn by its sharp edges alone, for the goal and for a compared arm."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.view.colours import Colour
from helicoide.view.layers import Stage
from helicoide.view.layers.arm import LinkNodes

THICKNESS = 0.0016


class Outline:
    """The frames and lines of an outline, hidden at first; they are added to the scene when it is first shown."""

    def __init__(self, stage: Stage, name: str, colour: Colour) -> None:
        self.stage, self.name, self.colour = stage, name, colour
        self.frames: list[viser.FrameHandle] = []
        self.lines: list[viser.LineSegmentsHandle] = []
        self.placed: LinkNodes | None = None
        self.shown = False

    def _add(self) -> LinkNodes:
        scene, thickness = self.stage.scene, THICKNESS * self.stage.size
        drawn = [shape for shape in self.stage.shapes if len(shape.edges)]
        names = [f"/{self.name}/{shape.name}" for shape in drawn]
        self.frames = [scene.add_frame(name, show_axes=False, visible=False) for name in names]
        self.lines = [
            scene.add_line_segments(f"{name}/edges", shape.edges, self.colour, thickness=thickness)
            for name, shape in zip(names, drawn, strict=True)
        ]
        return LinkNodes(drawn, self.frames)

    def show(self, shown: bool) -> None:
        """Show or hide the outline."""
        if shown != self.shown:
            self.placed = self.placed or self._add()
            self.shown = shown
            for frame in self.frames:
                frame.visible = shown

    def write(self, poses: Array, gripper: float) -> None:
        """Move the outline, if it is shown, to link poses (m + 1, 4, 4), m; gripper: 0 closed to 1 open."""
        if self.shown and self.placed is not None:
            self.placed.write(np.asarray(poses), gripper)

    def paint(self, colour: Colour) -> None:
        """Change the colour."""
        if colour != self.colour:
            self.colour = colour
            for line in self.lines:
                line.colors = np.array(colour, dtype=np.uint8)
