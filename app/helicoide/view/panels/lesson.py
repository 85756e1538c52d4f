"""The choice of a lesson, and the rows of one step: text, verdict, hint, reset, next and previous step."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from dataclasses import replace

from markupsafe import Markup
from viser import Icon

from helicoide import content
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Lesson, Prose, entered, load_lesson
from helicoide.markup import markdown_to_html
from helicoide.seat import Seat
from helicoide.text import HelicoideError, Text
from helicoide.view import html
from helicoide.view.panels.robot import joint_row
from helicoide.view.progress_rows import progress_rows
from helicoide.view.requests import ForArm, ForSeat, PageRequest
from helicoide.view.rows import Button, Dropdown, HtmlRow, Row
from helicoide.view.window_view import View

TITLE = Text(en="Lesson", pt_BR="Lição")
ORDER = 0
ICON = Icon.SCHOOL

FREE = Text(en="Explore freely", pt_BR="Exploração livre")
DONE = Text(en="Done. Go to the next step.", pt_BR="Feito. Vá para o próximo passo.")
ENDED = Text(
    en="Lesson complete.",
    pt_BR="Lição concluída.",
)
TO_DO = Text(en="Step not completed yet.", pt_BR="Passo ainda não concluído.")

log = logging.getLogger("helicoide")


def rows(robot: Robot) -> list[Row]:
    """The panel for one robot."""
    return [
        Dropdown(
            Text(en="Lesson", pt_BR="Lição"),
            [("", FREE), *((lesson.id, lesson.title) for lesson in lessons())],
            lambda view: view.seat.lesson or "",
            lambda name: ForSeat(lambda seat: entered(seat, name or None)),
        ),
        HtmlRow(_free),
        progress_rows(lessons),
    ]


def lessons() -> list[Lesson]:
    """Every lesson whose files can be read."""
    return [lesson for name in content.content_folders("lessons") if (lesson := _readable(name))]


def first_lesson() -> ForSeat:
    """The request that begins the first lesson, or leaves the seat as it is if there is none."""
    first = next(iter(lessons()), None)
    return ForSeat(lambda seat: seat if first is None else entered(seat, first.id))


def _readable(name: str) -> Lesson | None:
    """A lesson, or None if its files are broken, so that the others stay usable."""
    try:
        return load_lesson(name)
    except HelicoideError as error:
        log.warning("%s", error)
        return None


def _lesson(view: View) -> Lesson | None:
    return load_lesson(view.seat.lesson) if view.seat.lesson else None


def _in_lesson(view: View) -> bool:
    return view.seat.lesson is not None


def _has_next(view: View) -> bool:
    lesson = _lesson(view)
    return lesson is not None and view.seat.step + 1 < len(lesson.steps)


def _has_previous(view: View) -> bool:
    return _in_lesson(view) and view.seat.step > 0


def _hinted(seat: Seat) -> Seat:
    return replace(seat, hint_open=not seat.hint_open)


def _reset(view: View) -> PageRequest:
    lesson = _lesson(view)
    return ForArm(lesson.steps[view.seat.step].setup if lesson else lambda state: state)


def _turn(by: int) -> Callable[[View], PageRequest]:
    def request(view: View) -> PageRequest:
        return ForSeat(lambda seat: replace(seat, step=seat.step + by, hint_open=False))

    return request


def _free(view: View) -> Markup:
    """What can be done without a lesson."""
    free = Text(
        en="Drag the target in the scene or move the joints. Choose a lesson for step-by-step tasks.",
        pt_BR="Arraste o alvo na cena ou mova as juntas. Escolha uma lição para tarefas passo a passo.",
    )
    return Markup("") if _in_lesson(view) else html.note(free[view.seat.language])


def step_rows(robot: Robot, joints: Sequence[int]) -> list[Row]:
    """The rows of a step: its text, the joints that it needs, hint, reset, next and previous step."""
    return [
        HtmlRow(_step),
        *(joint_row(robot, index) for index in joints),
        Button(lambda _: Text(en="Hint", pt_BR="Dica"), lambda _: ForSeat(_hinted), Icon.BULB),
        Button(lambda _: Text(en="Reset step", pt_BR="Reiniciar o passo"), _reset, Icon.REFRESH),
        Button(
            lambda _: Text(en="Next step", pt_BR="Próximo passo"),
            _turn(1),
            Icon.ARROW_RIGHT,
            _has_next,
            weight="primary",
        ),
        Button(lambda _: Text(en="Previous step", pt_BR="Passo anterior"), _turn(-1), Icon.ARROW_LEFT, _has_previous),
    ]


def _step(view: View) -> Markup:
    lesson, language = _lesson(view), view.seat.language
    if lesson is None:
        return Markup("")
    step = lesson.steps[view.seat.step]
    prose = lesson.prose[step.id]
    return Markup('<div class="helicoide-lesson">{}<h3>{}. {}</h3>{}{}{}</div>').format(
        _dots(lesson, view.seat),
        view.seat.step + 1,
        prose.title[language],
        markdown_to_html(prose.body[language]),
        _verdict(lesson, view),
        _hint(prose, view),
    )


def _hint(prose: Prose, view: View) -> Markup:
    if not view.seat.hint_open:
        return Markup("")
    return Markup("<blockquote>{}</blockquote>").format(markdown_to_html(prose.hint[view.seat.language]))


def _dots(lesson: Lesson, seat: Seat) -> Markup:
    marks = (
        Markup('<i class="{}{}"></i>').format("done" if step.id in seat.done else "", " here" if k == seat.step else "")
        for k, step in enumerate(lesson.steps)
    )
    return Markup('<div class="helicoide-dots">{}</div>').format(Markup("").join(marks))


def _verdict(lesson: Lesson, view: View) -> Markup:
    done = lesson.steps[view.seat.step].id in view.seat.done
    last = view.seat.step + 1 == len(lesson.steps)
    text = (ENDED if last else DONE) if done else TO_DO
    return Markup('<p class="helicoide-verdict {}">{}{}</p>').format(
        "done" if done else "", "✓ " if done else "", text[view.seat.language]
    )
