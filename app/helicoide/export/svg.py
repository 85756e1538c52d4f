"""Charts as SVG that stands inside a page: lines, axes with round numbers, no script, no address, no font of its own.

Line charts are all that a study draws, so that this file stands in for a plotting library with its dozen packages; its
text stays text of the page, which can be searched, translated in size, and printed.
"""

from __future__ import annotations

from html import escape
from math import ceil, floor, log10

import numpy as np

from helicoide.kinematics.chain import Array
from helicoide.studies.study import Chart, Line
from helicoide.text import Language

WIDTH, HEIGHT = 720, 320
LEFT, RIGHT, TOP, BOTTOM = 76, 12, 10, 46
# Told apart by people who do not see all colours (Okabe and Ito 2008), and by dashes where there is no colour.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")
DASHES = ("", "7 3", "2 3", "9 3 2 3", "4 4", "12 4", "1 2")
FEW, MOST = 4, 8
FINEST, COARSEST = 1e-4, 1e6


def ticks(lower: float, upper: float) -> Array:
    """Round numbers within a range, 1, 2 or 5 times a power of ten apart, `FEW` to `MOST` of them."""
    exponent = floor(log10((upper - lower) / FEW))
    steps = [m * 10.0**e for e in (exponent, exponent - 1) for m in (5, 2, 1)]
    step = next((s for s in steps if FEW <= floor(upper / s) - ceil(lower / s) + 1 <= MOST), steps[0])
    return np.asarray(np.arange(ceil(lower / step), floor(upper / step) + 1) * step)


def labels(values: Array) -> list[str]:
    """Ticks with as many decimals as tell them apart; powers of ten where they would be many."""
    step, largest = (float(values[1] - values[0]) if len(values) > 1 else 1.0), float(np.abs(values).max())
    values = np.where(np.abs(values) < step / 2, 0.0, values)
    if step >= FINEST and largest < COARSEST:
        decimals = max(0, -floor(log10(step) + 1e-9))
        return [f"{value:.{decimals}f}" for value in values]
    digits = 2 + floor(log10(max(largest, step) / step) + 1e-9)
    return [f"{value:.{digits}g}" for value in values]


def span(values: list[Array]) -> tuple[float, float]:
    """The range of several curves with a little room, also where they are constant."""
    lower, upper = min(float(v.min()) for v in values), max(float(v.max()) for v in values)
    room = 0.04 * (upper - lower) or max(0.1 * abs(upper), 1e-9)
    return lower - room, upper + room


def thinned(x: Array, y: Array, columns: int = WIDTH) -> tuple[Array, Array]:
    """The same curve with fewer points: the lowest and the highest of each column where x rises, else every few."""
    if len(x) <= 4 * columns:
        return x, y
    if (np.diff(x) < 0).any():
        kept = np.linspace(0, len(x) - 1, 4 * columns).round().astype(int)
    else:
        pieces = np.array_split(np.arange(len(x)), columns)
        kept = np.unique([i for p in pieces for i in (p[0], p[y[p].argmin()], p[y[p].argmax()], p[-1])])
    return x[kept], y[kept]


def svg(chart: Chart, language: Language) -> str:
    """A chart as an SVG element."""
    across, up = span([line.x for line in chart.lines]), span([line.y for line in chart.lines])
    title, x_title, y_title = (escape(text[language]) for text in (chart.title, chart.across, chart.up))
    middle_x, middle_y = (LEFT + WIDTH - RIGHT) / 2, (TOP + HEIGHT - BOTTOM) / 2
    return "\n".join(
        [
            f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{title}">',
            *_grid(across, up),
            *(_polyline(line, i, across, up) for i, line in enumerate(chart.lines)),
            f'<text x="{middle_x:g}" y="{HEIGHT - 8}" text-anchor="middle">{x_title}</text>',
            f'<text transform="translate(14 {middle_y:g}) rotate(-90)" text-anchor="middle">{y_title}</text>',
            "</svg>",
        ]
    )


def figure(chart: Chart, language: Language) -> str:
    """A chart with its title above and its curves named below."""
    names = "".join(f"<li>{_swatch(i)} {escape(line.title[language])}</li>" for i, line in enumerate(chart.lines))
    title = escape(chart.title[language])
    return f"<figure><figcaption>{title}</figcaption>\n{svg(chart, language)}\n<ul>{names}</ul></figure>"


def _right(x: Array, across: tuple[float, float]) -> Array:
    return np.asarray(LEFT + (x - across[0]) / (across[1] - across[0]) * (WIDTH - LEFT - RIGHT))


def _down(y: Array, up: tuple[float, float]) -> Array:
    return np.asarray(HEIGHT - BOTTOM - (y - up[0]) / (up[1] - up[0]) * (HEIGHT - TOP - BOTTOM))


def _grid(across: tuple[float, float], up: tuple[float, float]) -> list[str]:
    x, y, floor_y = ticks(*across), ticks(*up), HEIGHT - BOTTOM
    rows = [f'<rect class="frame" x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" height="{floor_y - TOP}"/>']
    for at, label in zip(_right(x, across), labels(x), strict=True):
        rows.append(f'<path class="grid" d="M{at:.1f} {TOP}V{floor_y}"/>')
        rows.append(f'<text x="{at:.1f}" y="{floor_y + 16}" text-anchor="middle">{label}</text>')
    for at, label in zip(_down(y, up), labels(y), strict=True):
        rows.append(f'<path class="grid" d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}"/>')
        rows.append(f'<text x="{LEFT - 6}" y="{at + 4:.1f}" text-anchor="end">{label}</text>')
    return rows


def _pen(index: int) -> str:
    dash = DASHES[index % len(DASHES)]
    return f'stroke="{COLOURS[index % len(COLOURS)]}"' + (f' stroke-dasharray="{dash}"' if dash else "")


def _swatch(index: int) -> str:
    stroke = f'<path class="line" d="M0 4H28" {_pen(index)}/>'
    return f'<svg class="swatch" viewBox="0 0 28 8" aria-hidden="true">{stroke}</svg>'


def _polyline(line: Line, index: int, across: tuple[float, float], up: tuple[float, float]) -> str:
    x, y = thinned(line.x, line.y)
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(_right(x, across), _down(y, up), strict=True))
    return f'<polyline class="line" points="{points}" {_pen(index)}/>'
