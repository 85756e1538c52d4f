"""Each function of the console: described in both languages, with an example that gives what it says."""

from __future__ import annotations

import numpy as np
import pytest
from tests.console.lines import numbers, results

from helicoide.console import all_functions
from helicoide.console.functions import ConsoleFunction

WANTED = {
    "point", "line", "plane", "join", "meet", "distance", "angle", "exp", "log", "conj", "reverse", "inverse", "norm",
    "grade", "dual", "motor", "translator", "rotor", "rotate", "screw", "slerp", "sclerp", "project", "sin", "cos",
    "tan", "sqrt", "atan2", "abs",
}  # fmt: skip


@pytest.mark.parametrize("function", all_functions().values(), ids=lambda function: function.name)
def test_an_example_gives_what_it_says(function: ConsoleFunction) -> None:
    example = function.example
    assert function.name in example.expression
    np.testing.assert_allclose(numbers(example.expression), numbers(example.equals), rtol=0, atol=1e-12)


@pytest.mark.parametrize("function", all_functions().values(), ids=lambda function: function.name)
def test_a_function_is_described_and_says_so_when_it_is_called_wrongly(function: ConsoleFunction) -> None:
    assert function.about.en
    assert function.about.pt_BR
    assert function.about.en != function.about.pt_BR
    (result,) = results(f"{function.name}()")
    assert result.error is not None
    assert function.signature in result.error.text.en
    assert function.signature in result.error.text.pt_BR


def test_parallel_planes_have_a_distance_whatever_the_rounding_of_their_normals() -> None:
    lines = ("M = rotor(1,2,3,0.7)*translator(0.1,0.2,0.3)", "distance(M >> plane(0,0,1,0.5), M >> plane(0,0,1,2))")
    np.testing.assert_allclose(numbers(*lines), 1.5, atol=1e-12)
    np.testing.assert_allclose(numbers("distance(plane(1,2,3,0), plane(0.1,0.2,0.3,1))"), 1, atol=1e-12)
    for second in ("plane(1,0,0,1)", "plane(0,0.01,1,0.5)"):
        (result,) = results(f"distance(plane(0,0,1,0), {second})")
        assert result.error is not None
        assert "angle(A, B)" in result.error.text.en


def test_the_exponential_of_a_quaternion_with_a_real_part() -> None:
    """Rounding may leave a real part, as in the rotated vector g k g*: no reason to refuse it."""
    np.testing.assert_allclose(numbers("exp(0.5 + pi/3*k)"), numbers("exp(0.5)*exp(pi/3*k)"), rtol=1e-14)
    assert results("exp(1e+9 + k)")[0].error is not None


def test_what_is_too_large_has_no_unit_size() -> None:
    assert results("unit(1e+200*e1)")[0].error is not None


def test_the_functions_that_a_course_needs_are_there() -> None:
    assert all_functions().keys() >= WANTED
