"""Reading rows of numbers from text: fast if all are valid, else line by line."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.perception.text.splitting import LineSplitter, parse_number
from helicoide.text import Text

_BLOCK = 10_000
# Largest share of invalid rows that are skipped; more mean that the format was misunderstood.
_MAX_SKIPPED = 0.05


@dataclass
class _Bad:
    """Invalid rows: their number, and what is wrong with the first."""

    count: int = 0
    first: Text | None = None

    def add(self, why: Text) -> None:
        """Count one invalid row."""
        self.count += 1
        self.first = self.first or why

    def check(self, rows: int) -> None:
        """Raise BrokenFile if there are too many."""
        if self.first is not None and self.count > max(_MAX_SKIPPED * rows, 0):
            raise BrokenFile(
                Text(
                    en="{first}; this holds for {n} of {k} rows", pt_BR="{first}; isto vale para {n} de {k} linhas"
                ).format(first=self.first, n=self.count, k=rows)
            )

    def notes(self, rows: int) -> tuple[Text, ...]:
        """A note on skipped rows, if any."""
        if self.first is None:
            return ()
        skipped = Text(en="Rows ignored: {n} of {k}; {first}.", pt_BR="Linhas ignoradas: {n} de {k}; {first}.")
        return (skipped.format(n=self.count, k=rows, first=self.first),)


def read_rows(
    lines: Iterator[str],
    places: Sequence[int],
    cells: LineSplitter | None = None,
    begin: int = 1,
    most: int | None = None,
    comment: str | None = None,
) -> tuple[Array, tuple[Text, ...], int]:
    """The numbers in the columns `places` (k, n), notes on skipped rows, and the number of rows.

    begin: number of the first line; most: largest number of rows; comment: start of a comment.
    """
    cells, bad = cells or LineSplitter(), _Bad()
    parts, rows = list[Array](), 0
    while most is None or rows < most:
        block = list(islice(lines, _BLOCK if most is None else min(_BLOCK, most - rows)))
        if not block:
            break
        if cells.decimal:
            block = [line.replace(",", ".") for line in block]
        known = bad.count
        try:
            part = _quick(block, places, cells, comment)
        except ValueError:
            part = _careful(block, places, cells, comment, begin, bad)
        parts.append(part)
        rows, begin = rows + len(part) + bad.count - known, begin + len(block)
        if bad.count > _BLOCK:
            bad.check(rows)
    bad.check(rows)
    return np.concatenate([np.empty((0, len(places))), *parts]), bad.notes(rows), rows


def _quick(block: list[str], places: Sequence[int], cells: LineSplitter, comment: str | None) -> Array:
    with warnings.catch_warnings():  # about lines without numbers, which do not count
        warnings.simplefilter("ignore", UserWarning)
        rows = np.loadtxt(block, delimiter=cells.between, usecols=tuple(places), ndmin=2, comments=comment)
    return rows.reshape(-1, len(places))


def _careful(
    block: list[str], places: Sequence[int], cells: LineSplitter, comment: str | None, begin: int, bad: _Bad
) -> Array:
    """The numbers of a block, read line by line; invalid rows are added to `bad`."""
    numbers = list[list[float]]()
    for n, line in enumerate(block, begin):
        if comment is not None:
            line = line.partition(comment)[0]
        if not line.strip():
            continue
        row = cells.cells(line)
        try:
            numbers.append([parse_number(row[place]) for place in places])
        except (ValueError, IndexError):
            bad.add(_why(n, row, places))
    return np.array(numbers, dtype=np.float64).reshape(-1, len(places))


def _why(line: int, row: list[str], places: Sequence[int]) -> Text:
    """What is wrong with a row."""
    if len(row) <= max(places):
        return Text(
            en="line {line} has {n} columns; valid are at least {k}",
            pt_BR="a linha {line} tem {n} colunas; valem no mínimo {k}",
        ).format(line=line, n=len(row), k=max(places) + 1)
    place = next(place for place in places if not _reads(row[place]))
    return Text(
        en="line {line}, column {column} holds “{cell}”; valid is a number such as 0.7",
        pt_BR="a linha {line}, coluna {column}, contém “{cell}”; vale um número como 0.7",
    ).format(line=line, column=place + 1, cell=row[place][:40])


def _reads(cell: str) -> bool:
    try:
        parse_number(cell)
    except ValueError:
        return False
    return True
