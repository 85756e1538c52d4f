"""Repairs of a name, a blade, a function or an operator that stands for another one, and of a conjugate."""

from __future__ import annotations

from collections.abc import Iterator

from helicoide.console.names import BLADE
from helicoide.console.syntax import Expression, FunctionCall, Operation, Reference
from helicoide.lines.repair import Repair, each, replacing, together
from helicoide.lines.repairs_of_order import without_conjugate
from helicoide.lines.terms import product_factors, product_of
from helicoide.lines.tree import NOWHERE, call, operation
from helicoide.lines.typed_line import TypedLine

FAMILIES = (
    ("i", "j", "k"), ("e1", "e2", "e3"), ("e2e3", "e3e1", "e1e2"), ("e23", "e31", "e12"), ("e1e", "e2e", "e3e"),
    ("e2e3e", "e3e1e", "e1e2e"),
)  # fmt: skip
BLADES = ("e1", "e2", "e3", "e", "e2e3", "e3e1", "e1e2", "e1e", "e2e", "e3e", "e1e2e3", "e2e3e", "e3e1e", "e1e2e",
          "e1e2e3e")  # fmt: skip
OPPOSITE = {"join": "meet", "meet": "join"}
OPPOSITE_OPERATOR = {"^": "&", "&": "^"}
OTHER_OPERATORS = {"*": (">>", "^", "|", "+", "/"), ">>": ("*",), "^": ("*", "|"), "|": ("*", "^"), "&": ("*",),
                   "+": ("*",), "/": ("*",)}  # fmt: skip


def _name(name: str) -> Reference:
    return Reference(name, NOWHERE)


def join_or_meet_repairs(line: TypedLine) -> Iterator[Repair]:
    """A join for a meet, or the other way round."""

    def change(part: Expression) -> Iterator[Expression]:
        match part:
            case FunctionCall(name, arguments) if name in OPPOSITE:
                yield call(OPPOSITE[name], *arguments)
            case Operation(symbol, operands) if symbol in OPPOSITE_OPERATOR:
                yield operation(OPPOSITE_OPERATOR[symbol], *operands)

    yield from each(line, "join or meet", change)
    for part in line.parts:
        for symbol, other in OPPOSITE_OPERATOR.items():
            if line.is_top(part, symbol):
                yield replacing("join or meet", part, product_of(product_factors(part, symbol), other))


def conjugate_too_many_repairs(line: TypedLine) -> Iterator[Repair]:
    """A conjugate or inverse that should not be there."""

    def change(part: Expression) -> Iterator[Expression]:
        inner = without_conjugate(part)
        if inner is not None:
            yield inner

    return each(line, lambda part: "inverse" if line.is_motion(part) else "conjugate too many", change)


def conjugate_repairs(line: TypedLine) -> Iterator[Repair]:
    """A conjugate that is forgotten; of the whole line, the inverse."""

    for part in sorted(line.parts, key=lambda part: part is line.root or not isinstance(part, Reference)):
        if line.is_multivector(part):
            yield replacing("inverse" if line.is_motion(part) else "conjugate", part, call("conj", part))


def axis_repairs(line: TypedLine) -> Iterator[Repair]:
    """Another axis, i for j or e2e3 for e1e2, at one place, at all, or two of them exchanged."""
    for family in FAMILIES:

        def change(part: Expression, family: tuple[str, ...] = family) -> Iterator[Expression]:
            if isinstance(part, Reference) and part.name in family:
                yield from (_name(other) for other in family if other != part.name)

        yield from each(line, "axis", change)
        for left, right in ((0, 1), (0, 2), (1, 2)):
            swapped = {family[left]: family[right], family[right]: family[left]}
            group = tuple(part for part in line.parts if isinstance(part, Reference) and part.name in swapped)
            if group:
                changes: dict[int, Expression] = {id(part): _name(swapped[part.name]) for part in group}
                yield Repair("axis", changes, group[:1])


def blade_repairs(line: TypedLine) -> Iterator[Repair]:
    """A blade of another grade, such as e1 for e1e."""

    def change(part: Expression) -> Iterator[Expression]:
        if isinstance(part, Reference) and BLADE.fullmatch(part.name):
            yield from (_name(other) for other in BLADES)

    return each(line, "blade", change)


def name_repairs(line: TypedLine) -> Iterator[Repair]:
    """A given name that stands for another one of its kind, such as the angle of another joint."""

    def change(part: Expression) -> Iterator[Expression]:
        if isinstance(part, Reference):
            kind = line.given(part.name)
            yield from (_name(one.name) for one in line.names if one.kind == kind and one.name != part.name)

    yield from each(line, "name", change)
    references = [part for part in line.parts if isinstance(part, Reference) and line.given(part.name)]
    used = sorted({part.name for part in references})
    for n, left in enumerate(used):
        for right in used[n + 1 :]:
            swapped = {left: right, right: left}
            group = tuple(part for part in references if part.name in swapped)
            yield Repair("name", {id(part): _name(swapped[part.name]) for part in group}, group[:1])


def operator_repairs(line: TypedLine) -> Iterator[Repair]:
    """Another operator, such as a product for a sandwich."""
    for part in line.parts:
        if isinstance(part, Operation) and len(part.operands) == 2:
            for symbol in OTHER_OPERATORS.get(part.operator, ()):
                yield replacing("operator", part, operation(symbol, *part.operands))


def function_repairs(line: TypedLine) -> Iterator[Repair]:
    """A function that should not be applied."""

    def change(part: Expression) -> Iterator[Expression]:
        if isinstance(part, FunctionCall):
            yield from part.arguments

    yield from each(line, "function", change)
    group = tuple(part for part in line.parts if isinstance(part, FunctionCall) and len(part.arguments) == 1)
    if len(group) > 1:
        yield from together("function", group, change)
