"""PCD, the format of the Point Cloud Library: a header of fields, then numbers as text, bytes, or compressed bytes.

The points stay in the frame of the file; the viewpoint of the header is not applied, as PCL does not either.
"""

from __future__ import annotations

import re
import struct

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.perception.columns import Column, from_bytes, from_fields
from helicoide.perception.formats import MOST_BYTES, RawPoints, check_count
from helicoide.perception.lines import from_text
from helicoide.perception.lzf import unpack_lzf
from helicoide.text import Text

TITLE = Text(en="PCD (text, binary or compressed)", pt_BR="PCD (texto, binário ou comprimido)")
ENDINGS = (".pcd",)

_ENDED = re.compile(rb"(?:^|\r)DATA[ \t]+(\w+)[ \t]*(?:\r?\n|\r)", re.MULTILINE)
_SIZES = {"F": {"4", "8"}, "I": {"1", "2", "4", "8"}, "U": {"1", "2", "4", "8"}}


def coordinates(data: bytes) -> RawPoints:
    """Rows x, y, z (k, 3) of the points."""
    ended = _ENDED.search(data)
    if ended is None:
        raise BrokenFile(
            Text(en="its header breaks off or is none of PCD", pt_BR="o cabeçalho não é de PCD ou acaba cedo")
        )
    points, columns = _parsed(data[: ended.start()].decode("ascii", "replace"))
    rest = data[ended.end() :]
    match ended[1]:
        case b"ascii":
            return from_text(columns, points, rest, data[: ended.end()])
        case b"binary":
            return RawPoints(from_bytes(columns, points, rest))
        case b"binary_compressed":
            return RawPoints(_from_packed(columns, points, rest))
    raise BrokenFile(
        Text(
            en="its DATA is {kind!r}, neither ascii, binary nor binary_compressed",
            pt_BR="seu DATA é {kind!r}, e não ascii, binary ou binary_compressed",
        ).format(kind=ended[1].decode())
    )


def _parsed(header: str) -> tuple[int, list[Column]]:
    """The number of points, and their columns."""
    lines = [line.split() for line in header.splitlines() if not line.startswith("#")]
    entries = {words[0]: words[1:] for words in lines if words}
    fields, types = entries.get("FIELDS", []), entries.get("TYPE", [])
    sizes, counts = entries.get("SIZE", []), entries.get("COUNT", ["1"] * len(fields))
    if not len(fields) == len(sizes) == len(types) == len(counts):
        raise BrokenFile(
            Text(
                en="FIELDS, SIZE, TYPE and COUNT of its header are not equally many",
                pt_BR="FIELDS, SIZE, TYPE e COUNT do cabeçalho não são iguais em número",
            )
        )
    columns = [_column(*entry) for entry in zip(fields, types, sizes, counts, strict=True)]
    return check_count(_count(entries)), columns


def _column(name: str, kind: str, size: str, count: str) -> Column:
    if size not in _SIZES.get(kind, ()) or not count.isdecimal() or not 0 < int(count) < MOST_BYTES:
        raise BrokenFile(
            Text(
                en="field {name} of its header has TYPE {kind}, SIZE {size}, COUNT {count}; valid are F 4 or 8, I or U "
                "1, 2, 4 or 8",
                pt_BR="o campo {name} do cabeçalho tem TYPE {kind}, SIZE {size}, COUNT {count}; valem F 4 ou 8, I ou U "
                "1, 2, 4 ou 8",
            ).format(name=name, kind=kind, size=size, count=count)
        )
    return Column(name, f"<{kind.lower()}{size}", int(count))


def _count(entries: dict[str, list[str]]) -> int:
    """The number of points: POINTS or, in older files, WIDTH × HEIGHT."""
    for names in (("POINTS",), ("WIDTH", "HEIGHT")):
        words = [word for name in names for word in entries.get(name, [])]
        if len(words) == len(names) and all(word.isdecimal() for word in words):
            return int(np.prod([int(word) for word in words], dtype=object))
    raise BrokenFile(
        Text(en="its header does not say how many points", pt_BR="o cabeçalho não diz quantos são os pontos")
    )


def _from_packed(columns: list[Column], points: int, data: bytes) -> Array:
    """Columns stored one after another and compressed together by LZF, after two lengths of four bytes."""
    packed, whole = struct.unpack_from("<II", data) if len(data) >= 8 else (0, 0)
    if len(data) < 8 + packed:
        raise BrokenFile(Text(en="its compressed points break off", pt_BR="os pontos comprimidos acabam cedo"))
    if whole > MOST_BYTES:
        raise BrokenFile(Text(en="it unpacks to {n} bytes", pt_BR="descomprime em {n} bytes").format(n=whole))
    return from_fields(columns, points, unpack_lzf(data[8 : 8 + packed], whole))
