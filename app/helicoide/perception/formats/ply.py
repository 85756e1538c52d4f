"""PLY: a header of elements and their properties, then numbers as text or bytes."""

from __future__ import annotations

import re

from helicoide.kinematics.chain import Array
from helicoide.perception.columns import Column, from_bytes, from_text
from helicoide.perception.formats import Broken, check_count
from helicoide.text import Text

TITLE = Text(en="PLY (text or binary)", pt_BR="PLY (texto ou binário)")
ENDINGS = (".ply",)

_ENDED = re.compile(rb"\n[ \t]*end_header[ \t]*\r?\n")
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


def coordinates(data: bytes) -> Array:
    """Rows x, y, z (k, 3) of the element vertex."""
    ended = _ENDED.search(data)
    if not data.startswith(b"ply") or ended is None:
        raise Broken(_HEADER)
    order, elements = _parsed(data[: ended.start()].decode("ascii", "replace"))
    rest, skipped = data[ended.end() :], 0
    for name, count, columns in elements:
        if name == "vertex":
            check_count(count)
            if order:
                return from_bytes(columns, count, rest[skipped:])
            return from_text(columns, count, rest, skipped)
        skipped += count * (sum(column.size for column in columns) if order else 1)
    raise Broken(Text(en="it has no element vertex", pt_BR="não tem o elemento vertex"))


def _parsed(header: str) -> tuple[str, list[tuple[str, int, list[Column]]]]:
    """The order of bytes, "" for text, and the elements up to vertex: name, count, columns."""
    order, elements = None, list[tuple[str, int, list[Column]]]()
    for line in header.splitlines()[1:]:
        match line.split():
            case ["format", str(word), "1.0"] if word in _ORDERS:
                order = _ORDERS[word]
            case ["element", name, count] if count.isdecimal():
                if elements and elements[-1][0] == "vertex":
                    break
                elements.append((name, int(count), []))
            case ["property", "list", *_] if elements:
                raise Broken(
                    Text(
                        en="lists come before or within its points", pt_BR="há listas antes dos pontos ou dentro deles"
                    )
                )
            case ["property", kind, name] if elements and kind in _TYPES:
                elements[-1][2].append(Column(name, (order or "") + _TYPES[kind]))
            case ["comment" | "obj_info", *_] | []:
                pass
            case _:
                raise Broken(
                    Text(
                        en="its header has a line that PLY does not know: {line!r}",
                        pt_BR="o cabeçalho tem uma linha que PLY não conhece: {line!r}",
                    ).format(line=line[:80])
                )
    if order is None:
        raise Broken(_HEADER)
    return order, elements
