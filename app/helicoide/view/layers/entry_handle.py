"""The handle of the entry point: three arrows, shown while the entry point is held."""

from __future__ import annotations

import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.state import Drag
from helicoide.view import bind
from helicoide.view.layers import Stage
from helicoide.view.requests import ForArm
from helicoide.view.window_view import View

NAME = "entry_handle"
SHARED = False


def build(stage: Stage) -> EntryHandle:
    """The gizmo, hidden until an entry point is held."""
    gizmo = stage.scene.add_transform_controls(
        "/handles/entry",
        scale=0.16 * stage.size,
        line_width=3.0 * stage.weight,
        disable_rotations=True,
        depth_test=False,
    )
    gizmo.visible = False

    def dragged(phase: gate.Phase, position: Array, wxyz: Array) -> None:
        stage.act(ForArm(gate.drag_entry(stage.who, phase, position)))

    bind.on_drag(gizmo, dragged)
    return EntryHandle(stage.who, gizmo)


class EntryHandle:
    """The gizmo of one window. It is not moved while this window drags it."""

    def __init__(self, who: str, gizmo: viser.TransformControlsHandle) -> None:
        self.who, self.gizmo = who, gizmo

    def update(self, old: View | None, new: View) -> None:
        """Follow the entry point."""
        state, entry = new.state, new.state.problem.entry
        if self.gizmo.visible != (entry is not None):
            self.gizmo.visible = entry is not None
        if entry is not None and new.handles_moved(old) and state.request.drag != Drag(self.who, gate.ENTRY):
            self.gizmo.position = entry.point
