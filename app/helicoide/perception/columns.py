"""Rows of points with x, y and z among other columns, as text or as bytes, whose layout a header told."""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, islice

import numpy as np
from numpy.typing import NDArray

from helicoide.kinematics.chain import Array
from helicoide.perception.broken import Broken
from helicoide.perception.formats import Raw
from helicoide.perception.lists import walk
from helicoide.perception.text.cells import Cells, with_decimals
from helicoide.perception.text.table import table
from helicoide.text import Text

AXES = ("x", "y", "z")
SAMPLE = 200


@dataclass(frozen=True)
class Column:
    """A column: its name, the numpy type of its numbers, and how many there are of them in one row.

    length: the numpy type of a number before them that says how many there are; "" where that is always the same.
    """

    name: str
    type: str
    count: int = 1
    length: str = ""

    @property
    def size(self) -> int:
        """Bytes in a row; of a list, those of one of its numbers."""
        return np.dtype(self.type).itemsize * self.count


def from_bytes(columns: Sequence[Column], points: int, data: bytes) -> Array:
    """Rows that follow each other as bytes: x, y, z of each, (k, 3)."""
    places = [place(columns, axis) for axis in AXES]
    if any(column.length for column in columns):
        return _from_uneven(columns, places, points, data)
    begins = np.cumsum([0, *(column.size for column in columns)])
    row = np.dtype(
        {
            "names": list(AXES),
            "formats": [columns[place].type for place in places],
            "offsets": [int(begins[place]) for place in places],
            "itemsize": int(begins[-1]),
        }
    )
    check_rows(len(data) // row.itemsize, points)
    rows = np.frombuffer(data, row, points)
    return np.column_stack([rows[axis].astype(np.float64) for axis in AXES])


def _from_uneven(columns: Sequence[Column], places: list[int], points: int, data: bytes) -> Array:
    """The same where lists make the rows as long as they are."""
    check_rows(len(data) // sum(np.dtype(column.length or column.type).itemsize for column in columns), points)
    begins = np.zeros((points, 3), dtype=np.int64)
    _, there = walked(columns, points, data, 0, begins, places)
    check_rows(there, points)
    overlapping = (
        np.ndarray(len(data) - columns[place].size + 1, columns[place].type, data, strides=(1,)) for place in places
    )
    return np.column_stack([numbers[begins[:, k]].astype(np.float64) for k, numbers in enumerate(overlapping)])


def walked(
    columns: Sequence[Column],
    points: int,
    data: bytes,
    begin: int,
    begins: NDArray[np.int64] | None = None,
    places: Sequence[int] = (),
) -> tuple[int, int]:
    """Where so many rows of bytes end, and how many there are; where some of their columns begin goes to begins."""
    sizes = np.array([np.dtype(column.type).itemsize * column.count for column in columns], dtype=np.int64)
    lengths = np.array([np.dtype(column.length).itemsize if column.length else 0 for column in columns], dtype=np.int64)
    big = any(column.length.startswith(">") for column in columns)
    wished = np.array([*places, -1, -1, -1][:3], dtype=np.int64)
    there = np.zeros((0, 3), dtype=np.int64) if begins is None else begins
    ended = walk(np.frombuffer(data, np.uint8), (begin, min(points, len(data)), big), sizes, lengths, wished, there)
    return int(ended[0]), int(ended[1])


def from_text(columns: Sequence[Column], points: int, data: bytes, above: bytes, skipped: int = 0) -> Raw:
    """Rows that are lines of text, below a header and some lines that are skipped: x, y, z of each, (k, 3)."""
    begins = np.cumsum([0, *(column.count for column in columns)])
    places = [int(begins[place(columns, axis)]) for axis in AXES]
    lines = islice(io.TextIOWrapper(io.BytesIO(data), encoding="latin-1"), skipped, None)
    first = list(islice(lines, SAMPLE))
    cells = with_decimals(Cells(), first)
    source: Iterator[str] = chain(first, lines)
    if any(column.length for column in columns[: max(place(columns, axis) for axis in AXES)]):
        source = _without_lists(source, columns)
    begin = len(above.splitlines()) + skipped + 1
    rows, notes, count = table(source, places, cells, begin, points)
    check_rows(count, points)
    return Raw(rows, notes)


def _without_lists(lines: Iterable[str], columns: Sequence[Column]) -> Iterator[str]:
    """Lines with one dash in place of each list, so that every column has its place."""
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


def from_fields(columns: Sequence[Column], points: int, data: bytes) -> Array:
    """Columns that follow each other as bytes, each whole: x, y, z of each point, (k, 3)."""
    begins = np.cumsum([0, *(column.size * points for column in columns)])
    check_rows(len(data) * points // max(int(begins[-1]), 1), points)
    numbers = [_field(columns[i], points, data, int(begins[i])) for i in (place(columns, axis) for axis in AXES)]
    return np.column_stack(numbers)


def _field(column: Column, points: int, data: bytes, begin: int) -> Array:
    return np.frombuffer(data, column.type, points * column.count, begin)[:: column.count].astype(np.float64)


def check_rows(there: int, promised: int) -> None:
    """Raise Broken where a file ends too early."""
    if there < promised:
        raise Broken(
            Text(
                en="it ends after {there} of {promised} points", pt_BR="termina após {there} de {promised} pontos"
            ).format(there=there, promised=promised)
        )


def place(columns: Sequence[Column], axis: str) -> int:
    """The number of the column of that name; raises Broken where there is none."""
    names = [column.name for column in columns]
    if axis not in names and axis.upper() in names:
        return names.index(axis.upper())
    if axis not in names:
        raise Broken(
            Text(
                en="its points have no column {axis}, only {names}",
                pt_BR="seus pontos não têm coluna {axis}, só {names}",
            ).format(axis=axis, names=", ".join(names) or "—")
        )
    return names.index(axis)
