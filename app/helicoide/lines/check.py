"""Checking a typed line: accepted, refused as the console does, or wrong, with the first wrong term."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array
from helicoide.console import ExpressionError, Value, all_functions, kind_of
from helicoide.console.evaluate import Budget
from helicoide.console.grammar import parse_line
from helicoide.console.names import is_reserved
from helicoide.console.results import RESERVED
from helicoide.console.syntax import Expression, FunctionCall, Reference, Span
from helicoide.lines.equality import equality_rule
from helicoide.lines.exercise import LineExercise
from helicoide.lines.fallback import wrong_blades
from helicoide.lines.motion import motion_shown
from helicoide.lines.repair import Repair
from helicoide.lines.samples import expression_of, samples
from helicoide.lines.search import MOST_WORK, first_wrong, repaired
from helicoide.lines.slips import SlipName, words_of
from helicoide.lines.tree import all_parts, text_of, united
from helicoide.lines.typed_line import Sample, TypedLine
from helicoide.text import HelicoideError, Text

EMPTY = Text(en="type an expression here", pt_BR="digite aqui uma expressão")
WITHOUT = Text(en="here the line is written without {name}", pt_BR="aqui a linha se escreve sem {name}")
LONGEST_QUOTED = 60  # characters of a wrong term in its title


@dataclass(frozen=True)
class Accepted:
    """The line equals what is expected for all values."""


@dataclass(frozen=True, eq=False)
class WrongTerm:
    """The line differs: the characters of the first wrong term, what kind of slip it is, and what to look at.

    expected: what would be right in its place, or for the whole line. wrong_pose, right_pose: the motions (4, 4),
    m, of the typed and of the expected line, if they are motions.
    """

    span: Span
    slip: SlipName
    title: Text
    expected: str
    wrong_pose: Array | None = None
    right_pose: Array | None = None


@dataclass(frozen=True, eq=False)
class Refused:
    """The line cannot be read or has no value. error: says why, and at which characters."""

    error: ExpressionError


LineVerdict = Accepted | WrongTerm | Refused


def check_line(exercise: LineExercise, text: str, at: Mapping[str, Value] | None = None) -> LineVerdict:
    """Compare a typed line with what an exercise expects; of one with steps, the last line.

    at: the values of the names, such as those of the scene, for which a wrong motion is shown; else random ones.
    Raises HelicoideError if the exercise itself has a fault.
    """
    exercise = exercise.lines()[-1]
    expected, known = _expected(exercise)
    try:
        root = _read(exercise, text)
    except ExpressionError as error:
        return Refused(error.without_trace())
    found = tuple(Sample(sample.given, dict(sample.values)) for sample in known)
    line = TypedLine(root, expected, found, exercise.names, exercise.kind, equality_rule(exercise))
    search = Budget(MOST_WORK)
    try:
        for sample in line.samples:
            _learn(sample, line.root, search)
    except ExpressionError as error:
        with np.errstate(all="ignore"):
            repair = repaired(line, search) if _has_names_alone(line) else None
            return Refused(error.without_trace()) if repair is None else _wrong(line, repair, text, at)
    with np.errstate(all="ignore"):  # a very large value is wrong without a warning
        if all(line.rule.equal(one.values[id(line.root)], one.values[id(line.expected)]) for one in line.samples):
            return Accepted()
        return _wrong(line, first_wrong(line, search), text, at)


def _learn(sample: Sample, root: Expression, search: Budget) -> None:
    """Compute a line, which may take as much as a sheet; what it takes is not left for the search of a repair."""
    budget = Budget()
    before = budget.left
    try:
        sample.learn(root, budget)
    finally:
        search.left -= before - budget.left


def line_faults(exercise: LineExercise) -> list[Text]:
    """What is wrong with an exercise itself: a name with another meaning, an expected line without a value."""
    names = [one.name for one in exercise.names] + [name for name, _ in exercise.steps]
    faults = [RESERVED.format(name=name) for name in names if is_reserved(name)]
    for line in exercise.lines():
        try:
            _expected(line)
        except HelicoideError as error:
            faults.append(error.text)
    return faults


@lru_cache(maxsize=128)
def _expected(exercise: LineExercise) -> tuple[Expression, tuple[Sample, ...]]:
    """The expected line, and its values."""
    root = expression_of(exercise.expected)
    found = tuple(Sample(given, {}) for given in samples(exercise.names))
    for sample in found:
        sample.learn(root, Budget())
    return root, found


def _read(exercise: LineExercise, text: str) -> Expression:
    """The typed expression. Raises ExpressionError."""
    statement = parse_line(text)
    if statement is None:
        raise ExpressionError(EMPTY, 0, len(text))
    if statement.target is not None and is_reserved(statement.target.name):
        place = statement.target.place
        raise ExpressionError(RESERVED.format(name=statement.target.name), place.start, place.end)
    for part in all_parts(statement.expression):
        if isinstance(part, FunctionCall) and part.name in exercise.without:
            raise ExpressionError(WITHOUT.format(name=part.name), part.place.start, part.place.end)
    return statement.expression


def _has_names_alone(line: TypedLine) -> bool:
    """Whether each name and function of a line without a value has a meaning."""
    return all(
        part.name in all_functions()
        if isinstance(part, FunctionCall)
        else not isinstance(part, Reference) or is_reserved(part.name) or line.given(part.name) is not None
        for part in line.parts
    )


def _wrong(line: TypedLine, repair: Repair, text: str, at: Mapping[str, Value] | None) -> WrongTerm:
    span = united(repair.about, text)
    part = text[span.start : span.end]
    shown = part if len(part) <= LONGEST_QUOTED else f"{part[: LONGEST_QUOTED - 1]}…"
    title = words_of(repair.slip, line.kind).format(part=shown, **_fields(line, repair.slip))
    wrong, right = (motion_shown(line, root, at) for root in (line.root, line.expected))
    by = next(iter(repair.changes.values()))
    return WrongTerm(span, repair.slip, title, text_of(by), wrong, right)


def _fields(line: TypedLine, slip: SlipName) -> dict[str, object]:
    """What the words of a slip name besides the wrong term."""
    if slip == "coefficient":
        return {"blades": ", ".join(sorted(wrong_blades(line)))}
    if slip == "kind":
        typed, expected = (kind_of(line.samples[0].values[id(part)]).title for part in (line.root, line.expected))
        return {"kind": typed, "wanted": expected}
    return {}
