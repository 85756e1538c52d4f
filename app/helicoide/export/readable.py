"""Charts counted so that their numbers are short: a power of ten goes into the name of what is up."""

from __future__ import annotations

from dataclasses import replace
from math import floor, log10

import numpy as np

from helicoide.arrays import Array
from helicoide.export.study_table import raised
from helicoide.studies.study import Chart
from helicoide.text import same

# What three decimals and five digits tell apart.
LEAST_SPAN, MOST_VALUE = 0.05, 1e4


def readable(chart: Chart) -> Chart:
    """The chart with y in a power of ten in which three decimals are enough; `up` names the power.

    One that is drawn by powers of ten stays as it is, without what has no logarithm.
    """
    if chart.log:
        lines = tuple(replace(line, y=np.where(line.y > 0, line.y, np.nan)) for line in chart.lines)
        return replace(chart, lines=lines)
    power = _power(np.concatenate([line.y[np.isfinite(line.y)] for line in chart.lines]))
    if power == 0:
        return chart
    lines = tuple(replace(line, y=line.y / 10.0**power) for line in chart.lines)
    return replace(chart, up=same("{up} × {power}").format(up=chart.up, power=raised(power)), lines=lines)


def _power(values: Array) -> int:
    """The exponent, a multiple of three, that leaves 1 to 1000 of the span; 0 where values can be read as they are."""
    if not len(values):
        return 0
    most = float(np.abs(values).max())
    span = float(np.ptp(values)) or most
    if span == 0 or (span >= LEAST_SPAN and most < MOST_VALUE):
        return 0
    return 3 * floor(log10(most if most >= MOST_VALUE else span) / 3)
