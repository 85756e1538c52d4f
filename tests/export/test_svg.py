"""Charts as SVG: axes with round numbers, curves inside the frame, words of people escaped."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.export.svg import (
    BOTTOM,
    CHARACTER,
    LEFT,
    PAGE,
    RIGHT,
    TOP,
    axis_range,
    figure,
    labels,
    power_labels,
    reduced_curve,
    svg,
    ticks,
)
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import Text, untranslated

WIDTH, HEIGHT = PAGE
bounds = st.tuples(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6)).map(lambda pair: (pair[0], pair[0] + pair[1]))


def chart(*curves: tuple[list[float], list[float]]) -> Chart:
    lines = tuple(
        ChartLine(Text(en=f"line {i} <", pt_BR=f"linha {i} <"), np.array(x), np.array(y))
        for i, (x, y) in enumerate(curves)
    )
    return Chart(Text(en="A & B", pt_BR="A e B"), untranslated("t (s)"), untranslated("x > 0"), lines)


@given(bounds)
def test_ticks_are_few_round_and_inside(range_: tuple[float, float]) -> None:
    lower, upper = range_
    found = ticks(lower, upper)
    assert 3 <= len(found) <= 9
    width = upper - lower
    assert found.min() >= lower - 1e-9 * max(abs(lower), width)
    assert found.max() <= upper + 1e-9 * max(abs(upper), width)
    step = np.diff(found).mean()
    np.testing.assert_allclose(np.diff(found), step, rtol=1e-6, atol=1e-9 * max(abs(lower), abs(upper)))
    first = step / 10 ** np.floor(np.log10(step * (1 + 1e-9)))
    assert min(abs(first - digit) for digit in (1, 2, 5, 10)) < 1e-3


@given(bounds)
def test_labels_tell_ticks_apart(range_: tuple[float, float]) -> None:
    found = ticks(*range_)
    assert len(set(labels(found))) == len(found)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ((0.0, 0.2, 0.4), ["0.0", "0.2", "0.4"]),
        ((99.5, 100.0, 100.5), ["99.5", "100.0", "100.5"]),
        ((0, 1e-7), ["0", "1×10⁻⁷"]),
        ((-100.0, 0.0, 100.0), ["-100", "0", "100"]),
        ((150.0, 200.0, 250.0), ["150", "200", "250"]),
    ],
)
def test_labels_are_short(values: tuple[float, ...], said: list[str]) -> None:
    assert labels(np.array(values)) == said


def test_a_constant_curve_has_room_above_and_below() -> None:
    for value in (0.0, 5.0, -3.0):
        lower, upper = axis_range([np.full(3, value)])
        assert lower < value < upper


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_the_curves_stay_inside_the_frame(language: str) -> None:
    drawn = svg(chart(([0, 1, 2], [3, -4, 5]), ([0, 2], [7, 7])), language)  # type: ignore[arg-type]
    root = ElementTree.fromstring(drawn)
    lines = root.findall("polyline")
    assert len(lines) == 2
    for line in lines:
        xy = np.array([[float(v) for v in pair.split(",")] for pair in line.attrib["points"].split()])
        assert xy[:, 0].min() >= LEFT
        assert xy[:, 0].max() <= WIDTH - RIGHT
        assert xy[:, 1].min() >= TOP
        assert xy[:, 1].max() <= HEIGHT - BOTTOM
    assert lines[0].attrib["stroke"] != lines[1].attrib["stroke"]
    assert "stroke-dasharray" in lines[1].attrib


def test_higher_values_are_drawn_higher_and_later_ones_to_the_right() -> None:
    root = ElementTree.fromstring(svg(chart(([0, 1], [0, 1])), "en"))
    [line] = root.findall("polyline")
    (x0, y0), (x1, y1) = ([float(v) for v in pair.split(",")] for pair in line.attrib["points"].split())
    assert x1 > x0
    assert y1 < y0


def test_a_figure_names_its_curves_and_escapes_words() -> None:
    drawn = figure(chart(([0, 1], [0, 1])), "pt_BR")
    assert "A e B" in drawn
    assert "linha 0 &lt;" in drawn
    assert "x &gt; 0" in drawn
    ElementTree.fromstring(drawn)
    assert "A &amp; B" in figure(chart(([0, 1], [0, 1])), "en")
    assert not re.search(r"href|url\(|<script|<image", drawn)


def test_thinning_keeps_the_peaks_of_a_long_curve() -> None:
    x = np.linspace(0, 1, 60_000)
    y = np.zeros_like(x)
    y[12_345], y[43_210] = 9.0, -7.0
    fewer_x, fewer_y = reduced_curve(x, y)
    assert len(fewer_x) <= 4 * WIDTH
    assert (fewer_y.max(), fewer_y.min()) == (9.0, -7.0)
    assert (fewer_x[0], fewer_x[-1]) == (0.0, 1.0)
    assert (np.diff(fewer_x) > 0).all()
    around = np.linspace(0, 2 * np.pi, 60_000)
    assert len(reduced_curve(np.cos(around), np.sin(around))[0]) == 4 * WIDTH
    assert reduced_curve(x[:9], y[:9])[0] is not None


@pytest.mark.parametrize("values", [(1e-7, 1e-2), (1e-5, 1e4), (0.0101, 0.0102), (-1234.5, 98765.4)])
@pytest.mark.parametrize("log", [False, True])
def test_no_label_is_cut_at_the_left(values: tuple[float, float], log: bool) -> None:
    """A character is at most `CHARACTER` wide."""
    x, y = np.array([0.0, 1.0]), np.abs(values) if log else np.array(values)
    name = untranslated("y")
    drawn = svg(Chart(name, name, name, (ChartLine(name, x, y),), log=log), "pt_BR")
    for right, label in re.findall(r'<text x="([\d.]+)" y="[\d.]+" text-anchor="end">([^<]*)<', drawn):
        assert float(right) >= CHARACTER * len(label)
        assert "e" not in label
        assert "-" not in label


def test_powers_of_ten_are_written_shortly() -> None:
    assert power_labels(np.array([1e-5, 1e-3, 0.1, 1.0, 1e3, 1e4])) == ["10⁻⁵", "0.001", "0.1", "1", "1000", "10⁴"]
