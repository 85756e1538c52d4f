"""Rows of points in bytes, with x, y and z among other columns; a header gives the layout."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.text import Text

AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Column:
    """A column: its name, the numpy type of its numbers, and their count in one row.

    length: for a list of variable length, the numpy type of the count that precedes it; else "".
    """

    name: str
    type: str
    count: int = 1
    length: str = ""

    @property
    def size(self) -> int:
        """Bytes in a row; for a list, bytes of one number."""
        return np.dtype(self.type).itemsize * self.count


def from_bytes(columns: Sequence[Column], points: int, data: bytes) -> Array:
    """The columns x, y, z, (k, 3), of bytes stored row by row."""
    places = [column_index(columns, axis) for axis in AXES]
    begins = np.cumsum([0, *(column.size for column in columns)])
    row = np.dtype(
        {
            "names": list(AXES),
            "formats": [columns[place].type for place in places],
            "offsets": [int(begins[place]) for place in places],
            "itemsize": int(begins[-1]),
        }
    )
    check_row_count(len(data) // row.itemsize, points)
    rows = np.frombuffer(data, row, points)
    return np.column_stack([rows[axis].astype(np.float64) for axis in AXES])


def from_fields(columns: Sequence[Column], points: int, data: bytes) -> Array:
    """The columns x, y, z, (k, 3), of bytes stored column by column."""
    begins = np.cumsum([0, *(column.size * points for column in columns)])
    check_row_count(len(data) * points // max(int(begins[-1]), 1), points)
    numbers = [_field(columns[i], points, data, int(begins[i])) for i in (column_index(columns, axis) for axis in AXES)]
    return np.column_stack(numbers)


def _field(column: Column, points: int, data: bytes, begin: int) -> Array:
    return np.frombuffer(data, column.type, points * column.count, begin)[:: column.count].astype(np.float64)


def check_row_count(there: int, promised: int) -> None:
    """Raise BrokenFile if a file has fewer rows than its header states."""
    if there < promised:
        raise BrokenFile(
            Text(
                en="it ends after {there} of {promised} points", pt_BR="termina após {there} de {promised} pontos"
            ).format(there=there, promised=promised)
        )


def column_index(columns: Sequence[Column], axis: str) -> int:
    """The index of the column named `axis`; raises BrokenFile if there is none."""
    names = [column.name for column in columns]
    if axis not in names and axis.upper() in names:
        return names.index(axis.upper())
    if axis not in names:
        raise BrokenFile(
            Text(
                en="its points have no column {axis}, only {names}",
                pt_BR="seus pontos não têm coluna {axis}, só {names}",
            ).format(axis=axis, names=", ".join(names) or "—")
        )
    return names.index(axis)
