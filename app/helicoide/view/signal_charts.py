"""Charts of the history of live signals: over time with their bands, or one over the other as a phase plane."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import floor, log10

import numpy as np

from helicoide.arrays import Array
from helicoide.export.svg import axis_range
from helicoide.ik.methods import named
from helicoide.readout.signal import Band, PhasePlane, Signal
from helicoide.readout.signal_history import GAP, SignalHistory
from helicoide.readout.signals import phase_planes, signals_of
from helicoide.state import State
from helicoide.studies.study import Chart, ChartBand, ChartLine
from helicoide.text import Text, untranslated
from helicoide.view.chart_plot import POINTS
from helicoide.view.window_view import View

TIME = Text(en="time t [s]", pt_BR="tempo t [s]")
OF_METHOD, INVERSE = untranslated("{curve}, {method}"), untranslated("{y} = 1/{x}")
# A logarithmic axis shows at most this many powers of ten below the largest value.
DECADES = 8
PHASE_POINTS = 250  # of a curve in a phase plane
BRANCH = 100  # points of a branch of 1/x
CACHED = 128  # enough for four charts in each window of a class of thirty
Titles = tuple[Text, ...]


def live_charts(view: View) -> tuple[Chart, ...]:
    """The charts that the seat has chosen, without those that have no values yet."""
    choice, history = view.seat.charts, view.history
    if len(history.times) < 2 or history.robot is not view.state.robot:
        return ()
    known, phases, titles = signals_of(view.state), phase_planes(), method_titles(view.state)
    charts: list[Chart | None] = []
    for name in choice.shown:
        if name in phases:
            pair = known.get(phases[name].across), known.get(phases[name].up)
            if pair[0] is not None and pair[1] is not None:
                charts.append(_phase_chart(history, phases[name], (pair[0], pair[1]), choice.span, titles))
        elif name in known:
            signal = known[name]
            bands = signal.bands(view.state)
            charts.append(_time_chart(history, signal, bands, (choice.span, choice.log and signal.positive), titles))
    return tuple(chart for chart in charts if chart is not None)


def method_titles(state: State) -> Titles:
    """The title of the method of each arm; none if there is only one arm."""
    second = state.compared
    if second is None:
        return ()
    return tuple(named(one.method).TITLE for one in (state.request.controller, second.controller))


def _curves(signal: Signal, titles: Titles) -> Iterator[tuple[int, int, Text]]:
    """Number of the arm, number of the curve, and title of each line of a signal."""
    for c, curve in enumerate(signal.curves):
        for arm in range(max(1, len(titles))):
            yield arm, c, OF_METHOD.format(curve=curve, method=titles[arm]) if titles else curve


def axis_label(signal: Signal) -> Text:
    """The symbol and the unit of a signal."""
    return untranslated(f"{signal.symbol} [{signal.unit}]" if signal.unit else signal.symbol)


@lru_cache(maxsize=CACHED)  # until the next sample, so that a chart that has not changed is the same object
def _time_chart(
    history: SignalHistory, signal: Signal, bands: tuple[Band, ...], axis: tuple[float, bool], titles: Titles
) -> Chart | None:
    """axis: the span, s, and whether it is logarithmic. None if there is no value in the span."""
    span, log = axis
    part = history.since(span)
    sampled = history.of(signal)
    if sampled is None or not np.isfinite(sampled[part]).any():
        return None
    times, values = _thinned(*_with_gaps(history.times[part], sampled[part]))
    if log:
        values = np.where(values > 0, values, np.nan)
    shown = tuple(band for band in bands if not log)
    lines = tuple(ChartLine(title, times, values[:, arm, c]) for arm, c, title in _curves(signal, titles))
    return Chart(
        signal.title,
        TIME,
        axis_label(signal),
        lines,
        log=log,
        bands=tuple(ChartBand(band.title, band.lower, band.upper, band.level == "critical") for band in shown),
        y_range=_range(values, shown, log),
    )


def _with_gaps(times: Array, values: Array) -> tuple[Array, Array]:
    """Samples with a NaN between two that are further apart than `GAP`, so that no line joins them."""
    after = np.flatnonzero(np.diff(times) > GAP) + 1
    return np.insert(times, after, times[after - 1] + 1e-3), np.insert(values, after, np.nan, axis=0)


def _thinned(times: Array, values: Array) -> tuple[Array, Array]:
    """About `POINTS` samples: of each piece of time those where a curve is least or largest."""
    if len(times) <= POINTS:
        return times, values
    flat = values.reshape(len(times), -1)
    pieces = np.array_split(np.arange(len(times)), max(1, POINTS // (2 * flat.shape[1])))
    low, high = np.where(np.isnan(flat), np.inf, flat), np.where(np.isnan(flat), -np.inf, flat)
    kept = np.unique([piece[k] for piece in pieces for k in (*low[piece].argmin(axis=0), *high[piece].argmax(axis=0))])
    changes = np.flatnonzero(np.diff(np.isnan(flat).all(axis=1))) + 1  # a blank that begins or ends
    kept = np.union1d(np.union1d(kept, changes), [0, len(times) - 1])
    return times[kept], values[kept]


def _range(values: Array, bands: tuple[Band, ...], log: bool) -> tuple[float, float]:
    """The range of y: all values and the edges of the bands, rounded outwards so that it seldom changes."""
    finite = values[np.isfinite(values)]
    if log:
        lower, upper = axis_range([finite if len(finite) else np.ones(1)], log=True)
        return max(lower, upper * 10.0**-DECADES), upper
    edges = [edge for band in bands for edge in (band.lower, band.upper) if np.isfinite(edge)]
    lower, upper = axis_range([np.array([*finite, *edges] or [0.0])])
    step = 10.0 ** floor(log10(upper - lower)) / 2
    return step * floor(lower / step), -step * floor(-upper / step)


@lru_cache(maxsize=CACHED)
def _phase_chart(
    history: SignalHistory, phase: PhasePlane, signals: tuple[Signal, Signal], span: float, titles: Titles
) -> Chart | None:
    """One signal over another, curve by curve; None if no curve has values."""
    across, up = signals
    part = history.since(span)
    horizontal, vertical = history.of(across), history.of(up)
    if horizontal is None or vertical is None:
        return None
    x, y = horizontal[part], vertical[part]
    lines = []
    every = max(1, len(x) // PHASE_POINTS)
    x, y = x[::-every][::-1], y[::-every][::-1]  # with the last sample
    for arm, c, title in _curves(up, titles):
        where = np.isfinite(x[:, arm, min(c, x.shape[2] - 1)]) & np.isfinite(y[:, arm, c])
        if where.any():
            lines.append(ChartLine(title, x[where, arm, min(c, x.shape[2] - 1)], y[where, arm, c]))
    if not lines:
        return None
    y_range = axis_range([line.y for line in lines])
    if phase.inverse:
        lines.extend(_inverse(across, up, lines, y_range))
    return Chart(phase.title, axis_label(across), axis_label(up), tuple(lines), y_range=y_range, phase=True)


def _inverse(across: Signal, up: Signal, lines: list[ChartLine], y_range: tuple[float, float]) -> Iterator[ChartLine]:
    """The branches of y = 1/x, to which the curves converge, within the ranges of both axes."""
    low, high = axis_range([line.x for line in lines])
    for start, end in ((low, min(high, 0.0)), (max(low, 0.0), high)):
        x = np.linspace(start, end, BRANCH)[1:-1]
        with np.errstate(divide="ignore"):
            y = 1 / x
        inside = (y >= y_range[0]) & (y <= y_range[1])
        if start < end and inside.any():
            yield ChartLine(INVERSE.format(y=up.symbol, x=across.symbol), x[inside], y[inside])
