"""Charts of a study in a panel, drawn by uPlot; those over time grow while their motion is played."""

from __future__ import annotations

import numpy as np
import viser
from viser import uplot

from helicoide.kinematics.chain import Array
from helicoide.studies.study import Chart
from helicoide.text import Language, Text
from helicoide.view.rows import Plot, View

POINTS, HEIGHT = 400, 190
COLOURS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#7f7f7f")


def common(chart: Chart) -> tuple[Array, ...]:
    """The curves over one x, at most `POINTS` of them: x (k,), then a y (k,) for each; NaN where a curve is not."""
    low, high = min(line.x.min() for line in chart.lines), max(line.x.max() for line in chart.lines)
    x = np.linspace(low, high, min(POINTS, max(len(line.x) for line in chart.lines)))
    ys = []
    for line in chart.lines:
        order = np.argsort(line.x, kind="stable")
        ys.append(np.interp(x, line.x[order], line.y[order], left=np.nan, right=np.nan))
    return x, *ys


class Plotted:
    """A chart; its place is kept, and hidden while there is nothing to draw."""

    def __init__(self, gui: viser.GuiApi, row: Plot, view: View) -> None:
        self.gui, self.row = gui, row
        self.handle: viser.GuiUplotHandle | None = None
        self.drawn: Chart | None = None
        self.labels: tuple[Text, ...] = ()
        self.place = gui.add_folder("", visible=False)
        self.refresh(view)

    def refresh(self, view: View) -> None:
        """Show the chart that the view has now."""
        charts = self.row.charts(view)
        chart = charts[self.row.index] if self.row.index < len(charts) else None
        if chart is self.drawn:
            return
        self.drawn = chart
        if self.place.visible != (chart is not None):
            self.place.visible = chart is not None
        if chart is not None:
            self._draw(chart, view.seat.language)

    def _draw(self, chart: Chart, language: Language) -> None:
        """Give the chart that stands there other numbers, or put up another one."""
        labels = (chart.title, chart.across, chart.up, *(line.title for line in chart.lines))
        if self.handle is not None and labels == self.labels:
            self.handle.data = common(chart)
            return
        self.labels = labels
        if self.handle is not None:
            self.handle.remove()
        self.place.label = chart.title[language]
        series = [uplot.Series(label=chart.across[language])]
        for line, colour in zip(chart.lines, COLOURS * len(chart.lines), strict=False):
            series.append(uplot.Series(label=line.title[language], stroke=colour, width=1.5))
        axes = (uplot.Axis(label=chart.across[language]), uplot.Axis(label=chart.up[language]))
        with self.place:
            self.handle = self.gui.add_uplot(
                common(chart), tuple(series), axes=axes, scales={"x": uplot.Scale(time=False)}, height=HEIGHT
            )

    def remove(self) -> None:
        """Take it out of the window."""
        self.place.remove()
