"""Sums taken apart into terms, products into factors; and the first that differs from what is expected."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce

from helicoide.console.syntax import Expression, FunctionCall, Operation
from helicoide.lines.equality import EXACT
from helicoide.lines.tree import operation
from helicoide.lines.typed_line import TypedLine

PLUS, MINUS = 1, -1


def signed_terms(part: Expression, sign: int = PLUS) -> list[tuple[int, Expression]]:
    """The terms of a sum with their signs; of anything else, itself."""
    match part:
        case Operation("-", (operand,)):
            return signed_terms(operand, -sign)
        case Operation("+" | "-" as symbol, (left, right)):
            return [*signed_terms(left, sign), *signed_terms(right, sign if symbol == "+" else -sign)]
    return [(sign, part)]


def sum_of(terms: Sequence[tuple[int, Expression]]) -> Expression:
    """The sum of at least one term."""
    (sign, first), *others = terms
    total = first if sign == PLUS else operation("-", first)
    return reduce(lambda left, term: operation("+" if term[0] == PLUS else "-", left, term[1]), others, total)


def factors(part: Expression, symbol: str = "*") -> list[Expression]:
    """The factors of a product; of anything else, itself."""
    if isinstance(part, Operation) and part.operator == symbol and len(part.operands) == 2:
        return [factor for operand in part.operands for factor in factors(operand, symbol)]
    return [part]


def product_of(operands: Sequence[Expression], symbol: str = "*") -> Expression:
    """The product of at least one factor. A >> B >> X is read from the right."""
    if symbol == ">>":
        return reduce(lambda right, left: operation(symbol, left, right), reversed(operands))
    return reduce(lambda left, right: operation(symbol, left, right), operands)


def first_different(line: TypedLine) -> TypedLine | None:
    """The first term, factor or argument that differs, beside its counterpart; None if the two are built otherwise."""
    pairs = _counterparts(line)
    for typed, expected in pairs:
        if not _same(line, typed, expected):
            return replace(line, root=typed, expected=expected, rule=EXACT)
    return None


def _counterparts(line: TypedLine) -> list[tuple[Expression, Expression]]:
    """Pairs of parts at the same place of both lines."""
    match line.root, line.expected:
        case FunctionCall(name, arguments), FunctionCall(other, expected) if name == other:
            return list(zip(arguments, expected, strict=False))
        case Operation(symbol), Operation() if symbol in "+-":
            return _terms_side_by_side(line)
        case Operation("*" | ">>" as symbol), Operation(other) if symbol == other:
            return list(zip(factors(line.root, symbol), factors(line.expected, symbol), strict=False))
        case Operation(symbol, operands), Operation(other, expected) if symbol == other:
            return list(zip(operands, expected, strict=False))
    return []


def _terms_side_by_side(line: TypedLine) -> list[tuple[Expression, Expression]]:
    """The terms that occur on one side alone, in their order, if they have the same signs."""
    typed, expected = signed_terms(line.root), signed_terms(line.expected)
    for sign, term in list(typed):
        for other_sign, other in expected:
            if sign == other_sign and _same(line, term, other):
                typed = [one for one in typed if one[1] is not term]
                expected = [one for one in expected if one[1] is not other]
                break
    return [(term, other) for (sign, term), (other_sign, other) in zip(typed, expected, strict=False)
            if sign == other_sign]  # fmt: skip


def _same(line: TypedLine, typed: Expression, expected: Expression) -> bool:
    return all(EXACT.equal(sample.values[id(typed)], sample.values[id(expected)]) for sample in line.samples)
