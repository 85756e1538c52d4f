"""LAS, the format of laser scanners: a header, then points as integer multiples of a step from an origin.

Source: ASPRS LAS 1.4 R15, tables 3 and 7; the coordinates are stored alike in all versions and point formats.
LAZ, its compressed form, is refused: the package that unpacks it crashes the program on damaged files.
"""

from __future__ import annotations

import struct

import numpy as np

from helicoide.perception.broken import BrokenFile
from helicoide.perception.columns import check_row_count
from helicoide.perception.formats import RawPoints, check_count
from helicoide.text import Text

TITLE = Text(en="LAS (not packed)", pt_BR="LAS (sem compressão)")
ENDINGS = (".las", ".laz")

# Bytes of the header: of version 1.0 to 1.2, and of 1.4, which counts more points.
_SHORT, _LONG = 227, 375
_PACKED = 0b1100_0000


def coordinates(data: bytes) -> RawPoints:
    """Rows x, y, z (k, 3)."""
    if not data.startswith(b"LASF") or len(data) < _SHORT:
        raise BrokenFile(
            Text(en="its header breaks off or is none of LAS", pt_BR="o cabeçalho está incompleto ou não é de LAS")
        )
    begin, _, kind, length, points = struct.unpack_from("<IIBHI", data, 96)
    if data[25] >= 4 and len(data) >= _LONG:
        points = struct.unpack_from("<Q", data, 247)[0] or points
    if kind & _PACKED:
        raise BrokenFile(
            Text(
                en="its points are packed, as in LAZ; valid is the same cloud saved as LAS without compression",
                pt_BR="os pontos estão comprimidos, como em LAZ; vale a mesma nuvem salva em LAS sem compressão",
            )
        )
    check_count(points)
    steps, origin = np.array(struct.unpack_from("<6d", data, 131)).reshape(2, 3)
    if length < 12 or not np.isfinite([steps, origin]).all():
        raise BrokenFile(
            Text(
                en="its header has points of {n} bytes, steps {steps} and origin {origin}; valid are 12 bytes or more "
                "and finite numbers",
                pt_BR="o cabeçalho tem pontos de {n} bytes, passos {steps} e origem {origin}; valem 12 bytes ou mais e "
                "números finitos",
            ).format(n=length, steps=steps, origin=origin)
        )
    check_row_count(max(len(data) - begin, 0) // length, points)
    row = np.dtype({"names": ["place"], "formats": [("<i4", 3)], "offsets": [0], "itemsize": length})
    with np.errstate(over="ignore", invalid="ignore"):
        return RawPoints(np.frombuffer(data, row, points, begin)["place"] * steps + origin)
