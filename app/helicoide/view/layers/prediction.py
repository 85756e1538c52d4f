"""The marker of a prediction: three arrows that are dragged to a point; then that point, and the right one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import viser

from helicoide import gate
from helicoide.arrays import Array
from helicoide.lesson import Mark, right_answer
from helicoide.view import bind
from helicoide.view.colours import GREEN, PURPLE, Colour
from helicoide.view.layers import Stage
from helicoide.view.open_step import OpenStep, open_step
from helicoide.view.prediction_rows import marker_place
from helicoide.view.requests import ForSeat
from helicoide.view.window_view import View

NAME = "prediction"
SHARED = False

GIVEN, RIGHT, RADIUS = PURPLE, GREEN, 0.012


def build(stage: Stage) -> MarkerLayer:
    """The gizmo, hidden until a step asks for a point."""
    gizmo = stage.scene.add_transform_controls(
        "/handles/prediction",
        scale=0.12 * stage.size,
        line_width=3.0 * stage.weight,
        disable_rotations=True,
        depth_test=False,
    )
    stage.scene.add_icosphere("/handles/prediction/ball", RADIUS * stage.size, GIVEN)
    gizmo.visible = False
    return MarkerLayer(stage, gizmo)


class MarkerLayer:
    """The gizmo and the two points of one window. The gizmo is not moved while this window drags it."""

    def __init__(self, stage: Stage, gizmo: viser.TransformControlsHandle) -> None:
        self.stage, self.gizmo, self.dragging = stage, gizmo, False
        self.points: list[viser.IcosphereHandle] = []
        self.shown: tuple[object, ...] = ()
        bind.on_drag(gizmo, self._dragged)

    def update(self, old: View | None, new: View) -> None:
        """Follow the draft of the answer; after the answer, show it, and the right point once that is revealed."""
        if old is not None and old.seat is new.seat and (new.seat.lesson is None or new.seat.draft is not None):
            return
        opened = open_step(new.seat)
        asked = opened if opened is not None and isinstance(opened.step.prediction, Mark) else None
        is_open = asked is not None and asked.answer is None
        if is_open and not self.dragging and tuple(self.gizmo.position) != marker_place(new):
            self.gizmo.position = marker_place(new)
        if self.gizmo.visible != is_open:
            self.gizmo.visible = is_open
        answer = None if asked is None else asked.answer
        key = () if asked is None or answer is None else (asked.lesson.id, asked.number, answer)
        if key != self.shown:
            self.shown = key
            self._draw(asked, new)

    def _draw(self, opened: OpenStep | None, view: View) -> None:
        while self.points:
            self.points.pop().remove()
        answer, prediction = (None, None) if opened is None else (opened.answer, opened.step.prediction)
        if answer is None or prediction is None:
            return
        self._add("given", answer.given, GIVEN)
        if answer.right is not None:
            self._add("right", right_answer(prediction, view.state, view.seat), RIGHT)

    def _add(self, name: str, place: tuple[float, ...], colour: Colour) -> None:
        x, y, z = place
        radius = RADIUS * self.stage.size
        self.points.append(self.stage.scene.add_icosphere(f"/prediction/{name}", radius, colour, position=(x, y, z)))

    def _dragged(self, phase: gate.Phase, position: Array, wxyz: Array) -> None:
        self.dragging = phase != "end"
        if np.all(np.isfinite(position)):
            place = tuple(map(float, position))
            self.stage.act(ForSeat(lambda seat: replace(seat, draft=place)))
