"""Take the inspected multivector along: as LaTeX, or as Python code that computes it again."""

from __future__ import annotations

from collections.abc import Callable

from viser import Icon

from helicoide.export.algebra_code import Formula, galaga_code, kingdon_code, latex_text
from helicoide.text import Text
from helicoide.view.inspector_rows import inspected
from helicoide.view.requests import Save
from helicoide.view.rows import Button, Folder, Row
from helicoide.view.term_rows import chain_shown
from helicoide.view.window_view import View

TITLE = Text(en="As LaTeX and code", pt_BR="Em LaTeX e código")
SAVE = Text(en="Save for {name}", pt_BR="Salvar para {name}")


def code_rows() -> Folder:
    """A button for each language."""
    rows: list[Row] = [
        _button("LaTeX", "multivector.tex", latex_text),
        _button("kingdon", "multivector_kingdon.py", kingdon_code),
        _button("galaga", "multivector_galaga.py", galaga_code),
    ]
    return Folder(TITLE, rows, open=False)


def _button(name: str, file: str, written: Callable[[Formula], str]) -> Button:
    return Button(
        lambda _: SAVE.format(name=name),
        lambda view: Save(file, written(_formula(view)).encode()),
        Icon.DOWNLOAD,
        lambda view: inspected(view) is not None,
    )


def _formula(view: View) -> Formula:
    element = inspected(view)
    assert element is not None, "the button is disabled without an inspected object"
    return Formula(element.nature, element.values(view.state), view.seat.notation, chain_shown(view))
