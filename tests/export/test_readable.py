"""Charts counted in powers of ten: three decimals tell their numbers apart, and nothing but the unit changes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.export.chart_scale import scaled_chart
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import Text, untranslated

UP = Text(en="error (mm)", pt_BR="erro (mm)")


def chart(*ys: list[float]) -> Chart:
    lines = tuple(
        ChartLine(untranslated(str(i)), np.arange(len(y), dtype=float), np.array(y)) for i, y in enumerate(ys)
    )
    return Chart(untranslated("a chart"), untranslated("time, s"), UP, lines)


@pytest.mark.parametrize(
    ("values", "power", "first"),
    [
        ([2e-6, 5e-6], " × 10⁻⁶", 2.0),
        ([3e-4, 2e-3], " × 10⁻³", 0.3),
        ([5e4, 1e5], " × 10³", 50.0),
        ([1.5, 1.50001], " × 10⁻⁶", 1.5e6),
        ([7e-9, 7e-9], " × 10⁻⁹", 7.0),
        ([0.1, 0.5], "", 0.1),
        ([0.0, 0.0], "", 0.0),
        ([float("nan"), 4e-6], " × 10⁻⁶", np.nan),
    ],
)
def test_small_and_large_numbers_are_counted_in_a_power_that_the_name_tells(
    values: list[float], power: str, first: float
) -> None:
    found = scaled_chart(chart(values))
    assert found.y_label == Text(en=UP.en + power, pt_BR=UP.pt_BR + power)
    np.testing.assert_allclose(found.lines[0].y[0], first)
    assert np.array_equal(found.lines[0].x, [0.0, 1.0])


def test_all_curves_of_a_chart_share_the_power() -> None:
    found = scaled_chart(chart([1e-7, 2e-7], [1e-3, 4e-3]))
    np.testing.assert_allclose([line.y for line in found.lines], [[1e-4, 2e-4], [1.0, 4.0]])


@given(st.floats(-15, 12), st.floats(0.1, 1))
def test_three_decimals_and_five_digits_are_enough_for_numbers_from_nought(exponent: float, share: float) -> None:
    most = 10.0**exponent
    found = scaled_chart(chart([0.0, share * most, most])).lines[0].y
    assert 0.05 <= found.max() < 1e4
