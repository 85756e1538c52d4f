"""The names that mean the same in every sheet: constants and blades. The others are of the scene, or of a sheet."""

from __future__ import annotations

import math
import re
from collections.abc import Collection
from functools import lru_cache

import numpy as np

from helicoide.console.errors import ExpressionError
from helicoide.console.functions import all_functions
from helicoide.console.grammar import parse_line
from helicoide.console.syntax import ParsedLine, references
from helicoide.console.values import Value, multivector_value, quaternion_value
from helicoide.geometry.clifford import CL031
from helicoide.sheet import Sheet

CONSTANTS: dict[str, Value] = {
    "pi": math.pi,
    "i": quaternion_value(np.eye(4)[1]),
    "j": quaternion_value(np.eye(4)[2]),
    "k": quaternion_value(np.eye(4)[3]),
}
BLADE = re.compile(r"(e\d*)+")
# Names like those of the arm: one that the scene lacks is a mistake, and gets no slider.
OF_AN_ARM = re.compile(r"M_\w+|q_\w+|L\d+|theta\d+")


def is_reserved(name: str) -> bool:
    """Whether a name is a constant, a blade or a function, which no line may define."""
    return name in CONSTANTS or BLADE.fullmatch(name) is not None or name in all_functions()


@lru_cache(maxsize=256)
def reserved_value(name: str) -> Value | None:
    """The value of a constant or a blade; None for other names. Raises HelicoideError for a wrong blade."""
    if BLADE.fullmatch(name):
        return multivector_value(CL031.blade(name))
    return CONSTANTS.get(name)


def parsed_lines(sheet: Sheet) -> tuple[ParsedLine | ExpressionError | None, ...]:
    """Each line of a sheet, parsed: an error for one that cannot be read, None for a comment."""
    return _parsed(tuple(line.text for line in sheet.lines))


@lru_cache(maxsize=64)  # the sheets of a class
def _parsed(texts: tuple[str, ...]) -> tuple[ParsedLine | ExpressionError | None, ...]:
    found: list[ParsedLine | ExpressionError | None] = []
    for text in texts:
        try:
            found.append(parse_line(text))
        except ExpressionError as error:
            found.append(error.without_trace())
    return tuple(found)


def free_names(sheet: Sheet, of_the_scene: Collection[str]) -> tuple[str, ...]:
    """The names of a sheet that nothing defines, in the order in which they occur: each gets a slider."""
    statements = [line for line in parsed_lines(sheet) if isinstance(line, ParsedLine)]
    defined = {line.target.name for line in statements if line.target is not None}
    used = dict.fromkeys(part.name for line in statements for part in references(line.expression))
    known = defined | set(of_the_scene)
    return tuple(name for name in used if name not in known and not is_reserved(name) and not OF_AN_ARM.fullmatch(name))
