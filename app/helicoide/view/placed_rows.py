"""Rows placed in a window: built once in its language, then updated with each view.

A row that raises is marked as failed; the others still work.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import Any, Protocol, TypeVar

import viser

from helicoide.text import Text
from helicoide.view import controls, html
from helicoide.view.chart_plot import ChartPlot
from helicoide.view.requests import Act, Ask, PageRequest
from helicoide.view.rows import (
    Bar,
    Button,
    ButtonGroup,
    Checkbox,
    DependentRows,
    Dropdown,
    Folder,
    HtmlRow,
    Plot,
    Row,
    Slider,
    TextEntry,
    Upload,
    VectorRow,
)
from helicoide.view.window_view import View

FAILED = Text(en="This row failed; see the terminal.", pt_BR="Esta linha falhou; veja o terminal.")
Done = TypeVar("Done")
log = logging.getLogger("helicoide")


class WindowRow(Protocol):
    """A row in a window."""

    def refresh(self, view: View) -> None:
        """Update the row to a view."""

    def remove(self) -> None:
        """Remove the row from the window."""


class _IsolatedRow:
    """A row whose errors do not reach other rows. The first one is logged, and a mark below the row is shown."""

    def __init__(self, gui: viser.GuiApi, row: Row, view: View, act: Act) -> None:
        self.row, self.act, self.failed = row, act, False
        self.mark: viser.GuiHtmlHandle | None = None
        self.placed = self._try(lambda: _pose_rows(gui, row, view, act, self._ask))
        self.mark = html.put_html(gui, html.note(FAILED[view.seat.language]), visible=self.failed)

    def _try(self, do: Callable[[], Done]) -> Done | None:
        """The result of `do`; None if it raises."""
        try:
            return do()
        except Exception:
            if not self.failed:
                log.exception("A row of a panel failed: %s.", type(self.row).__name__)
            self.failed = True
            if self.mark is not None:
                self.mark.visible = True
            return None

    def _ask(self, make: Callable[[], PageRequest | None]) -> None:
        request = self._try(make)
        if request is not None:
            self._try(partial(self.act, request))

    def refresh(self, view: View) -> None:
        if self.placed is not None:
            self._try(partial(self.placed.refresh, view))

    def remove(self) -> None:
        if self.placed is not None:
            self._try(self.placed.remove)
        if self.mark is not None:
            self.mark.remove()


class _Folder:
    """Rows under a heading; dependent rows are replaced when their key changes."""

    def __init__(self, gui: viser.GuiApi, row: Folder, view: View, act: Act) -> None:
        self.gui, self.row, self.act = gui, row, act
        rows = self._wanted(view)
        self.handle = gui.add_folder(row.label[view.seat.language], expand_by_default=row.open)
        self._fill(rows, view)

    def _wanted(self, view: View) -> Sequence[Row]:
        """The rows for a view; keeps the key of dependent rows."""
        rows = self.row.rows
        if not isinstance(rows, DependentRows):
            return rows
        self.key = rows.key(view)
        return rows.rows(self.key)

    def _fill(self, rows: Sequence[Row], view: View) -> None:
        with self.handle:
            self.rows = place_rows(self.gui, rows, view, self.act)

    def refresh(self, view: View) -> None:
        if isinstance(self.row.rows, DependentRows) and self.row.rows.key(view) != self.key:
            while self.rows:
                self.rows.pop().remove()
            self._fill(self._wanted(view), view)
        for row in self.rows:
            row.refresh(view)

    def remove(self) -> None:
        self.handle.remove()


class _Words:
    def __init__(self, gui: viser.GuiApi, row: HtmlRow, view: View) -> None:
        self.row = row
        self.handle = html.put_html(gui, self._html(view))

    def _html(self, view: View) -> str:
        return self.row.html(view) if view.ready or not self.row.computed else ""

    def refresh(self, view: View) -> None:
        html.show(self.handle, self._html(view))

    def remove(self) -> None:
        self.handle.remove()


class _Bar:
    def __init__(self, gui: viser.GuiApi, row: Bar, view: View) -> None:
        self.row = row
        percent, visible = self._shown(view)
        self.handle: Any = gui.add_progress_bar(percent, visible=visible)

    def _shown(self, view: View) -> tuple[float, bool]:
        """The percentage, and whether there is one."""
        share = self.row.share(view)
        return (0.0, False) if share is None else (round(100 * min(max(share, 0.0), 1.0)), True)

    def refresh(self, view: View) -> None:
        percent, visible = self._shown(view)
        if self.handle.visible != visible:
            self.handle.visible = visible
        if self.handle.value != percent:
            self.handle.value = percent

    def remove(self) -> None:
        self.handle.remove()


def place_rows(gui: viser.GuiApi, rows: Iterable[Row], view: View, act: Act) -> list[WindowRow]:
    """Build rows in the current container of the GUI, in the language of the view's seat."""
    return [_IsolatedRow(gui, row, view, act) for row in rows]


def _pose_rows(gui: viser.GuiApi, row: Row, view: View, act: Act, ask: Ask) -> WindowRow:
    match row:
        case HtmlRow():
            return _Words(gui, row, view)
        case Button():
            return controls.ButtonControl(gui, row, view, ask)
        case ButtonGroup():
            return controls.GroupControl(gui, row, view, ask)
        case Slider():
            return controls.slider(gui, row, view, ask)
        case Checkbox():
            return controls.checkbox(gui, row, view, ask)
        case Dropdown():
            return controls.ChoiceControl(gui, row, view, ask)
        case VectorRow():
            return controls.vector_boxes(gui, row, view, ask)
        case TextEntry():
            return controls.EntryControl(gui, row, view, ask)
        case Upload():
            return controls.UploadControl(gui, row, view, ask)
        case Bar():
            return _Bar(gui, row, view)
        case Plot():
            return ChartPlot(gui, row, view)
        case Folder():
            return _Folder(gui, row, view, act)
