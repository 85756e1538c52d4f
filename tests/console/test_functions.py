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


def test_the_functions_that_a_course_needs_are_there() -> None:
    assert all_functions().keys() >= WANTED
