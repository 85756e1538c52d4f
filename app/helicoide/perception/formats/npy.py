"""NPY, one array of numpy: (k, 3), or the picture (h, w, 3) of a depth camera."""

from __future__ import annotations

import io
import warnings
from tokenize import TokenError
from typing import Any

import numpy as np
from numpy.lib import format as npy_format

from helicoide.kinematics.chain import Array
from helicoide.perception.formats import Broken, check_count
from helicoide.text import Text

TITLE = Text(en="NPY (an array k × 3)", pt_BR="NPY (uma matriz k × 3)")
ENDINGS = (".npy",)


def coordinates(data: bytes) -> Array:
    """Rows x, y, z (k, 3)."""
    file = io.BytesIO(data)
    shape, by_columns, kind = _header(file)
    if len(shape) < 2 or shape[-1] != 3 or kind.kind not in "fiu":
        raise Broken(
            Text(
                en="its array is of shape {shape} and type {kind}; valid are real numbers in rows of three",
                pt_BR="a matriz tem forma {shape} e tipo {kind}; valem números reais em linhas de três",
            ).format(shape=shape, kind=kind)
        )
    points = check_count(int(np.prod(shape[:-1], dtype=object)))
    rest = data[file.tell() :]
    if len(rest) < 3 * points * kind.itemsize:
        raise Broken(
            Text(en="it ends before the last of {n} points", pt_BR="termina antes do último de {n} pontos").format(
                n=points
            )
        )
    numbers = np.frombuffer(rest, kind, 3 * points)
    return numbers.reshape(shape, order="F" if by_columns else "C").reshape(-1, 3).astype(np.float64)


def _header(file: io.BytesIO) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    """Shape of the array, whether it lies column by column, and the type of its numbers."""
    try:
        with warnings.catch_warnings():  # of headers by Python 2
            warnings.simplefilter("ignore", UserWarning)
            version = npy_format.read_magic(file)
            read = npy_format.read_array_header_1_0 if version == (1, 0) else npy_format.read_array_header_2_0
            return read(file)
    except (ValueError, TypeError, SyntaxError, TokenError, RecursionError, MemoryError) as error:
        raise Broken(
            Text(en="its header breaks off or is none of NPY", pt_BR="o cabeçalho está incompleto ou não é de NPY")
        ) from error
