"""Rows of bytes with lists of variable length, each preceded by its count."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array
from helicoide.kernels import kernel
from helicoide.perception.columns import AXES, Column, check_row_count, column_index

Whole = NDArray[np.int64]


def from_lists(columns: Sequence[Column], points: int, data: bytes) -> Array:
    """The columns x, y, z, (k, 3), of bytes stored row by row, with rows of different lengths."""
    places = [column_index(columns, axis) for axis in AXES]
    check_row_count(len(data) // sum(np.dtype(column.length or column.type).itemsize for column in columns), points)
    begins = np.zeros((points, 3), dtype=np.int64)
    _, there = walk_rows(columns, points, data, 0, begins, places)
    check_row_count(there, points)
    overlapping = (
        np.ndarray(len(data) - columns[place].size + 1, columns[place].type, data, strides=(1,)) for place in places
    )
    return np.column_stack([numbers[begins[:, k]].astype(np.float64) for k, numbers in enumerate(overlapping)])


def walk_rows(
    columns: Sequence[Column],
    points: int,
    data: bytes,
    begin: int,
    begins: NDArray[np.int64] | None = None,
    places: Sequence[int] = (),
) -> tuple[int, int]:
    """The end of `points` rows of bytes and their number; start bytes of columns `places` are written to `begins`."""
    sizes = np.array([np.dtype(column.type).itemsize * column.count for column in columns], dtype=np.int64)
    lengths = np.array([np.dtype(column.length).itemsize if column.length else 0 for column in columns], dtype=np.int64)
    big = any(column.length.startswith(">") for column in columns)
    padded = np.array([*places, -1, -1, -1][:3], dtype=np.int64)
    there = np.zeros((0, 3), dtype=np.int64) if begins is None else begins
    ended = walk_rows_kernel(
        np.frombuffer(data, np.uint8), (begin, min(points, len(data)), big), sizes, lengths, padded, there
    )
    return int(ended[0]), int(ended[1])


@kernel
def walk_rows_kernel(
    data: NDArray[np.uint8],
    way: tuple[int, int, bool],
    sizes: Whole,
    lengths: Whole,
    places: Whole,
    begins: Whole,
) -> tuple[int, int]:
    """Go through rows; returns the end of the last complete row and the number of complete rows.

    Args: way: first byte, number of rows, and whether numbers are big-endian; sizes (n,): bytes of one number of each
    column; lengths (n,): bytes of the count that precedes a list, 0 for a single number; places (3,): the columns whose
    start bytes are written to begins (rows, 3), unless begins is empty.
    """
    at, rows, big = way
    for row in range(rows):
        for k in range(sizes.shape[0]):
            if lengths[k] == 0:
                for axis in range(3):
                    if places[axis] == k and row < begins.shape[0]:
                        begins[row, axis] = at
                at += sizes[k]
                if at > data.shape[0]:
                    return at, row
                continue
            if at + lengths[k] > data.shape[0]:
                return at, row
            many = 0
            for i in range(lengths[k]):
                many = many * 256 + int(data[at + i if big else at + lengths[k] - 1 - i])
            if many < 0 or many > data.shape[0]:
                return at, row
            at += lengths[k] + many * sizes[k]
            if at > data.shape[0]:
                return at, row
    return at, rows
