"""The results of a sheet at a state, line by line."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache, partial

from helicoide.console.errors import ExpressionError
from helicoide.console.evaluate import Budget, Scope, evaluate
from helicoide.console.names import free_names, is_reserved, parsed_lines
from helicoide.console.scene_names import scene_names
from helicoide.console.syntax import ParsedLine, Reference, references
from helicoide.console.values import Value
from helicoide.sheet import Sheet
from helicoide.state import State
from helicoide.text import Text

RESERVED = Text(
    en="{name} already has a meaning, as a constant, a blade or a function: choose another name",
    pt_BR="{name} já tem significado, como constante, lâmina ou função: escolha outro nome",
)
FURTHER_DOWN = Text(
    en="{name} is defined further down, in line {line}: move that line up",
    pt_BR="{name} é definido mais abaixo, na linha {line}: suba essa linha",
)


@dataclass(frozen=True, eq=False)
class LineResult:
    """The result of a line: its value, or the error; neither for a comment. name: the one that the line defines."""

    name: str | None = None
    value: Value | None = None
    error: ExpressionError | None = None


@lru_cache(maxsize=64)  # of each window, for its panel and its layer
def sheet_results(sheet: Sheet, state: State | None, sliders: bool = True) -> tuple[LineResult, ...]:
    """The result of each line. state: gives the names of the scene, if any; sliders: whether free names have values."""
    scene = {} if state is None else {name: partial(one.at, state) for name, one in scene_names(state).items()}
    free = free_names(sheet, scene) if sliders else ()
    known: dict[str, Value] = {name: sheet.slider(name).value for name in free}
    scope, lines = Scope(known, scene, Budget()), parsed_lines(sheet)
    found = []
    for n, line in enumerate(lines):
        result = _result(line, lines[n + 1 :], n + 2, scope)
        if result.name is not None and result.value is not None:
            known[result.name] = result.value
        found.append(result)
    return tuple(found)


Parsed = ParsedLine | ExpressionError | None


def _result(line: Parsed, below: tuple[Parsed, ...], next_number: int, scope: Scope) -> LineResult:
    if line is None:
        return LineResult()
    if isinstance(line, ExpressionError):
        return LineResult(error=line)
    name = None if line.target is None else line.target.name
    try:
        if line.target is not None and is_reserved(line.target.name):
            raise _error(line.target, RESERVED.format(name=line.target.name))
        _check_order(line, below, next_number, scope)
        return LineResult(name, evaluate(line.expression, scope))
    except ExpressionError as error:
        return LineResult(name, error=error.without_trace())


def _check_order(line: ParsedLine, below: tuple[Parsed, ...], next_number: int, scope: Scope) -> None:
    """Raise ExpressionError for a name without a value, if a line further down defines it."""
    for part in references(line.expression):
        if part.name in scope.values or part.name in scope.scene or is_reserved(part.name):
            continue
        for n, other in enumerate(below, next_number):
            if isinstance(other, ParsedLine) and other.target is not None and other.target.name == part.name:
                raise _error(part, FURTHER_DOWN.format(name=part.name, line=n))


def _error(part: Reference, what: Text) -> ExpressionError:
    return ExpressionError(what, part.place.start, part.place.end)
