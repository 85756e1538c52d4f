"""Splitting a line of text into cells, and reading numbers from cells."""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import nan

_MISSING = re.compile(r"|[-?]|n/?a|null|none|[-+]?1[.,]#\w*|[-+]?nan(\(\w*\))?", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+(e[-+]?\d+)?", re.IGNORECASE)
_QUOTED_DECIMALS = re.compile(r'"[-+]?\d+,\d+"')


@dataclass(frozen=True)
class LineSplitter:
    """How a line is split: between, the separator, None for blanks; decimal: whether a comma is the decimal mark."""

    between: str | None = None
    decimal: bool = False

    def cells(self, line: str) -> list[str]:
        """The cells of a line, without surrounding blanks."""
        if self.between is None:
            return line.split()
        return [cell.strip() for cell in line.strip("\n ").split(self.between)]

    def plain(self, text: str) -> str:
        """The text with decimal commas replaced by points."""
        return text.replace(",", ".") if self.decimal and "," in text else text


def detect_splitter(line: str) -> LineSplitter:
    """The separator of a row, guessed from its characters."""
    for between in (";", "\t"):
        if between in line:
            return LineSplitter(between)
    parts = line.split()
    blanks = len(parts) >= 3 and not any(part.startswith(",") or part.endswith(",") for part in parts)
    return LineSplitter("," if "," in line and not blanks else None)


def with_decimals(cells: LineSplitter, lines: list[str]) -> LineSplitter:
    """The separator, with the decimal mark determined from many rows."""
    commas = cells.between != "," and any(
        _DECIMAL_COMMA.fullmatch(cell) for line in lines for cell in cells.cells(line)
    )
    return LineSplitter(cells.between, commas)


def parse_number(cell: str) -> float:
    """The number in a cell; nan for a missing value; raises ValueError for anything else."""
    if "_" in cell:  # Python would accept it in numbers
        raise ValueError
    try:
        return float(cell)
    except ValueError:
        if _MISSING.fullmatch(cell):
            return nan
        raise


def is_number(cell: str) -> bool:
    """Whether a cell holds a number or a missing value."""
    try:
        parse_number(cell)
    except ValueError:
        return _DECIMAL_COMMA.fullmatch(cell) is not None
    return True


def unquoted(text: str) -> str:
    """The text without quotation marks; separating commas become semicolons if quoted numbers have decimal commas."""
    if '"' not in text:
        return text
    if _QUOTED_DECIMALS.search(text, 0, 10_000):
        text = re.sub(r'"[ \t]*,[ \t]*"', '";"', text)
    return text.replace('"', "")
