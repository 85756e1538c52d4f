"""Multivectors as a grid, and formulas with a name in them."""

from __future__ import annotations

import re

import numpy as np
import pytest
from tests.hostile import NAMES, Page

from helicoide.geometry.clifford import CL031
from helicoide.view.formula import coefficient_grid, formula_html


def test_every_blade_has_its_coefficient_and_its_name() -> None:
    values = np.array([0.0, -1.25, *range(2, 16)])
    cells = re.findall(r'<i class="g(\d)( zero)?"><b>(.*?)</b><u>(.*?)</u></i>', coefficient_grid(values))
    assert [int(grade) for grade, *_ in cells] == list(CL031.grades)
    assert [bool(zero) for _, zero, *_ in cells] == [True] + 15 * [False]
    assert [said for _, _, said, _ in cells][:3] == ["0", "−1.250", "2.000"]
    assert [re.sub("</?sub>", "", name) for *_, name in cells] == list(CL031.names)
    assert cells[0][3] == "1"
    assert cells[5][3] == "e<sub>1</sub>e<sub>2</sub>"


@pytest.mark.parametrize("name", [*NAMES, "+z", "&", "π < 4"])
def test_a_name_below_a_symbol_is_no_formula(name: str) -> None:
    read = Page(formula_html(r"\pi", name))
    assert read.text == f"π{name}"
    assert read.tags == {"div", "math", "msub", "mrow", "mi", "mtext"}


def test_signs_of_a_formula_are_text() -> None:
    assert Page(formula_html(r"a < b \leq c - d")).text == "a<b≤c−d"
