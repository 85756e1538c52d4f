"""The formats of point clouds, a file each.

A module has TITLE, the format in words, ENDINGS of file names, and `coordinates(data)`: the rows x, y, z (k, 3) of a
file's bytes, as they are, with what is not finite, as `RawPoints`. It raises `BrokenFile`, or what the parser below it
raises.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Protocol, cast

from helicoide import content
from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.perception.units import Unit
from helicoide.text import Text

# More takes longer to read than a person waits, and memory that others on the machine need.
MOST_POINTS = 5_000_000
MOST_BYTES = 200_000_000


@dataclass(frozen=True, eq=False)
class RawPoints:
    """What a file holds: rows x, y, z (k, 3), sentences on how they were read, and the unit where the file says one."""

    rows: Array
    notes: tuple[Text, ...] = ()
    unit: Unit | None = None


class Format(Protocol):
    """What a module of this folder holds."""

    TITLE: Text
    ENDINGS: tuple[str, ...]

    def coordinates(self, data: bytes) -> RawPoints:
        """Rows x, y, z (k, 3) of the bytes of a file."""


@cache
def cloud_formats() -> tuple[Format, ...]:
    """Every format there is."""
    return tuple(cast(Format, module) for module in content.modules(__name__).values())


@cache
def formats_by_ending() -> dict[str, Format]:
    """The formats by the endings of file names, such as .ply."""
    return {ending: module for module in cloud_formats() for ending in module.ENDINGS}


def check_count(points: int) -> int:
    """The number of points; raises Broken where there are none, or too many."""
    if points < 1:
        raise BrokenFile(Text(en="there are no points in it", pt_BR="não há pontos nele"))
    if points > MOST_POINTS:
        raise BrokenFile(Text(en="it has {n} points", pt_BR="tem {n} pontos").format(n=points))
    return points
