"""Charts in a panel: which of them uPlot can draw, on which heights, and curves over one x."""

from __future__ import annotations

import numpy as np
import pytest

from helicoide.studies.study import Chart, ChartLine
from helicoide.text import untranslated
from helicoide.view.chart_plot import POINTS, common, heights, runs_backwards

AROUND = np.linspace(0, 2 * np.pi, 50)


def chart(*curves: tuple[object, object]) -> Chart:
    lines = tuple(ChartLine(untranslated("a curve"), np.asarray(x, float), np.asarray(y, float)) for x, y in curves)
    return Chart(untranslated("a chart"), untranslated("x"), untranslated("y"), lines)


@pytest.mark.parametrize(
    ("curve", "does"), [(([0, 1, 1, 2], [0, 1, 2, 3]), False), ((np.cos(AROUND), np.sin(AROUND)), True)]
)
def test_a_curve_that_closes_turns_back(curve: tuple[object, object], does: bool) -> None:
    assert runs_backwards(chart(([0, 1], [0, 1]), curve)) is does


def test_heights_hold_every_curve_and_pass_over_what_is_blank() -> None:
    lower, upper = heights(chart(([0, 1, 2], [3, np.nan, -4]), ([0, 1], [np.nan, np.nan]), ([0, 1], [7, 8])))
    assert -5 < lower < -4
    assert 8 < upper < 9
    lower, upper = heights(chart(([0, 1], [np.nan, np.nan])))
    assert lower < upper


def test_curves_over_one_x_are_blank_where_they_are_not() -> None:
    x, short, long = common(chart(([1, 2], [5, 7]), (np.arange(1001), np.arange(1001))))
    assert len(x) == POINTS
    assert np.isnan(short[(x < 1) | (x > 2)]).all()
    np.testing.assert_allclose(long, x)
