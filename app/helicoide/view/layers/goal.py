"""The accepted goal: the arm's outline where it will come to rest, coloured by how well that meets the wish."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.readout import SHORT
from helicoide.state import Along, Hold, State
from helicoide.view.layers import Stage
from helicoide.view.layers.arm import Placed
from helicoide.view.rows import View

NAME = "goal"
SHARED = True

MET, MISSED = (0, 150, 136), (230, 81, 0)
AWAY = 0.02


def build(stage: Stage) -> Outline:
    """The outline of the arm, hidden until there is a goal."""
    scene, thickness = stage.scene, 0.0016 * stage.size
    drawn = [shape for shape in stage.shapes if len(shape.edges)]
    frames, lines = [], []
    for shape in drawn:
        frames.append(scene.add_frame(f"/goal/{shape.name}", show_axes=False, visible=False))
        lines.append(scene.add_line_segments(f"/goal/{shape.name}/edges", shape.edges, MET, thickness=thickness))
    return Outline(Placed(drawn, frames), lines)


class Outline:
    """The frames of the outline and its lines."""

    def __init__(self, placed: Placed, lines: list[viser.LineSegmentsHandle]) -> None:
        self.placed, self.lines = placed, lines
        self.shown, self.colour = False, MET

    def update(self, old: View | None, new: View) -> None:
        """Follow the goal."""
        state = new.state
        if old is not None and old.state.goal is state.goal and old.state.q is state.q:
            return
        goal = state.goal
        self._show(goal is not None and _is_away(state))
        if goal is not None and self.shown:
            self.placed.write(np.asarray(goal.poses), state.gripper)
            self._paint(MET if goal.short <= SHORT else MISSED)

    def _show(self, shown: bool) -> None:
        if shown != self.shown:
            self.shown = shown
            for frame in self.placed.frames:
                frame.visible = shown

    def _paint(self, colour: tuple[int, int, int]) -> None:
        if colour != self.colour:
            self.colour = colour
            for line in self.lines:
                line.colors = np.array(colour, dtype=np.uint8)


def _is_away(state: State) -> bool:
    """Whether the goal is far enough from the arm to be told apart; a path that plays needs no outline."""
    if state.goal is None or isinstance(state.command, Hold | Along):
        return False
    return bool(np.max(np.abs(state.goal.q - state.q)) > AWAY)
