"""Charts scaled so that the numbers on the axis are short: the label of the axis names the power of ten."""

from __future__ import annotations

from dataclasses import replace
from math import floor, log10

import numpy as np

from helicoide.arrays import Array
from helicoide.studies.study import Chart
from helicoide.text import power_of_ten, untranslated

# A smaller span needs more than three decimals, and a larger value more than five digits.
LEAST_SPAN, MOST_VALUE = 0.05, 1e4


def scaled_chart(chart: Chart) -> Chart:
    """The chart with y divided by a power of ten, so that three decimals are enough; `up` names the power.

    A logarithmic chart is not scaled, and its values without a logarithm become NaN.
    """
    if chart.log:
        lines = tuple(replace(line, y=np.where(line.y > 0, line.y, np.nan)) for line in chart.lines)
        return replace(chart, lines=lines)
    power = _power(np.concatenate([line.y[np.isfinite(line.y)] for line in chart.lines]))
    if power == 0:
        return chart
    lines = tuple(replace(line, y=line.y / 10.0**power) for line in chart.lines)
    return replace(
        chart, y_label=untranslated("{up} × {power}").format(up=chart.y_label, power=power_of_ten(power)), lines=lines
    )


def _power(values: Array) -> int:
    """The exponent, a multiple of three, that scales the span to 1 … 1000; 0 if the values are readable unscaled."""
    if not len(values):
        return 0
    most = float(np.abs(values).max())
    span = float(np.ptp(values)) or most
    if span == 0 or (span >= LEAST_SPAN and most < MOST_VALUE):
        return 0
    return 3 * floor(log10(most if most >= MOST_VALUE else span) / 3)
