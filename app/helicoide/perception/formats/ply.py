"""PLY: a header of elements and their properties, then numbers as text or bytes."""

from __future__ import annotations

import re

from helicoide.perception.broken import BrokenFile
from helicoide.perception.columns import Column, from_bytes
from helicoide.perception.formats import RawPoints, check_count
from helicoide.perception.lines import from_text
from helicoide.perception.lists import from_lists, walk_rows
from helicoide.text import Text

TITLE = Text(en="PLY (text or binary)", pt_BR="PLY (texto ou binário)")
ENDINGS = (".ply",)

_ENDED = re.compile(rb"[\r\n][ \t]*end_header[ \t]*(?:\r?\n|\r)")
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_TYPES = {
    "char": "i1",
    "uchar": "u1",
    "short": "i2",
    "ushort": "u2",
    "int": "i4",
    "uint": "u4",
    "float": "f4",
    "double": "f8",
    **{f"{word}{8 * size}": f"{word[0]}{size}" for word in ("int", "uint") for size in (1, 2, 4, 8)},
    **{f"float{8 * size}": f"f{size}" for size in (2, 4, 8)},
}
_HEADER = Text(en="its header breaks off or is none of PLY", pt_BR="o cabeçalho está incompleto ou não é de PLY")


def coordinates(data: bytes) -> RawPoints:
    """Rows x, y, z (k, 3) of the element vertex."""
    ended = _ENDED.search(data)
    if not data.startswith(b"ply") or ended is None:
        raise BrokenFile(_HEADER)
    order, elements = _parsed(data[: ended.start()].decode("ascii", "replace"))
    rest, skipped = data[ended.end() :], 0
    for name, count, columns in elements:
        if name == "vertex":
            check_count(count)
            if not order:
                return from_text(columns, count, rest, data[: ended.end()], skipped)
            read = from_lists if any(column.length for column in columns) else from_bytes
            return RawPoints(read(columns, count, rest[skipped:]))
        skipped = _behind(columns, count, rest, skipped) if order else skipped + count
    raise BrokenFile(Text(en="it has no element vertex", pt_BR="não tem o elemento vertex"))


def _behind(columns: list[Column], count: int, data: bytes, begin: int) -> int:
    """The end of an element that starts at byte `begin`."""
    if not any(column.length for column in columns):
        return begin + count * sum(column.size for column in columns)
    end, there = walk_rows(columns, count, data, begin)
    if there < count:
        raise BrokenFile(
            Text(
                en="it ends after {there} of {count} rows before its points",
                pt_BR="termina após {there} de {count} linhas antes dos pontos",
            ).format(there=there, count=count)
        )
    return end


def _parsed(header: str) -> tuple[str, list[tuple[str, int, list[Column]]]]:
    """The byte order, "" for text, and the elements up to vertex: name, count, columns."""
    order, elements = None, list[tuple[str, int, list[Column]]]()
    for line in header.splitlines()[1:]:
        match line.split():
            case ["format", str(word), "1.0"] if word in _ORDERS:
                order = _ORDERS[word]
            case ["element", name, count] if count.isdecimal():
                if elements and elements[-1][0] == "vertex":
                    break
                elements.append((name, int(count), []))
            case ["property", "list", length, kind, name] if (
                elements and kind in _TYPES and _TYPES.get(length, "f")[0] != "f"
            ):
                mark = order or "<"
                elements[-1][2].append(Column(name, mark + _TYPES[kind], length=mark + _TYPES[length]))
            case ["property", kind, name] if elements and kind in _TYPES:
                elements[-1][2].append(Column(name, (order or "") + _TYPES[kind]))
            case ["comment" | "obj_info", *_] | []:
                pass
            case _:
                raise BrokenFile(
                    Text(
                        en="its header has a line that PLY does not know: {line!r}",
                        pt_BR="o cabeçalho tem uma linha que PLY não conhece: {line!r}",
                    ).format(line=line[:80])
                )
    if order is None:
        raise BrokenFile(_HEADER)
    return order, elements
