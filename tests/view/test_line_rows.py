"""The rows of an exercise whose line is typed: they say what is asked for."""

from __future__ import annotations

import pytest

from helicoide import lesson
from helicoide.kinematics.library import load_robot
from helicoide.lines import LINE_KINDS
from helicoide.state import initial_state
from helicoide.view.line_rows import line_rows
from helicoide.view.open_step import open_step
from helicoide.view.rows import HtmlRow
from helicoide.view.window import new_seat
from helicoide.view.window_view import View


@pytest.mark.parametrize(("name", "step"), [("workspace", "write"), ("sine_to_motor", "write")])
def test_an_exercise_says_what_is_asked_for(name: str, step: str) -> None:
    found = lesson.load_lesson(name)
    number = [one.id for one in found.steps].index(step)
    seat = lesson.turned_to(found, lesson.entered(new_seat("", "pt_BR", None), name), number)
    opened, exercise = open_step(seat), found.steps[number].line
    assert opened is not None
    assert exercise is not None
    first = line_rows(opened, exercise, "pt_BR")[0]
    assert isinstance(first, HtmlRow)
    asked = (exercise.title or LINE_KINDS[exercise.kind])["pt_BR"]
    assert f"Digite {asked}. Nomes:" in first.html(View(initial_state(load_robot(found.robot)), seat))
