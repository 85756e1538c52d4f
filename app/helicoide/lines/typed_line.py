"""A line that a student typed, with the values of its parts, beside the line that is expected."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from helicoide.console import Value
from helicoide.console.evaluate import Budget, Scope, applied
from helicoide.console.syntax import Expression, FunctionCall, Operation, operands_of
from helicoide.console.values import size_of
from helicoide.geometry.multivector import Multivector
from helicoide.lines.equality import EXACT, EqualityRule
from helicoide.lines.exercise import GivenKind, GivenName, LineKind
from helicoide.lines.tree import all_parts, replaced, text_of, with_operands

Values = dict[int, Value]  # of each part, by its `id`


@dataclass(frozen=True, eq=False)
class Sample:
    """One value for each name, and what follows for each part of the typed and of the expected line."""

    given: dict[str, Value]
    values: Values

    def value_of(self, part: Expression, budget: Budget) -> Value:
        """The value of a part; of an altered one, by the values of what it has kept. Raises ExpressionError."""
        if id(part) in self.values:
            return self.values[id(part)]
        values = tuple(self.value_of(operand, budget) for operand in operands_of(part))
        return applied(part, values, Scope(self.given, {}, budget))

    def learn(self, root: Expression, budget: Budget) -> Value:
        """The value of a line, which is kept with those of its parts. Raises ExpressionError."""
        values = tuple(self.learn(operand, budget) for operand in operands_of(root))
        self.values[id(root)] = applied(root, values, Scope(self.given, {}, budget))
        return self.values[id(root)]


@dataclass(frozen=True, eq=False)
class TypedLine:
    """A typed expression, or a part of one, beside what is expected of it. is_whole: whether it is all of the line."""

    root: Expression
    expected: Expression
    samples: tuple[Sample, ...]
    names: tuple[GivenName, ...]
    kind: LineKind
    rule: EqualityRule = EXACT
    is_whole: bool = True

    @cached_property
    def parts(self) -> tuple[Expression, ...]:
        """Each part, before its own parts."""
        return tuple(all_parts(self.root))

    @property
    def depth(self) -> int:
        """The depth of its nesting, 0 for a number or a name."""
        return self.root.depth if isinstance(self.root, Operation | FunctionCall) else 0

    @cached_property
    def parents(self) -> dict[int, Expression]:
        """What holds each part, by its `id`."""
        return {id(operand): part for part in self.parts for operand in operands_of(part)}

    @cached_property
    def repeated(self) -> tuple[tuple[Expression, ...], ...]:
        """The parts that occur more than once with the same text."""
        groups: dict[str, list[Expression]] = {}
        for part in self.parts:
            groups.setdefault(text_of(part), []).append(part)
        return tuple(tuple(group) for group in groups.values() if len(group) > 1)

    def changed(self, changes: Mapping[int, Expression]) -> Expression:
        """The line with some of its parts, named by their `id`, replaced."""
        if len(changes) > 1:
            return replaced(self.root, changes)
        ((old, new),) = changes.items()
        while (outer := self.parents.get(old)) is not None:
            operands = tuple(new if id(operand) == old else operand for operand in operands_of(outer))
            old, new = id(outer), with_operands(outer, operands)
        return new

    def is_multivector(self, part: Expression) -> bool:
        """Whether a part is no number, but a quaternion or a multivector, or has no value."""
        return isinstance(self.samples[0].values.get(id(part)), Multivector | None)

    def is_motion(self, part: Expression) -> bool:
        """Whether a part is the whole line, and a unit quaternion or motor."""
        value = self.samples[0].values.get(id(part))
        return part is self.root and self.is_whole and value is not None and abs(size_of(value) - 1) < 1e-9

    def given(self, name: str) -> GivenKind | None:
        """What a name stands for."""
        return next((one.kind for one in self.names if one.name == name), None)

    def calls_around(self, part: Expression) -> Iterator[tuple[FunctionCall, int]]:
        """The functions around a part, from the inside to the outside, with the number of the argument it is in."""
        inner, outer = part, self.parents.get(id(part))
        while outer is not None:
            if isinstance(outer, FunctionCall):
                yield outer, next(n for n, argument in enumerate(outer.arguments) if argument is inner)
            inner, outer = outer, self.parents.get(id(outer))

    def is_top(self, part: Expression, symbol: str) -> bool:
        """Whether a part is an operation that continues no operation of the same kind around it."""
        around = self.parents.get(id(part))
        own = isinstance(part, Operation) and part.operator in symbol and len(part.operands) == 2
        return own and not (isinstance(around, Operation) and around.operator in symbol and len(around.operands) == 2)
