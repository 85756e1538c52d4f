"""Charts in a panel, drawn by uPlot: those of a study, which grow while their motion is played, and live signals."""

from __future__ import annotations

import numpy as np
import viser
from markupsafe import Markup
from viser import uplot

from helicoide.arrays import Array
from helicoide.export.svg import COLOURS, axis_range, caption, figure, power_labels, powers
from helicoide.markup import plain_subscripts
from helicoide.studies.study import Chart
from helicoide.text import Language, with_decimal_comma
from helicoide.view import html
from helicoide.view.rows import Plot
from helicoide.view.window_view import View

POINTS, HEIGHT = 400, 170
ACROSS, UP, PADDING = 30, 52, (10, 16, 0, 0)
SIZE = (320, 230)
CHART, CAPTION = Markup("<div class='helicoide-chart'>{}</div>"), Markup("<figure>{}</figure>")
BAND_FILLS = {False: "rgba(230, 159, 0, 0.2)", True: "rgba(213, 94, 0, 0.22)"}
BAND_EDGES = {False: "#b26b00", True: "#b0350a"}
HIDDEN = "helicoide-hidden"  # a line without an entry in the legend


def common(chart: Chart) -> tuple[Array, ...]:
    """The curves over one common x: x (k,), k ≤ `POINTS`, then y (k,) of each curve, NaN outside that curve's range.

    Curves that share their x as one array keep its values.
    """
    first = chart.lines[0].x
    if len(first) <= 2 * POINTS and all(line.x is first for line in chart.lines):
        return first, *(line.y for line in chart.lines)
    low, high = min(line.x.min() for line in chart.lines), max(line.x.max() for line in chart.lines)
    x = np.linspace(low, high, min(POINTS, max(len(line.x) for line in chart.lines)))
    ys = []
    for line in chart.lines:
        order = np.argsort(line.x, kind="stable")
        ys.append(np.interp(x, line.x[order], line.y[order], left=np.nan, right=np.nan))
    return x, *ys


def runs_backwards(chart: Chart) -> bool:
    """Whether x decreases somewhere along a curve, as on a closed one; uPlot cannot draw such a curve."""
    return chart.phase or any((np.diff(line.x) < 0).any() for line in chart.lines)


def heights(chart: Chart) -> tuple[float, float]:
    """The range of y, which uPlot cannot find in a curve with NaN."""
    if chart.y_range is not None:
        return chart.y_range
    lines = [line.y[np.isfinite(line.y)] for line in chart.lines]
    return axis_range([y for y in lines if len(y)] or [np.ones(1)], chart.log)


def band_edges(chart: Chart, reach: tuple[float, float], count: int) -> list[Array]:
    """The upper and the lower edge of each band as curves (count,), within the range of y."""
    edges = np.clip([edge for band in chart.bands for edge in (band.upper, band.lower)], *reach)
    return [np.full(count, edge) for edge in edges]


def band_series(chart: Chart, language: Language) -> list[uplot.Series]:
    """The two edges of each band; its inner one, or else its upper one, is in the legend."""
    series = []
    for band in chart.bands:
        for edge, other in ((band.upper, band.lower), (band.lower, band.upper)):
            named = np.isfinite(edge) and (edge == band.upper or not np.isfinite(other))
            one = uplot.Series(label=band.title[language], stroke=BAND_EDGES[band.serious], width=1, dash=(5, 4))
            one["points"] = uplot.Series_Points(show=False)
            series.append(one if named else uplot.Series(**{**one, "class": HIDDEN, "width": 0}))
    return series


def bands_between(chart: Chart) -> tuple[uplot.Band, ...]:
    """The areas between the edges, whose series come after those of the lines."""
    first = 1 + len(chart.lines)
    return tuple(
        uplot.Band(series=(first + 2 * k, first + 2 * k + 1), fill=BAND_FILLS[band.serious])
        for k, band in enumerate(chart.bands)
    )


class ChartPlot:
    """A chart. Its place in the panel is kept, and hidden while there is no chart."""

    def __init__(self, gui: viser.GuiApi, row: Plot, view: View) -> None:
        self.gui, self.row = gui, row
        self.words: viser.GuiHtmlHandle | None = None
        self.handle: viser.GuiUplotHandle | None = None
        self.drawn: Chart | None = None
        self.labels: tuple[object, ...] = ()
        self.language: Language = view.seat.language
        self.place = gui.add_folder(None, visible=False)
        self.refresh(view)

    def refresh(self, view: View) -> None:
        """Show the current chart of a view."""
        charts = self.row.charts(view)
        chart = charts[self.row.index] if self.row.index < len(charts) else None
        if chart is self.drawn:
            return
        self.drawn = chart
        if chart is not None:
            self._draw(chart, view.seat.language)
        if self.place.visible != (chart is not None):
            self.place.visible = chart is not None

    def _draw(self, chart: Chart, language: Language) -> None:
        """Give the existing plot new data, or replace it by another plot or figure."""
        parts = (*(line.title for line in chart.lines), *(band.title for band in chart.bands))
        labels, is_figure = (chart.log, chart.title, chart.x_label, chart.y_label, *parts), runs_backwards(chart)
        if self.handle is not None and labels == self.labels and not is_figure:
            self._reach(chart)
            self.handle.data = self._data(chart)
            return
        if self.handle is None and self.words is not None and is_figure:
            html.show(self.words, CHART.format(figure(chart, language, SIZE)))
            return
        self.labels, self.language = labels, language
        for handle in (self.words, self.handle):
            if handle is not None:
                handle.remove()
        self.handle = None
        with self.place:
            if is_figure:
                self.words = html.put_html(self.gui, CHART.format(figure(chart, language, SIZE)))
                return
            self.words = html.put_html(self.gui, CHART.format(CAPTION.format(caption(chart, language))))
            self.handle = self._lines(chart, language)

    def _lines(self, chart: Chart, language: Language) -> viser.GuiUplotHandle:
        """The curves of a chart, by uPlot."""
        series = [uplot.Series(label=plain_subscripts(chart.x_label[language]))]
        for line, colour in zip(chart.lines, COLOURS * len(chart.lines), strict=False):
            series.append(uplot.Series(label=plain_subscripts(line.title[language]), stroke=colour, width=1.5))
        self.reach = heights(chart)
        return self.gui.add_uplot(
            self._data(chart),
            (*series, *band_series(chart, language)),
            bands=bands_between(chart) or None,
            axes=axes(self.reach, chart.log, language),
            scales=scales(self.reach, chart.log),
            height=HEIGHT,
            padding=PADDING,
        )

    def _data(self, chart: Chart) -> tuple[Array, ...]:
        """x, the curves, and the edges of the bands."""
        x, *ys = common(chart)
        return x, *ys, *band_edges(chart, self.reach, len(x))

    def _reach(self, chart: Chart) -> None:
        """Set the range of y for new data; a chart that is not complete yet keeps a range that contains it."""
        assert self.handle is not None
        lower, upper = heights(chart)
        blank = chart.y_range is None and any(np.isnan(line.y).any() for line in chart.lines)
        if blank and self.reach[0] <= lower and upper <= self.reach[1]:
            return
        if (lower, upper) != self.reach:
            self.reach = (lower, upper)
            self.handle.axes = axes(self.reach, chart.log, self.language)
            self.handle.scales = scales(self.reach, chart.log)

    def remove(self) -> None:
        """Remove the chart from the window."""
        self.place.remove()


def axes(reach: tuple[float, float], log: bool, language: Language) -> tuple[uplot.Axis, ...]:
    """The x axis and the y axis. log: marks of y at powers of ten, since uPlot would write the small ones as 0."""
    across = uplot.Axis(size=ACROSS)
    if not log:
        return across, uplot.Axis(size=UP)
    marks = [float(mark) for mark in powers(*reach)]
    shown = tuple(with_decimal_comma(label)[language] for label in power_labels(np.array(marks)))
    return across, uplot.Axis(size=UP, splits=tuple(marks), values=shown)


def scales(reach: tuple[float, float], log: bool) -> dict[str, uplot.Scale]:
    """The scale of x, of numbers and not of dates, and of y with the range `reach`; log: y is logarithmic."""
    up = uplot.Scale(range=reach, distr=3) if log else uplot.Scale(range=reach)
    return {"x": uplot.Scale(time=False), "y": up}
