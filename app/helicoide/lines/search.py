"""The first wrong term of a line: by a repair that makes it right; otherwise term by term and factor by factor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from helicoide.console.evaluate import Budget
from helicoide.console.syntax import Expression
from helicoide.lines import repairs_of_names as names
from helicoide.lines import repairs_of_numbers as numbers
from helicoide.lines import repairs_of_order as order
from helicoide.lines import repairs_of_parts as parts
from helicoide.lines.equality import EXACT
from helicoide.lines.fallback import (
    other_kind,
    rounded_number,
    unfinished_line,
    whole_replaced,
    wrong_coefficient,
    wrong_term_of_a_sum,
)
from helicoide.lines.repair import Repair, Repairs
from helicoide.lines.slips import SlipName
from helicoide.lines.terms import first_different
from helicoide.lines.tree import text_of
from helicoide.lines.typed_line import TypedLine
from helicoide.text import HelicoideError

# The first that makes a line right names its slip, so those of a narrow meaning stand before the general ones.
REPAIRS: tuple[Repairs, ...] = (
    order.blade_order_repairs,
    numbers.written_minus_repairs,
    order.passive_repairs,
    order.factor_order_repairs,
    order.operand_order_repairs,
    order.argument_order_repairs,
    names.join_or_meet_repairs,
    numbers.sine_or_cosine_repairs,
    numbers.half_repairs,
    names.conjugate_too_many_repairs,
    numbers.sign_repairs,
    numbers.moment_sign_repairs,
    names.conjugate_repairs,
    names.axis_repairs,
    names.name_repairs,
    numbers.unit_repairs,
    names.operator_repairs,
    numbers.power_repairs,
    names.function_repairs,
    parts.surplus_repairs,
    parts.missing_repairs,
    names.blade_repairs,
    parts.other_part_repairs,
)
# One of these gives way to a repair that gives the expected text.
DOUBTFUL: frozenset[SlipName] = frozenset({"order", "orientation", "difference", "operator"})
GENERAL: frozenset[SlipName] = frozenset({"operator", "missing factor", "missing term", "missing function", "part"})
MOST_WORK = 16_000  # for all repairs, in the units of the console; the first search takes half, the next a quarter


def first_wrong(line: TypedLine, budget: Budget) -> Repair:
    """What is wrong in a line that differs from what is expected. budget: for the search of a repair."""
    found = rounded_number(line) or repaired(line, budget)
    if found is not None and found.slip not in GENERAL:
        of_all_angles = found.slip == "sense" and len(found.changes) > 1
        return (wrong_term_of_a_sum(line) if of_all_angles else None) or found
    found = wrong_term_of_a_sum(line) or unfinished_line(line) or found
    if found is not None and found.slip != "part":
        return found
    inner = first_different(line if found is None else _with_its_counterpart(line, found))
    if inner is not None:
        return first_wrong(inner, budget)
    if found is not None:
        return found
    return wrong_coefficient(line) or other_kind(line) or whole_replaced(line, "line" if line.is_whole else "part")


def _with_its_counterpart(line: TypedLine, repair: Repair) -> TypedLine:
    """The part that a repair replaces, beside the part of the expected line that replaces it."""
    ((_, expected),) = repair.changes.items()
    return replace(line, root=repair.about[0], expected=expected, rule=EXACT, is_whole=False)


def repaired(line: TypedLine, budget: Budget) -> Repair | None:
    """The first repair that makes a line right; rather than another operator, one that gives the expected text."""
    found: Repair | None = None
    expected = text_of(line.expected)
    own, to_build = Budget(budget.left // 2), 1 + len(line.parts) // 10 + (line.depth // 8) ** 2
    budget.left -= own.left
    for repair in _all_repairs(line):
        own.left -= to_build
        if own.left < 0:
            break
        if found is None:
            root = line.changed(repair.changes)
            if _is_right(line, root, own):
                found = repair
                if repair.slip not in DOUBTFUL or text_of(root) == expected:
                    return repair
        elif _may_replace(found, repair) and text_of(line.changed(repair.changes)) == expected:
            return repair
    return found


def _may_replace(found: Repair, other: Repair) -> bool:
    return other.slip not in GENERAL or found.slip in GENERAL


def _all_repairs(line: TypedLine) -> Iterator[Repair]:
    for repairs in REPAIRS:
        yield from repairs(line)


def _is_right(line: TypedLine, root: Expression, budget: Budget) -> bool:
    try:
        return all(
            line.rule.equal(sample.value_of(root, budget), sample.values[id(line.expected)]) for sample in line.samples
        )
    except HelicoideError:
        return False
