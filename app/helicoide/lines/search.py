"""The first wrong term of a line: by a repair that makes it right; otherwise term by term and factor by factor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from helicoide.console import kind_of, value_terms
from helicoide.console.evaluate import Budget
from helicoide.console.kinds import NOISE
from helicoide.console.syntax import Expression, Literal, Operation, operands_of
from helicoide.geometry.multivector import Multivector
from helicoide.lines import repairs_of_names as names
from helicoide.lines import repairs_of_numbers as numbers
from helicoide.lines import repairs_of_order as order
from helicoide.lines import repairs_of_parts as parts
from helicoide.lines.equality import EXACT, same_blades
from helicoide.lines.repair import Repair, Repairs
from helicoide.lines.slips import SlipName
from helicoide.lines.terms import first_different, signed_terms, term_with_wrong_sign, terms_of_one_side
from helicoide.lines.tree import all_parts, text_of
from helicoide.lines.typed_line import TypedLine
from helicoide.text import HelicoideError

# The first that makes a line right names its slip, so those of a narrow meaning stand before the general ones.
REPAIRS: tuple[Repairs, ...] = (
    order.blade_order, numbers.written_minus, order.passive, order.factor_order, order.operand_order,
    order.argument_order, names.join_or_meet, numbers.sine_or_cosine, numbers.half, names.conjugate_too_many,
    numbers.sign, numbers.moment_sign, names.conjugate, names.axis, names.name, numbers.unit, names.operator,
    numbers.power, names.function, parts.surplus, parts.missing, names.blade, parts.other_part,
)  # fmt: skip
# One of these gives way to a repair that gives the expected text.
DOUBTFUL: frozenset[SlipName] = frozenset({"order", "difference", "operator"})
GENERAL: frozenset[SlipName] = frozenset({"operator", "missing factor", "missing term", "missing function", "part"})
MOST_WORK = 16_000  # for all repairs, in the units of the console; the first search takes half, the next a quarter
NEARLY = 5e-3  # of the largest coefficient, by which a rounded number may be wrong


def first_wrong(line: TypedLine, budget: Budget) -> Repair:
    """What is wrong in a line that differs from what is expected. budget: for the search of a repair."""
    found = _rounded(line) or repaired(line, budget)
    if found is not None and found.slip not in GENERAL:
        return found
    found = _of_a_sum(line) or _unfinished(line) or found
    if found is not None and found.slip != "part":
        return found
    inner = first_different(line if found is None else _beside_its_counterpart(line, found))
    if inner is not None:
        return first_wrong(inner, budget)
    if found is not None:
        return found
    return _wrong_coefficient(line) or _other_kind(line) or _at_root(line, "line" if line.is_whole else "part")


def _beside_its_counterpart(line: TypedLine, repair: Repair) -> TypedLine:
    """The part that a repair replaces, beside the part of the expected line that replaces it."""
    ((_, expected),) = repair.changes.items()
    return replace(line, root=repair.about[0], expected=expected, rule=EXACT, is_whole=False)


def repaired(line: TypedLine, budget: Budget) -> Repair | None:
    """The first repair that makes a line right; rather than another operator, one that gives the expected text."""
    found: Repair | None = None
    expected = text_of(line.expected)
    own, to_build = Budget(budget.left // 2), 1 + len(line.parts) // 10
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


def _at_root(line: TypedLine, slip: SlipName, *about: Expression) -> Repair:
    return Repair(slip, {id(line.root): line.expected}, about or (line.root,))


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


def _of_a_sum(line: TypedLine) -> Repair | None:
    """The term of a sum that has the wrong sign, is one too many, or is missing."""
    if len(signed_terms(line.root)) + len(signed_terms(line.expected)) == 2:
        return None
    term = term_with_wrong_sign(line)
    if term is not None:
        return _at_root(line, "sign", term)
    typed, expected = terms_of_one_side(line)
    if typed and not expected:
        return _at_root(line, "surplus term", typed[0][1])
    if expected and not typed:
        return _at_root(line, "missing term")
    wrong = wrong_blades(line)
    if len(signed_terms(line.root)) > 1 and wrong and not wrong & _blades(line, line.root):
        return _at_root(line, "missing term")
    return None


def _unfinished(line: TypedLine) -> Repair | None:
    """A line that is a part of the expected one."""
    typed = text_of(line.root)
    for outer in all_parts(line.expected) if line.is_whole else ():
        for part in operands_of(outer):
            if text_of(part) == typed:
                is_product = isinstance(outer, Operation) and outer.operator in "*/"
                return _at_root(line, "missing factor" if is_product else "unfinished")
    return None


def _rounded(line: TypedLine) -> Repair | None:
    """The first number with digits after the point, if the line is nearly right."""
    written = [part for part in line.parts if isinstance(part, Literal) and 100 * part.value % 1 != 0]
    for sample in line.samples if written else ():
        pair = same_blades(sample.values[id(line.root)], sample.values[id(line.expected)])
        if pair is None or abs(pair[0] - pair[1]).max() > NEARLY * abs(pair[1]).max():
            return None
    return _at_root(line, "rounded", written[0]) if written else None


def _other_kind(line: TypedLine) -> Repair | None:
    typed, expected = (line.samples[0].values[id(part)] for part in (line.root, line.expected))
    if same_blades(typed, expected) is not None and kind_of(typed) == kind_of(expected):
        return None
    if {kind_of(typed).name, kind_of(expected).name} <= {"motor", "even"}:
        return None
    return _at_root(line, "kind")


def _wrong_coefficient(line: TypedLine) -> Repair | None:
    """The first term of a sum with a blade whose coefficient is wrong."""
    wrong = wrong_blades(line)
    terms = [term for _, term in signed_terms(line.root)]
    if len(terms) > 1 and not wrong >= _blades(line, line.expected):
        for term in terms:
            if wrong & _blades(line, term):
                return _at_root(line, "coefficient", term)
    return None


def wrong_blades(line: TypedLine) -> set[str]:
    """The names of the blades whose coefficients differ from what is expected."""
    found: set[str] = set()
    for sample in line.samples:
        typed, expected = sample.values[id(line.root)], sample.values[id(line.expected)]
        if isinstance(typed, Multivector) or isinstance(expected, Multivector):
            if same_blades(typed, expected) is None:
                return set()
            found |= {unit for number, unit in value_terms(typed - expected) if abs(number) > NOISE}
    return found


def _blades(line: TypedLine, part: Expression) -> set[str]:
    return {unit for sample in line.samples for _, unit in value_terms(sample.values[id(part)])}
