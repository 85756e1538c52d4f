"""Charts as SVG inside an HTML page: lines, axes with round numbers, no script, no link, no font of its own.

Studies draw only line charts, so this file replaces a plotting library. The labels are text of the page, which can be
searched, scaled and printed.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, log10

import numpy as np
from markupsafe import Markup

from helicoide.arrays import Array
from helicoide.markup import typeset
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import Language, power_of_ten, significant_digits, with_decimal_comma

# The size of a chart on a page: small enough for its words to be read on a phone, where it is drawn smaller than this.
PAGE = (520, 300)
LEFT, RIGHT, TOP, BOTTOM = 52, 14, 10, 26
CHARACTER, GAP = 9, 6  # width of a digit where letters are largest, and of the space between a label and the frame
# Distinguishable with colour blindness (Okabe and Ito 2008); dashes distinguish curves without colour.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#696969")
DASHES = ("", "7 3", "2 3", "9 3 2 3", "4 4", "12 4", "1 2")
MIN_TICKS, MAX_TICKS = 4, 8
FINEST, COARSEST, PLAIN_POWER = 1e-4, 1e6, 3


def ticks(lower: float, upper: float) -> Array:
    """Round numbers within a range, `FEW` to `MOST` of them; the step is 1, 2 or 5 times a power of ten."""
    exponent = floor(log10((upper - lower) / MIN_TICKS))
    steps = [m * 10.0**e for e in (exponent, exponent - 1) for m in (5, 2, 1)]
    step = next((s for s in steps if MIN_TICKS <= floor(upper / s) - ceil(lower / s) + 1 <= MAX_TICKS), steps[0])
    return np.asarray(np.arange(ceil(lower / step), floor(upper / step) + 1) * step)


def powers(lower: float, upper: float) -> Array:
    """Powers of ten within a range, at most `MOST` of them."""
    first, last = round(log10(lower)), round(log10(upper))
    return np.asarray(10.0 ** np.arange(first, last + 1, max(1, ceil((last - first) / MAX_TICKS))))


def labels(values: Array) -> list[str]:
    """The labels of ticks, with just enough decimals to distinguish them, or with an exponent."""
    step, largest = (float(values[1] - values[0]) if len(values) > 1 else 1.0), float(np.abs(values).max())
    values = np.where(np.abs(values) < step / 2, 0.0, values)
    if step >= FINEST and largest < COARSEST:
        decimals = max(0, -floor(log10(step) + 1e-9))
        return [f"{value:.{decimals}f}" for value in values]
    digits = 2 + floor(log10(max(largest, step) / step) + 1e-9)
    return [significant_digits(value, digits) for value in values]


def power_labels(values: Array) -> list[str]:
    """The labels of powers of ten, such as 0.01 or 10⁻⁵."""
    exponents = [round(log10(value)) for value in values]
    return [f"{10.0**n:g}" if abs(n) <= PLAIN_POWER else power_of_ten(n) for n in exponents]


def axis_range(values: list[Array], log: bool = False) -> tuple[float, float]:
    """The range of several curves with a margin, even if they are constant; log: whole powers of ten."""
    if log:
        powers = np.log10([value for v in values for value in v[v > 0]] or [1.0])
        return 10.0 ** floor(powers.min()), 10.0 ** max(ceil(powers.max()), floor(powers.min()) + 1)
    lower, upper = min(float(v.min()) for v in values), max(float(v.max()) for v in values)
    room = 0.04 * (upper - lower) or max(0.1 * abs(upper), 1e-9)
    return lower - room, upper + room


def reduced_curve(x: Array, y: Array, columns: int = PAGE[0]) -> tuple[Array, Array]:
    """The curve with fewer points: minimum and maximum of each column where x increases, else evenly spaced points."""
    if len(x) <= 4 * columns:
        return x, y
    if (np.diff(x) < 0).any():
        kept = np.linspace(0, len(x) - 1, 4 * columns).round().astype(int)
    else:
        pieces = np.array_split(np.arange(len(x)), columns)
        kept = np.unique([i for p in pieces for i in (p[0], p[y[p].argmin()], p[y[p].argmax()], p[-1])])
    return x[kept], y[kept]


@dataclass(frozen=True)
class ChartFrame:
    """The frame of a chart, in SVG units, and the ranges (lower, upper) of its axes.

    log: whether the vertical axis is logarithmic; left: the room for its labels.
    """

    width: int
    height: int
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    log: bool = False
    left: int = LEFT

    @property
    def bottom(self) -> int:
        """The y coordinate of the lower edge of the plot."""
        return self.height - BOTTOM

    def x_pixels(self, x: Array) -> Array:
        """The horizontal SVG coordinates of values of x."""
        share = (x - self.x_range[0]) / (self.x_range[1] - self.x_range[0])
        return np.asarray(self.left + share * (self.width - self.left - RIGHT))

    def y_pixels(self, y: Array) -> Array:
        """The vertical SVG coordinates of values of y."""
        lower, upper, y = (np.log10(v) if self.log else np.asarray(v) for v in (*self.y_range, y))
        return np.asarray(self.bottom - (y - lower) / (upper - lower) * (self.bottom - TOP))


def svg(chart: Chart, language: Language, size: tuple[int, int] = PAGE) -> Markup:
    """A chart as an SVG element, without title and legend."""
    across = axis_range([line.x for line in chart.lines])
    up = chart.y_range or axis_range([line.y[np.isfinite(line.y)] for line in chart.lines], chart.log)
    marks = powers(*up) if chart.log else ticks(*up)
    words = [_written(label, language) for label in (power_labels(marks) if chart.log else labels(marks))]
    left = max(LEFT, GAP + CHARACTER * max(map(len, words), default=0))
    frame = ChartFrame(*size, across, up, chart.log, left)
    inside = (
        *_grid(frame, list(zip(frame.y_pixels(marks), words, strict=True)), language),
        *(_polyline(line, i, frame) for i, line in enumerate(chart.lines)),
    )
    return Markup('<svg viewBox="0 0 {} {}" role="img" aria-label="{}">\n{}\n</svg>').format(
        frame.width, frame.height, chart.title[language], Markup("\n").join(inside)
    )


def caption(chart: Chart, language: Language) -> Markup:
    """The title and the axis labels of a chart as HTML text, which can wrap."""
    title = f"{chart.title[language]} ({chart.figure})" if chart.figure else chart.title[language]
    return Markup('<figcaption>{}</figcaption>\n<p class="axes"><span>↑ {}</span> <span>→ {}</span></p>').format(
        *map(typeset, (title, chart.y_label[language], chart.x_label[language]))
    )


def figure(chart: Chart, language: Language, size: tuple[int, int] = PAGE) -> Markup:
    """A chart with its title above and its legend below."""
    names = Markup("").join(
        Markup("<li>{} {}</li>").format(_swatch(i), typeset(line.title[language])) for i, line in enumerate(chart.lines)
    )
    return Markup("<figure>{}\n{}\n<ul>{}</ul></figure>").format(
        caption(chart, language), svg(chart, language, size), names
    )


def _written(label: str, language: Language) -> str:
    return with_decimal_comma(label.replace("-", "−"))[language]


def _grid(frame: ChartFrame, up: list[tuple[float, str]], language: Language) -> list[Markup]:
    """The frame, the grid and the labels. up: heights and labels of the marks of y."""
    x, floor_y, edge = ticks(*frame.x_range), frame.bottom, frame.width - RIGHT
    frame_of = Markup('<rect class="frame" x="{}" y="{}" width="{}" height="{}"/>')
    path = Markup('<path class="grid" d="{}"/>')
    text = Markup('<text x="{}" y="{}" text-anchor="{}">{}</text>')
    rows = [frame_of.format(frame.left, TOP, edge - frame.left, floor_y - TOP)]
    for at, label in zip(frame.x_pixels(x), labels(x), strict=True):
        rows.append(path.format(f"M{at:.1f} {TOP}V{floor_y}"))
        rows.append(text.format(f"{at:.1f}", floor_y + 16, "middle", _written(label, language)))
    for at, label in up:
        rows.append(path.format(f"M{frame.left} {at:.1f}H{edge}"))
        rows.append(text.format(frame.left - GAP, f"{at + 4:.1f}", "end", label))
    return rows


def _pen(index: int) -> Markup:
    stroke, dash = COLOURS[index % len(COLOURS)], DASHES[index % len(DASHES)]
    if not dash:
        return Markup('stroke="{}"').format(stroke)
    return Markup('stroke="{}" stroke-dasharray="{}"').format(stroke, dash)


def _swatch(index: int) -> Markup:
    stroke = Markup('<path class="line" d="M0 4H28" {}/>').format(_pen(index))
    return Markup('<svg class="swatch" viewBox="0 0 28 8" aria-hidden="true">{}</svg>').format(stroke)


def _polyline(line: ChartLine, index: int, frame: ChartFrame) -> Markup:
    there = np.isfinite(line.y)
    x, y = reduced_curve(line.x[there], line.y[there])
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(frame.x_pixels(x), frame.y_pixels(y), strict=True))
    return Markup('<polyline class="line" points="{}" {}/>').format(points, _pen(index))
