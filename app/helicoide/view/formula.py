"""Formulas: TeX to MathML, and multivectors as a grid of coefficients."""

from __future__ import annotations

import re

import numpy as np
from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.geometry.clifford import CL031
from helicoide.markup import formula_to_mathml
from helicoide.text import Language, number_text

ZERO = 5e-4


def formula_html(tex: str, index: str = "") -> Markup:
    """A formula for an HTML row. index: a name written as its subscript."""
    return Markup('<div class="helicoide-formula">{}</div>').format(formula_to_mathml(tex, index))


def _blade(name: str) -> Markup:
    """The name of a basis blade, such as e1e2, with its digits as subscripts."""
    parts = re.split(r"(?<=e)(\d)", name)
    return Markup("").join(Markup("<sub>{}</sub>").format(part) if k % 2 else part for k, part in enumerate(parts))


def _grid() -> Markup:
    """The grid, with two %s to fill in each cell. It is made once, since panels fill it ten times a second."""
    cell = Markup('<i class="g{}%s"><b>%s</b><u>{}</u></i>')
    cells = (cell.format(grade, _blade(name)) for grade, name in zip(CL031.grades, CL031.names, strict=True))
    return Markup('<div class="helicoide-grid">{}</div>').format(Markup("").join(cells))


GRID = _grid()


def coefficient(value: float, language: Language = "en") -> str:
    """The value with three decimals and a minus sign; 0 if it is smaller than `ZERO`."""
    return "0" if abs(value) < ZERO else number_text(value, ".3f")[language].replace("-", "−")


def coefficient_grid(values: Array, language: Language = "en") -> Markup:
    """The 16 coefficients with their blade names, coloured by grade, zero ones faint."""
    said = [(" zero" if abs(value) < ZERO else "", coefficient(value, language)) for value in np.asarray(values)]
    return GRID % tuple(word for words in said for word in words)
