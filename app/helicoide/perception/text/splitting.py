"""A line of text as cells: how its columns are parted, and what a cell says."""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import nan

_MISSING = re.compile(r"|[-?]|n/?a|null|none|[-+]?1[.,]#\w*|[-+]?nan(\(\w*\))?", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+(e[-+]?\d+)?", re.IGNORECASE)
_QUOTED_DECIMALS = re.compile(r'"[-+]?\d+,\d+"')


@dataclass(frozen=True)
class LineSplitter:
    """How a line is parted; between: None for blanks; decimal: whether a comma is the decimal mark."""

    between: str | None = None
    decimal: bool = False

    def cells(self, line: str) -> list[str]:
        """The cells of a line, without the blanks around them."""
        if self.between is None:
            return line.split()
        return [cell.strip() for cell in line.strip("\n ").split(self.between)]

    def plain(self, text: str) -> str:
        """The same text with points for decimal commas."""
        return text.replace(",", ".") if self.decimal and "," in text else text


def detect_splitter(line: str) -> LineSplitter:
    """How a row is parted, by the look of it."""
    for between in (";", "\t"):
        if between in line:
            return LineSplitter(between)
    parts = line.split()
    blanks = len(parts) >= 3 and not any(part.startswith(",") or part.endswith(",") for part in parts)
    return LineSplitter("," if "," in line and not blanks else None)


def with_decimals(cells: LineSplitter, lines: list[str]) -> LineSplitter:
    """The same, with what many rows say of the decimal mark."""
    commas = cells.between != "," and any(
        _DECIMAL_COMMA.fullmatch(cell) for line in lines for cell in cells.cells(line)
    )
    return LineSplitter(cells.between, commas)


def parse_number(cell: str) -> float:
    """What a cell says, nan where it says that nothing is known; raises ValueError where it is no number."""
    if "_" in cell:  # which Python takes for a part of numbers
        raise ValueError
    try:
        return float(cell)
    except ValueError:
        if _MISSING.fullmatch(cell):
            return nan
        raise


def is_number(cell: str) -> bool:
    """Whether a cell says a number, or that there is none."""
    try:
        parse_number(cell)
    except ValueError:
        return _DECIMAL_COMMA.fullmatch(cell) is not None
    return True


def unquoted(text: str) -> str:
    """The same text without quotation marks; commas between numbers in quotes that have commas become semicolons."""
    if '"' not in text:
        return text
    if _QUOTED_DECIMALS.search(text, 0, 10_000):
        text = re.sub(r'"[ \t]*,[ \t]*"', '";"', text)
    return text.replace('"', "")
