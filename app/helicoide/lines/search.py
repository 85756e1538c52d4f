"""The first wrong term of a line: by a repair that makes it right; otherwise term by term and factor by factor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from helicoide.console import kind_of, value_terms
from helicoide.console.evaluate import Budget
from helicoide.console.kinds import NOISE
from helicoide.console.syntax import Expression, Literal
from helicoide.geometry.multivector import Multivector
from helicoide.lines import repairs_of_names as names
from helicoide.lines import repairs_of_numbers as numbers
from helicoide.lines import repairs_of_order as order
from helicoide.lines import repairs_of_parts as parts
from helicoide.lines.equality import same_blades
from helicoide.lines.repair import Repair, Repairs
from helicoide.lines.terms import first_different, signed_terms
from helicoide.lines.tree import replaced
from helicoide.lines.typed_line import TypedLine
from helicoide.text import HelicoideError

# The first that makes a line right names its slip, so those of a narrow meaning stand before the general ones.
REPAIRS: tuple[Repairs, ...] = (
    order.blade_order, order.passive, order.factor_order, order.operand_order, order.argument_order, names.join_or_meet,
    numbers.sine_or_cosine, numbers.half, names.conjugate_too_many, numbers.sign, numbers.moment_sign, names.conjugate,
    names.axis, names.name, numbers.unit, names.operator, numbers.power, names.function, parts.surplus, parts.missing,
    names.blade, parts.other_part,
)  # fmt: skip
MOST_TRIED = 1_500  # repairs; each takes about 50 µs
NEARLY = 5e-3  # of the largest coefficient, by which a rounded number may be wrong


@dataclass
class Attempts:
    """How many repairs may still be tried."""

    left: int = MOST_TRIED


def first_wrong(line: TypedLine, attempts: Attempts) -> Repair:
    """What is wrong in a line that differs from what is expected."""
    found = _rounded(line) or _repaired(line, attempts)
    if found is not None:
        return found
    inner = first_different(line)
    if inner is not None and inner.root is not line.root:
        return first_wrong(inner, attempts)
    return _other_kind(line) or _wrong_coefficient(line) or Repair("line", {id(line.root): line.expected}, (line.root,))


def _repaired(line: TypedLine, attempts: Attempts) -> Repair | None:
    for repair in _all_repairs(line):
        attempts.left -= 1
        if attempts.left < 0:
            return None
        if _makes_right(line, repair):
            return repair
    return None


def _all_repairs(line: TypedLine) -> Iterator[Repair]:
    for repairs in REPAIRS:
        yield from repairs(line)


def _makes_right(line: TypedLine, repair: Repair) -> bool:
    root, budget = replaced(line.root, repair.changes), Budget()
    try:
        return all(
            line.rule.equal(sample.value_of(root, budget), sample.values[id(line.expected)]) for sample in line.samples
        )
    except HelicoideError:
        return False


def _rounded(line: TypedLine) -> Repair | None:
    """The first number with digits after the point, if the line is nearly right."""
    written = [part for part in line.parts if isinstance(part, Literal) and 100 * part.value % 1 != 0]
    for sample in line.samples if written else ():
        pair = same_blades(sample.values[id(line.root)], sample.values[id(line.expected)])
        if pair is None or abs(pair[0] - pair[1]).max() > NEARLY * abs(pair[1]).max():
            return None
    return Repair("rounded", {id(line.root): line.expected}, (written[0],)) if written else None


def _other_kind(line: TypedLine) -> Repair | None:
    typed, expected = (line.samples[0].values[id(part)] for part in (line.root, line.expected))
    if same_blades(typed, expected) is not None and kind_of(typed) == kind_of(expected):
        return None
    if {kind_of(typed).name, kind_of(expected).name} <= {"motor", "even", "multivector", "screw", "line", "zero"}:
        return None
    return Repair("kind", {id(line.root): line.expected}, (line.root,))


def _wrong_coefficient(line: TypedLine) -> Repair | None:
    """The first term of a sum with a blade whose coefficient is wrong."""
    wrong = wrong_blades(line)
    terms = [term for _, term in signed_terms(line.root)]
    for term in terms if len(terms) > 1 else ():
        if wrong & _blades(line, term):
            return Repair("coefficient", {id(line.root): line.expected}, (term,))
    if wrong and not wrong & _blades(line, line.root):
        return Repair("missing term", {id(line.root): line.expected}, (line.root,))
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
