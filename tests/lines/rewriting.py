"""Equivalent forms of an expression, as different students would write it."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator

from helicoide.console import Value
from helicoide.console.evaluate import Budget, Scope, evaluate
from helicoide.console.syntax import Expression, FunctionCall, Literal, Operation, Reference, operands_of
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lines import LineExercise
from helicoide.lines.samples import expression_of, samples
from helicoide.lines.tree import NOWHERE, all_parts, call, operation, replaced, text_of
from helicoide.sheet import LONGEST_LINE

MOST_PARTS = 90


def number(value: float) -> Literal:
    return Literal(value, NOWHERE)


def name(word: str) -> Reference:
    return Reference(word, NOWHERE)


def times(*factors: Expression) -> Expression:
    first, *others = factors
    for factor in others:
        first = operation("*", first, factor)
    return first


def plus(*terms: Expression) -> Expression:
    first, *others = terms
    for term in others:
        first = operation("+", first, term)
    return first


def over(part: Expression, by: float) -> Expression:
    return operation("/", part, number(by))


def of_sums(part: Expression) -> Iterator[Expression]:
    """Commuted, regrouped, and with other signs."""
    match part:
        case Operation("+", (a, Operation("+", (b, c)))):
            yield plus(a, b, c)
        case Operation("+", (Operation("+", (a, b)), c)):
            yield plus(a, operation("+", b, c))
            yield plus(c, a, b)
    match part:
        case Operation("+", (a, b)):
            yield plus(b, a)
            yield operation("-", a, operation("-", b))
        case Operation("-", (a, b)):
            yield plus(a, operation("-", b))
            yield plus(operation("-", b), a)
            yield operation("-", operation("-", b, a))
            yield plus(a, times(operation("-", number(1)), b))


def of_products(part: Expression) -> Iterator[Expression]:
    """Regrouped, and expanded."""
    match part:
        case Operation("*", (a, Operation("*", (b, c)))):
            yield times(a, b, c)
        case Operation("*", (Operation("*", (a, b)), c)):
            yield times(a, times(b, c))
    match part:
        case Operation("*", (a, Operation("+" | "-" as sign, (b, c)))):
            yield operation(sign, times(a, b), times(a, c))
        case Operation("*", (Operation("+" | "-" as sign, (a, b)), c)):
            yield operation(sign, times(a, c), times(b, c))
        case Operation("/", (a, Literal(2.0))):
            yield times(number(0.5), a)
            yield times(a, number(0.5))
            yield operation("/", a, plus(number(1), number(1)))
        case Operation("*", (Literal(0.5), a)):
            yield over(a, 2)
        case Operation("**", (a, Literal(2.0))):
            yield times(a, a)


def of_anything(part: Expression) -> Iterator[Expression]:
    """Nothing added, or the same thing done twice."""
    yield operation("-", operation("-", part))
    yield operation("~", operation("~", part))
    yield call("conj", call("conj", part))
    yield times(number(1), part)
    yield plus(part, number(0))
    yield over(times(number(2), part), 2)


def of_angles(part: Expression) -> Iterator[Expression]:
    match part:
        case FunctionCall("sin", (x,)):
            yield operation("-", call("sin", operation("-", x)))
            yield call("cos", operation("-", over(name("pi"), 2), x))
            yield times(number(2), call("sin", over(x, 2)), call("cos", over(x, 2)))
        case FunctionCall("cos", (x,)):
            yield call("cos", operation("-", x))
            yield call("sin", plus(x, call("deg", number(90))))
            yield operation("-", number(1), times(number(2), operation("**", call("sin", over(x, 2)), number(2))))
        case Reference("i"):
            yield times(name("j"), name("k"))
        case Reference("e1e2"):
            yield name("e12")
            yield operation("-", name("e2e1"))
            yield times(name("e1"), name("e2"))
        case Reference("e2e"):
            yield times(name("e2"), name("e"))


def of_motions(part: Expression) -> Iterator[Expression]:
    match part:
        case FunctionCall("conj", (Operation("*", (a, b)),)):
            yield times(call("conj", b), call("conj", a))
        case FunctionCall("screw", (L, angle)):
            yield call("exp", times(over(angle, 2), L))
            yield call("screw", operation("-", L), operation("-", angle))
        case FunctionCall("exp", (Operation("*", (half, FunctionCall("line") | Reference() as L)),)):
            yield plus(call("cos", half), times(call("sin", half), L))
            yield call("screw", L, times(number(2), half))
        case FunctionCall("rotor", (Literal(0), Literal(0), Literal(1), angle)):
            yield plus(call("cos", over(angle, 2)), times(call("sin", over(angle, 2)), name("e1e2")))
            yield call("rotor", number(0), number(0), operation("-", number(1)), operation("-", angle))
            yield call("exp", times(over(angle, 2), name("e12")))
        case FunctionCall("translator", (x, y, z)):
            shift = plus(times(x, name("e1e")), times(y, name("e2e")), times(z, name("e3e")))
            yield plus(number(1), over(shift, 2))
            yield call("exp", over(shift, 2))
        case Operation(">>", (M, X)):
            yield times(M, X, call("conj", M))
            yield times(M, X, call("inverse", M))


RULES: tuple[Callable[[Expression], Iterator[Expression]], ...] = (
    of_sums, of_sums, of_products, of_products, of_anything, of_angles, of_angles, of_motions, of_motions,
)  # fmt: skip


def of_kind(part: Expression, given: dict[str, Value]) -> Iterator[Expression]:
    """What depends on the values: numbers commute and move nothing, the conjugate of what is even is its reverse."""

    def value_of(part: Expression) -> Value:
        return evaluate(part, Scope(given, {}, Budget()))

    value = value_of(part)
    match part:
        case Operation(">>", (Operation("*", (A, B)), X)):
            if isinstance(value_of(A), Multivector) and isinstance(value_of(B), Multivector):
                yield operation(">>", A, operation(">>", B, X))
        case FunctionCall("conj" | "inverse", (a,)) if isinstance(value, Multivector):
            is_even = value.algebra is not CL031 or not value.values[CL031.grades % 2 == 1].any()
            if is_even and part.name == "conj":
                yield operation("~", a)
        case Operation("*", (a, b)) if not isinstance(value, Multivector):
            yield times(b, a)


def rewritten(exercise: LineExercise, source: random.Random, steps: int) -> str:
    """The expected line of an exercise after some random changes that keep its value."""
    root, given = expression_of(exercise.expected), samples(exercise.names)[0]
    for _ in range(steps):
        part = source.choice(list(all_parts(root)))
        forms = [*source.choice(RULES)(part), *of_kind(part, given)]
        changed = replaced(root, {id(part): source.choice(forms)}) if forms else root
        if len(list(all_parts(changed))) <= MOST_PARTS and len(text_of(changed)) <= LONGEST_LINE - 20:
            root = changed
    if exercise.kind == "incidence" and source.random() < 0.2 and operands_of(root):
        root = scaled(root, given, source)
    text = text_of(root)
    return text.replace(" ", source.choice(["", " "])) if source.random() < 0.5 else f"answer = {text}  # done"


def scaled(root: Expression, given: dict[str, Value], source: random.Random) -> Expression:
    """A point, line or plane of another size."""
    value = evaluate(root, Scope(given, {}, Budget()))
    is_element = isinstance(value, Multivector) and bool(value.values[1:].any())
    return times(number(source.choice([0.5, 2.0, 3.0])), root) if is_element else root
