"""Reading JSON that people may have edited, with errors that say what is wrong and where."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from math import isfinite
from typing import Any

from helicoide.text import HelicoideError, Text

LARGEST = 2**53  # the whole numbers up to here are exact in every program
NO_JSON = Text(
    en="line {line}, column {column}: this is no JSON", pt_BR="linha {line}, coluna {column}: isto não é JSON"
)
TWICE = Text(en="{key!r} is given twice", pt_BR="{key!r} aparece duas vezes")
TOO_LARGE = Text(en="a number is too large", pt_BR="um número é grande demais")
NO_NUMBER = Text(en="{word} is no number", pt_BR="{word} não é um número")
TOO_DEEP = Text(en="it is nested too deep", pt_BR="há níveis demais")


def parse_json(words: str) -> Any:
    """The value of a JSON text. Raises HelicoideError, also for a key that is given twice and a number without end."""
    try:
        return json.loads(
            words, object_pairs_hook=_table, parse_float=_float, parse_int=_int, parse_constant=_refused_constant
        )
    except json.JSONDecodeError as error:
        raise HelicoideError(NO_JSON.format(line=error.lineno, column=error.colno)) from error
    except RecursionError as error:
        raise HelicoideError(TOO_DEEP) from error


def _table(pairs: Sequence[tuple[str, Any]]) -> dict[str, Any]:
    table = dict(pairs)
    if len(table) < len(pairs):
        ((key, _),) = Counter(key for key, _ in pairs).most_common(1)
        raise HelicoideError(TWICE.format(key=key))
    return table


def _float(digits: str) -> float:
    value = float(digits)
    if not isfinite(value):
        raise HelicoideError(TOO_LARGE)
    return value


def _int(digits: str) -> int:
    if len(digits) > len(str(-LARGEST)) or abs(int(digits)) > LARGEST:
        raise HelicoideError(TOO_LARGE)
    return int(digits)


def _refused_constant(word: str) -> float:
    """Refuse NaN and Infinity, which Python reads and JSON does not have."""
    raise HelicoideError(NO_NUMBER.format(word=word))
