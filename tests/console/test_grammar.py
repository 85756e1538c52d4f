"""The grammar: how strong the operators bind, what a line may be, and errors that point at their character."""

from __future__ import annotations

import numpy as np
import pytest
from tests.console.lines import numbers, results, value

from helicoide.console import pointer
from helicoide.console.evaluate import MOST_WORK
from helicoide.console.syntax import DEEPEST
from helicoide.sheet import LONGEST_LINE


@pytest.mark.parametrize(
    ("line", "bracketed"),
    [
        ("1 + 2*3", "1 + (2*3)"),
        ("2*3**2", "2*(3**2)"),
        ("-2**2", "-(2**2)"),
        ("2**3**2", "2**(3**2)"),
        ("8/4/2", "(8/4)/2"),
        ("8 - 4 - 2", "(8 - 4) - 2"),
        ("2**-1", "2**(-1)"),
        ("2*e1 ^ e2 + e3", "(2*(e1 ^ e2)) + e3"),
        ("e1*e2 | e12", "e1*(e2 | e12)"),
        ("e1e2e3 & e1e2e * 2", "(e1e2e3 & e1e2e)*2"),
        ("rotor(0,0,1,1) * rotor(1,0,0,1) >> e1 + e2", "((rotor(0,0,1,1)*rotor(1,0,0,1)) >> e1) + e2"),
        ("rotor(0,0,1,1) >> rotor(1,0,0,1) >> e2", "(rotor(0,0,1,1)*rotor(1,0,0,1)) >> e2"),
        ("~rotor(0,0,1,1)**2", "~(rotor(0,0,1,1)**2)"),
        ("-~e12", "-(~e12)"),
        ("2e+1 + .5 + 3.", "20 + 0.5 + 3"),
        ("e31", "-e13"),
        ("e01", "-e1e"),
        ("e3e1e", "e3*e1*e"),
        ("e0123", "e*e1*e2*e3"),
        ("i*j", "k"),
        ("~(1 + 2*i)", "1 - 2*i"),
    ],
)
def test_operators_bind_as_the_grammar_says(line: str, bracketed: str) -> None:
    np.testing.assert_allclose(numbers(line), numbers(bracketed), atol=1e-14)


def test_a_definition_serves_the_lines_below_it() -> None:
    assert value("a = 2", "b = a + 1  # a comment", "a*b") == 6


def test_a_name_can_be_given_a_new_value() -> None:
    assert value("a = 2", "a = a + 1", "a") == 3


@pytest.mark.parametrize("line", ["", "   ", "# a comment", "\t# e1 +"])
def test_a_comment_has_no_result(line: str) -> None:
    (result,) = results(line)
    assert (result.name, result.value, result.error) == (None, None, None)


@pytest.mark.parametrize(
    ("line", "start", "says"),
    [
        ("1 + ", 3, "a number"),
        ("a b", 2, "an operator"),
        ("2e12", 1, "2*e12"),
        ("point(1, 2", 10, "“)”"),
        ("point(1; 2)", 7, "type ,"),
        ("x − 1", 2, "type -"),
        ("a.b", 1, "letters"),
        ("[1]", 0, "type ("),
        ("1 + jion(e1, e2)", 4, "join"),
        ("distanse(1)", 0, "distance"),
        ("2 * distance(e12, 1)", 4, "argument 2"),
        ("point(1, 2)", 0, "point(x, y, z)"),
        ("e1 + e11", 5, "e0123"),
        ("2 ^ 3", 2, "**"),
        ("i*e1", 1, "rotate"),
        ("sin", 0, "sin(x)"),
        ("1/(1 - 1)", 1, "zero"),
        ("pi = 3", 0, "constant"),
        ("e12 = 3", 0, "blade"),
        ("join = 3", 0, "function"),
        ("1 + M_tol", 4, "M_tol"),
        ("inverse(e)", 0, "inverse"),
        ("e12**0.5", 3, "exp(s*log(M))"),
        ("i ^ j", 2, "quaternions"),
        ("modern(e1) + e1", 11, "sources"),
    ],
)
def test_an_error_points_at_its_character_and_says_what_is_valid(line: str, start: int, says: str) -> None:
    (result,) = results(line)
    assert result.error is not None
    assert result.error.start == start
    assert says in result.error.text.en
    assert result.error.text.en.startswith(f"character {start + 1}: ")
    assert result.error.text.pt_BR.startswith(f"caractere {start + 1}: ")
    above, below = pointer(line, result.error).splitlines()
    assert above == line
    assert below.index("^") == start


def test_an_error_stops_only_the_lines_that_need_it() -> None:
    wrong, fine, needs = results("a = 1/0", "b = 2", "c = a + b")
    assert wrong.error is not None
    assert fine.value == 2
    assert needs.error is not None


def test_a_name_that_is_defined_further_down_is_no_slider() -> None:
    first, second = results("a + 1", "a = 2")
    assert first.error is not None
    assert "line 2" in first.error.text.en
    assert second.value == 2


def test_a_wrong_definition_of_a_blade_leaves_the_lines_above_it_as_they_are() -> None:
    first, second = results("e1 + pi", "e1 = 2")
    assert first.value is not None
    assert second.error is not None


@pytest.mark.parametrize("opening", ["-", "~", "1+(", "sin(", "1**", "-("])
def test_nesting_is_bounded(opening: str) -> None:
    closing = ")" * opening.count("(")
    deep = min(DEEPEST + 1, (LONGEST_LINE - 1) // len(opening + closing))
    shallow = DEEPEST // 2 - 1
    assert results(opening * shallow + "0" + closing * shallow)[0].value is not None
    if deep > DEEPEST:
        assert results(opening * deep + "0" + closing * deep)[0].error is not None


def test_a_line_is_bounded() -> None:
    assert value("1" + " " * (LONGEST_LINE - 1)) == 1


def test_the_work_of_a_sheet_is_bounded_whatever_its_lines() -> None:
    lines = ["rotor(0,0,1,1)**32" for _ in range(MOST_WORK // 32 + 5)]
    found = results(*lines)
    assert found[0].error is None
    assert found[-1].error is not None
    assert str(MOST_WORK) in found[-1].error.text.en
