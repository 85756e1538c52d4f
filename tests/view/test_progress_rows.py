"""The rows of one's progress: a file brings it back, and a file that cannot be read changes nothing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest

from helicoide.lesson import Estimate, all_lessons, load_lesson
from helicoide.seat import LessonProgress, PredictionAnswer, Seat
from helicoide.state import State
from helicoide.store.answer_check import without_bad_answers
from helicoide.store.progress_file import NAME, decode_progress, encode_progress
from helicoide.text import HelicoideError
from helicoide.view import html
from helicoide.view.progress_rows import LOAD, SAVE, add_progress, progress_rows, steps_of
from helicoide.view.requests import ForgetProgress, ForSeat, Save
from helicoide.view.rows import Button, Folder, HtmlRow, Upload
from helicoide.view.window_view import View

LESSON = "drive_the_arm"
STEPS = tuple(step.id for step in load_lesson(LESSON).steps)
SEAT = Seat("", "pt_BR", progress={LESSON: LessonProgress(LESSON, 1, frozenset(STEPS[:1]))})


def leaves(folder: Folder) -> Iterator[Any]:
    for row in folder.rows:
        yield from leaves(row) if isinstance(row, Folder) else [row]


ROWS = list(leaves(progress_rows(all_lessons)))


def saved(view: View) -> Save:
    (button,) = (row for row in ROWS if isinstance(row, Button) and row.label(view) == SAVE)
    request = button.request(view)
    assert isinstance(request, Save)
    return request


def test_progress_that_was_saved_is_added_again(state: State) -> None:
    view = View(state, SEAT)
    request = saved(view)
    assert request.name == NAME
    assert decode_progress(request.content, steps_of(all_lessons())) == SEAT.progress
    (upload,) = (row for row in ROWS if isinstance(row, Upload))
    assert upload.label == LOAD
    again = upload.request(view, "any name", request.content)
    assert isinstance(again, ForSeat)
    assert again.update(Seat("", "en")).progress == SEAT.progress
    assert again.update(SEAT).progress == SEAT.progress


def test_a_file_adds_to_what_is_there(state: State) -> None:
    later = replace(SEAT, progress={LESSON: LessonProgress(LESSON, 2, frozenset(STEPS[1:2]))})
    both = add_progress(saved(View(state, SEAT)).content, all_lessons())(later).progress[LESSON]
    assert (both.step, both.done) == (2, frozenset(STEPS[:2]))


@pytest.mark.parametrize("content", [b"", b"{}", b"\xff", b"waypoints"])
def test_a_file_that_cannot_be_read_is_refused(content: bytes) -> None:
    with pytest.raises(HelicoideError):
        add_progress(content, all_lessons())(SEAT)


def test_nothing_is_saved_or_deleted_where_nothing_is(state: State) -> None:
    buttons = [row for row in ROWS if isinstance(row, Button)]
    assert [button.enabled(View(state, Seat("", "en"))) for button in buttons] == [False, False]
    assert [button.enabled(View(state, SEAT)) for button in buttons] == [True, True]
    assert ForgetProgress() in [button.request(View(state, SEAT)) for button in buttons]


def test_the_page_says_how_far_one_is_and_whether_it_is_kept(state: State) -> None:
    note = LOAD  # any text
    shown = [row.html(View(state, SEAT, progress_note=note)) for row in ROWS if isinstance(row, HtmlRow)]
    assert "começadas: 1; concluídas: 0" in shown[0]
    assert html.note(note.pt_BR) in shown[0]


def test_an_answer_that_no_prediction_asks_for_is_refused_from_a_file_and_left_out_of_the_store() -> None:
    found = load_lesson(LESSON)
    step = replace(found.steps[0], prediction=Estimate(lambda state, seat: 0.0, "mm", 1.0))
    lesson = replace(found, steps=(step, *found.steps[1:]))
    bad = {LESSON: LessonProgress(LESSON, answers={step.id: PredictionAnswer((1.0, 2.0, 3.0, 4.0))})}
    with pytest.raises(HelicoideError, match=f"the answer in the step {step.id} of {LESSON}"):
        add_progress(encode_progress(bad), [lesson])(SEAT)
    assert not without_bad_answers(bad, [lesson])[LESSON].answers
    good = {LESSON: LessonProgress(LESSON, answers={step.id: PredictionAnswer((0.0,))})}
    assert without_bad_answers(good, [lesson]) == good
