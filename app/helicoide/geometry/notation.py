"""Multivectors as text, LaTeX, MathML and HTML, with blades named as in the sources or in modern texts."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache
from typing import Literal, NamedTuple

from latex2mathml.converter import convert
from markupsafe import Markup

from helicoide.geometry.clifford import Algebra, Array

BladeNaming = Literal["factors", "compact"]
"""Names of blades: e1e2e as in the sources, or as in modern texts e12, with the null generator in front, e012."""

DECIMALS = 3
# By grade, as in static/panel.css for the light look; a scalar has the colour of the text around it.
GRADE_COLOURS = ("inherit", "#1864ab", "#c2255c", "#237032", "#7048e8")
# With three generators that are not null, bivectors are named in the order of the axes about which they rotate.
CYCLIC: dict[BladeNaming, tuple[str, ...]] = {
    "factors": (
        *("1", "e1", "e2", "e3", "e", "e2e3", "e3e1", "e1e2", "e1e", "e2e", "e3e"),
        *("e1e2e3", "e2e3e", "e3e1e", "e1e2e", "e1e2e3e"),
    ),
    "compact": (
        *("1", "e1", "e2", "e3", "e0", "e23", "e31", "e12", "e01", "e02", "e03"),
        *("e123", "e032", "e013", "e021", "e0123"),
    ),
}


class DisplayedBlade(NamedTuple):
    """A blade as it is displayed: its coefficient is the sign times the value at this place of the stored array."""

    name: str
    place: int
    sign: int


@cache
def displayed_blades(algebra: Algebra, naming: BladeNaming = "factors") -> tuple[DisplayedBlade, ...]:
    """The blades in the order and with the signs in which they are displayed, everywhere.

    With three generators e₁, e₂, e₃ and a null one: e₂₃, e₃₁, e₁₂ for the axes x, y, z, and so on. Other algebras are
    displayed as they are stored.
    """
    if len(algebra.squares) == 4 and algebra.r == 1:
        names = CYCLIC[naming]
    else:
        names = algebra.names if naming == "factors" else algebra.compact_names
    return tuple(DisplayedBlade(name, *algebra.parse_blade(name)) for name in names)


def multivector_text(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> str:
    """Sum of the blades that are not zero after rounding, such as 0.866 + 0.5 e1e2.

    values: (2ⁿ,). Names may change signs: −e1e is written e01, since moving e past e1 changes the sign.
    """
    return _sum(_terms(values, algebra, naming, " ", str))


def multivector_latex(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> str:
    r"""The same sum in LaTeX, such as 0.866 + 0.5\,e_{1}e_{2}. values: (2ⁿ,)."""
    return _sum(_terms(values, algebra, naming, r"\,", blade_latex))


def multivector_mathml(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> str:
    """The same sum as a MathML element. values: (2ⁿ,)."""
    return convert(multivector_latex(values, algebra, naming))


def multivector_html(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> Markup:
    """The same sum as HTML, each term in the colour of its grade. values: (2ⁿ,)."""
    written = Markup("")
    for name, coefficient in _coefficients(values, algebra, naming):
        plus, minus = (" + ", " − ") if written else ("", "−")
        written += minus if coefficient < 0 else plus
        written += _coloured(name, _number(abs(coefficient)), int(algebra.grades[algebra.parse_blade(name)[0]]))
    return written or Markup("0")


def _coloured(name: str, number: str, grade: int) -> Markup:
    """A term without its sign, in the colour of its grade."""
    blade = Markup("").join(
        Markup("<sub>{}</sub>").format(part) if k % 2 else part for k, part in enumerate(re.split(r"(\d+)", name))
    )
    said = number if name == "1" else blade if number == "1" else Markup("{} {}").format(number, blade)
    return Markup('<span style="color:{}">{}</span>').format(GRADE_COLOURS[grade % len(GRADE_COLOURS)], said)


def blade_latex(name: str) -> str:
    """The name of a blade in LaTeX, such as e_{2}e_{3}; nothing for the blade 1."""
    return "" if name == "1" else re.sub(r"e(\d+)", r"e_{\1}", name)


def _coefficients(values: Array, algebra: Algebra, naming: BladeNaming) -> Iterator[tuple[str, float]]:
    """The names of the blades and their coefficients, rounded, without those that are zero then."""
    for name, place, sign in displayed_blades(algebra, naming):
        coefficient = sign * round(float(values[place]), DECIMALS)
        if coefficient != 0:
            yield name, coefficient


def _number(coefficient: float) -> str:
    return f"{coefficient:.{DECIMALS}f}".rstrip("0").rstrip(".")


def _terms(
    values: Array, algebra: Algebra, naming: BladeNaming, times: str, written: Callable[[str], str]
) -> Iterator[str]:
    for name, coefficient in _coefficients(values, algebra, naming):
        number = _number(coefficient)
        if name == "1":
            yield number
        elif abs(coefficient) == 1:
            yield number.replace("1", written(name))
        else:
            yield number + times + written(name)


def _sum(terms: Iterator[str]) -> str:
    return (" + ".join(terms) or "0").replace("+ -", "- ")
