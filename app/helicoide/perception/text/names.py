"""Finds the columns of x, y and z by the names in a header."""

from __future__ import annotations

import re
from collections.abc import Sequence

from helicoide.perception.broken import BrokenFile
from helicoide.perception.units import Unit
from helicoide.text import Text

AXES = ("x", "y", "z")
_UNITS: dict[str, Unit] = {
    **dict.fromkeys(("m", "metre", "metres", "meter", "meters", "metro", "metros"), "m"),
    **dict.fromkeys(("cm", "centimetres", "centimeters", "centímetros"), "cm"),
    **dict.fromkeys(("mm", "millimetres", "millimeters", "milímetros", "milimetros"), "mm"),
    **dict.fromkeys(("in", "inch", "inches", "pol", "polegadas"), "inch"),
    **dict.fromkeys(("ft", "foot", "feet", "pé", "pés"), "ft"),
}
# Words that may accompany the letter of a coordinate; normals, velocities and the like are not positions.
_BESIDE = {
    "pos", "position", "posição", "posicao", "point", "points", "ponto", "pontos", "p", "pt", "coord", "coords",
    "coordinate", "coordinates", "coordenada", "coordenadas", "world", "base", "loc", "location", "cartesian", "axis",
    "eixo", "local", "xyz", "vertex", "field", "col", "column",
}  # fmt: skip
_WORDS = re.compile(r"[^\W\d_]+|\d+")
_BOUNDARY = re.compile(r"(?<=[a-z])(?=[A-Z])")


def named_columns(names: Sequence[str]) -> tuple[int, int, int] | None:
    """The columns of x, y and z; None if no name is a coordinate; raises BrokenFile unless each is named once."""
    words = [_words(name) for name in names]
    found = [[i for i, one in enumerate(words) if _says(one, k)] for k in range(3)]
    if not any(found):
        return None
    for axis, columns in zip(AXES, found, strict=True):
        plain = [i for i in columns if words[i] == [axis]] or columns
        if len(plain) != 1:
            raise BrokenFile(
                (NAMED_TWICE if plain else NOT_NAMED).format(names=shortened_list(names), n=len(plain), axis=axis)
            )
        columns[:] = plain
    return found[0][0], found[1][0], found[2][0]


NOT_NAMED = Text(
    en="its columns are named {names}, and none of them {axis}; valid are names in which x, y and z stand once each",
    pt_BR="as colunas se chamam {names}, e nenhuma {axis}; valem nomes em que x, y e z apareçam uma vez cada",
)
NAMED_TWICE = Text(
    en="its columns are named {names}, and {n} of them {axis}; valid are names in which x, y and z stand once each",
    pt_BR="as colunas se chamam {names}, e {n} delas {axis}; valem nomes em que x, y e z apareçam uma vez cada",
)


def unit_in_names(names: Sequence[str]) -> Unit | None:
    """The one unit in names or cells, such as `x [mm]`; None if there is none or more than one."""
    said = {next((_UNITS[word] for word in _all_words(name) if word in _UNITS), None) for name in names}
    return said.pop() if len(said) == 1 else None


def is_unit(cell: str) -> bool:
    """Whether a cell holds only a unit."""
    words = _all_words(cell)
    return len(words) == 1 and words[0] in _UNITS


def shortened_list(names: Sequence[str], most: int = 10) -> str:
    """A list of names for a message, shortened."""
    return ", ".join(name[:30] or "–" for name in names[:most]) + (" …" if len(names) > most else "")


def _all_words(name: str) -> list[str]:
    return _WORDS.findall(_BOUNDARY.sub(" ", name).lower())


def _words(name: str) -> list[str]:
    """The words of a name without units."""
    return [word for word in _all_words(name) if word not in _UNITS]


def _says(words: list[str], axis: int) -> bool:
    """Whether the words of a name denote a coordinate: x, pos_x, point.x, or Points:0."""
    if words.count(AXES[axis]) == 1:
        return all(word in _BESIDE or word.isdecimal() for word in words if word != AXES[axis])
    return len(words) == 2 and words[0] in _BESIDE and words[1] == str(axis)
