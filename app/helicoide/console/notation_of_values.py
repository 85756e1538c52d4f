"""Values as text that the grammar reads again, and as LaTeX, with the blades in the order and sign of the sources."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from helicoide.console.kinds import NOISE, ROUNDING
from helicoide.console.values import Value
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Algebra
from helicoide.geometry.multivector import Multivector
from helicoide.text import Language

DIGITS = 5  # significant ones

# The signs of e3e1, e3e1e (of the sources) and e31, e032, e013, e021 (of modern texts) are those of their own order.
BLADES = {
    CL031: ("1", "e1", "e2", "e3", "e", "e2e3", "e3e1", "e1e2", "e1e", "e2e", "e3e", "e1e2e3", "e2e3e", "e3e1e",
            "e1e2e", "e1e2e3e"),
    PGA: ("1", "e1", "e2", "e3", "e0", "e23", "e31", "e12", "e01", "e02", "e03", "e123", "e032", "e013", "e021",
          "e0123"),
}  # fmt: skip
UNITS = ("1", "i", "j", "k")


@cache
def _places(algebra: Algebra) -> list[tuple[str, int, int]]:
    """Each blade with its place among the coefficients and its sign there."""
    return [(name, *algebra.parse_blade(name)) for name in BLADES[algebra]]


def value_terms(value: Value) -> list[tuple[float, str]]:
    """The numbers of a value with their units or blades, "1" for none; those lost in rounding are left out."""
    if not isinstance(value, Multivector):
        return [(value, "1")]
    if value.algebra is QUATERNIONS:
        numbered = list(zip(value.values.tolist(), UNITS, strict=True))
    else:
        numbers = value.values.tolist()
        numbered = [(sign * numbers[place], name) for name, place, sign in _places(value.algebra)]
    zero = max(ROUNDING * max(abs(number) for number, _ in numbered), NOISE)
    return [(number, unit) for number, unit in numbered if abs(number) > zero]


def value_text(value: Value, language: Language = "en", digits: int = DIGITS) -> str:
    """The value as a sum, such as 0.866 + 0.5*e2e3. In English the grammar reads it again, if it is of Cl(0,3,1)."""
    text = _sum(_written(number, unit, "*", digits) for number, unit in value_terms(value))
    return text if language == "en" else text.replace(".", ",")


def value_latex(value: Value, language: Language = "en") -> str:
    """The same sum in LaTeX."""
    comma = "." if language == "en" else "{,}"
    return _sum(_in_latex(number, unit, comma) for number, unit in value_terms(value))


def _number(number: float, digits: int) -> str:
    return f"{number:.{digits}g}"


def _written(number: float, unit: str, times: str, digits: int) -> str:
    shown = _number(number, digits)
    if unit == "1":
        return shown
    return shown.replace("1", unit) if shown in ("1", "-1") else shown + times + unit


def unit_latex(unit: str) -> str:
    """A unit or blade in LaTeX, such as e_{1}e_{2}."""
    return re.sub(r"(\d+)", r"_{\1}", unit)


def unit_grade(unit: str) -> int:
    """The grade of a blade; 0 for "1", 2 for i, j and k, which are bivectors."""
    if unit in UNITS:
        return 0 if unit == "1" else 2
    return len(re.findall(r"\d|e(?!\d)", unit))


def _in_latex(number: float, unit: str, comma: str) -> str:
    blade = unit_latex(unit)
    mantissa, _, power = _number(number, DIGITS).partition("e")
    shown = mantissa.replace(".", comma) + (rf" \cdot 10^{{{int(power)}}}" if power else "")
    if unit == "1":
        return shown
    return shown.replace("1", blade) if shown in ("1", "-1") else rf"{shown}\,{blade}"


def _sum(terms: Iterator[str]) -> str:
    return (" + ".join(terms) or "0").replace("+ -", "- ")
