"""Rows of bytes with lists in them, each as long as a number before it says."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from helicoide.kernels import kernel

Whole = NDArray[np.int64]


@kernel
def walk(
    data: NDArray[np.uint8],
    way: tuple[int, int, bool],
    sizes: Whole,
    lengths: Whole,
    places: Whole,
    begins: Whole,
) -> tuple[int, int]:
    """Go through rows: where the last one ends, and how many there were before the bytes end.

    Args: way: the first byte, how many rows, and whether numbers are big-endian; sizes (n,) of a number of each column,
    bytes; lengths (n,): of the number that says how many there are, 0 where there is one; places (3,): the columns
    whose first bytes are written into begins (rows, 3), or none where begins has no rows.
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
