"""A matrix of the state as it is now, as a table with the names of its rows and columns."""

from __future__ import annotations

import numpy as np
from markupsafe import Markup

from helicoide.readout.matrices import TITLES, NamedMatrix, named_matrix
from helicoide.text import Language, Text, number_text
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
TABLE = Markup("<div class='helicoide-matrix'><table>{}{}</table></div>")


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
    return _written(matrix, language) + html.note(matrix.note[language])


def _written(matrix: NamedMatrix, language: Language) -> Markup:
    head = Markup("<tr><th></th>{}</tr>").format(_cells("th", [name[language] for name in matrix.columns]))
    body = Markup("").join(
        Markup("<tr><th>{}</th>{}</tr>").format(name[language], _cells("td", [entry_text(v, language) for v in row]))
        for name, row in zip(matrix.rows, matrix.values, strict=True)
    )
    return TABLE.format(head if any(name.en for name in matrix.columns) else "", body)


def _cells(kind: str, words: list[str]) -> Markup:
    cell = Markup("<th>{}</th>") if kind == "th" else Markup("<td>{}</td>")
    return Markup("").join(map(cell.format, words))


def entry_text(value: float, language: Language) -> str:
    """A number with four significant digits, and a minus sign; 0 if it is tiny beside 1."""
    value = 0.0 if abs(value) < 1e-12 else float(np.round(value, 12))
    return number_text(value, ".4g")[language].replace("-", "−")
