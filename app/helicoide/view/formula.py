"""Formulas: TeX to MathML, and multivectors as a grid of coefficients."""

from __future__ import annotations

import re

import numpy as np
from markupsafe import Markup

from helicoide.geometry.clifford import CL031
from helicoide.kinematics.chain import Array
from helicoide.view import html

ZERO = 5e-4


def mathml(tex: str, index: str = "") -> Markup:
    """A formula for an HTML row; index: a name that stands below it."""
    return Markup('<div class="helicoide-formula">{}</div>').format(html.formula(tex, index))


def _blade(name: str) -> Markup:
    """The name of a basis blade, such as e1e2, with its numbers below the line."""
    parts = re.split(r"(?<=e)(\d)", name)
    return Markup("").join(Markup("<sub>{}</sub>").format(part) if part.isdigit() else part for part in parts)


BLADES = tuple(Markup("1") if name == "1" else _blade(name) for name in CL031.names)


def coefficient(value: float) -> str:
    """Three decimals with a proper minus; what is zero is written as 0."""
    return "0" if abs(value) < ZERO else f"{value:.3f}".replace("-", "−")


def coefficient_grid(values: Array) -> Markup:
    """The 16 coefficients with their blade names, coloured by grade, zero ones faint."""
    cells = (
        Markup('<i class="g{}{}"><b>{}</b><u>{}</u></i>').format(
            grade, " zero" if abs(value) < ZERO else "", coefficient(value), blade
        )
        for blade, grade, value in zip(BLADES, CL031.grades, np.asarray(values), strict=True)
    )
    return Markup('<div class="helicoide-grid">{}</div>').format(Markup("").join(cells))
