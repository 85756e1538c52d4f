"""Matrices as tables: as wide as the panel, few digits, sets of columns."""

from __future__ import annotations

import re

import numpy as np
import pytest

from helicoide.readout.matrices import NamedMatrix
from helicoide.text import Text, untranslated
from helicoide.view.matrix_rows import MOST_COLUMNS, common_exponent, entry_text, written_matrix


def matrix(values: np.ndarray) -> NamedMatrix:
    """A matrix whose rows and columns have numbers for names."""
    rows, columns = ([untranslated(str(i + 1)) for i in range(n)] for n in values.shape)
    return NamedMatrix(values, tuple(rows), tuple(columns), Text(en="", pt_BR=""))


@pytest.mark.parametrize(("largest", "exponent"), [(0.0, 0), (0.1, 0), (9999.4, 0), (1e4, 3), (0.05, -3), (2e-7, -9)])
def test_very_large_and_very_small_matrices_have_one_exponent(largest: float, exponent: int) -> None:
    assert common_exponent(np.array([[0.0, -largest]])) == exponent
    assert common_exponent(np.array([[np.nan, largest], [np.inf, 0.0]])) == 0


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 0.99995, 1.0, 9.9995, 99.996, 999.96, 9999.6, 1e8])
def test_no_entry_has_more_than_four_digits(scale: float) -> None:
    values = scale * np.random.default_rng(0).uniform(-1, 1, (6, 7))
    values[0, 0] = scale
    shown = values / 10.0 ** common_exponent(values)
    for value in shown.flat:
        said = entry_text(value, 3, "en")
        assert len(re.sub(r"\D", "", said.removeprefix("−").removeprefix("0"))) <= 4
        assert float(said.replace("−", "-")) == pytest.approx(value, rel=6e-4, abs=6e-4)
    assert entry_text(-0.0001, 3, "pt_BR") == "0"
    assert entry_text(-0.0516, 3, "pt_BR") == "−0,052"


@pytest.mark.parametrize("count", [1, 4, 7, 8, 15])
def test_every_entry_stands_once_in_sets_of_columns(count: int) -> None:
    written = written_matrix(matrix(np.arange(6.0 * count).reshape(6, count)), "en")
    tables = written.split("<table>")[1:]
    assert len(tables) == -(-count // MOST_COLUMNS)
    assert all(table.split("</tr>")[1].count("<td>") <= MOST_COLUMNS for table in tables)
    assert sorted(map(int, re.findall(r"<td>(\d+)</td>", written))) == list(range(6 * count))
    assert ("Columns 1 to" in written) == (count > MOST_COLUMNS)
