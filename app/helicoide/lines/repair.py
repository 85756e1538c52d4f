"""A repair: the smallest change of a typed line that could make it right. Which one does, tells what the slip was."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from helicoide.console.syntax import Expression
from helicoide.lines.slips import SlipName
from helicoide.lines.typed_line import TypedLine


@dataclass(frozen=True, eq=False)
class Repair:
    """Parts to replace, by their `id`, and the slip that this would undo. about: the parts that are wrong."""

    slip: SlipName
    changes: dict[int, Expression]
    about: tuple[Expression, ...]


Repairs = Callable[[TypedLine], Iterator[Repair]]
Change = Callable[[Expression], Iterator[Expression]]
Naming = Callable[[Expression], SlipName]


def replacing(slip: SlipName, part: Expression, by: Expression, *about: Expression) -> Repair:
    """The replacement of one part. about: the parts that are wrong, if it is not the whole of it."""
    return Repair(slip, {id(part): by}, about or (part,))


def each(line: TypedLine, slip: SlipName | Naming, change: Change) -> Iterator[Repair]:
    """A change at each part, then at all parts at once that have the same text."""
    for part in line.parts:
        for by in change(part):
            yield replacing(_name(slip, part), part, by)
    for group in line.repeated:
        yield from together(_name(slip, group[0]), group, change)


def together(slip: SlipName, group: tuple[Expression, ...], change: Change) -> Iterator[Repair]:
    """The same change at all parts of a group, of which the first is named."""
    if not group:
        return
    for changed in zip(*(tuple(change(part)) for part in group), strict=False):
        yield Repair(slip, {id(part): by for part, by in zip(group, changed, strict=True)}, group[:1])


def _name(slip: SlipName | Naming, part: Expression) -> SlipName:
    return slip(part) if callable(slip) else slip
