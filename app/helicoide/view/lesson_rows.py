"""The rows of a docked lesson: a step with its texts and controls, or the summary after the last step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from markupsafe import Markup
from viser import Icon

from helicoide.kinematics.robot import Robot
from helicoide.lesson import Lesson, entered, progressed, restarted, skipped, turned_to
from helicoide.seat import LessonProgress, Seat
from helicoide.text import Language, Text
from helicoide.view.console_rows import console_line_rows
from helicoide.view.line_rows import line_rows
from helicoide.view.open_step import OpenStep, lesson_of, open_step
from helicoide.view.panels.robot import joint_row
from helicoide.view.playground_rows import playground_rows
from helicoide.view.prediction_rows import prediction_rows, reveal_row
from helicoide.view.prose_html import prose_html, prose_rows
from helicoide.view.requests import ForSeat, ResetStep
from helicoide.view.rows import Button, HtmlRow, Plot, Row
from helicoide.view.signal_charts import live_charts
from helicoide.view.window_view import View

DONE = Text(en="Done. Go to the next step.", pt_BR="Feito. Vá para o próximo passo.")
SKIPPED = Text(en="Skipped; you can still do it.", pt_BR="Pulado; ainda dá para fazer.")
TO_DO = Text(en="Step not completed yet.", pt_BR="Passo ainda não concluído.")
TRIED = Text(en="I have tried it", pt_BR="Já experimentei")
HINT, RESET = Text(en="Hint", pt_BR="Dica"), Text(en="Reset step", pt_BR="Reiniciar o passo")
NEXT, SKIP = Text(en="Next step", pt_BR="Próximo passo"), Text(en="Skip step", pt_BR="Pular o passo")
PREVIOUS = Text(en="Previous step", pt_BR="Passo anterior")
LEAVE, AGAIN = Text(en="Leave lesson", pt_BR="Sair da lição"), Text(en="Begin again", pt_BR="Começar de novo")
HEAD = Markup('<div class="helicoide-lesson">{}<h3>{}. {}</h3>{}</div>')
VERDICT = Markup('<p class="helicoide-verdict {}">{}{}</p>')
QUOTED = Markup('<div class="helicoide-lesson"><blockquote{}>{}</blockquote></div>')
DOTS, DOT = Markup('<div class="helicoide-dots">{}</div>'), Markup('<i class="{}"></i>')


def step_rows(robot: Robot, opened: OpenStep, language: Language) -> list[Row]:
    """The rows of a step, in the order in which they are read and used."""
    lesson, step, prose = opened.lesson, opened.step, opened.prose
    reveals = step.prediction is not None
    is_late = step.prediction is not None and step.prediction.reveal == "done"
    return [
        HtmlRow(_head),
        *prose_rows(lesson, prose.body[language]),
        *(prediction_rows(opened) if reveals else []),
        *([reveal_row()] if reveals and not is_late else []),
        *prose_rows(lesson, prose.task[language]),
        *(joint_row(robot, index) for index in step.joints),
        *(console_line_rows() if step.console else []),
        *([playground_rows()] if step.playground else []),
        *(line_rows(opened, step.line, language) if step.line is not None else []),
        *(Plot(live_charts, index) for index in range(len(step.charts))),
        *([reveal_row()] if is_late else []),
        HtmlRow(_mistake),
        HtmlRow(_hint),
        *_step_buttons(),
        *leaving_rows(),
    ]


def leaving_rows() -> list[Row]:
    """Leave the lesson, or begin it again."""
    return [
        Button(lambda _: LEAVE, lambda _: ForSeat(lambda seat: entered(seat, None)), Icon.DOOR_EXIT),
        Button(lambda _: AGAIN, lambda _: ForSeat(restarted), Icon.REPEAT, weight="destructive"),
    ]


def dots(lesson: Lesson, progress: LessonProgress) -> Markup:
    """A dot for each step: done, skipped, or the one at which its reader is."""

    def kind(number: int, step: str) -> str:
        said = "done" if step in progress.done else "skipped" if step in progress.skipped else ""
        return f"{said} here" if number == progress.step else said

    return DOTS.format(Markup("").join(DOT.format(kind(k, step.id)) for k, step in enumerate(lesson.steps)))


def _step_buttons() -> list[Row]:
    def is_tried(view: View) -> bool:
        opened = open_step(view.seat)
        return opened is not None and opened.step.by_reader and not opened.is_done

    return [
        Button(lambda _: TRIED, lambda _: ForSeat(_tried), Icon.CHECK, shown=is_tried, weight="primary"),
        Button(lambda _: NEXT, lambda _: ForSeat(_turned(1)), Icon.ARROW_RIGHT, shown=_is_done, weight="primary"),
        Button(lambda _: HINT, lambda _: ForSeat(_hinted), Icon.BULB),
        Button(lambda _: RESET, lambda _: ResetStep(), Icon.REFRESH),
        Button(lambda _: SKIP, lambda _: ForSeat(_skipped), Icon.ARROW_RIGHT, shown=lambda view: not _is_done(view)),
        Button(lambda _: PREVIOUS, lambda _: ForSeat(_turned(-1)), Icon.ARROW_LEFT, enabled=_has_previous),
    ]


def _is_done(view: View) -> bool:
    opened = open_step(view.seat)
    return opened is not None and opened.is_done


def _has_previous(view: View) -> bool:
    progress = view.seat.lesson_progress
    return progress is not None and progress.step > 0


def _hinted(seat: Seat) -> Seat:
    return replace(seat, hint_open=not seat.hint_open)


def _tried(seat: Seat) -> Seat:
    opened = open_step(seat)
    return progressed(opened.step, seat) if opened is not None and opened.step.by_reader else seat


def _skipped(seat: Seat) -> Seat:
    lesson = lesson_of(seat)
    return seat if lesson is None else skipped(lesson, seat)


def _turned(by: int) -> Callable[[Seat], Seat]:
    def turned(seat: Seat) -> Seat:
        lesson, progress = lesson_of(seat), seat.lesson_progress
        return seat if lesson is None or progress is None else turned_to(lesson, seat, progress.step + by)

    return turned


def _head(view: View) -> Markup:
    """The dots, the title, and whether the step is done."""
    opened = open_step(view.seat)
    if opened is None:
        return Markup("")
    language, is_skipped = view.seat.language, opened.step.id in opened.progress.skipped
    text = DONE if opened.is_done else SKIPPED if is_skipped else TO_DO
    verdict = VERDICT.format("done" if opened.is_done else "", "✓ " if opened.is_done else "", text[language])
    bar = dots(opened.lesson, opened.progress)
    return HEAD.format(bar, opened.number + 1, opened.prose.title[language], verdict)


def _mistake(view: View) -> Markup:
    """The hint of the mistake that is made."""
    opened = open_step(view.seat)
    hints = {} if opened is None else opened.prose.hints
    if opened is None or view.seat.mistake is None or view.seat.mistake not in hints:
        return Markup("")
    hint = hints[view.seat.mistake][view.seat.language]
    return QUOTED.format(Markup(' class="mistake" role="status"'), prose_html(opened.lesson, hint, view))


def _hint(view: View) -> Markup:
    opened = open_step(view.seat)
    if opened is None or not view.seat.hint_open:
        return Markup("")
    return QUOTED.format("", prose_html(opened.lesson, opened.prose.hint[view.seat.language], view))
