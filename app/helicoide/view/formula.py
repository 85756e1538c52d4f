"""Formulas: TeX to MathML, and multivectors as a grid of coefficients."""

from __future__ import annotations

import re
from functools import lru_cache

import numpy as np
from latex2mathml.converter import convert

from helicoide.geometry.clifford import CL031
from helicoide.kinematics.chain import Array

ZERO = 5e-4
_BLADES = tuple("1" if name == "1" else re.sub(r"e(\d)", r"e<sub>\1</sub>", name) for name in CL031.names)


@lru_cache(maxsize=256)
def mathml(tex: str, display: bool = False) -> str:
    """A formula for an HTML row."""
    return f'<div class="helicoide-formula">{convert(tex, display="block" if display else "inline")}</div>'


def coefficient(value: float) -> str:
    """Three decimals with a proper minus; what is zero is written as 0."""
    return "0" if abs(value) < ZERO else f"{value:.3f}".replace("-", "−")


def coefficient_grid(values: Array) -> str:
    """The 16 coefficients with their blade names, coloured by grade, zero ones faint."""
    cells = (
        f'<i class="g{grade}{" zero" if abs(value) < ZERO else ""}"><b>{coefficient(value)}</b><u>{blade}</u></i>'
        for blade, grade, value in zip(_BLADES, CL031.grades, np.asarray(values), strict=True)
    )
    return f'<div class="helicoide-grid">{"".join(cells)}</div>'
