"""Multivectors as text, LaTeX and MathML, with blades named as in the sources or in modern texts."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Literal

from latex2mathml.converter import convert

from helicoide.geometry.clifford import Algebra, Array

BladeNaming = Literal["factors", "compact"]
"""Names of blades: e1e2e as in the sources, or as in modern texts e12, with the null generator in front, e012."""

DECIMALS = 3


def multivector_text(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> str:
    """Sum of the blades that are not zero after rounding, such as 0.866 + 0.5 e1e2.

    values: (2ⁿ,). Compact names may change signs: −e1e is written e01, since moving e past e1 changes the sign.
    """
    return _sum(_terms(values, algebra, naming, " ", str))


def multivector_latex(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> str:
    r"""The same sum in LaTeX, such as 0.866 + 0.5\,e_{1}e_{2}. values: (2ⁿ,)."""
    return _sum(_terms(values, algebra, naming, r"\,", _indexed))


def multivector_mathml(values: Array, algebra: Algebra, naming: BladeNaming = "factors") -> str:
    """The same sum as a MathML element. values: (2ⁿ,)."""
    return convert(multivector_latex(values, algebra, naming))


def _indexed(name: str) -> str:
    return re.sub(r"e(\d+)", r"e_{\1}", name)


def _terms(
    values: Array, algebra: Algebra, naming: BladeNaming, times: str, written: Callable[[str], str]
) -> Iterator[str]:
    for name in algebra.names if naming == "factors" else algebra.compact_names:
        place, sign = algebra.parse_blade(name)
        coefficient = sign * round(float(values[place]), DECIMALS)
        number = f"{coefficient:.{DECIMALS}f}".rstrip("0").rstrip(".")
        if coefficient == 0:
            continue
        if name == "1":
            yield number
        elif abs(coefficient) == 1:
            yield number.replace("1", written(name))
        else:
            yield number + times + written(name)


def _sum(terms: Iterator[str]) -> str:
    return (" + ".join(terms) or "0").replace("+ -", "- ")
