"""Expressions as trees: their parts, one part replaced by another, their place in the text, and their own text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from helicoide.console.syntax import Expression, FunctionCall, Literal, Operation, Reference, Span, operands_of

NOWHERE = Span(0, 0)
# How strong each form binds, from weak to strong, as in the grammar of the console.
SUM, SANDWICH, PRODUCT, BLEND, SIGNED, POWER, ATOM = range(7)
STRENGTH = {"+": SUM, "-": SUM, ">>": SANDWICH, "*": PRODUCT, "/": PRODUCT, "^": BLEND, "|": BLEND, "&": BLEND}


def all_parts(part: Expression) -> Iterator[Expression]:
    """An expression and all that it holds, each before its own parts, from left to right."""
    yield part
    for operand in operands_of(part):
        yield from all_parts(operand)


def operation(symbol: str, *operands: Expression) -> Operation:
    """An operation that stands nowhere in a text."""
    return Operation(symbol, operands, NOWHERE, 0)


def call(name: str, *arguments: Expression) -> FunctionCall:
    """A function call that stands nowhere in a text."""
    return FunctionCall(name, arguments, NOWHERE, 0)


def replaced(part: Expression, by: Mapping[int, Expression]) -> Expression:
    """An expression with some of its parts, named by their `id`, replaced; all others are the same objects."""
    if id(part) in by:
        return by[id(part)]
    operands = operands_of(part)
    changed = tuple(replaced(operand, by) for operand in operands)
    if all(new is old for new, old in zip(changed, operands, strict=True)):
        return part
    return with_operands(part, changed)


def with_operands(part: Expression, operands: tuple[Expression, ...]) -> Expression:
    """The same operation or function of other operands."""
    if isinstance(part, Operation):
        return Operation(part.operator, operands, part.place, part.depth)
    assert isinstance(part, FunctionCall)
    return FunctionCall(part.name, operands, part.place, part.depth)


def extent(part: Expression, text: str) -> Span:
    """All characters of a part, with its arguments and their brackets."""
    spans = [part.place, *(extent(operand, text) for operand in operands_of(part))]
    end = max(span.end for span in spans)
    if isinstance(part, FunctionCall):
        end = max(end, text.find("(", part.place.end) + 1)
    return _balanced(min(span.start for span in spans), end, text)


def united(parts: Sequence[Expression], text: str) -> Span:
    """All characters from the first of some parts to the last."""
    spans = [extent(part, text) for part in parts]
    return _balanced(min(span.start for span in spans), max(span.end for span in spans), text)


def _balanced(start: int, end: int, text: str) -> Span:
    """The characters with the brackets that are missing to the left and to the right."""
    depth = lowest = 0
    for character in text[start:end]:
        depth += (character == "(") - (character == ")")
        lowest = min(lowest, depth)
    for _ in range(-lowest):
        start = text.rfind("(", 0, start)
    for _ in range(depth - lowest):
        end = text.find(")", end) + 1
    return Span(start, end)


def text_of(part: Expression) -> str:
    """An expression as a line that the grammar reads again."""
    return _text(part)[0]


def _text(part: Expression) -> tuple[str, int]:
    """The text, and how strong it binds."""
    match part:
        case Literal(value):
            return repr(value).removesuffix(".0"), ATOM
        case Reference(name):
            return name, ATOM
        case FunctionCall(name, arguments):
            return f"{name}({', '.join(map(text_of, arguments))})", ATOM
        case Operation(symbol, (operand,)):
            return symbol + _within(operand, SIGNED), SIGNED
        case Operation("**", (base, exponent)):
            return f"{_within(base, ATOM)}**{_within(exponent, SIGNED)}", POWER
        case Operation(symbol, (left, right)):
            own = STRENGTH[symbol]
            to_the_right = symbol == ">>"
            blank = "" if symbol in "*/" else " "
            first, second = _within(left, own + to_the_right), _within(right, own + (not to_the_right))
            return f"{first}{blank}{symbol}{blank}{second}", own
    raise AssertionError(part)


def _within(part: Expression, least: int) -> str:
    text, strength = _text(part)
    return text if strength >= least else f"({text})"
