"""Charts of a study in a panel, drawn by uPlot. Charts over time grow while their motion is played."""

from __future__ import annotations

import numpy as np
import viser
from markupsafe import Markup
from viser import uplot

from helicoide.arrays import Array
from helicoide.export.study_table import significant_digits
from helicoide.export.svg import COLOURS, axis_range, caption, figure, powers
from helicoide.studies.study import Chart
from helicoide.text import Language, Text, with_decimal_comma
from helicoide.view import html
from helicoide.view.rows import Plot, View

POINTS, HEIGHT = 400, 170
ACROSS, UP, PADDING = 30, 52, (10, 16, 0, 0)
SIZE = (320, 230)
CHART, CAPTION = Markup("<div class='helicoide-chart'>{}</div>"), Markup("<figure>{}</figure>")


def common(chart: Chart) -> tuple[Array, ...]:
    """The curves over one common x: x (k,), k ≤ `POINTS`, then y (k,) of each curve, NaN outside that curve's range."""
    low, high = min(line.x.min() for line in chart.lines), max(line.x.max() for line in chart.lines)
    x = np.linspace(low, high, min(POINTS, max(len(line.x) for line in chart.lines)))
    ys = []
    for line in chart.lines:
        order = np.argsort(line.x, kind="stable")
        ys.append(np.interp(x, line.x[order], line.y[order], left=np.nan, right=np.nan))
    return x, *ys


def runs_backwards(chart: Chart) -> bool:
    """Whether x decreases somewhere along a curve, as on a closed one; uPlot cannot draw such a curve."""
    return any((np.diff(line.x) < 0).any() for line in chart.lines)


def heights(chart: Chart) -> tuple[float, float]:
    """The range of y, which uPlot cannot find in a curve with NaN."""
    lines = [line.y[np.isfinite(line.y)] for line in chart.lines]
    return axis_range([y for y in lines if len(y)] or [np.ones(1)], chart.log)


class ChartPlot:
    """A chart. Its place in the panel is kept, and hidden while there is no chart."""

    def __init__(self, gui: viser.GuiApi, row: Plot, view: View) -> None:
        self.gui, self.row = gui, row
        self.words: viser.GuiHtmlHandle | None = None
        self.handle: viser.GuiUplotHandle | None = None
        self.drawn: Chart | None = None
        self.labels: tuple[Text, ...] = ()
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
        labels = (chart.title, chart.x_label, chart.y_label, *(line.title for line in chart.lines))
        if self.handle is not None and labels == self.labels and not runs_backwards(chart):
            self._reach(chart)
            self.handle.data = common(chart)
            return
        self.labels, self.language = labels, language
        for handle in (self.words, self.handle):
            if handle is not None:
                handle.remove()
        self.handle = None
        with self.place:
            if runs_backwards(chart):
                self.words = html.put_html(self.gui, CHART.format(figure(chart, language, SIZE)))
                return
            self.words = html.put_html(self.gui, CHART.format(CAPTION.format(caption(chart, language))))
            self.handle = self._lines(chart, language)

    def _lines(self, chart: Chart, language: Language) -> viser.GuiUplotHandle:
        """The curves of a chart, by uPlot."""
        series = [uplot.Series(label=chart.x_label[language])]
        for line, colour in zip(chart.lines, COLOURS * len(chart.lines), strict=False):
            series.append(uplot.Series(label=line.title[language], stroke=colour, width=1.5))
        self.reach = heights(chart)
        up, reach = axes(self.reach, chart.log, language), scales(self.reach, chart.log)
        return self.gui.add_uplot(common(chart), tuple(series), axes=up, scales=reach, height=HEIGHT, padding=PADDING)

    def _reach(self, chart: Chart) -> None:
        """Set the range of y for new data; a chart that is not complete yet keeps a range that contains it."""
        assert self.handle is not None
        lower, upper = heights(chart)
        blank = any(np.isnan(line.y).any() for line in chart.lines)
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
    shown = tuple(with_decimal_comma(significant_digits(mark, 2))[language] for mark in marks)
    return across, uplot.Axis(size=UP, splits=tuple(marks), values=shown)


def scales(reach: tuple[float, float], log: bool) -> dict[str, uplot.Scale]:
    """The scale of x, of numbers and not of dates, and of y with the range `reach`; log: y is logarithmic."""
    up = uplot.Scale(range=reach, distr=3) if log else uplot.Scale(range=reach)
    return {"x": uplot.Scale(time=False), "y": up}
