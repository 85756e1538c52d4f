"""Sums taken apart into terms, products into factors; and the first that differs from what is expected."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce

from helicoide.console.syntax import Expression, FunctionCall, Literal, Operation
from helicoide.lines.equality import EXACT
from helicoide.lines.tree import operation
from helicoide.lines.typed_line import TypedLine

PLUS, MINUS = 1, -1
Terms = list[tuple[int, Expression]]  # each with its sign


def signed_terms(part: Expression, sign: int = PLUS) -> Terms:
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


def product_factors(part: Expression, symbol: str = "*") -> list[Expression]:
    """The factors of a product; of anything else, itself."""
    if isinstance(part, Operation) and part.operator == symbol and len(part.operands) == 2:
        return [factor for operand in part.operands for factor in product_factors(operand, symbol)]
    return [part]


def product_of(operands: Sequence[Expression], symbol: str = "*") -> Expression:
    """The product of at least one factor. A >> B >> X is read from the right."""
    if symbol == ">>":
        return reduce(lambda right, left: operation(symbol, left, right), reversed(operands))
    return reduce(lambda left, right: operation(symbol, left, right), operands)


def first_different(line: TypedLine) -> TypedLine | None:
    """The first term, factor or argument that differs, beside its counterpart; None if the two are built otherwise."""
    for typed, expected in _counterparts(line):
        if not isinstance(typed, Literal) and not _same(line, typed, expected):
            return replace(line, root=typed, expected=expected, rule=EXACT, is_whole=False)
    return None


def _counterparts(line: TypedLine) -> list[tuple[Expression, Expression]]:
    """Pairs of parts at the same place of both lines."""
    match line.root, line.expected:
        case FunctionCall(name, arguments), FunctionCall(other, expected) if name == other:
            return list(zip(arguments, expected, strict=False))
        case Operation(symbol), Operation(other) if symbol in "+-" and other in "+-":
            typed_alone, expected_alone = terms_of_one_side(line)
            return [(a, b) for (m, a), (n, b) in zip(typed_alone, expected_alone, strict=False) if m == n]
        case Operation("*" | ">>" as symbol), Operation(other) if symbol == other:
            return list(zip(product_factors(line.root, symbol), product_factors(line.expected, symbol), strict=False))
        case Operation(symbol, operands), Operation(other, expected) if symbol == other:
            return list(zip(operands, expected, strict=False))
    return []


def terms_of_one_side(line: TypedLine) -> tuple[Terms, Terms]:
    """The terms of the typed line that the expected one lacks, and the other way round, in their order."""
    typed, expected = signed_terms(line.root), signed_terms(line.expected)
    for term in list(typed):
        for other in expected:
            if _same(line, term[1], other[1], term[0] * other[0]):
                typed.remove(term)
                expected.remove(other)
                break
    return typed, expected


def term_with_wrong_sign(line: TypedLine) -> Expression | None:
    """The first term that the expected line has with the other sign."""
    typed, expected = terms_of_one_side(line)
    for sign, term in typed:
        if any(_same(line, term, other, -sign * other_sign) for other_sign, other in expected):
            return term
    return None


def _same(line: TypedLine, typed: Expression, expected: Expression, sign: int = PLUS) -> bool:
    return all(EXACT.equal(sign * sample.values[id(typed)], sample.values[id(expected)]) for sample in line.samples)
