"""Values as text that the grammar reads again, and as LaTeX, with the blades in the order and sign of the sources."""

from __future__ import annotations

import re
from collections.abc import Iterator

from helicoide.console.kinds import NOISE, ROUNDING
from helicoide.console.values import Value
from helicoide.geometry.clifford import PGA, QUATERNIONS
from helicoide.geometry.multivector import Multivector
from helicoide.geometry.notation import BladeNaming, displayed_blades

DIGITS = 5  # significant ones

UNITS = ("1", "i", "j", "k")


def value_terms(value: Value) -> list[tuple[float, str]]:
    """The numbers of a value with their units or blades, "1" for none; those lost in rounding are left out."""
    if not isinstance(value, Multivector):
        return [(value, "1")]
    if value.algebra is QUATERNIONS:
        numbered = list(zip(value.values.tolist(), UNITS, strict=True))
    else:
        naming: BladeNaming = "compact" if value.algebra is PGA else "factors"
        numbers = value.values.tolist()
        numbered = [(sign * numbers[place], name) for name, place, sign in displayed_blades(value.algebra, naming)]
    zero = max(ROUNDING * max(abs(number) for number, _ in numbered), NOISE)
    return [(number, unit) for number, unit in numbered if abs(number) > zero]


def value_text(value: Value) -> str:
    """The value as a sum, such as 0.866 + 0.5*e2e3, which the grammar reads again if it is of Cl(0,3,1)."""
    return _sum(_written(number, unit) for number, unit in value_terms(value))


def value_latex(value: Value) -> str:
    """The same sum in LaTeX."""
    return _sum(_in_latex(number, unit) for number, unit in value_terms(value))


def _number(number: float) -> str:
    return f"{number:.{DIGITS}g}"


def _written(number: float, unit: str) -> str:
    shown = _number(number)
    if unit == "1":
        return shown
    return shown.replace("1", unit) if shown in ("1", "-1") else f"{shown}*{unit}"


def unit_latex(unit: str) -> str:
    """A unit or blade in LaTeX, such as e_{1}e_{2}."""
    return re.sub(r"(\d+)", r"_{\1}", unit)


def unit_grade(unit: str) -> int:
    """The grade of a blade; 0 for "1", 2 for i, j and k, which are bivectors."""
    if unit in UNITS:
        return 0 if unit == "1" else 2
    return len(re.findall(r"\d|e(?!\d)", unit))


def _in_latex(number: float, unit: str) -> str:
    blade = unit_latex(unit)
    mantissa, _, power = _number(number).partition("e")
    shown = mantissa + (rf" \cdot 10^{{{int(power)}}}" if power else "")
    if unit == "1":
        return shown
    return shown.replace("1", blade) if shown in ("1", "-1") else rf"{shown}\,{blade}"


def _sum(terms: Iterator[str]) -> str:
    return (" + ".join(terms) or "0").replace("+ -", "- ")
