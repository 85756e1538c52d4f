"""Reading TOML that people write, as a table and as a struct, with errors that say what is wrong and where."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

import msgspec

from helicoide.text import HelicoideError, Text, untranslated

Struct = TypeVar("Struct", bound=msgspec.Struct)

# tomllib takes minutes for keys of thousands of parts.
_LONG_KEY = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){16}""")
_NUMBER, _LIST = Text(en="a number", pt_BR="um número"), Text(en="a list", pt_BR="uma lista")
_KINDS = {
    "float": _NUMBER,
    "int": Text(en="a whole number (int)", pt_BR="um número inteiro"),
    "str": Text(en="words in quotes", pt_BR="um texto entre aspas"),
    "bool": Text(en="true or false", pt_BR="true ou false"),
    "array": _LIST,
    "object": Text(en="a table", pt_BR="uma tabela"),
    "datetime": Text(en="a date", pt_BR="uma data"),
    "date": Text(en="a date", pt_BR="uma data"),
    "time": Text(en="a time", pt_BR="uma hora"),
}
# Messages of tomllib and msgspec, by patterns of their beginnings, and their translations.
_MESSAGES: Mapping[str, Text] = {
    r"(Cannot overwrite|Cannot declare|Cannot mutate)": Text(
        en="something is given twice", pt_BR="algo aparece duas vezes"
    ),
    r"(Unclosed|Expected '\]+')": Text(
        en="the end of an array, a table or its declaration is missing", pt_BR="uma lista ou tabela não foi fechada"
    ),
    r"Unterminated": Text(en="a quote is not closed", pt_BR="faltam aspas para fechar um texto"),
    r"Expected '='": Text(en="a key needs = and a value", pt_BR="uma chave precisa de = e de um valor"),
    r"Object missing required field `(?P<key>[^`]*)`": Text(
        en="the required {key} is missing", pt_BR="falta o campo {key}"
    ),
    r"Object contains unknown field `(?P<key>[^`]*)`": Text(
        en="there is no such key as {key}", pt_BR="não existe a chave {key}"
    ),
    r"Expected `.*` of length (?P<n>\d+), got (?P<got>\d+)": Text(
        en="there must be {n} values, not {got}", pt_BR="são precisos {n} valores, não {got}"
    ),
    r"Expected `(?P<kind>\w+).*`, got `(?P<other>\w+)": Text(
        en="{kind} belongs here, not {other}", pt_BR="aqui vai {kind}, não {other}"
    ),
    r"Invalid (enum )?value (?P<word>'[^`]*')": Text(
        en="{word} is none of the words for this place", pt_BR="{word} não é uma das palavras que valem aqui"
    ),
    r"Number out of range": Text(en="a number is too large", pt_BR="um número é grande demais"),
    r"": Text(en="this is no TOML, or does not belong here", pt_BR="isto não é TOML, ou não cabe aqui"),
}
_PLACES: Mapping[str, Text] = {
    r" \(at line (?P<line>\d+), column (?P<column>\d+)\)$": Text(
        en=" (line {line}, column {column})", pt_BR=" (linha {line}, coluna {column})"
    ),
    r" \(at end of document\)$": Text(en=" (at the end)", pt_BR=" (no fim)"),
    r" - at `(?:key in )?(?P<path>\$.*)`$": Text(en=" (at {path})", pt_BR=" (em {path})"),
    r"$": untranslated(""),
}


def parse_toml(words: str, parse_float: Callable[[str], float] = float) -> dict[str, Any]:
    """Parse a TOML text into a table."""
    if not words.strip():
        raise HelicoideError(Text(en="it is empty", pt_BR="está vazio"))
    if _LONG_KEY.search(words):
        raise HelicoideError(Text(en="a key has too many dots", pt_BR="uma chave tem pontos demais"))
    try:
        return tomllib.loads(words, parse_float=parse_float)
    except RecursionError as error:
        raise HelicoideError(Text(en="it is nested too deep", pt_BR="há níveis demais")) from error
    except tomllib.TOMLDecodeError as error:
        raise HelicoideError(_translated(str(error))) from error
    except (ValueError, OverflowError) as error:  # digits or dates that Python cannot hold
        number = Text(en="a number or a date is impossible", pt_BR="há um número ou uma data impossível")
        raise HelicoideError(number) from error


def table_to_struct(found: object, kind: type[Struct]) -> Struct:
    """Convert a table to the struct of a file format."""
    try:
        return msgspec.convert(found, kind)
    except RecursionError as error:
        raise HelicoideError(Text(en="it is nested too deep", pt_BR="há níveis demais")) from error
    except (msgspec.ValidationError, ValueError, OverflowError) as error:
        raise HelicoideError(_translated(str(error))) from error


def _translated(message: str) -> Text:
    """The translation of a library's message, with its place."""
    place = next((match, words) for start, words in _PLACES.items() if (match := re.search(start, message)))
    what = next((match, words) for start, words in _MESSAGES.items() if (match := re.match(start, message)))
    fields = {name: _KINDS.get(value, value) for name, value in what[0].groupdict().items() if value is not None}
    return Text(en="{what}{where}", pt_BR="{what}{where}").format(
        what=what[1].format(**fields), where=place[1].format(**place[0].groupdict())
    )
