"""The parts of a line: numbers, names, operations and calls, each with its place in the text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from helicoide.console.errors import ExpressionError
from helicoide.text import Text

DEEPEST = 100
TOO_DEEP = Text(
    en="this is nested more than {most} deep: give parts of it a name in lines of their own",
    pt_BR="isto tem mais de {most} níveis: dê nome a partes dele em linhas separadas",
)


@dataclass(frozen=True)
class Span:
    """The characters of a part, from start up to end, counted from 0."""

    start: int
    end: int


@dataclass(frozen=True)
class Literal:
    """A number."""

    value: float
    place: Span


@dataclass(frozen=True)
class Reference:
    """A name: of the scene, of the sheet, of a constant or of a blade."""

    name: str
    place: Span


@dataclass(frozen=True)
class Operation:
    """An operator with its operands, one or two. place: that of the operator itself; depth: of the nesting."""

    operator: str
    operands: tuple[Expression, ...]
    place: Span
    depth: int


@dataclass(frozen=True)
class FunctionCall:
    """A function with its arguments. place: that of its name."""

    name: str
    arguments: tuple[Expression, ...]
    place: Span
    depth: int


Expression = Literal | Reference | Operation | FunctionCall


@dataclass(frozen=True)
class ParsedLine:
    """A line: an expression, with the name that it defines, if any."""

    target: Reference | None
    expression: Expression


def depth_over(parts: tuple[Expression, ...], place: Span) -> int:
    """The depth of what holds these parts. Raises ExpressionError beyond `DEEPEST`."""
    depth = 1 + max((part.depth for part in parts if isinstance(part, Operation | FunctionCall)), default=0)
    if depth > DEEPEST:
        raise ExpressionError(TOO_DEEP.format(most=DEEPEST), place.start, place.end)
    return depth


def operands_of(part: Expression) -> tuple[Expression, ...]:
    """What an operation or a function is applied to; nothing for a number or a name."""
    match part:
        case Operation():
            return part.operands
        case FunctionCall():
            return part.arguments
    return ()


def references(part: Expression) -> Iterator[Reference]:
    """The names in an expression, from left to right; functions are none of them."""
    if isinstance(part, Reference):
        yield part
    for operand in operands_of(part):
        yield from references(operand)
