"""The handles of the planes: an arrow on each movable pane, dragged along the normal."""

from __future__ import annotations

import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.state import Drag
from helicoide.text import Text
from helicoide.view import bind
from helicoide.view.layers import Stage
from helicoide.view.layers.planes import pane_wxyz
from helicoide.view.requests import ForArm
from helicoide.view.window_view import View

NAME = "handles"
SHARED = False
TITLE = Text(en="Plane handles", pt_BR="Alças dos planos")
SHOWN = True
KIND = "confinement"
SAID = Text(
    en="An arrow on each plane that can be moved: drag it along the normal.",
    pt_BR="Uma seta em cada plano móvel: arraste-a ao longo da normal.",
)


def build(stage: Stage) -> Handles:
    """The layer, without handles at first."""
    return Handles(stage, NAME, rotates=False)


class Handles:
    """The gizmos, one for each movable plane. None is moved while this window drags it.

    rotates: whether the gizmos are rings that rotate the planes, and not arrows that move them.
    """

    def __init__(self, stage: Stage, name: str, rotates: bool) -> None:
        self.stage, self.name, self.rotates = stage, name, rotates
        self.gizmos: dict[int, viser.TransformControlsHandle] = {}

    def update(self, old: View | None, new: View) -> None:
        """Follow the planes, and hide while they are off."""
        state, planes = new.state, new.state.problem.planes
        shown = new.seat.visible_layers[self.name] and not state.arm.parked
        movable = {k for k, pane in enumerate(planes.panes) if pane.movable}
        for k in movable - self.gizmos.keys() if shown else ():
            self.gizmos[k] = self._gizmo(k)
            old = None
        changed = new.handles_moved(old)
        for index, gizmo in self.gizmos.items():
            if gizmo.visible != (shown and index in movable):
                gizmo.visible = shown and index in movable
            if changed and index in movable and state.request.drag != Drag(self.stage.who, f"plane {index}"):
                gizmo.position = planes.centres[index]
                gizmo.wxyz = pane_wxyz(planes.normals[index])

    def _gizmo(self, index: int) -> viser.TransformControlsHandle:
        stage = self.stage
        gizmo = stage.scene.add_transform_controls(
            f"/{self.name}/plane {index}",
            scale=0.2 * stage.weight,
            line_width=4.0 * stage.weight,
            active_axes=(self.rotates, self.rotates, True),
            disable_axes=self.rotates,
            disable_sliders=True,
            disable_rotations=not self.rotates,
        )

        def dragged(phase: gate.Phase, position: Array, wxyz: Array) -> None:
            stage.act(ForArm(gate.drag_plane(stage.who, phase, index, position, wxyz)))

        bind.on_drag(gizmo, dragged)
        return gizmo
