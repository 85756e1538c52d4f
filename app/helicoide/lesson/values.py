"""Values of the prose: read from the state in SI units or radians, written in the unit that the text names."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from helicoide.arrays import Array
from helicoide.geometry.multivector import Multivector
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import Text, rounded_text, untranslated

# What a number in SI units or rad is multiplied by, for each unit; other units are only names.
FACTORS = {"mm": 1e3, "mm/s": 1e3, "ms": 1e3, "°": 180 / math.pi, "°/s": 180 / math.pi, "%": 100.0}
WHOLE = ("mm", "mm/s", "ms", "°", "°/s", "%")  # units in which whole numbers are precise enough
UNKNOWN = untranslated("–")


@dataclass(frozen=True)
class Value:
    """What `{name}` stands for in the prose.

    read: a number, an array (n,) or (m, n), or a multivector, in SI units or rad; unit: in which it is written, such as
    "mm" or "°"; decimals: how many are written, None for as many as the unit needs.
    """

    read: Callable[[State, Seat], float | Array | Multivector]
    unit: str = ""
    decimals: int | None = None


def fixed(
    value: float | Array | Multivector | Callable[[], float | Array | Multivector],
    unit: str = "",
    decimals: int | None = None,
) -> Value:
    """A value that does not change. A function is called when it is shown: products need the kernels."""
    return Value(lambda state, seat: value() if callable(value) else value, unit, decimals)


def in_unit(number: float, unit: str) -> float:
    """A number in SI units or rad, in the unit."""
    return number * FACTORS.get(unit, 1.0)


def needed_decimals(unit: str, decimals: int | None) -> int:
    """The decimals that are written, if an author has not chosen them."""
    return decimals if decimals is not None else 0 if unit in WHOLE else 2


def measured_text(shown: float, unit: str, decimals: int | None = None) -> Text:
    """A number that is already in its unit, with the unit; a dash if it is not finite."""
    if not math.isfinite(shown):
        return UNKNOWN
    space = "" if unit in ("", "°") else "\u202f"
    number = rounded_text(shown, needed_decimals(unit, decimals))
    return Text(en=f"{number.en}{space}{unit}", pt_BR=f"{number.pt_BR}{space}{unit}")
