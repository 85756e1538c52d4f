"""A matrix of the state as it is now, as a table with the names of its rows and columns, as wide as the panel."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.readout.matrices import TITLES, NamedMatrix, named_matrix
from helicoide.text import Language, Text, significant_text
from helicoide.view import html
from helicoide.view.requests import ForSeat
from helicoide.view.rows import Dropdown, Folder, HtmlRow
from helicoide.view.settings import NONE
from helicoide.view.signal_rows import with_charts
from helicoide.view.window_view import View

TITLE, SHOWN = Text(en="Matrices", pt_BR="Matrizes"), Text(en="Matrix", pt_BR="Matriz")
UNDEFINED = Text(
    en="The current method and posture do not define this matrix. Θ and B appear once such a method moves the arm.",
    pt_BR="O método e a postura atuais não definem esta matriz. Θ e B aparecem quando um tal método move o braço.",
)
COLUMNS = Text(en="Columns {first} to {last}", pt_BR="Colunas {first} a {last}")
TABLE = Markup("<div class='helicoide-matrix{}'>{}<table>{}{}</table></div>")
CAPTION = Markup("<p>{}</p>")
POWER = Markup("10<sup>{}</sup> ×")
# A table has at most MOST_COLUMNS; one with more than FEW has smaller type (static/helicoide.css) and fewer decimals.
FEW, MOST_COLUMNS = 4, 7
DIGITS, LARGEST = 4, 9999.5  # larger entries would need more than four digits


def matrix_rows() -> Folder:
    """A table that is computed only while a matrix is chosen."""
    return Folder(
        TITLE,
        [
            Dropdown(
                SHOWN,
                [("", NONE), *TITLES.items()],
                lambda view: view.seat.charts.matrix,
                lambda name: ForSeat(lambda seat: with_charts(seat, matrix=name)),
            ),
            HtmlRow(matrix_table, computed=True),
        ],
    )


def matrix_table(view: View) -> Markup:
    """The chosen matrix; a note if the state does not define it."""
    name, language = view.seat.charts.matrix, view.seat.language
    if not name:
        return Markup("")
    matrix = named_matrix(view.state, name)
    if matrix is None:
        return html.note(UNDEFINED[language])
    return written_matrix(matrix, language) + html.note(matrix.note[language])


def written_matrix(matrix: NamedMatrix, language: Language) -> Markup:
    """The matrix in sets of columns that are as wide as the panel, each with the names of the rows."""
    count = len(matrix.columns)
    exponent = common_exponent(matrix.values) if count > 1 else 0
    sets = np.array_split(np.arange(count), -(-count // MOST_COLUMNS))
    return Markup("").join(_table(matrix, columns.tolist(), exponent, language) for columns in sets)


def _table(matrix: NamedMatrix, columns: Sequence[int], exponent: int, language: Language) -> Markup:
    count, power = len(columns), POWER.format(str(exponent).replace("-", "−")) if exponent else ""
    is_part = count < len(matrix.columns)
    said = COLUMNS.format(first=columns[0] + 1, last=columns[-1] + 1)[language] if is_part else ""
    names = [matrix.columns[k][language] for k in columns]
    head = Markup("<tr><th>{}</th>{}</tr>").format(power, _cells("th", names)) if any(names) else ""
    decimals = None if len(matrix.columns) == 1 else 4 if count <= FEW else 3
    body = Markup("").join(
        Markup("<tr><th>{}</th>{}</tr>").format(
            name[language], _cells("td", [entry_text(row[k] / 10.0**exponent, decimals, language) for k in columns])
        )
        for name, row in zip(matrix.rows, matrix.values, strict=True)
    )
    size = "" if count <= FEW else " many" if count < MOST_COLUMNS else " most"
    return TABLE.format(size, CAPTION.format(said) if said else "", head, body)


def _cells(kind: str, words: list[str]) -> Markup:
    cell = Markup("<th>{}</th>") if kind == "th" else Markup("<td>{}</td>")
    return Markup("").join(map(cell.format, words))


def common_exponent(values: Array) -> int:
    """The power of ten, a multiple of 3, that is taken out of a matrix whose largest entry is not 0.1 to 10 000."""
    largest = float(np.abs(values).max(initial=0.0))
    if not 0.0 < largest < math.inf or 0.1 <= largest < LARGEST:
        return 0
    return 3 * math.floor(math.log10(largest) / 3)


def entry_text(value: float, decimals: int | None, language: Language) -> str:
    """A number with four significant digits and at most so many decimals (None: any), and a minus sign.

    It is 0 if it is tiny beside 1.
    """
    value = 0.0 if abs(value) < 1e-12 else float(np.round(value, 12 if decimals is None else decimals)) + 0.0
    return significant_text(value, DIGITS)[language]
