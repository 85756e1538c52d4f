"""Rows for the settings of an options class: a slider, a choice or a tick for each."""

from __future__ import annotations

from collections.abc import Callable
from math import log10
from typing import Any

from helicoide.ik.method import OneOf, Quantity, YesNo, settings
from helicoide.text import Text, same
from helicoide.view.rows import Choice, Row, Slider, Tick, View, Wish

STEPS, PER_DECADE = 100, 20
Options = Callable[[View], Any]
Change = Callable[[str, object], Wish]


def rows_of(kind: type, length: float, options: Options, change: Change) -> list[Row]:
    """A row for each setting of an options class.

    length: the characteristic length, m, for what is shown in mm; options: what is set now; change: the wish that sets
    one by name.
    """
    rows: list[Row] = []
    for name, setting in settings(kind).items():
        value, wish = _value(options, name), _wish(change, name)
        match setting:
            case Quantity():
                rows.append(_quantity(setting, length, value, wish))
            case OneOf(title, choices):
                rows.append(Choice(title, list(choices.items()), value, wish))
            case YesNo(title):
                rows.append(Tick(title, value, wish))
    return rows


def _value(options: Options, name: str) -> Callable[[View], Any]:
    return lambda view: getattr(options(view), name)


def _wish(change: Change, name: str) -> Callable[[object], Wish]:
    return lambda value: change(name, value)


def _quantity(setting: Quantity, length: float, value: Callable[[View], float], wish: Callable[[object], Wish]) -> Row:
    """A slider in the unit of the screen; one through powers of ten says in its label what they stand for."""
    unit = (1000 * length) ** setting.lengths
    to, back = (log10, _power) if setting.decades else (float, float)
    lower, upper = to(setting.lower * unit), to(setting.upper * unit)

    def label(view: View) -> Text:
        said = f"{value(view) * unit:.3g}" if setting.decades else ""
        return same("{title} {said} {unit}").format(title=setting.title, said=said, unit=setting.unit)

    def within(shown: float) -> Wish:
        return wish(min(max(back(shown) / unit, setting.lower), setting.upper))

    step = 1 / PER_DECADE if setting.decades else (upper - lower) / STEPS
    return Slider(label, lower, upper, step, lambda view: to(value(view) * unit), within)


def _power(exponent: float) -> float:
    return float(10.0**exponent)
