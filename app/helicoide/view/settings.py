"""Rows for the settings of an options class: a slider, a dropdown or a checkbox for each."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, floor, log10
from typing import Any

from helicoide.ik.method import OneOf, Quantity, YesNo, settings
from helicoide.text import Text, sentence_case, significant_text, untranslated
from helicoide.view.requests import PageRequest
from helicoide.view.rows import Checkbox, Dropdown, Row, Slider
from helicoide.view.window_view import View

NONE = Text(en="none", pt_BR="nenhum")
NOTHING_TO_SET = Text(en="Nothing can be set.", pt_BR="Não há o que ajustar.")
STEPS, PER_DECADE = 50, 20
DECADES = "\u2063"  # an invisible mark in the label, by which the page finds logarithmic sliders
Options = Callable[[View], Any]
Change = Callable[[str, object], PageRequest]


def setting_rows(kind: type, length: float, options: Options, change: Change) -> list[Row]:
    """A row for each setting of an options class.

    length: the characteristic length, m, for what is shown in mm; options: the current values; change: makes the
    request that sets one of them by name.
    """
    rows: list[Row] = []
    for name, setting in settings(kind).items():
        value, request = _value(options, name), _request(change, name)
        match setting:
            case Quantity():
                rows.append(_quantity(setting, length, value, request))
            case OneOf(title, choices):
                rows.append(Dropdown(sentence_case(title), list(choices.items()), value, request))
            case YesNo(title):
                rows.append(Checkbox(sentence_case(title), value, request))
    return rows


def _value(options: Options, name: str) -> Callable[[View], Any]:
    return lambda view: getattr(options(view), name)


def _request(change: Change, name: str) -> Callable[[object], PageRequest]:
    return lambda value: change(name, value)


def _quantity(
    setting: Quantity, length: float, value: Callable[[View], float], request: Callable[[object], PageRequest]
) -> Row:
    """A slider in the unit on the screen, with steps of a power of ten."""
    unit = (1000 * length) ** setting.lengths
    if setting.decades:
        return _decades(setting, unit, value, request)
    lower, upper = setting.lower * unit, setting.upper * unit
    step = 10 ** floor(log10((upper - lower) / STEPS))
    return Slider(
        untranslated("{title} {unit}").format(title=sentence_case(setting.title), unit=_in_brackets(setting)),
        ceil(lower / step) * step,
        floor(upper / step) * step,
        step,
        lambda view: value(view) * unit,
        lambda shown: request(_within(setting, shown / unit)),
    )


def _decades(
    setting: Quantity, unit: float, value: Callable[[View], float], request: Callable[[object], PageRequest]
) -> Row:
    """A logarithmic slider. Its label shows the value; the page hides the exponent that viser shows."""

    def label(view: View) -> Text:
        said = significant_text(value(view) * unit, 3)
        return untranslated("{title}: {said} {unit}{decades}").format(
            title=sentence_case(setting.title), said=said, unit=setting.unit, decades=DECADES
        )

    return Slider(
        label,
        ceil(log10(setting.lower * unit) * PER_DECADE) / PER_DECADE,
        floor(log10(setting.upper * unit) * PER_DECADE) / PER_DECADE,
        1 / PER_DECADE,
        lambda view: log10(value(view) * unit),
        lambda exponent: request(_within(setting, 10.0**exponent / unit)),
    )


def _within(setting: Quantity, value: float) -> float:
    return min(max(value, setting.lower), setting.upper)


def _in_brackets(setting: Quantity) -> str:
    return f"[{setting.unit}]" if setting.unit else ""
