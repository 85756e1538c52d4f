"""Whatever is typed: no error but ours, nothing beyond the bounds, and values of the console alone."""

from __future__ import annotations

import random

import pytest
from tests.console.lines import HOSTILE, fuzzed

from helicoide.console import kind_of, sheet_results, value_latex, value_text
from helicoide.console.evaluate import MOST_WORK, Budget
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS
from helicoide.geometry.multivector import Multivector
from helicoide.sheet import LONGEST_LINE, Sheet, SheetLine
from helicoide.state import State
from helicoide.text import HelicoideError

COUNT = 5_000


@pytest.fixture
def spent(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The work of each step that is granted."""
    steps: list[int] = []
    spend = Budget.spend

    def counted(budget: Budget, work: int) -> None:
        spend(budget, work)
        steps.append(work)

    monkeypatch.setattr(Budget, "spend", counted)
    return steps


def check(line: str, state: State) -> bool:
    """Evaluate a line; returns whether it has a value, which is then finite and of the console."""
    try:
        sheet = Sheet((SheetLine(line),))
    except HelicoideError:
        assert len(line) > LONGEST_LINE
        return False
    (result,) = sheet_results(sheet, state)
    if result.error is not None:
        assert 0 <= result.error.start < result.error.end <= LONGEST_LINE + 40
        assert result.error.text.en
        assert result.error.text.pt_BR
    if result.value is None:
        return False
    assert kind_of(result.value).title.pt_BR
    assert type(result.value) in (float, Multivector)
    if isinstance(result.value, Multivector):
        assert result.value.algebra in (CL031, PGA, QUATERNIONS)
        assert abs(result.value.values).max() < float("inf")
    assert value_text(result.value)
    assert value_latex(result.value)
    return True


def test_generated_lines_give_values_or_our_errors_within_the_bounds(state: State, spent: list[int]) -> None:
    source, given = random.Random(2022), 0
    for _ in range(COUNT):
        spent.clear()
        given += check(fuzzed(source), state)
        assert sum(spent) <= MOST_WORK
    assert given > COUNT / 10


@pytest.mark.parametrize("line", [*HOSTILE, "sin(1e+200*M_tool)", "sin(1e+200*(e12 + e3e))", "distance(1e+300*L1, e1)"])
def test_hostile_lines_reach_nothing(line: str, state: State) -> None:
    check(line, state)
