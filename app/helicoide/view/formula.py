"""Formulas: TeX to MathML, and multivectors as a grid of coefficients."""

from __future__ import annotations

import re
from functools import lru_cache

import numpy as np
from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.geometry.notation import blade_latex
from helicoide.markup import formula_to_mathml
from helicoide.readout import SYMBOLS, Coefficient, Nature, coefficients, role_of
from helicoide.seat import Notation
from helicoide.text import Language, number_text

ZERO = 5e-4


def formula_html(tex: str, index: str = "") -> Markup:
    """A formula for an HTML row. index: a name written as its subscript."""
    return Markup('<div class="helicoide-formula">{}</div>').format(formula_to_mathml(tex, index))


def _blade(name: str) -> Markup:
    """The name of a basis blade, such as e1e2 or e12, with its digits as subscripts."""
    parts = re.split(r"(?<=e)(\d+)", name)
    return Markup("").join(Markup("<sub>{}</sub>").format(part) if k % 2 else part for k, part in enumerate(parts))


def blade_words(name: str) -> str:
    """The name of a blade in plain text, such as e₂e₃ or e₂₃."""
    return name.translate(str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")) if name != "1" else name


@lru_cache(maxsize=64)
def _grid(shown: tuple[Coefficient, ...], chosen: str | None) -> Markup:
    """The grid, with two %s to fill in each cell. It is made once, since panels fill it ten times a second."""
    cell = Markup('<i class="g{}{}%s"><b>%s</b><u>{}</u></i>')
    cells = (cell.format(one.grade, " chosen" if one.blade == chosen else "", _blade(one.name)) for one in shown)
    return Markup('<div class="helicoide-grid">{}</div>').format(Markup("").join(cells))


def coefficient(value: float, language: Language = "en") -> str:
    """The value with three decimals and a minus sign; 0 if it is smaller than `ZERO`."""
    return "0" if abs(value) < ZERO else number_text(value, ".3f")[language].replace("-", "−")


def coefficient_grid(
    values: Array, shown: tuple[Coefficient, ...], language: Language = "en", chosen: str | None = None
) -> Markup:
    """The 16 coefficients (16,) of `CL031` as displayed, with their blades, coloured by grade, zero ones faint.

    chosen: the blade of `CL031` that is marked.
    """
    stored = np.asarray(values).tolist()
    signed = [one.sign * stored[one.place] for one in shown]
    said = [(" zero" if abs(value) < ZERO else "", coefficient(value, language)) for value in signed]
    return _grid(shown, chosen) % tuple(word for words in said for word in words)


def sum_of_blades(values: Array, shown: tuple[Coefficient, ...], language: Language = "en") -> Markup:
    """The multivector (16,) of `CL031` as a sum, in the order, signs and digits of the grid; it breaks between terms.

    Made without MathML, which takes a millisecond each time that the arm moves.
    """
    terms: list[Markup] = []
    for one in shown:
        said = coefficient(one.sign * float(values[one.place]), language)
        if said != "0":
            sign = "− " if said.startswith("−") else "+ " if terms else ""
            blade = Markup("") if one.name == "1" else Markup("\u2009") + _blade(one.name)
            terms.append(Markup("<span>{}{}{}</span>").format(sign, said.removeprefix("−"), blade))
    return Markup('<p class="helicoide-sum">= {}</p>').format(Markup(" ").join(terms) or "0")


@lru_cache(maxsize=64)
def general_formula(nature: Nature, notation: Notation) -> Markup:
    """A multivector of this nature with letters for its coefficients, in the order and with the signs of the grid.

    The bivectors with the null generator begin a second line.
    """
    lines = [""]
    for one in coefficients(nature, notation):
        role = role_of(nature, one.blade)
        if role is None:
            continue
        if one.blade == "e1e" and nature in ("motor", "line"):
            lines.append("")
        sign = "-" if one.sign * role.sign < 0 else "+" if any(lines) else ""
        lines[-1] += rf" {sign} {role.letter}\, {blade_latex(one.name)}"
    lines[0] = f"{SYMBOLS[nature]} = {lines[0]}"
    return Markup("").join(map(formula_html, lines))
