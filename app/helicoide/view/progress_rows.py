"""Rows for one's progress in the lessons: whether it is kept, take it home as a file, bring it back, delete it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from markupsafe import Markup
from viser import Icon

from helicoide.lesson import Lesson
from helicoide.seat import Seat, SeatUpdate
from helicoide.store.answer_check import bad_answers
from helicoide.store.merging import NO_PROGRESS, merge_progress
from helicoide.store.progress_file import NAME, NO_PROGRESS_FILE, decode_progress, encode_progress
from helicoide.text import HelicoideError, Text
from helicoide.view import html
from helicoide.view.requests import ForgetProgress, ForSeat, Save
from helicoide.view.rows import Button, Folder, HtmlRow, Row, Upload
from helicoide.view.window_view import View

TITLE = Text(en="My progress", pt_BR="Meu progresso")
COUNTED = Text(
    en="Lessons begun: {begun}; completed: {finished}.", pt_BR="Lições começadas: {begun}; concluídas: {finished}."
)
SAVE = Text(en="Save my progress as a file", pt_BR="Salvar meu progresso como arquivo")
LOAD = Text(en="Add the progress of a file", pt_BR="Acrescentar o progresso de um arquivo")
DELETION = Text(en="Delete my progress", pt_BR="Apagar meu progresso")
FOR_GOOD = Text(
    en="All lessons, answers and lines are deleted, here and where the lab keeps them. Only a saved file brings them "
    "back.",
    pt_BR="Todas as lições, respostas e linhas são apagadas, aqui e onde o laboratório as guarda. Só um arquivo salvo "
    "as traz de volta.",
)
BAD_ANSWER = Text(
    en="the answer in the step {step} of {lesson} does not have the form that is asked for there",
    pt_BR="a resposta no passo {step} de {lesson} não tem a forma que se pede ali",
)
DELETE = Text(en="Delete for good", pt_BR="Apagar de vez")


def progress_rows(lessons: Callable[[], Sequence[Lesson]]) -> Folder:
    """The folder of one's progress. lessons: those that a file may be about."""
    deletion: list[Row] = [
        HtmlRow(lambda view: html.note(FOR_GOOD[view.seat.language])),
        Button(lambda _: DELETE, lambda _: ForgetProgress(), Icon.TRASH, _has_any, weight="destructive"),
    ]
    rows: list[Row] = [
        HtmlRow(_about),
        Button(lambda _: SAVE, lambda view: Save(NAME, encode_progress(view.seat.progress)), Icon.DOWNLOAD, _has_any),
        Upload(LOAD, lambda _, __, content: ForSeat(add_progress(content, lessons()))),
        Folder(DELETION, deletion, open=False),
    ]
    return Folder(TITLE, rows, open=False)


def add_progress(content: bytes, lessons: Sequence[Lesson]) -> SeatUpdate:
    """The update that adds the progress of a file to that of a seat, of which nothing is lost.

    The update raises HelicoideError if the file cannot be read, or is not about these lessons.
    """

    def update(seat: Seat) -> Seat:
        added = decode_progress(content, steps_of(lessons))
        for lesson, step in bad_answers(added, lessons):
            raise HelicoideError(NO_PROGRESS_FILE.format(reason=BAD_ANSWER.format(lesson=lesson, step=step)))
        return replace(seat, progress=merge_progress(seat.progress, NO_PROGRESS, added))

    return update


def steps_of(lessons: Iterable[Lesson]) -> Mapping[str, tuple[str, ...]]:
    """The ids of the steps of lessons, by the ids of the lessons."""
    return {lesson.id: tuple(step.id for step in lesson.steps) for lesson in lessons}


def _has_any(view: View) -> bool:
    return bool(view.seat.progress)


def _about(view: View) -> Markup:
    """How far one is, and whether it is kept."""
    progress, language = view.seat.progress.values(), view.seat.language
    counted = COUNTED.format(begun=len(progress), finished=sum(lesson.finished for lesson in progress))
    return Markup("{}{}").format(html.note(counted[language]), html.note(view.progress_note[language]))
