"""NPY, one array of numpy: rows of points (k, n), or an image (h, w, n) of a depth camera.

x, y and z are the fields of that name, else the first three numbers of a row unless these look like something else.
"""

from __future__ import annotations

import io
import warnings
from tokenize import TokenError
from typing import Any

import numpy as np
from numpy.lib import format as npy_format
from numpy.typing import NDArray

from helicoide.perception.broken import BrokenFile
from helicoide.perception.formats import RawPoints, check_count
from helicoide.perception.text import unnamed
from helicoide.perception.text.names import named_columns
from helicoide.text import Text

TITLE = Text(en="NPY (an array k × 3)", pt_BR="NPY (uma matriz k × 3)")
ENDINGS = (".npy",)
# Largest number of columns.
MOST_WIDE = 32
SAMPLE = 200


def coordinates(data: bytes) -> RawPoints:
    """Rows x, y, z (k, 3)."""
    file = io.BytesIO(data)
    shape, by_columns, kind = _header(file)
    wide = shape[-1] if shape else 0
    fields = None if kind.names is None or kind.hasobject else named_columns(kind.names)
    lying = len(shape) == 2 and shape[0] in (3, 4) and wide > MOST_WIDE
    numbers = kind.kind in "fiu" and len(shape) >= 2 and (3 <= wide <= MOST_WIDE or lying)
    if not numbers and (fields is None or any(kind[i].kind not in "fiu" or kind[i].shape for i in fields)):
        raise BrokenFile(
            Text(
                en="its array is of shape {shape} and type {kind}; valid are real numbers in rows of three or a few "
                "more, or with fields x, y and z",
                pt_BR="a matriz tem forma {shape} e tipo {kind}; valem números reais em linhas de três ou pouco mais, "
                "ou com campos x, y e z",
            ).format(shape=shape, kind=str(kind)[:80])
        )
    count = int(np.prod(shape, dtype=object))
    points = check_count(count if fields else wide if lying else count // wide)
    rest = data[file.tell() :]
    if len(rest) < count * kind.itemsize:
        raise BrokenFile(
            Text(en="it ends before the last of {n} points", pt_BR="termina antes do último de {n} pontos").format(
                n=points
            )
        )
    array = np.frombuffer(rest, kind, count).reshape(shape, order="F" if by_columns else "C")
    if fields is not None and kind.names is not None:
        return RawPoints(np.column_stack([array[kind.names[i]].ravel().astype(np.float64) for i in fields]))
    return _rows(array.T if lying else array.reshape(-1, wide))


def _rows(array: NDArray[Any]) -> RawPoints:
    """The columns x, y and z of rows (k, n)."""
    spread = array[:: max(1, len(array) // SAMPLE)][:SAMPLE].astype(np.float64)
    columns, notes = unnamed.guessed_columns(array[:SAMPLE].astype(np.float64), spread)
    return RawPoints(array[:, columns].astype(np.float64), notes)


def _header(file: io.BytesIO) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    """Shape of the array, whether it is stored in column-major order, and the type of its numbers."""
    try:
        with warnings.catch_warnings():  # about headers written by Python 2
            warnings.simplefilter("ignore", UserWarning)
            version = npy_format.read_magic(file)
            read = npy_format.read_array_header_1_0 if version == (1, 0) else npy_format.read_array_header_2_0
            return read(file)
    except (ValueError, TypeError, SyntaxError, TokenError, RecursionError, MemoryError) as error:
        raise BrokenFile(
            Text(en="its header breaks off or is none of NPY", pt_BR="o cabeçalho está incompleto ou não é de NPY")
        ) from error
