"""An error in an expression: what is wrong, at which character, and what would be valid."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

from helicoide.text import HelicoideError, Text

MOST_LISTED = 16
SIMILAR = Text(en="similar: {names}", pt_BR="parecidos: {names}")
AVAILABLE = Text(en="there is {names}", pt_BR="há {names}")
AT = Text(en="character {column}: {what}", pt_BR="caractere {column}: {what}")


class ExpressionError(HelicoideError):
    """A wrong expression. what: without the place; start, end: the characters it is about, counted from 0."""

    def __init__(self, what: Text, start: int, end: int) -> None:
        super().__init__(AT.format(column=start + 1, what=what))
        self.what, self.start, self.end = what, start, max(end, start + 1)

    def without_trace(self) -> ExpressionError:
        """The same error to keep: it holds no frames, which would keep all that the parser and the evaluation used."""
        return ExpressionError(self.what, self.start, self.end)

    def __reduce__(self) -> tuple[type[ExpressionError], tuple[Text, int, int]]:  # type: ignore[override]
        return type(self), (self.what, self.start, self.end)


def pointer(source: str, error: ExpressionError) -> str:
    """The line and, below it, a caret under the character that the error is about."""
    return f"{source}\n{' ' * error.start}{'^' * (min(error.end, len(source) + 1) - error.start)}"


def similar(name: str, known: Iterable[str]) -> Text:
    """The known names that resemble one or begin with it; if there is none, the first of all."""
    names = sorted(known)
    close = [*(one for one in names if one.startswith(name)), *get_close_matches(name, names, n=4, cutoff=0.6)]
    if not close:
        return AVAILABLE.format(names=", ".join(names[:MOST_LISTED]) + (", …" if len(names) > MOST_LISTED else ""))
    return SIMILAR.format(names=", ".join(dict.fromkeys(close)))
