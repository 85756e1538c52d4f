"""The handles of the obstacles: three arrows in the middle of each sphere."""

from __future__ import annotations

import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.state import Drag
from helicoide.view import bind
from helicoide.view.layers import Stage
from helicoide.view.requests import ForArm
from helicoide.view.window_view import View

NAME = "obstacle_handles"
SHARED = False


def build(stage: Stage) -> ObstacleHandles:
    """The layer, without handles at first."""
    return ObstacleHandles(stage)


class ObstacleHandles:
    """The gizmos of one window. None is moved while this window drags it; those without a sphere are hidden."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.gizmos: list[viser.TransformControlsHandle] = []

    def update(self, old: View | None, new: View) -> None:
        """Follow the obstacles."""
        state, obstacles = new.state, new.state.problem.obstacles
        if not new.handles_moved(old):
            return
        while len(self.gizmos) < len(obstacles.radii):
            self.gizmos.append(self._handle(len(self.gizmos)))
        for index, gizmo in enumerate(self.gizmos):
            shown = index < len(obstacles.radii)
            if gizmo.visible != shown:
                gizmo.visible = shown
            if shown and state.request.drag != Drag(self.stage.who, gate.obstacle_handle(index)):
                gizmo.position = obstacles.ends[index, 0]

    def _handle(self, index: int) -> viser.TransformControlsHandle:
        stage = self.stage
        gizmo = stage.scene.add_transform_controls(
            f"/handles/{gate.obstacle_handle(index)}",
            scale=0.16 * stage.size,
            line_width=3.0 * stage.weight,
            disable_rotations=True,
            depth_test=False,
        )

        def dragged(phase: gate.Phase, position: Array, wxyz: Array) -> None:
            stage.act(ForArm(gate.drag_obstacle(stage.who, phase, index, position)))

        bind.on_drag(gizmo, dragged)
        return gizmo
