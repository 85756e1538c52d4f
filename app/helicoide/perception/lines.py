"""Rows of points as lines of text, with x, y and z among other columns; a header gives the layout."""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice

import numpy as np

from helicoide.perception.columns import AXES, Column, check_row_count, column_index
from helicoide.perception.formats import RawPoints
from helicoide.perception.text.splitting import LineSplitter, with_decimals
from helicoide.perception.text.table import read_rows

SAMPLE = 200


def from_text(columns: Sequence[Column], points: int, data: bytes, above: bytes, skipped: int = 0) -> RawPoints:
    """The columns x, y, z, (k, 3), of lines of text, after a header and `skipped` lines."""
    begins = np.cumsum([0, *(column.count for column in columns)])
    places = [int(begins[column_index(columns, axis)]) for axis in AXES]
    lines = islice(io.TextIOWrapper(io.BytesIO(data), encoding="latin-1"), skipped, None)
    first = list(islice(lines, SAMPLE))
    cells = with_decimals(LineSplitter(), first)
    source: Iterator[str] = chain(first, lines)
    if any(column.length for column in columns[: max(column_index(columns, axis) for axis in AXES)]):
        source = _without_lists(source, columns)
    begin = len(above.splitlines()) + skipped + 1
    rows, notes, count = read_rows(source, places, cells, begin, points)
    check_row_count(count, points)
    return RawPoints(rows, notes)


def _without_lists(lines: Iterable[str], columns: Sequence[Column]) -> Iterator[str]:
    """Lines with each list replaced by one dash, so that every column has a fixed index."""
    for line in lines:
        words, at, kept = line.split(), 0, list[str]()
        for column in columns:
            if column.length:
                long = int(words[at]) if at < len(words) and words[at].isdecimal() else 0
                at, word = at + 1 + long, "-"
            else:
                word, at = (words[at] if at < len(words) else ""), at + 1
            kept.append(word)
        yield " ".join(kept)
