"""Text with one point per line, separated by blanks, commas or semicolons, possibly with other columns.

A header names the columns x, y and z; without names they are the first three, unless these look like something else.
If blanks or semicolons separate the columns, a comma is the decimal mark, as in Portuguese.
Lines that begin with # or // are comments.
"""

from __future__ import annotations

import io
import re
from itertools import islice

from helicoide.perception.broken import BrokenFile
from helicoide.perception.columns import check_row_count
from helicoide.perception.formats import MOST_POINTS, RawPoints, check_count
from helicoide.perception.text.decoding import decode_text
from helicoide.perception.text.head import read_head
from helicoide.perception.text.splitting import unquoted
from helicoide.perception.text.table import read_rows
from helicoide.text import Text

ENDINGS = (".xyz", ".txt", ".csv", ".pts", ".asc", ".tsv")
TITLE = Text(en="XYZ text ({endings})", pt_BR="texto XYZ ({endings})").format(endings=" ".join(ENDINGS))

_HOLES = re.compile(r"[-+]?1[.,]#\w*")
_SLASHES = re.compile(r"//.*")


def coordinates(data: bytes) -> RawPoints:
    """Rows x, y, z (k, 3)."""
    text = decode_text(data)
    if (lines := text.count("\n")) > MOST_POINTS:
        raise BrokenFile(Text(en="it has {n} lines", pt_BR="tem {n} linhas").format(n=lines))
    text = unquoted(text)
    if "1.#" in text or "1,#" in text:  # missing values as Windows writes them, not comments
        text = _HOLES.sub("nan", text)
    head = read_head(text)
    source = islice(io.StringIO(_SLASHES.sub("", text) if "//" in text else text), head.first_row, None)
    rows, notes, count = read_rows(source, head.columns, head.cells, head.first_row + 1, comment="#")
    check_count(len(rows))
    if head.row_count is not None:
        check_row_count(count, head.row_count)
    return RawPoints(rows, (*head.notes, *notes), head.unit)
