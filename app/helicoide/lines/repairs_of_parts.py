"""Repairs of what is missing, is there once too often, or is another part of the expected line."""

from __future__ import annotations

from collections.abc import Iterator

from helicoide.console.syntax import Expression, FunctionCall, Literal, Operation, operands_of
from helicoide.lines.repair import Repair, replacing
from helicoide.lines.terms import product_factors, product_of, signed_terms, sum_of
from helicoide.lines.tree import all_parts, call, operation, text_of
from helicoide.lines.typed_line import TypedLine


def surplus_repairs(line: TypedLine) -> Iterator[Repair]:
    """A term or a factor that should not be there."""
    for part in line.parts:
        if line.is_top(part, "+-"):
            terms = signed_terms(part)
            for n, (_, term) in enumerate(terms):
                yield replacing("surplus term", part, sum_of([*terms[:n], *terms[n + 1 :]]), term)
        for symbol in ("*", ">>"):
            if line.is_top(part, symbol):
                found = product_factors(part, symbol)
                for n, factor in enumerate(found):
                    yield replacing("surplus factor", part, product_of([*found[:n], *found[n + 1 :]], symbol), factor)


def missing_repairs(line: TypedLine) -> Iterator[Repair]:
    """A term, a factor or a function of the expected line that is missing."""
    others = _different(line.expected)
    for part in line.parts:
        around = line.parents.get(id(part))
        if not isinstance(part, Literal) and not (isinstance(around, Operation) and around.operator in "+-"):
            for other in others:
                yield replacing("missing term", part, operation("+", part, other))
                yield replacing("missing term", part, operation("-", part, other))
    for part in line.parts:
        around = line.parents.get(id(part))
        is_inner = isinstance(around, Operation) and around.operator == "*" and not line.is_top(around, "*")
        if not is_inner and not isinstance(part, Literal):
            for other in others:
                yield replacing("missing factor", part, operation("*", part, other))
                yield replacing("missing factor", part, operation("*", other, part))
        if line.is_top(part, "*"):
            yield from _inserted(part, others)
    for call_there in (part for part in all_parts(line.expected) if isinstance(part, FunctionCall)):
        yield from _with_function(line, call_there)


def _with_function(line: TypedLine, expected: FunctionCall) -> Iterator[Repair]:
    """An argument more, as of join(p, q, r); or a function more, around a part or around what is no number in it."""
    for part in line.parts:
        match part:
            case FunctionCall(name, arguments) if name == expected.name:
                for other in expected.arguments:
                    yield replacing("missing argument", part, call(name, *arguments, other))
    if len(expected.arguments) == 1:
        for part in line.parts:
            yield replacing("missing function", part, call(expected.name, part))
            if line.is_top(part, "*"):
                found = product_factors(part)
                numbers = [factor for factor in found if not line.is_multivector(factor)]
                others = [factor for factor in found if line.is_multivector(factor)]
                if numbers and others:
                    inner = call(expected.name, product_of(others))
                    yield replacing("missing function", part, product_of([*numbers, inner]), *others)


def _inserted(part: Expression, others: list[Expression]) -> Iterator[Repair]:
    found = product_factors(part)
    for n in range(1, len(found)):
        for other in others:
            yield replacing("missing factor", part, product_of([*found[:n], other, *found[n:]]))


def other_part_repairs(line: TypedLine) -> Iterator[Repair]:
    """A part that stands for another part of the expected line; small parts first."""
    others = _different(line.expected)
    for part in sorted(line.parts, key=lambda part: len(list(all_parts(part)))):
        if part is not line.root:
            for other in others:
                yield replacing("part", part, other)


def _different(root: Expression) -> list[Expression]:
    """The parts of an expression, each once."""
    found = {text_of(part): part for part in all_parts(root) if part is not root or not operands_of(part)}
    return list(found.values())
