"""Repairs of angles and numbers: sine for cosine, a half, a sign, degrees, a power."""

from __future__ import annotations

import math
from collections.abc import Iterator

from helicoide.console.syntax import Expression, FunctionCall, Literal, Operation, Reference, operands_of
from helicoide.lines.repair import Change, Repair, each, replacing, together
from helicoide.lines.repairs_of_order import is_negated
from helicoide.lines.slips import SlipName
from helicoide.lines.terms import signed_terms, sum_of
from helicoide.lines.tree import NOWHERE, call, operation
from helicoide.lines.typed_line import TypedLine

OTHER_FUNCTION = {"sin": "cos", "cos": "sin"}
OF_AN_ANGLE = ("sin", "cos", "tan", "exp")
ANGLE_AT = {"rotor": 3, "screw": 1, **dict.fromkeys(OF_AN_ANGLE, 0)}
AXIS_AT = {"rotor": 2, "screw": 0, "direction": 2, "plane": 2}  # the last argument that is about the axis
COORDINATES = ("direction", "translator", "point")
NULL_BLADE = ("e1e", "e2e", "e3e", "e01", "e02", "e03")


def _number(value: float) -> Literal:
    return Literal(value, NOWHERE)


def sine_or_cosine_repairs(line: TypedLine) -> Iterator[Repair]:
    """A sine for a cosine or the other way round, at one place or at all."""

    def change(part: Expression) -> Iterator[Expression]:
        if isinstance(part, FunctionCall) and part.name in OTHER_FUNCTION:
            yield call(OTHER_FUNCTION[part.name], *part.arguments)

    yield from each(line, "sine or cosine", change)
    group = tuple(part for part in line.parts if isinstance(part, FunctionCall) and part.name in OTHER_FUNCTION)
    if len(group) > 1:
        yield from together("sine or cosine", group, change)


def _angles(line: TypedLine, of: tuple[str, ...] = OF_AN_ANGLE) -> tuple[Expression, ...]:
    return tuple(part.arguments[0] for part in line.parts
                 if isinstance(part, FunctionCall) and part.name in of and part.arguments)  # fmt: skip


def half_repairs(line: TypedLine) -> Iterator[Repair]:
    """A half that is forgotten, or is there once too often."""

    def forgotten(part: Expression) -> Iterator[Expression]:
        if not isinstance(part, Literal):
            yield operation("/", part, _number(2.0))

    def too_often(part: Expression) -> Iterator[Expression]:
        if not isinstance(part, Literal):
            yield operation("*", _number(2.0), part)

    for part in line.parts:
        match part:
            case Operation("/", (whole, Literal(2.0))) | Operation("*", (Literal(0.5), whole)):
                yield replacing("half too much", part, whole)
    changes: tuple[tuple[SlipName, Change], ...] = (("half", forgotten), ("half too much", too_often))
    for slip, change in changes:
        for group in (_angles(line), _angles(line, ("sin", "cos")), _angles(line, ("exp",))):
            if group:
                yield from together(slip, group, change)
        yield from each(line, slip, change)
        for part in line.parts:
            if isinstance(part, FunctionCall) and part.name in COORDINATES:
                yield from together(slip, tuple(x for x in part.arguments if not isinstance(x, Literal)), change)


def written_minus_repairs(line: TypedLine) -> Iterator[Repair]:
    """A minus in front of something, which should not be there."""
    if is_negated(line.root) and line.is_whole:
        yield replacing("opposite", line.root, operation("-", line.root))
    for part in line.parts:
        match part:
            case Operation("-", (operand,)):
                yield replacing(_sign_of_what(line, part), part, operand)


def sign_repairs(line: TypedLine) -> Iterator[Repair]:
    """A plus for a minus, or a minus that is missing."""

    def slip(part: Expression) -> SlipName:
        return _sign_of_what(line, part)

    def change(part: Expression) -> Iterator[Expression]:
        around = line.parents.get(id(part))
        is_exponent = isinstance(around, Operation) and around.operator == "**" and part is around.operands[1]
        if not is_exponent and not (isinstance(part, Literal) and part.value == 0):
            yield operation("-", part)

    if line.is_whole:
        yield replacing("opposite", line.root, operation("-", line.root))
    for part in line.parts:
        match part:
            case Operation("+" | "-" as symbol, (left, right)):
                yield replacing(slip(right), part, operation("-" if symbol == "+" else "+", left, right), right)
    yield from each(line, slip, change)
    if angles := _angles(line):
        yield from together("sense", angles, change)
    for part in line.parts:
        if isinstance(part, FunctionCall) and part.name in COORDINATES:
            yield replacing("sign", part, call(part.name, *(operation("-", argument) for argument in part.arguments)))


def _sign_of_what(line: TypedLine, part: Expression) -> SlipName:
    """The whole line, the angle of a motion, its axis, or any other term."""
    if part is line.root and line.is_whole:
        return "opposite"
    for function, n in line.calls_around(part):
        if n == ANGLE_AT.get(function.name):
            return "sense"
        return "axis sign" if n <= AXIS_AT.get(function.name, -1) else "sign"
    return "sign"


def moment_sign_repairs(line: TypedLine) -> Iterator[Repair]:
    """The terms with e1e, e2e, e3e of a line or twist negated: v × r for r × v."""
    for part in line.parts:
        if line.is_top(part, "+-"):
            terms = signed_terms(part)
            moment = [term for _, term in terms if _has_null_blade(term)]
            if len(moment) > 1:
                turned = [(-plus if _has_null_blade(term) else plus, term) for plus, term in terms]
                yield replacing("moment", part, sum_of(turned), *moment)


def _has_null_blade(part: Expression) -> bool:
    match part:
        case Reference(name):
            return name in NULL_BLADE
        case Operation("*" | "/" | "-", operands):
            return any(map(_has_null_blade, operands))
    return False


def unit_repairs(line: TypedLine) -> Iterator[Repair]:
    """Degrees for radians, millimetres for metres."""

    def change(part: Expression) -> Iterator[Expression]:
        if line.is_multivector(part):
            return
        for factor in (math.pi / 180, 180 / math.pi, 1e-3, 1e3):
            yield operation("*", part, _number(factor))

    for part in line.parts:
        if isinstance(part, FunctionCall) and part.name == "deg":
            yield from (replacing("unit", part, inner) for inner in part.arguments)
    in_degrees = tuple(part for part in line.parts if isinstance(part, FunctionCall) and part.name == "deg")
    yield from together("unit", in_degrees, lambda part: iter(operands_of(part)))
    group = _angles(line)
    if group and not any(map(line.is_multivector, group)):
        yield from together("unit", group, change)
    yield from each(line, "unit", change)


def power_repairs(line: TypedLine) -> Iterator[Repair]:
    """A square that is missing, or is there once too often."""

    def change(part: Expression) -> Iterator[Expression]:
        match part:
            case Operation("**", (base, _)):
                yield base
            case Operation() | FunctionCall() | Reference() if not line.is_multivector(part):
                yield operation("**", part, _number(2.0))
                yield call("sqrt", part)

    return each(line, "power", change)
