"""The summary after the last step of a lesson: what was done, predicted and mistaken, and what comes next."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from markupsafe import Markup
from viser import Icon

from helicoide.lesson import Lesson, all_lessons, next_lessons, turned_to
from helicoide.seat import LessonProgress, Seat
from helicoide.text import Text, join_texts, untranslated
from helicoide.view.lesson_rows import PREVIOUS, dots, leaving_rows
from helicoide.view.open_step import lesson_of
from helicoide.view.requests import ForSeat
from helicoide.view.rows import Button, HtmlRow, Row
from helicoide.view.window_view import View

ENDED = Text(en="Lesson complete.", pt_BR="Lição concluída.")
STEPS = Text(en="{done} of {n} steps done.", pt_BR="{done} de {n} passos concluídos.")
SKIPPED = Text(en="Skipped: {titles}.", pt_BR="Pulados: {titles}.")
RIGHT = Text(
    en="{right} of {n} predictions right, of those that you answered. A wrong one is no failure: it is where you "
    "learned something.",
    pt_BR="{right} de {n} previsões certas, entre as que você respondeu. Errar uma não é falhar: foi ali que você "
    "aprendeu alguma coisa.",
)
MISTAKES = Text(
    en="Steps in which a mistake was explained to you:", pt_BR="Passos em que um erro foi explicado a você:"
)
SOURCES = Text(en="Sources: {sources}.", pt_BR="Fontes: {sources}.")
ONWARD = Text(en="Go on with:", pt_BR="Continue com:")
MOST_NEXT = 3
SUMMARY = Markup('<div class="helicoide-lesson helicoide-summary">{}<h3>{}</h3>{}</div>')
PARAGRAPH, LIST, ITEM = Markup("<p>{}</p>"), Markup("<ul>{}</ul>"), Markup("<li><b>{}</b> {}</li>")
GO = Markup('<li><button type="button" class="helicoide-go" data-go="lesson:{}">{}</button></li>')


def summary_rows() -> list[Row]:
    """The rows of the summary."""
    return [
        HtmlRow(partial(_summary, all_lessons())),
        Button(lambda _: PREVIOUS, lambda _: ForSeat(_back), Icon.ARROW_LEFT),
        *leaving_rows(),
    ]


def _back(seat: Seat) -> Seat:
    lesson = lesson_of(seat)
    return seat if lesson is None else turned_to(lesson, seat, len(lesson.steps) - 1)


def _summary(lessons: Sequence[Lesson], view: View) -> Markup:
    lesson, progress = lesson_of(view.seat), view.seat.lesson_progress
    if lesson is None or progress is None:
        return Markup("")
    onward = [each for each in next_lessons(lessons, view.seat.progress) if each.id != lesson.id]
    said = Markup("").join((*_parts(lesson, progress, view), _onward(onward[:MOST_NEXT], view)))
    return SUMMARY.format(dots(lesson, progress), ENDED[view.seat.language], said)


def _parts(lesson: Lesson, progress: LessonProgress, view: View) -> Iterator[Markup]:
    language, ids = view.seat.language, [step.id for step in lesson.steps]
    yield PARAGRAPH.format(STEPS.format(done=len(progress.done & {*ids}), n=len(ids))[language])
    if skipped := [lesson.prose[step].title for step in ids if step in progress.skipped]:
        yield PARAGRAPH.format(SKIPPED.format(titles=join_texts(skipped))[language])
    judged = [answer.right for step, answer in progress.answers.items() if step in ids and answer.right is not None]
    if judged:
        yield PARAGRAPH.format(RIGHT.format(right=sum(judged), n=len(judged))[language])
    mistaken = {step for step, _ in progress.mistakes}
    if steps := [number for number, step in enumerate(ids, 1) if step in mistaken]:
        listed = (ITEM.format(f"{number}.", lesson.prose[ids[number - 1]].title[language]) for number in steps)
        yield PARAGRAPH.format(MISTAKES[language]) + LIST.format(Markup("").join(listed))
    if lesson.sources:
        yield PARAGRAPH.format(SOURCES.format(sources=untranslated("; ".join(lesson.sources)))[language])


def _onward(lessons: Sequence[Lesson], view: View) -> Markup:
    language = view.seat.language
    listed = Markup("").join(GO.format(lesson.id, lesson.title[language]) for lesson in lessons)
    return PARAGRAPH.format(ONWARD[language]) + LIST.format(listed) if lessons else Markup("")
