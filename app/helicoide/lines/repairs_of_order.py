"""Repairs of what stands in the wrong order: factors, arguments, operands, the letters of a blade."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import combinations

from helicoide.console.names import BLADE
from helicoide.console.syntax import Expression, FunctionCall, Operation, Reference
from helicoide.lines.repair import Repair, each, replacing
from helicoide.lines.slips import SlipName
from helicoide.lines.terms import product_factors, product_of, signed_terms
from helicoide.lines.tree import call, operation, text_of
from helicoide.lines.typed_line import TypedLine

IN_THEIR_ORDER = {"e2e3", "e3e1", "e1e2", "e2e3e", "e3e1e", "e1e2e", "e1e", "e2e", "e3e", "e1e2e3", "e1e2e3e"}
COMPONENTS = {"direction", "point", "rotor", "translator", "plane", "quaternion"}
ORIENTED = {"join", "meet", "line", "plane_through", "common_normal"}
MOST_MOVED = 7  # of longer products only neighbours are exchanged
CONJUGATES = {"conj", "inverse", "reverse"}


def blade_order_repairs(line: TypedLine) -> Iterator[Repair]:
    """e1e3 for e3e1, which differ in sign."""

    def change(part: Expression) -> Iterator[Expression]:
        if isinstance(part, Reference) and BLADE.fullmatch(part.name):
            letters = re.findall(r"e\d?(?=e|$)", part.name) or re.findall(r"\d", part.name)
            written = "".join(f"e{letter.strip('e0')}" for letter in letters)
            if len(letters) > 1 and written not in IN_THEIR_ORDER:
                yield operation("-", part)

    return each(line, "blade order", change)


def passive_repairs(line: TypedLine) -> Iterator[Repair]:
    """q* v q for q v q*, or M* >> X for M >> X: the coordinates change instead of what is moved."""
    for part in line.parts:
        if line.is_top(part, "*"):
            found = product_factors(part)
            for n in range(len(found) - 2):
                first, middle, last = found[n : n + 3]
                if _conjugate_of(first, last) or _conjugate_of(last, first):
                    swapped = [*found[:n], last, middle, first, *found[n + 3 :]]
                    yield replacing("passive", part, product_of(swapped), first, last)
        match part:
            case Operation(">>", (mover, X)):
                unwrapped = without_conjugate(mover)
                changed = call("conj", mover) if unwrapped is None else unwrapped
                yield replacing("passive", part, operation(">>", changed, X), mover)


def without_conjugate(part: Expression) -> Expression | None:
    """What is conjugated or inverted; None if nothing is."""
    match part:
        case FunctionCall(name, (inner,)) if name in CONJUGATES:
            return inner
        case Operation("~", (inner,)):
            return inner
    return None


def _conjugate_of(one: Expression, other: Expression) -> bool:
    inner = without_conjugate(one)
    return inner is not None and text_of(inner) == text_of(other)


def factor_order_repairs(line: TypedLine) -> Iterator[Repair]:
    """Factors of a product, or motors of a sandwich, that are exchanged, moved or in reverse."""
    for symbol in ("*", ">>"):
        for part in line.parts:
            if line.is_top(part, symbol):
                found = product_factors(part, symbol)
                movable = [factor for factor in found if line.is_multivector(factor)]
                numbers = [factor for factor in found if not line.is_multivector(factor)]
                for order, about in _orders(movable):
                    yield replacing("order", part, product_of([*numbers, *order], symbol), *about)


def _orders(found: list[Expression]) -> Iterator[tuple[list[Expression], Sequence[Expression]]]:
    count = len(found)
    for m, n in combinations(range(count), 2):
        if n == m + 1 or count <= MOST_MOVED:
            order = list(found)
            order[m], order[n] = order[n], order[m]
            yield order, found[m : n + 1]
    if 2 < count <= MOST_MOVED:
        yield found[::-1], found
        for m in range(2, count - 1):
            yield [*found[m:], *found[:m]], found
        yield [factor for n in range(0, count, 2) for factor in found[n : n + 2][::-1]], found
        for m in range(count):
            rest = [*found[:m], *found[m + 1 :]]
            for n in range(count):
                if abs(m - n) > 1:
                    yield [*rest[:n], found[m], *rest[n:]], (found[m],)


def operand_order_repairs(line: TypedLine) -> Iterator[Repair]:
    """q ^ p for p ^ q, and a − b for b − a."""
    for part in line.parts:
        match part:
            case Operation("^" | "&" | "|" as symbol, (left, right)):
                yield replacing("order" if symbol == "|" else "orientation", part, operation(symbol, right, left))
            case Operation("-", (left, right)) if len(signed_terms(part)) == 2 and not is_negated(left):
                yield replacing("difference", part, operation("-", right, left))


def is_negated(part: Expression) -> bool:
    """Whether a part begins with a minus."""
    match part:
        case Operation("-", (_,)):
            return True
        case Operation(_, (left, _)):
            return is_negated(left)
    return False


def argument_order_repairs(line: TypedLine) -> Iterator[Repair]:
    """Two arguments that are exchanged: join(q, p) for join(p, q), or the x and z of a direction."""
    for part in line.parts:
        if isinstance(part, FunctionCall):
            for m, n in combinations(range(len(part.arguments)), 2):
                order = list(part.arguments)
                order[m], order[n] = order[n], order[m]
                yield replacing(_slip_of_arguments(part.name, n), part, call(part.name, *order))


def _slip_of_arguments(function: str, last: int) -> SlipName:
    if function in ORIENTED:
        return "orientation"
    return "axis" if function in COMPONENTS and last < 3 else "argument order"
