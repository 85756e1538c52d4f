"""The prose of a lesson as HTML, with its formulas, and with its values as they are now."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.console import unit_grade, value_terms
from helicoide.geometry.multivector import Multivector
from helicoide.lesson import Lesson, Value, in_unit, measured_text, paragraphs, placeholders
from helicoide.lesson.values import needed_decimals
from helicoide.markup import prose_to_html
from helicoide.text import Language, rounded_text
from helicoide.view.formula import blade_words
from helicoide.view.rows import HtmlRow
from helicoide.view.window_view import View

WAITING = Markup("<b class='helicoide-value'>…</b>")
NUMBER = Markup("<b class='helicoide-value'>{}</b>")
# Not a table: that would end the paragraph in which the value stands.
MATRIX = Markup("<span class='helicoide-array'><span class='helicoide-brackets'>{}</span>{}</span>")
TUPLE = Markup("<span class='helicoide-value'>({}){}</span>")
SEPARATORS = {"en": ", ", "pt_BR": "; "}  # in Portuguese the comma is the decimal sign
ROW, CELL = Markup("<i>{}</i>"), Markup("<span>{}</span>")
SUM, TERM = Markup("<span class='helicoide-value'>{}</span>"), Markup("<span>{}{}{}</span>")
DECIMALS = 3  # of a multivector, unless an author has chosen


def prose_html(lesson: Lesson, text: str, view: View, inline: bool = False) -> Markup:
    """A text of a lesson. inline: without a paragraph around it."""
    pieces = prose_to_html(text, tuple(lesson.pictures.items()), inline)
    said = (_value(lesson.values[piece], view) if k % 2 else piece for k, piece in enumerate(pieces))
    return Markup("").join(said)


def prose_rows(lesson: Lesson, text: str) -> list[HtmlRow]:
    """A text as rows: a paragraph with values is a row of its own, so that only such paragraphs are written again."""
    return [_row(lesson, "\n\n".join(parts)) for parts in _grouped(paragraphs(text))]


def _row(lesson: Lesson, text: str) -> HtmlRow:
    return HtmlRow(lambda view: Markup('<div class="helicoide-lesson">{}</div>').format(prose_html(lesson, text, view)))


def _grouped(parts: Sequence[str]) -> list[list[str]]:
    """Paragraphs, with those together that follow each other and have no values."""
    groups = list[list[str]]()
    for part in parts:
        if groups and not placeholders(part) and not placeholders(groups[-1][0]):
            groups[-1].append(part)
        else:
            groups.append([part])
    return groups


def _value(value: Value, view: View) -> Markup:
    """What a placeholder stands for now; dots until the kernels are compiled."""
    if not view.ready:
        return WAITING
    read, language = value.read(view.state, view.seat), view.seat.language
    if isinstance(read, Multivector):
        return _sum(read, DECIMALS if value.decimals is None else value.decimals, language)
    if isinstance(read, np.ndarray) and read.ndim > 0:
        return _array(read, value, language)
    return NUMBER.format(measured_text(in_unit(float(read), value.unit), value.unit, value.decimals)[language])


def _array(numbers: Array, value: Value, language: Language) -> Markup:
    """An array of one row as (x, y), or (m, n) as a matrix, with the unit after it."""
    decimals = needed_decimals(value.unit, value.decimals)
    written = [
        [measured_text(in_unit(float(number), value.unit), "", decimals)[language] for number in row]
        for row in np.atleast_2d(numbers)
    ]
    unit = value.unit if value.unit in ("", "°") else f"\u202f{value.unit}"
    if len(written) == 1:
        return TUPLE.format(SEPARATORS[language].join(written[0]), unit)
    rows = (ROW.format(Markup(" ").join(map(CELL.format, row))) for row in written)
    return MATRIX.format(Markup("").join(rows), unit)


def _sum(multivector: Multivector, decimals: int, language: Language) -> Markup:
    """A multivector as a sum, which breaks between its terms."""
    terms = list[Markup]()
    for number, unit in value_terms(multivector):
        sign = "− " if number < 0 else "+ " if terms else ""
        shown = rounded_text(abs(number), decimals)[language]
        blade = "" if unit == "1" else f"\u2009{blade_words(unit)}"
        grade = Markup('<i class="g{}">{}</i>').format(unit_grade(unit), blade)
        terms.append(TERM.format(sign, shown, grade))
    return SUM.format(Markup(" ").join(terms) or "0")
