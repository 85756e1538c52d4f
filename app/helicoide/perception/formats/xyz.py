"""Text with a point a line: x, y, z first, between blanks, commas or semicolons; more columns are not read.

Where blanks or semicolons part the columns already, a comma is the decimal mark, as in Portuguese. Lines that begin
with # or // are comments, and a first line of names is passed over.
"""

from __future__ import annotations

import io
import re
import warnings

import numpy as np

from helicoide.kinematics.chain import Array
from helicoide.perception.formats import MOST_POINTS, Broken, check_count
from helicoide.text import Text

TITLE = Text(en="XYZ text", pt_BR="texto XYZ")
ENDINGS = (".xyz", ".txt", ".csv")

_COMMENTS = ("#", "//")
_LINE = re.compile(r"^[ \t]*(?!#|//)\S.*$", re.MULTILINE)
_NOT_A_NUMBER = re.compile(r"nan|inf(inity)?", re.IGNORECASE)
_NAMES = re.compile(r"\D*[^\W\d]\D*")


def coordinates(data: bytes) -> Array:
    """Rows x, y, z (k, 3)."""
    if b"\0" in data:
        raise Broken(Text(en="it is no text", pt_BR="não é texto"))
    text = data.decode("utf-8-sig")
    if (lines := text.count("\n")) > MOST_POINTS:
        raise Broken(Text(en="it has {n} lines", pt_BR="tem {n} linhas").format(n=lines))
    first = _LINE.search(text)
    if first and _NAMES.fullmatch(_NOT_A_NUMBER.sub("", first[0])):
        text = text[first.end() :]
        first = _LINE.search(text)
    with warnings.catch_warnings():  # of empty lines, which are not counted
        warnings.simplefilter("ignore", UserWarning)
        rows = np.loadtxt(
            io.StringIO(_blanks(text, first[0] if first else "")),
            usecols=(0, 1, 2),
            ndmin=2,
            comments=_COMMENTS,
        )
    check_count(len(rows))
    return np.asarray(rows, dtype=np.float64)


def _blanks(text: str, example: str) -> str:
    """The same text with points for decimal commas, and blanks between its columns."""
    parted = re.split(r"[;\s]+", example.strip())
    decimal = len(parted) >= 3 and not any(part.startswith(",") or part.endswith(",") for part in parted)
    return text.replace(",", "." if decimal else " ").replace(";", " ")
