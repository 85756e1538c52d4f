"""What the buttons within the text of a lesson do: `layer:twist` shows a layer, `answer:1` gives an answer."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from helicoide import studies
from helicoide.console import example_sheets
from helicoide.lesson import all_lessons, answered, entered
from helicoide.lesson.links import ProseLink, parsed_link
from helicoide.seat import Seat
from helicoide.studies import panel_state
from helicoide.view import layers, panels
from helicoide.view.open_step import open_step
from helicoide.view.requests import ForSeat, ForStudyPanel, PageRequest, ShowTab

LONGEST = 100


def requests_of(target: object) -> tuple[PageRequest, ...]:
    """The requests of a button, by its `data-go` as a page sends it; none if it is unknown."""
    if not isinstance(target, str) or len(target) > LONGEST:
        return ()
    link = parsed_link(target)
    if link is not None:
        return _followed(link)
    kind, _, number = target.partition(":")
    if not (number.isascii() and number.isdigit()):
        return ()
    match kind:
        case "answer":
            return (ForSeat(lambda seat: with_answer(seat, (float(number),))),)
        case "up" | "down":
            return (ForSeat(partial(with_option_moved, option=int(number), by=-1 if kind == "up" else 1)),)
        case _:
            return ()


def with_answer(seat: Seat, given: tuple[float, ...]) -> Seat:
    """The seat with an answer to the prediction of the open step."""
    opened = open_step(seat)
    return seat if opened is None else answered(opened.lesson, seat, given)


def option_order(seat: Seat, n: int) -> tuple[float, ...]:
    """The order of n options as a person has arranged them so far."""
    draft = seat.draft or ()
    return draft if sorted(draft) == list(range(n)) else tuple(map(float, range(n)))


def with_option_moved(seat: Seat, option: int, by: int) -> Seat:
    """The seat with one option of the open step moved up (−1) or down (1)."""
    opened = open_step(seat)
    order = list(option_order(seat, 0 if opened is None else len(opened.prose.options)))
    if option not in order or not 0 <= (at := order.index(option)) + by < len(order):
        return seat
    order[at], order[at + by] = order[at + by], order[at]
    return replace(seat, draft=tuple(order))


def _followed(link: ProseLink) -> tuple[PageRequest, ...]:
    match link.kind:
        case "layer" if link.name in (layer.NAME for layer in layers.optional()):
            return (ForSeat(lambda seat: seat.with_layer(link.name, True)),)
        case "sheet" if link.name in example_sheets():
            sheet = example_sheets()[link.name].sheet
            return ForSeat(lambda seat: replace(seat, sheet=sheet)), ShowTab(panels.panel_names().index("algebra"))
        case "study" if link.name in studies.study_names():
            chosen = ForStudyPanel(panel_state.with_study(link.name))
            return chosen, ShowTab(panels.panel_names().index("study"))
        case "tab" if link.name in panels.panel_names():
            return (ShowTab(panels.panel_names().index(link.name)),)
        case "lesson" if link.name in (lesson.id for lesson in all_lessons()):
            return (ForSeat(partial(entered, name=link.name)),)
        case _:
            return ()
