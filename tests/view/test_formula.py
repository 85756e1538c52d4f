"""Multivectors as a grid, and formulas with a name in them."""

from __future__ import annotations

import re
from typing import get_args

import numpy as np
import pytest
from tests.hostile import NAMES, Page

from helicoide.geometry.clifford import CL031
from helicoide.geometry.notation import BladeNaming, multivector_text
from helicoide.readout import ALGEBRAS, Nature, coefficients, in_algebra
from helicoide.seat import Notation
from helicoide.view.formula import coefficient_grid, formula_html, sum_of_blades

CELL = re.compile(r'<i class="g(\d)( chosen)?( zero)?"><b>(.*?)</b><u>(.*?)</u></i>')
NOTATIONS = [Notation(algebra, naming) for algebra in ALGEBRAS for naming in get_args(BladeNaming)]


@pytest.mark.parametrize("notation", NOTATIONS, ids=str)
@pytest.mark.parametrize("nature", get_args(Nature))
def test_the_grid_has_the_order_and_the_signs_of_the_sum(nature: Nature, notation: Notation) -> None:
    """Each cell of the grid is the coefficient that the typeset sum has before the same blade."""
    values = np.array([0.0, -1.25, *range(2, 16)])
    shown = coefficients(nature, notation)
    cells = [
        (int(grade), "" if zero else said.replace("−", "-"), re.sub("</?sub>", "", name))
        for grade, _, zero, said, name in CELL.findall(coefficient_grid(values, shown))
    ]
    assert [name for _, _, name in cells] == [one.name for one in shown]
    assert [grade for grade, _, _ in cells] == sorted(CL031.grades)
    summed = re.findall(r"<span>([+−]? ?)([\d.]+)\u2009?(.*?)</span>", sum_of_blades(values, shown))
    assert [
        (re.sub("</?sub>", "", name), float(sign.replace("−", "-").strip() + said)) for sign, said, name in summed
    ] == [(name, float(said)) for _, said, name in cells if said]
    algebra = ALGEBRAS[notation.algebra]
    written = multivector_text(in_algebra(nature, values, notation.algebra), algebra, notation.naming)
    terms = re.findall(r"(-?) ?([\d.]+) (e\w*)", written)
    assert [(name, float(sign + number)) for sign, number, name in terms] == [
        (name, float(said)) for _, said, name in cells if said
    ]


def test_the_chosen_coefficient_is_marked_and_zero_ones_are_faint() -> None:
    cells = CELL.findall(coefficient_grid(np.eye(16)[6], coefficients("motor", Notation()), chosen="e1e3"))
    assert [name for _, chosen, _, _, name in cells if chosen] == ["e<sub>3</sub>e<sub>1</sub>"]
    assert [said for _, _, zero, said, _ in cells if not zero] == ["−1.000"]


@pytest.mark.parametrize("name", [*NAMES, "+z", "&", "π < 4"])
def test_a_name_below_a_symbol_is_no_formula(name: str) -> None:
    read = Page(formula_html(r"\pi", name))
    assert read.text == f"π{name}"
    assert read.tags == {"div", "math", "msub", "mrow", "mi", "mtext"}


def test_signs_of_a_formula_are_text() -> None:
    assert Page(formula_html(r"a < b \leq c - d")).text == "a<b≤c−d"
