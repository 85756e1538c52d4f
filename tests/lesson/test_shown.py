"""What a step shows is undone on leaving it, and nothing else is."""

from __future__ import annotations

from dataclasses import replace

from helicoide import lesson
from helicoide.lesson import Shown, Step
from helicoide.seat import ChartChoice, Notation, Seat, Selection
from helicoide.sheet import Sheet, SheetLine

SHOWN = Shown(
    layers=("twist",),
    hidden=("axes",),
    selection=Selection("tool"),
    coefficient="e1e2",
    notation=Notation(naming="compact"),
    sheet="hodge_star",
)
STEP = Step("a", lambda state: state, shown=SHOWN, charts=("manipulability",))


def seat() -> Seat:
    own = Sheet((SheetLine("1 + 1"),))
    layers = {"twist": False, "axes": True, "dh": False}
    return replace(
        Seat(token="", language="en", visible_layers=layers, sheet=own), charts=ChartChoice(shown=("speed",))
    )


def test_all_that_a_step_shows_is_shown_and_undone() -> None:
    before = seat()
    shown = lesson.with_step_shown(before, STEP)
    assert shown.visible_layers == {"twist": True, "axes": False, "dh": False}
    assert (shown.selected, shown.coefficient, shown.notation) == (Selection("tool"), "e1e2", SHOWN.notation)
    assert shown.sheet != before.sheet
    assert shown.charts.shown == ("manipulability",)
    assert lesson.without_step_shown(shown, STEP) == before


def test_a_step_that_is_reset_is_undone_to_what_was_before_it() -> None:
    before = seat()
    shown = lesson.with_step_shown(before, STEP)
    touched = shown.with_layer("twist", False).inspecting(None)
    again = lesson.with_step_shown(touched, STEP)
    assert replace(again, outside=None) == replace(shown, outside=None)
    assert lesson.without_step_shown(again, STEP) == before


def test_what_a_step_does_not_show_stays_as_the_person_left_it() -> None:
    quiet = Step("b", lambda state: state)
    changed = lesson.with_step_shown(seat(), quiet).with_layer("dh", True).inspecting(Selection("joint", 1))
    after = lesson.without_step_shown(changed, quiet)
    assert after.visible_layers["dh"]
    assert after.selected == Selection("joint", 1)
    assert after.outside is None
    assert lesson.without_step_shown(after, STEP) is after
