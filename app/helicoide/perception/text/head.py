"""The header of a text file of points: comments, column names, units, and the number of rows."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.perception.text import names as naming
from helicoide.perception.text import unnamed
from helicoide.perception.text.splitting import LineSplitter, detect_splitter, is_number, parse_number, with_decimals
from helicoide.perception.units import Unit
from helicoide.text import Text

_LOOK, _SAMPLE, _MOST_TITLES, _MOST_CELLS = 200_000, 200, 100, 1000
_COMMENT = re.compile(r"\s*(#|//|%|!)[#/%!\s]*")
_APART = re.compile(r"[,;\s]+")
_BEFORE_UNIT = re.compile(r"\s+(?=[\[(])")
_BOTH_COMMAS = re.compile(r"0\d+")


@dataclass(frozen=True)
class TableHead:
    """The header: first_row, lines above the first row; columns of x, y and z; row_count, stated number of rows."""

    first_row: int
    cells: LineSplitter
    columns: tuple[int, int, int]
    notes: tuple[Text, ...]
    unit: Unit | None
    row_count: int | None


@dataclass(frozen=True)
class _Title:
    """A line above the rows; comment: whether it begins as a comment and so need not hold names."""

    words: str
    comment: bool


def read_head(text: str) -> TableHead:
    """Read the header; raises BrokenFile if there are no rows, or the columns x, y and z cannot be determined."""
    lines = text[:_LOOK].split("\n")
    if len(text) > _LOOK:
        lines.pop()
    begin, titles, promised = _above(lines)
    rows = [line for line in lines[begin : begin + _SAMPLE] if line.strip() and not _COMMENT.match(line)]
    cells = with_decimals(detect_splitter(lines[begin]), rows)
    sample = [cells.cells(line.partition("#")[0])[:_MOST_CELLS] for line in rows]
    _check_commas(cells, sample)
    numbers = _numbers(cells, sample, max(map(len, sample)))
    named = _named(titles, cells, numbers)
    unit = next((unit for title in titles if (unit := _unit_line(_split(title, cells))) is not None), None)
    if named is not None:
        places, said = named
        return TableHead(begin, cells, places, (), said or unit, promised)
    spread = [cells.cells(line.partition("#")[0])[: numbers.shape[1]] for line in _spread(text)]
    places, notes = unnamed.guessed_columns(numbers, _numbers(cells, spread, numbers.shape[1]))
    return TableHead(begin, cells, places, notes, unit, promised)


def _above(lines: list[str]) -> tuple[int, list[_Title], int | None]:
    """The number of lines above the first row, those that are not empty, and the stated number of rows, if any."""
    titles, promised = list[_Title](), None
    for n, line in enumerate(lines):
        if len(titles) > _MOST_TITLES:
            break
        if comment := _COMMENT.match(line):
            titles.append(_Title(line[comment.end() :], True))
        elif line.strip().isdecimal() and not titles:
            promised = int(line[:18])
        elif _is_row(line):
            return n, titles, promised
        elif line.strip():
            titles.append(_Title(line, False))
    if not any(not title.comment for title in titles):
        raise BrokenFile(Text(en="there are no points in it", pt_BR="não há pontos nele"))
    first = next(title.words for title in titles if not title.comment)
    raise BrokenFile(
        Text(
            en="it has no row of three numbers, and begins “{line}”; there are no points in it",
            pt_BR="não tem linha com três números e começa por “{line}”; não há pontos nele",
        ).format(line=first.strip()[:60])
    )


def _is_row(line: str) -> bool:
    row = detect_splitter(line).cells(line.partition("#")[0])[:_MOST_CELLS]
    known = [cell for cell in row if cell and is_number(cell)]
    if row and row[0] == "" and known == [str(i) for i in range(len(row) - 1)]:  # pandas numbers unnamed columns
        return False
    return len(known) >= 3 or (len(row) >= 3 and len(known) >= 1 and all(map(is_number, row)))


def _spread(text: str) -> list[str]:
    """Sample lines from the whole text."""
    begins = [text.find("\n", at) + 1 for at in np.linspace(0, len(text), _SAMPLE, endpoint=False).astype(int).tolist()]
    ends = [(begin, text.find("\n", begin, begin + _LOOK)) for begin in sorted({*begins} - {0})]
    return [text[begin:end] for begin, end in ends if end > begin]


def _numbers(cells: LineSplitter, sample: list[list[str]], width: int) -> Array:
    """Rows of cells as numbers (k, width), nan for missing values."""
    numbers = np.full((len(sample), width), np.nan)
    for i, row in enumerate(sample):
        for k, cell in enumerate(row):
            if is_number(cell):
                numbers[i, k] = parse_number(cells.plain(cell)) if cells.decimal or "," not in cell else np.nan
    return numbers


def _split(title: _Title, cells: LineSplitter) -> list[str]:
    """The names in a line, split like the rows if possible, else at any separator."""
    if cells.between and cells.between in title.words:
        return cells.cells(title.words)
    return _APART.split(_BEFORE_UNIT.sub("", title.words).strip())


def _named(
    titles: list[_Title], cells: LineSplitter, numbers: Array
) -> tuple[tuple[int, int, int], Unit | None] | None:
    """The columns of x, y and z by the last line that names them, and their unit; None if no line does."""
    width = numbers.shape[1]
    for title in reversed(titles):
        names = _split(title, cells)
        try:
            places = naming.named_columns(names)
        except BrokenFile:
            if title.comment or len(names) not in (width - 1, width):
                continue
            raise
        if places is not None and max(places) < width:
            labels = len(names) == width - 1 and (unnamed.is_row_number(numbers[:, 0]) or np.isnan(numbers[:, 0]).all())
            x, y, z = places
            unit = naming.unit_in_names([names[place] for place in places])
            return ((x + 1, y + 1, z + 1) if labels else places), unit
        if places is None and not title.comment and len(names) == width and not all(map(naming.is_unit, names)):
            _refuse(names)
    return None


def _unit_line(names: list[str]) -> Unit | None:
    return naming.unit_in_names(names[:3]) if len(names) >= 3 and all(map(naming.is_unit, names[:3])) else None


def _refuse(names: list[str]) -> None:
    if any(is_number(name) for name in names if name):
        return
    raise BrokenFile(
        Text(
            en="its columns are named {names}; valid are names among which x, y and z stand",
            pt_BR="as colunas se chamam {names}; valem nomes entre os quais estejam x, y e z",
        ).format(names=naming.shortened_list(names))
    )


def _check_commas(cells: LineSplitter, sample: list[list[str]]) -> None:
    """Raise BrokenFile if commas are both separators and decimal marks, which is ambiguous."""
    if cells.between != "," or any("." in cell for row in sample for cell in row) or len(sample[0]) % 2:
        return
    if len(sample[0]) >= 6 and any(_BOTH_COMMAS.fullmatch(cell) for row in sample for cell in row[1::2]):
        raise BrokenFile(
            Text(
                en="commas both separate its numbers and occur within them; numbers with decimal commas need "
                "semicolons or spaces between them",
                pt_BR="há vírgulas entre os números e também dentro deles; números com vírgula decimal precisam de "
                "ponto e vírgula ou espaços entre si",
            )
        )
