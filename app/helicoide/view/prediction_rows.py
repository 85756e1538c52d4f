"""The rows of a prediction: its question, the way to answer it, and, once it is time, what is right."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from markupsafe import Markup

from helicoide.lesson import Choice, Estimate, Mark, Order, measured_text, right_answer
from helicoide.seat import Seat
from helicoide.text import HelicoideError, Text, numbers_text, untranslated
from helicoide.view.open_step import OpenStep, open_step
from helicoide.view.prose_html import prose_html
from helicoide.view.prose_links import option_order, with_answer
from helicoide.view.requests import ForSeat, PageRequest
from helicoide.view.rows import Button, HtmlRow, Row, TextEntry, VectorRow
from helicoide.view.window_view import View

PREDICTION, ANSWER = Text(en="Prediction", pt_BR="Previsão"), Text(en="Answer", pt_BR="Responder")
ESTIMATE = Text(en="Your estimate", pt_BR="Sua estimativa")
ESTIMATE_IN = Text(en="Your estimate [{unit}]", pt_BR="Sua estimativa [{unit}]")
MARKED = Text(en="Marked point [mm]", pt_BR="Ponto marcado [mm]")
POINT = untranslated("({numbers}) mm")
YOURS = Text(en="Your answer: {given}.", pt_BR="Sua resposta: {given}.")
RIGHT = Text(en="Your prediction was right.", pt_BR="Sua previsão estava certa.")
WRONG = Text(
    en="Not what happens, and good to know: here is why.", pt_BR="Não é o que acontece, e é bom saber: veja por quê."
)
IS_RIGHT = Text(en="Right is {right}.", pt_BR="O certo é {right}.")
LATER = Text(
    en="Recorded. What is right is shown when the step is done.",
    pt_BR="Anotado. O certo aparece quando o passo estiver concluído.",
)
NO_NUMBER = Text(
    en="{given!r} is no number; type one such as 12.5", pt_BR="{given!r} não é número; digite um como 12,5"
)
UP, DOWN = Text(en="Move up", pt_BR="Subir"), Text(en="Move down", pt_BR="Descer")

ABOVE = 0.2  # height of the marker above the end effector, as a share of the reach
BOX = Markup('<div class="helicoide-lesson helicoide-prediction"><b>{}</b>{}{}</div>')
OPTIONS = Markup('<ol class="helicoide-options">{}</ol>')
OPTION = Markup('<li><button type="button" class="helicoide-go" data-go="answer:{}">{}</button></li>')
GIVEN = Markup('<li class="{}">{}{}</li>')
MOVED = Markup(
    '<li>{}<button type="button" class="helicoide-go" data-go="up:{}" aria-label="{}">↑</button>'
    '<button type="button" class="helicoide-go" data-go="down:{}" aria-label="{}">↓</button></li>'
)
PARAGRAPH = Markup("<p>{}</p>")


def prediction_rows(opened: OpenStep) -> list[Row]:
    """The question, and what it needs to be answered: nothing more once it is answered."""
    rows: list[Row] = [HtmlRow(_question)]
    if opened.answer is not None:
        return rows
    match opened.step.prediction:
        case Estimate(unit=unit):
            label = ESTIMATE_IN.format(unit=unit) if unit else ESTIMATE
            return [*rows, TextEntry(label, lambda _: "", ANSWER, lambda text: ForSeat(partial(_estimated, text=text)))]
        case Mark():
            return [*rows, VectorRow(MARKED, 1.0, _marker, _moved), Button(lambda _: ANSWER, _placed)]
        case Order():
            return [*rows, Button(lambda _: ANSWER, _ordered)]
        case _:
            return rows


def reveal_row() -> HtmlRow:
    """What is right, and why, once it is revealed."""
    return HtmlRow(_reveal)


def marker_place(view: View) -> tuple[float, float, float]:
    """Where the marker of a prediction is, (3,) m, world frame: at first above the end effector and its target."""
    if view.seat.draft is not None:
        x, y, z = view.seat.draft
    else:
        x, y, z = view.state.T_world_tool[:3, 3].tolist()
        z += ABOVE * view.state.robot.reach
    return x, y, z


def _question(view: View) -> Markup:
    opened = open_step(view.seat)
    if opened is None:
        return Markup("")
    said = prose_html(opened.lesson, opened.prose.question[view.seat.language], view)
    return BOX.format(PREDICTION[view.seat.language], said, _options(opened, view))


def _options(opened: OpenStep, view: View) -> Markup:
    """The options: as buttons or with arrows before the answer, with marks after it."""
    language, prediction, answer = view.seat.language, opened.step.prediction, opened.answer
    said = [prose_html(opened.lesson, option[language], view, inline=True) for option in opened.prose.options]
    match prediction:
        case Choice() if answer is None:
            return OPTIONS.format(Markup("").join(OPTION.format(k, option) for k, option in enumerate(said)))
        case Choice(right):
            given = [int(number) for number in answer.given] if answer is not None else []
            shown = None if answer is None or answer.right is None else right
            return OPTIONS.format(Markup("").join(_marked(said, given, shown)))
        case Order() if answer is None:
            order = map(int, option_order(view.seat, len(said)))
            items = (MOVED.format(said[k], k, UP[language], k, DOWN[language]) for k in order)
            return OPTIONS.format(Markup("").join(items))
        case Order():
            order = map(int, answer.given if answer is not None else ())
            return OPTIONS.format(Markup("").join(GIVEN.format("", "", said[k]) for k in order))
        case _:
            return Markup("")


def _marked(options: Sequence[Markup], given: Sequence[int], right: int | None) -> Iterable[Markup]:
    """The options, with the given one and, if it is known, the right one marked."""
    for k, option in enumerate(options):
        kind = " ".join((["given"] if k in given else []) + (["right"] if k == right else []))
        yield GIVEN.format(kind, "✓ " if k == right else "• " if k in given else "", option)


def _reveal(view: View) -> Markup:
    opened = open_step(view.seat)
    if opened is None or opened.answer is None:
        return Markup("")
    language = view.seat.language
    if opened.answer.right is None:
        return BOX.format("", PARAGRAPH.format(LATER[language]), "")
    head = (RIGHT if opened.answer.right else WRONG)[language]
    said = PARAGRAPH.format(" ".join(text[language] for text in _measured(opened, view)))
    return BOX.format(head, said, prose_html(opened.lesson, opened.prose.reveal[language], view))


def _measured(opened: OpenStep, view: View) -> list[Text]:
    """What was given and what is right, in numbers; in the order of the options, for an order."""
    prediction, answer = opened.step.prediction, opened.answer
    if answer is None or prediction is None:
        return []
    match prediction:
        case Estimate(unit=unit):
            (right,), (given,) = right_answer(prediction, view.state, view.seat), answer.given
            decimals = 0 if abs(right) >= 100 else 1 if abs(right) >= 10 else 2
            texts = [measured_text(number, unit, decimals) for number in (given, right)]
        case Mark():
            points = answer.given, right_answer(prediction, view.state, view.seat)
            texts = [POINT.format(numbers=numbers_text((1e3 * number for number in point), ".0f")) for point in points]
        case Order(right=order):
            language = view.seat.language
            named = " → ".join(opened.prose.options[k][language] for k in order)
            return [IS_RIGHT.format(right=untranslated(named))]
        case _:
            return []
    return [YOURS.format(given=texts[0]), IS_RIGHT.format(right=texts[1])]


def _estimated(seat: Seat, text: str) -> Seat:
    """The seat with a typed number as the answer. Raises HelicoideError if it is none."""
    try:
        number = float(text.strip().replace("−", "-").replace(",", "."))
    except ValueError as error:
        raise HelicoideError(NO_NUMBER.format(given=text[:40])) from error
    return with_answer(seat, (number,))


def _marker(view: View) -> tuple[float, float, float]:
    x, y, z = (round(1e3 * number) for number in marker_place(view))
    return x, y, z


def _moved(view: View, given: tuple[float, float, float]) -> PageRequest:
    place = tuple(1e-3 * number for number in given)
    return ForSeat(lambda seat: replace(seat, draft=place) if np.all(np.isfinite(place)) else seat)


def _placed(view: View) -> PageRequest:
    return ForSeat(lambda seat: with_answer(seat, marker_place(replace(view, seat=seat))))


def _ordered(view: View) -> PageRequest:
    def arranged(seat: Seat) -> Seat:
        opened = open_step(seat)
        return seat if opened is None else with_answer(seat, option_order(seat, len(opened.prose.options)))

    return ForSeat(arranged)
