"""What can be said of a line that no single repair makes right: by its terms, its coefficients, and its kind."""

from __future__ import annotations

from helicoide.console import kind_of, value_terms
from helicoide.console.kinds import NOISE
from helicoide.console.syntax import Expression, Literal, Operation, operands_of
from helicoide.geometry.multivector import Multivector
from helicoide.lines.equality import same_blades
from helicoide.lines.repair import Repair
from helicoide.lines.slips import SlipName
from helicoide.lines.terms import signed_terms, term_with_wrong_sign, terms_of_one_side
from helicoide.lines.tree import all_parts, text_of
from helicoide.lines.typed_line import TypedLine

NEARLY = 5e-3  # of the largest coefficient, by which a rounded number may be wrong


def whole_replaced(line: TypedLine, slip: SlipName, *about: Expression) -> Repair:
    """The whole line replaced by the expected one. about: the parts that are wrong, if not all of it."""
    return Repair(slip, {id(line.root): line.expected}, about or (line.root,))


def wrong_term_of_a_sum(line: TypedLine) -> Repair | None:
    """The term of a sum that has the wrong sign, is one too many, or is missing."""
    if len(signed_terms(line.root)) + len(signed_terms(line.expected)) == 2:
        return None
    term = term_with_wrong_sign(line)
    if term is not None:
        return whole_replaced(line, "sign", term)
    typed, expected = terms_of_one_side(line)
    if typed and not expected:
        return whole_replaced(line, "surplus term", typed[0][1])
    if expected and not typed:
        return whole_replaced(line, "missing term")
    wrong = wrong_blades(line)
    if len(signed_terms(line.root)) > 1 and wrong and not wrong & _blades(line, line.root):
        return whole_replaced(line, "missing term")
    return None


def unfinished_line(line: TypedLine) -> Repair | None:
    """A line that is a part of the expected one."""
    typed = text_of(line.root)
    for outer in all_parts(line.expected) if line.is_whole else ():
        for part in operands_of(outer):
            if text_of(part) == typed:
                is_product = isinstance(outer, Operation) and outer.operator in "*/"
                return whole_replaced(line, "missing factor" if is_product else "unfinished")
    return None


def rounded_number(line: TypedLine) -> Repair | None:
    """The first number with digits after the point, if the line is nearly right."""
    written = [part for part in line.parts if isinstance(part, Literal) and 100 * part.value % 1 != 0]
    for sample in line.samples if written else ():
        pair = same_blades(sample.values[id(line.root)], sample.values[id(line.expected)])
        if pair is None or abs(pair[0] - pair[1]).max() > NEARLY * abs(pair[1]).max():
            return None
    return whole_replaced(line, "rounded", written[0]) if written else None


def other_kind(line: TypedLine) -> Repair | None:
    """A line that is another kind of thing, such as a number where a motor is expected."""
    typed, expected = (line.samples[0].values[id(part)] for part in (line.root, line.expected))
    if same_blades(typed, expected) is not None and kind_of(typed) == kind_of(expected):
        return None
    if {kind_of(typed).name, kind_of(expected).name} <= {"motor", "even"}:
        return None
    return whole_replaced(line, "kind")


def wrong_coefficient(line: TypedLine) -> Repair | None:
    """The first term of a sum with a blade whose coefficient is wrong."""
    wrong = wrong_blades(line)
    terms = [term for _, term in signed_terms(line.root)]
    if len(terms) > 1 and not wrong >= _blades(line, line.expected):
        for term in terms:
            if wrong & _blades(line, term):
                return whole_replaced(line, "coefficient", term)
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
