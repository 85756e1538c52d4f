"""A table of the instruments of a method and of the method that it is compared with."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from markupsafe import Markup

from helicoide.ik.methods import named
from helicoide.readout import Instrument, counted_names, instruments, limiting, near_singular
from helicoide.state import State
from helicoide.text import Language, Text, significant_text
from helicoide.view import html
from helicoide.view.formula import formula_html
from helicoide.view.window_view import View


def instrument_table(view: View) -> Markup:
    """The equation of the method, and a table of its instruments and those of the compared method."""
    arms = [state for state in (view.state, view.state.compared_state) if state is not None]
    columns = [{instrument.symbol: instrument for instrument in instruments(state)} for state in arms]
    lines = {symbol: instrument for column in columns for symbol, instrument in column.items()}
    head = _cells(
        Markup("<th>{}</th>"), (named(state.request.controller.method).TITLE[view.seat.language] for state in arms)
    )
    body = Markup("").join(
        Markup("<tr><td>{}<span>{}</span></td>{}</tr>").format(
            formula_html(_tex(symbol)),
            instrument.title[view.seat.language],
            _cells(VALUE, (_read(column.get(symbol), view.seat.language) for column in columns)),
        )
        for symbol, instrument in lines.items()
    )
    table = Markup("<table class='helicoide-instruments'><tr><th></th>{}</tr>{}<tr><td>{}</td>{}</tr></table>{}")
    held = _cells(VALUE, (_limited_by(state, view) for state in arms))
    notes = Markup("").join([_counted(view), *_singular(view)])
    return formula_html(named(view.state.request.controller.method).EQUATION) + table.format(
        head, body, HELD[view.seat.language], held, notes
    )


COUNTED = Text(en="J: {rows}", pt_BR="J: {rows}")


SINGULAR = Text(en="Singularity: {said}.", pt_BR="Singularidade: {said}.")
OF_SEVERAL = Text(en="Singularity ({method}): {said}.", pt_BR="Singularidade ({method}): {said}.")


def _singular(view: View) -> Iterator[Markup]:
    """Notes on a singularity or a near one of each arm; with two arms, each with its method."""
    for state in (view.state, view.state.compared_state):
        said = None if state is None else near_singular(state)
        if state is not None and said is not None:
            words = SINGULAR if view.state.compared is None else OF_SEVERAL
            title = named(state.request.controller.method).TITLE
            yield html.note(words.format(method=title, said=said)[view.seat.language])


def _counted(view: View) -> Markup:
    """A note with the task rows to which the numbers refer; empty if there are none."""
    rows = counted_names(view.state)
    return html.note(COUNTED.format(rows=rows)[view.seat.language]) if rows else Markup("")


def _cells(cell: Markup, words: Iterable[str]) -> Markup:
    return Markup("").join(map(cell.format, words))


VALUE = Markup("<td>{}</td>")
ROUNDING = 1e-12  # a smaller value is lost in rounding, such as σ in a singular posture
HELD = Text(en="limited by", pt_BR="limitado por")


def _tex(symbol: str) -> str:
    """A symbol such as dt_max in TeX, with its whole index as subscript."""
    return re.sub(r"_(\w{2,})", r"_{\\mathrm{\1}}", symbol)


def _read(instrument: Instrument | None, language: Language) -> str:
    if instrument is None:
        return "–"
    value = round(instrument.value, 4) if instrument.unit in ("mm", "°") else instrument.value
    value = 0.0 if abs(value) < ROUNDING else value
    return f"{significant_text(value, 4)[language]} {instrument.unit}"


def _limited_by(state: State, view: View) -> str:
    return Markup("<br>").join(text[view.seat.language] for text in limiting(state)) or "–"
