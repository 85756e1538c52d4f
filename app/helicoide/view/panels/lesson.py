"""The lesson: one step at a time, its goal checked, its hint on request, its start one press away."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import replace

from markdown_it import MarkdownIt
from viser import Icon

from helicoide import content
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Lesson, entered, load
from helicoide.state import Seat
from helicoide.text import HelicoideError, Text
from helicoide.view.rows import Button, Choice, ForArm, ForSeat, Row, View, Wish, Words

TITLE = Text(en="Lesson", pt_BR="Lição")
ORDER = 0
ICON = Icon.SCHOOL

FREE = Text(en="Free play", pt_BR="Exploração livre")
DONE = Text(en="Done. On to the next step.", pt_BR="Feito. Siga para o próximo passo.")
ENDED = Text(
    en="That was the last step: the arm is yours.",
    pt_BR="Esse era o último passo: o braço é seu.",
)
TO_DO = Text(en="Not there yet.", pt_BR="Ainda não.")

log = logging.getLogger("helicoide")
_markdown = MarkdownIt("commonmark", {"html": False})


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    lessons = [lesson for name in content.found("lessons") if (lesson := _readable(name))]
    return [
        Choice(
            Text(en="Lesson", pt_BR="Lição"),
            [("", FREE), *((lesson.id, lesson.title) for lesson in lessons)],
            lambda view: view.seat.lesson or "",
            lambda name: ForSeat(lambda seat: entered(seat, name or None)),
        ),
        Words(_step),
        Button(lambda _: Text(en="Hint", pt_BR="Dica"), lambda _: ForSeat(_hinted), Icon.BULB, shown=_in_lesson),
        Button(lambda _: Text(en="Reset step", pt_BR="Reiniciar o passo"), _reset, Icon.REFRESH, shown=_in_lesson),
        Button(
            lambda _: Text(en="Next step", pt_BR="Próximo passo"), _turn(1), Icon.ARROW_RIGHT, _has_next, _in_lesson
        ),
        Button(
            lambda _: Text(en="Previous step", pt_BR="Passo anterior"),
            _turn(-1),
            Icon.ARROW_LEFT,
            _has_previous,
            _in_lesson,
        ),
    ]


def _readable(name: str) -> Lesson | None:
    """A lesson, or nothing when its files are broken: the others stay usable."""
    try:
        return load(name)
    except HelicoideError as error:
        log.warning("%s", error)
        return None


def _lesson(view: View) -> Lesson | None:
    return load(view.seat.lesson) if view.seat.lesson else None


def _in_lesson(view: View) -> bool:
    return view.seat.lesson is not None


def _has_next(view: View) -> bool:
    lesson = _lesson(view)
    return lesson is not None and view.seat.step + 1 < len(lesson.steps)


def _has_previous(view: View) -> bool:
    return _in_lesson(view) and view.seat.step > 0


def _hinted(seat: Seat) -> Seat:
    return replace(seat, hint_open=not seat.hint_open)


def _reset(view: View) -> Wish:
    lesson = _lesson(view)
    return ForArm(lesson.steps[view.seat.step].setup if lesson else lambda state: state)


def _turn(by: int) -> Callable[[View], Wish]:
    def wish(view: View) -> Wish:
        return ForSeat(lambda seat: replace(seat, step=seat.step + by, hint_open=False))

    return wish


def _step(view: View) -> str:
    lesson, language = _lesson(view), view.seat.language
    if lesson is None:
        free = Text(
            en="Drag the target in the scene, move the joints. Choose a lesson for a guided tour.",
            pt_BR="Arraste o alvo na cena, mova as juntas. Escolha uma lição para um passeio guiado.",
        )
        return f'<p class="helicoide-note">{free[language]}</p>'
    step = lesson.steps[view.seat.step]
    prose = lesson.prose[step.id]
    hint = f"<blockquote>{_markdown.render(prose.hint[language])}</blockquote>" if view.seat.hint_open else ""
    return (
        f'<div class="helicoide-lesson">{_dots(lesson, view.seat)}'
        f"<h3>{view.seat.step + 1}. {prose.title[language]}</h3>{_markdown.render(prose.body[language])}"
        f"{_verdict(lesson, view)}{hint}</div>"
    )


def _dots(lesson: Lesson, seat: Seat) -> str:
    marks = (
        f'<i class="{"done" if step.id in seat.done else ""}{" here" if k == seat.step else ""}"></i>'
        for k, step in enumerate(lesson.steps)
    )
    return f'<div class="helicoide-dots">{"".join(marks)}</div>'


def _verdict(lesson: Lesson, view: View) -> str:
    done = lesson.steps[view.seat.step].id in view.seat.done
    last = view.seat.step + 1 == len(lesson.steps)
    text = (ENDED if last else DONE) if done else TO_DO
    return f'<p class="helicoide-verdict {"done" if done else ""}">{"✓ " if done else ""}{text[view.seat.language]}</p>'
