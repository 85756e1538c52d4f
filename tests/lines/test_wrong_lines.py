"""Recorded wrong lines: the slip and the first wrong term are named."""

from __future__ import annotations

from collections import Counter

import pytest
from tests.lines.exercises import EXERCISES
from tests.lines.recorded import WrongLine, wrong_lines

from helicoide.lines import LINE_KINDS, SLIPS, SlipName, WrongTerm, check_line
from helicoide.lines.slips import words_of
from helicoide.text import LANGUAGES

NAMED = 0.95
# What a teacher would say of a line, where the checker says something else.
MISSED = {
    "(w - x*i - y*j - z*k)/(w**2 + x**2 + y**2)",
    "g + 0.5*e*t*g",
    "a1*sin(q1)*a2*sin(q1+q2)",
    "a1*cos(q1) + a2*cos(q1)*cos(q2)",
    "w1*e12 + w2*(screw(e12, q1)*e31)",
    "(xd - x) + (yd - y)",
}


def is_named(line: WrongLine) -> bool:
    verdict = check_line(EXERCISES[line.exercise], line.text)
    assert isinstance(verdict, WrongTerm), line
    named = line.text[verdict.span.start : verdict.span.end]
    return (verdict.slip, named) == (line.slip, line.term)


@pytest.fixture(scope="module")
def missed() -> set[str]:
    return {line.text for line in wrong_lines() if not is_named(line)}


def test_there_are_enough_lines_of_each_kind() -> None:
    kinds = Counter(EXERCISES[line.exercise].kind for line in wrong_lines())
    assert kinds.keys() == LINE_KINDS.keys()
    assert min(kinds.values()) >= 40
    assert kinds.total() >= 200


def test_the_first_wrong_term_is_named(missed: set[str]) -> None:
    assert len(missed) <= (1 - NAMED) * len(wrong_lines())


def test_those_that_are_not_named_are_known(missed: set[str]) -> None:
    assert missed == MISSED


def test_each_slip_occurs_in_a_recorded_line() -> None:
    assert SLIPS.keys() - {line.slip for line in wrong_lines()} <= {"coefficient", "rounded"}


@pytest.mark.parametrize("slip", SLIPS)
def test_the_words_of_a_slip_quote_the_term_and_ask_a_question_in_both_languages(slip: SlipName) -> None:
    for kind in LINE_KINDS:
        words = words_of(slip, kind)
        assert words.en != words.pt_BR
        assert all("“{part}”" in words[language] for language in LANGUAGES)
