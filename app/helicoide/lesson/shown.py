"""What a step shows its reader: applied to the seat on entering the step, undone on leaving it."""

from __future__ import annotations

from dataclasses import replace

from helicoide.console import example_sheets
from helicoide.lesson.step import Step
from helicoide.seat import Seat


def with_step_shown(seat: Seat, step: Step) -> Seat:
    """The seat as a step shows it. `seat.outside` keeps the seat without that."""
    outside, shown = seat.outside or seat, step.shown
    for name, on in (*((name, True) for name in shown.layers), *((name, False) for name in shown.hidden)):
        seat = seat.with_layer(name, on)
    if shown.selection is not None:
        seat = seat.inspecting(shown.selection)
    if shown.coefficient is not None:
        seat = replace(seat, coefficient=shown.coefficient)
    if shown.notation is not None:
        seat = replace(seat, notation=shown.notation)
    if shown.sheet in example_sheets():
        seat = replace(seat, sheet=example_sheets()[shown.sheet].sheet)
    if step.charts:
        seat = replace(seat, charts=replace(seat.charts, shown=step.charts, paused=False))
    return replace(seat, outside=replace(outside, outside=None))


def without_step_shown(seat: Seat, step: Step) -> Seat:
    """The seat as it was before a step was shown. What that step does not change stays."""
    outside, shown = seat.outside, step.shown
    if outside is None:
        return seat
    for name in (*shown.layers, *shown.hidden):
        if name in outside.visible_layers:
            seat = seat.with_layer(name, outside.visible_layers[name])
    if shown.selection is not None or shown.coefficient is not None:
        seat = replace(seat.inspecting(outside.selected), coefficient=outside.coefficient)
    if shown.notation is not None:
        seat = replace(seat, notation=outside.notation)
    if shown.sheet is not None:
        seat = replace(seat, sheet=outside.sheet)
    if step.charts:
        seat = replace(seat, charts=outside.charts)
    return replace(seat, outside=None)
