"""Rows placed in a window: built once in its language, then kept in step with the view.

A control that a person has just touched is left alone for a moment, so that it is never pulled from under their hand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from time import monotonic
from typing import Any, Protocol

import viser
from viser import Icon

from helicoide.text import Text
from helicoide.view import bind
from helicoide.view.plotted import Plotted
from helicoide.view.rows import (
    Act,
    Bar,
    Button,
    Changing,
    Choice,
    Entry,
    Folder,
    Plot,
    Row,
    Slider,
    Tick,
    Triple,
    Upload,
    View,
    Words,
)

UNTOUCHED = 0.7


class Placed(Protocol):
    """A row in a window."""

    def refresh(self, view: View) -> None:
        """Show what the view says now."""

    def remove(self) -> None:
        """Take it out of the window."""


class _Folder:
    """Rows under a heading; those that change with the view are placed anew when their key does."""

    def __init__(self, gui: viser.GuiApi, row: Folder, view: View, act: Act) -> None:
        self.gui, self.row, self.act = gui, row, act
        self.handle = gui.add_folder(row.label[view.seat.language], expand_by_default=row.open)
        self.rows: list[Placed] = []
        self._fill(view)

    def _fill(self, view: View) -> None:
        for row in self.rows:
            row.remove()
        rows = self.row.rows
        if isinstance(rows, Changing):
            self.key = rows.key(view)
            rows = rows.rows(self.key)
        with self.handle:
            self.rows = place(self.gui, rows, view, self.act)

    def refresh(self, view: View) -> None:
        if isinstance(self.row.rows, Changing) and self.row.rows.key(view) != self.key:
            self._fill(view)
        for row in self.rows:
            row.refresh(view)

    def remove(self) -> None:
        self.handle.remove()


class _Words:
    def __init__(self, gui: viser.GuiApi, row: Words, view: View) -> None:
        self.row = row
        self.handle = gui.add_html("")
        self.refresh(view)

    def refresh(self, view: View) -> None:
        html = self.row.html(view) if view.ready or not self.row.computed else ""
        if html != self.handle.content:
            self.handle.content = html

    def remove(self) -> None:
        self.handle.remove()


class _Entry:
    def __init__(self, gui: viser.GuiApi, row: Entry, view: View, act: Act) -> None:
        self.row, language = row, view.seat.language
        self.said = row.shown(view)
        self.text: Any = gui.add_text(row.label[language], self.said)
        self.button = gui.add_button(row.button[language])
        bind.on_press(self.button, lambda: act(row.wish(self.text.value)))

    def refresh(self, view: View) -> None:
        """What is typed stays until the view says something else than before."""
        said = self.row.shown(view)
        if said != self.said:
            self.said = self.text.value = said

    def remove(self) -> None:
        self.text.remove()
        self.button.remove()


class _Upload:
    def __init__(self, gui: viser.GuiApi, row: Upload, view: View, act: Act) -> None:
        self.handle = gui.add_upload_button(row.label[view.seat.language], icon=Icon.UPLOAD)
        bind.on_upload(self.handle, lambda name, content: act(row.wish(name, content)))

    def refresh(self, view: View) -> None:
        pass

    def remove(self) -> None:
        self.handle.remove()


class _Bar:
    def __init__(self, gui: viser.GuiApi, row: Bar, view: View) -> None:
        self.row = row
        self.handle: Any = gui.add_progress_bar(0.0, visible=False)
        self.refresh(view)

    def refresh(self, view: View) -> None:
        share = self.row.share(view)
        percent = 0.0 if share is None else round(100 * min(max(share, 0.0), 1.0))
        if self.handle.visible != (share is not None):
            self.handle.visible = share is not None
        if self.handle.value != percent:
            self.handle.value = percent

    def remove(self) -> None:
        self.handle.remove()


class _Control:
    """A control with a value: written when it differs, unless it was touched a moment ago; deaf while disabled."""

    def __init__(
        self,
        handle: Any,
        value: Callable[[View], Any],
        wish: Callable[[Any], None],
        enabled: Callable[[View], bool],
        view: View,
        label: Callable[[View], str] | None = None,
    ) -> None:
        self.handle, self.value, self.enabled, self.view, self.label = handle, value, enabled, view, label
        self.touched = 0.0
        handle.disabled = not enabled(view)

        def act(given: Any) -> None:
            self.touched = monotonic()
            if self.enabled(self.view):
                wish(given)

        bind.on_value(handle, act)

    def refresh(self, view: View) -> None:
        self.view = view
        disabled = not self.enabled(view)
        if disabled != self.handle.disabled:
            self.handle.disabled = disabled
        if self.label is not None and self.label(view) != self.handle.label:
            self.handle.label = self.label(view)
        value = self.value(view)
        if value != self.handle.value and monotonic() - self.touched > UNTOUCHED:
            self.handle.value = value

    def remove(self) -> None:
        self.handle.remove()


class _Button:
    def __init__(self, gui: viser.GuiApi, row: Button, view: View, act: Act) -> None:
        self.row, self.view = row, view
        self.handle = gui.add_button(row.label(view)[view.seat.language], icon=row.icon)

        def pressed() -> None:
            if row.enabled(self.view):
                act(row.wish(self.view))

        bind.on_press(self.handle, pressed)
        self.refresh(view)

    def refresh(self, view: View) -> None:
        self.view = view
        row, handle = self.row, self.handle
        for name, value in (
            ("label", row.label(view)[view.seat.language]),
            ("disabled", not row.enabled(view)),
            ("visible", row.shown(view)),
        ):
            if value != getattr(handle, name):
                setattr(handle, name, value)

    def remove(self) -> None:
        self.handle.remove()


def _slider(gui: viser.GuiApi, row: Slider, view: View, act: Act) -> Placed:
    def value(view: View) -> float:
        steps = round((row.value(view) - row.lower) / row.step)
        return round(min(max(row.lower + steps * row.step, row.lower), row.upper), 6)

    def label(view: View) -> str:
        text = row.label if isinstance(row.label, Text) else row.label(view)
        return text[view.seat.language]

    handle = gui.add_slider(label(view), row.lower, row.upper, row.step, value(view))
    return _Control(handle, value, lambda given: act(row.wish(given)), row.enabled, view, label)


def _tick(gui: viser.GuiApi, row: Tick, view: View, act: Act) -> Placed:
    handle = gui.add_checkbox(row.label[view.seat.language], row.value(view))
    return _Control(handle, row.value, lambda given: act(row.wish(given)), lambda _: True, view)


class _Choice(_Control):
    """A list to choose from, which shows what can be chosen now."""

    def __init__(self, gui: viser.GuiApi, row: Choice, view: View, act: Act) -> None:
        self.row = row
        words = self._words(view)
        handle = gui.add_dropdown(
            row.label[view.seat.language], tuple(words.values()), initial_value=words[row.value(view)]
        )
        self.act = act
        super().__init__(handle, lambda view: self._words(view)[row.value(view)], self._wish, lambda _: True, view)

    def _words(self, view: View) -> dict[str, str]:
        options = self.row.options
        known = options(view) if callable(options) else options
        return {key: text[view.seat.language] for key, text in known}

    def _wish(self, word: str) -> None:
        keys = {word: key for key, word in self._words(self.view).items()}
        if word in keys:
            self.act(self.row.wish(keys[word]))

    def refresh(self, view: View) -> None:
        """Show what can be chosen, and what is."""
        words = tuple(self._words(view).values())
        if words != self.handle.options:
            self.handle.options = words
        super().refresh(view)


def _triple(gui: viser.GuiApi, row: Triple, view: View, act: Act) -> Placed:
    handle = gui.add_vector3(row.label[view.seat.language], row.value(view), step=row.step)

    def wish(given: tuple[float, float, float]) -> None:
        act(row.wish(placed.view, given))

    placed = _Control(handle, row.value, wish, lambda _: True, view)
    return placed


def place(gui: viser.GuiApi, rows: Iterable[Row], view: View, act: Act) -> list[Placed]:
    """Build rows where the GUI stands, in the language of the view's seat."""
    return [_placed(gui, row, view, act) for row in rows]


def _placed(gui: viser.GuiApi, row: Row, view: View, act: Act) -> Placed:
    match row:
        case Words():
            return _Words(gui, row, view)
        case Button():
            return _Button(gui, row, view, act)
        case Slider():
            return _slider(gui, row, view, act)
        case Tick():
            return _tick(gui, row, view, act)
        case Choice():
            return _Choice(gui, row, view, act)
        case Triple():
            return _triple(gui, row, view, act)
        case Entry():
            return _Entry(gui, row, view, act)
        case Upload():
            return _Upload(gui, row, view, act)
        case Bar():
            return _Bar(gui, row, view)
        case Plot():
            return Plotted(gui, row, view)
        case Folder():
            return _Folder(gui, row, view, act)
