"""The target: a gizmo, and a line to it from the tool while the tool is elsewhere."""

from __future__ import annotations

from math import dist

import numpy as np
import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.readout import SHORT
from helicoide.state import Drag, State
from helicoide.view import bind
from helicoide.view.colours import GREEN, VERMILION
from helicoide.view.layers import Stage
from helicoide.view.pose import place_node
from helicoide.view.requests import ForArm
from helicoide.view.window_view import View

NAME = "target"
SHARED = False

NEAR, FAR = GREEN, VERMILION


def build(stage: Stage) -> Target:
    """The gizmo and its line."""
    gizmo = stage.scene.add_transform_controls(
        "/target", scale=0.28 * stage.size, line_width=3.0 * stage.weight, depth_test=False
    )

    def dragged(phase: gate.Phase, position: Array, wxyz: Array) -> None:
        stage.act(ForArm(gate.drag_target(stage.who, phase, position, wxyz)))

    bind.on_drag(gizmo, dragged)
    line = stage.scene.add_line_segments(
        "/missing", np.zeros((1, 2, 3)), FAR, thickness=0.004 * stage.size, visible=False
    )
    return Target(stage.who, gizmo, line)


def _shown_pose(state: State) -> Array:
    """The pose (4, 4), m, of the gizmo while it is not dragged: the target pose if there is one, else the tool pose."""
    return state.request.command.T_world_target if isinstance(state.request.command, MoveToPose) else state.T_world_tool


class Target:
    """The gizmo of one window."""

    def __init__(self, who: str, gizmo: viser.TransformControlsHandle, line: viser.LineSegmentsHandle) -> None:
        self.who, self.gizmo, self.line = who, gizmo, line

    def update(self, old: View | None, new: View) -> None:
        """Follow the target, except while this window drags the gizmo."""
        state = new.state
        if old is not None and _shown_of(old.state) == _shown_of(state):
            return
        if self.gizmo.visible == state.arm.parked:
            self.gizmo.visible = not state.arm.parked
        if state.request.drag != Drag(self.who, "target"):
            pose = _shown_pose(state)
            place_node(self.gizmo, pose)
            # During a drag, this would lose the end of the drag.
            if self.gizmo.disable_rotations == state.request.with_orientation:
                self.gizmo.disable_rotations = not state.request.with_orientation
        self._line(state)

    def _line(self, state: State) -> None:
        """Draw the line from the tool to the target."""
        target = _shown_pose(state)[:3, 3]
        tool = state.T_world_tool[:3, 3]
        away = dist(target, tool) > SHORT
        if away:
            self.line.points = np.array([[tool, target]], dtype=np.float32)
            colour = FAR if state.request.goal is not None and state.request.goal.position_error > SHORT else NEAR
            self.line.colors = np.array(colour, dtype=np.uint8)
        if away != self.line.visible:
            self.line.visible = away


def _shown_of(state: State) -> tuple[object, ...]:
    """The parts of the state that the target depends on. Equal results: nothing has to be drawn."""
    arm, request = state.arm, state.request
    return id(arm.q), id(request.command), request.drag, request.with_orientation, arm.parked
