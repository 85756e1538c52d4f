"""Finds the columns of x, y and z without names: the first three, unless their numbers contradict this."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.broken import BrokenFile
from helicoide.text import Text

# Least number of rows to decide whether a column always grows, or counts.
TELLING, COUNTING = 10, 5
_UNIX, _HUGE = 1e8, 1e15
Places = tuple[int, int, int]


def guessed_columns(sample: Array, spread: Array) -> tuple[Places, tuple[Text, ...]]:
    """The columns of x, y, z, and notes. Raises Broken if they cannot be determined.

    sample: the first rows (k, n), nan for missing values; spread: rows from the whole file (m, n).
    """
    columns = [i for i in range(sample.shape[1]) if not np.isnan(sample[:, i]).all()][:4]
    if len(columns) < 3:
        columns = list(range(min(3, sample.shape[1])))
    if len(columns) < 3:
        raise BrokenFile(
            Text(
                en="its rows have {n} columns; valid are rows of at least three numbers, x, y and z",
                pt_BR="suas linhas têm {n} colunas; valem linhas de pelo menos três números, x, y e z",
            ).format(n=sample.shape[1])
        )
    sample, spread = (np.where(np.abs(rows) < _HUGE, rows, np.nan) for rows in (sample, spread))
    first, others = sample[:, columns[0]], sample[:, columns[1:]]
    if is_row_number(first):
        if len(columns) == 4:
            return _in_words(columns[1:], COUNTED)
        raise BrokenFile(DOUBT.format(n=columns[0] + 1, why=COUNTS))
    if len(columns) == 4 and (why := _doubt(first, others, spread[:, columns[0]])) is not None:
        raise BrokenFile(DOUBT.format(n=columns[0] + 1, why=why))
    return _in_words(columns[:3], TAKEN) if columns[2] != 2 else ((0, 1, 2), ())


def is_row_number(column: Array) -> bool:
    """Whether a column holds row numbers."""
    return len(column) >= COUNTING and bool((np.diff(column) == 1).all()) and float(column[0]).is_integer()


def _doubt(first: Array, others: Array, spread: Array) -> Text | None:
    """The reason why a first column before three others is hardly x. In images x grows too, but restarts every row."""
    if len(first) >= TELLING and (np.diff(first) > 0).all() and (np.diff(spread) > 0).all():
        return GROWS
    if _size(first) > _UNIX > 1e3 * _size(others):
        return GROWS
    if len(first) >= COUNTING and _whole(first) and _whole(spread) and not any(_whole(other) for other in others.T):
        return WHOLE
    return None


def _whole(column: Array) -> bool:
    known = column[np.isfinite(column)]
    return bool((known == np.round(known)).all())


def _size(numbers: Array) -> float:
    known = numbers[np.isfinite(numbers)]
    return float(np.median(np.abs(known))) if len(known) else 0.0


def _in_words(columns: list[int], words: Text) -> tuple[Places, tuple[Text, ...]]:
    x, y, z = columns[:3]
    return (x, y, z), (words.format(x=x + 1, y=y + 1, z=z + 1),)


COUNTED = Text(
    en="The first column counts the rows; x, y and z are columns {x}, {y} and {z}.",
    pt_BR="A primeira coluna numera as linhas; x, y e z são as colunas {x}, {y} e {z}.",
)
TAKEN = Text(
    en="Columns {x}, {y} and {z} were read as x, y and z.",
    pt_BR="As colunas {x}, {y} e {z} foram lidas como x, y e z.",
)
COUNTS = Text(en="counts up as the numbers of rows do", pt_BR="cresce de um em um, como números de linha")
GROWS = Text(en="grows from row to row as times do", pt_BR="cresce de linha em linha, como instantes de tempo")
WHOLE = Text(
    en="has whole numbers only, as brightness or a class does", pt_BR="só tem inteiros, como intensidade ou classe"
)
DOUBT = Text(
    en="its columns have no names, and column {n} {why}, so that x, y and z may be others; valid is a first line that "
    "names the columns, with x, y and z among them",
    pt_BR="as colunas não têm nomes, e a coluna {n} {why}, de modo que x, y e z podem ser outras; vale uma primeira "
    "linha com os nomes das colunas, entre eles x, y e z",
)
