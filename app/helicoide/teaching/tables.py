"""Tables and matrices of a notebook as HTML."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.text import Language, rounded_text

DECIMALS = 4
NUMBER = Markup('<td style="text-align:right">{}</td>')
MATRIX = Markup('<table style="border-left:1px solid;border-right:1px solid">{}</table>')


def decimal_text(value: float, decimals: int, language: Language) -> str:
    """A number with its decimals, without a minus before a zero."""
    return rounded_text(value, decimals)[language]


def table(heads: Iterable[str], rows: Iterable[Sequence[str]]) -> Markup:
    """A table as HTML; plain strings in it are shown as text."""
    return Markup("<table><thead>{}</thead><tbody>{}</tbody></table>").format(
        _row(Markup("<th>{}</th>"), heads), Markup("").join(_row(Markup("<td>{}</td>"), row) for row in rows)
    )


def matrix(values: Array, language: Language) -> Markup:
    """The numbers (k,) or (k, m) between two vertical lines."""
    rows = ([decimal_text(float(x), DECIMALS, language) for x in row] for row in np.atleast_2d(values))
    return MATRIX.format(Markup("").join(_row(NUMBER, row) for row in rows))


def _row(cell: Markup, words: Iterable[str]) -> Markup:
    return Markup("<tr>{}</tr>").format(Markup("").join(cell.format(word) for word in words))
