"""The rows that make requests, as controls of viser.

A control is not written for `UNTOUCHED` seconds after the user changed it. Each control computes all that it shows
before it is added, so that a row that raises adds nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import partial
from time import monotonic
from typing import Any, Literal

import viser
from viser import Icon

from helicoide.text import Text
from helicoide.view import bind
from helicoide.view.requests import Ask, PageRequest
from helicoide.view.rows import (
    Button,
    ButtonGroup,
    Checkbox,
    Dropdown,
    Slider,
    TextEntry,
    Upload,
    VectorRow,
    Weight,
    always,
)
from helicoide.view.window_view import View

UNTOUCHED = 0.7
# Colours of viser, by which static/panel.css recognizes the weight of a button.
COLOURS: dict[Weight, Literal["blue", "gray", "red"]] = {"primary": "blue", "plain": "gray", "destructive": "red"}


@dataclass(frozen=True)
class Binding:
    """What a control shows of a view, and the request that a change of its value makes.

    label: None for one that does not change.
    """

    value: Callable[[View], Any]
    request: Callable[[Any], PageRequest | None]
    enabled: Callable[[View], bool] = always
    label: Callable[[View], str] | None = None


class ValueControl:
    """A control with a value. It is written when it differs, but not just after the user changed it.

    While it is disabled, it makes no requests.
    """

    def __init__(self, handle: Any, binding: Binding, view: View, ask: Ask) -> None:
        self.handle, self.binding, self.view = handle, binding, view
        self.touched = 0.0

        def touched(given: Any) -> None:
            self.touched = monotonic()
            ask(lambda: binding.request(given) if binding.enabled(self.view) else None)

        bind.on_value(handle, touched)

    def refresh(self, view: View) -> None:
        """Update the control to a view."""
        self.view = view
        disabled = not self.binding.enabled(view)
        if disabled != self.handle.disabled:
            self.handle.disabled = disabled
        label = self.binding.label
        if label is not None and label(view) != self.handle.label:
            self.handle.label = label(view)
        value = self.binding.value(view)
        if value != self.handle.value and monotonic() - self.touched > UNTOUCHED:
            self.handle.value = value

    def remove(self) -> None:
        """Remove the control from the window."""
        self.handle.remove()


class ButtonControl:
    """A button. While it is disabled or hidden, it makes no requests."""

    def __init__(self, gui: viser.GuiApi, row: Button, view: View, ask: Ask) -> None:
        self.row, self.view = row, view
        self.handle = gui.add_button(icon=row.icon, color=COLOURS[row.weight], **self._shown(view))

        def pressed() -> PageRequest | None:
            return row.request(self.view) if row.enabled(self.view) and row.shown(self.view) else None

        bind.on_press(self.handle, lambda: ask(pressed))

    def _shown(self, view: View) -> dict[str, Any]:
        row = self.row
        return {
            "label": row.label(view)[view.seat.language],
            "disabled": not row.enabled(view),
            "visible": row.shown(view),
        }

    def refresh(self, view: View) -> None:
        """Update the control to a view."""
        self.view = view
        for name, value in self._shown(view).items():
            if value != getattr(self.handle, name):
                setattr(self.handle, name, value)

    def remove(self) -> None:
        """Remove the control from the window."""
        self.handle.remove()


class GroupControl:
    """Small buttons in a row, which are the same in every view."""

    def __init__(self, gui: viser.GuiApi, row: ButtonGroup, view: View, ask: Ask) -> None:
        keys = {text[view.seat.language]: key for key, text in row.options}
        self.handle: Any = gui.add_button_group(row.label[view.seat.language], tuple(keys))
        bind.on_press(self.handle, lambda: ask(lambda: row.request(keys[self.handle.value])))

    def refresh(self, view: View) -> None:
        """Nothing changes with the view."""

    def remove(self) -> None:
        """Remove the buttons from the window."""
        self.handle.remove()


def slider(gui: viser.GuiApi, row: Slider, view: View, ask: Ask) -> ValueControl:
    """A slider, whose value is rounded to its steps."""

    def value(view: View) -> float:
        steps = round((row.value(view) - row.lower) / row.step)
        return round(min(max(row.lower + steps * row.step, row.lower), row.upper), 6)

    def label(view: View) -> str:
        text = row.label if isinstance(row.label, Text) else row.label(view)
        return text[view.seat.language]

    disabled = not row.enabled(view)
    handle = gui.add_slider(label(view), row.lower, row.upper, row.step, value(view), disabled=disabled)
    return ValueControl(handle, Binding(value, row.request, row.enabled, label), view, ask)


def checkbox(gui: viser.GuiApi, row: Checkbox, view: View, ask: Ask) -> ValueControl:
    """A checkbox."""
    handle = gui.add_checkbox(row.label[view.seat.language], row.value(view))
    return ValueControl(handle, Binding(row.value, row.request), view, ask)


class ChoiceControl(ValueControl):
    """A dropdown, whose options are updated with the view."""

    def __init__(self, gui: viser.GuiApi, row: Dropdown, view: View, ask: Ask) -> None:
        self.row = row
        words = self._words(view)
        handle = gui.add_dropdown(
            row.label[view.seat.language], tuple(words.values()), initial_value=words[row.value(view)]
        )
        binding = Binding(lambda view: self._words(view)[row.value(view)], self._request)
        super().__init__(handle, binding, view, ask)

    def _words(self, view: View) -> dict[Hashable, str]:
        """The text of each key; equal texts get a number."""
        options = self.row.options
        known = options(view) if callable(options) else options
        words = [text[view.seat.language] for _, text in known]
        return {
            key: word if words.index(word) == k else f"{word} ({k + 1})"
            for k, ((key, _), word) in enumerate(zip(known, words, strict=True))
        }

    def _request(self, word: str) -> PageRequest | None:
        keys = {word: key for key, word in self._words(self.view).items()}
        return self.row.request(keys[word]) if word in keys else None

    def refresh(self, view: View) -> None:
        """Update the options and the choice to a view."""
        words = tuple(self._words(view).values())
        if words != self.handle.options:
            self.handle.options = words
        super().refresh(view)


def vector_boxes(gui: viser.GuiApi, row: VectorRow, view: View, ask: Ask) -> ValueControl:
    """Three boxes for numbers."""
    handle = gui.add_vector3(row.label[view.seat.language], row.value(view), step=row.step)
    binding = Binding(row.value, lambda given: row.request(placed.view, given))
    placed = ValueControl(handle, binding, view, ask)
    return placed


class EntryControl:
    """A text field with its button."""

    def __init__(self, gui: viser.GuiApi, row: TextEntry, view: View, ask: Ask) -> None:
        self.row, language = row, view.seat.language
        self.said = row.shown(view)
        self.text: Any = gui.add_text(row.label[language], self.said)
        self.button = gui.add_button(row.button[language], color=COLOURS["plain"])
        self.touched = 0.0

        def pressed() -> PageRequest:
            given, self.touched = self.text.value, 0.0
            if row.typed is not None:  # at once: the user may type on before the row is next updated
                self.said = self.text.value = ""
            return row.request(given)

        bind.on_press(self.button, lambda: ask(pressed))
        if row.typed is not None:
            bind.on_value(self.text, partial(self._type, row.typed, ask))

    def _type(self, typed: Callable[[str], PageRequest], ask: Ask, text: str) -> None:
        self.touched, self.said = monotonic(), text
        ask(lambda: typed(text))

    def refresh(self, view: View) -> None:
        """Update the text, but only if the view's own text has changed; otherwise what was typed stays."""
        said = self.row.shown(view)
        if said != self.said and monotonic() - self.touched > UNTOUCHED:
            self.said = self.text.value = said

    def remove(self) -> None:
        """Remove the control from the window."""
        self.text.remove()
        self.button.remove()


class UploadControl:
    """A button that asks for a file."""

    def __init__(self, gui: viser.GuiApi, row: Upload, view: View, ask: Ask) -> None:
        self.view = view
        self.handle = gui.add_upload_button(row.label[view.seat.language], icon=Icon.UPLOAD, color=COLOURS["plain"])
        bind.on_upload(self.handle, lambda name, content: ask(lambda: row.request(self.view, name, content)))

    def refresh(self, view: View) -> None:
        """Keep the view for the next file; the button looks the same in every view."""
        self.view = view

    def remove(self) -> None:
        """Remove the control from the window."""
        self.handle.remove()
