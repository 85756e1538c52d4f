"""Whatever is typed: a verdict of ours, at characters of the line, within the bounds of the search."""

from __future__ import annotations

import random

import pytest
from tests.console.lines import HOSTILE, fuzzed
from tests.lines.exercises import exercise

from helicoide.console.evaluate import MOST_WORK as MOST_OF_A_SHEET
from helicoide.console.evaluate import Budget
from helicoide.lines import LineExercise, Refused, WrongTerm, check_line
from helicoide.lines.samples import COUNT as SAMPLES
from helicoide.lines.search import MOST_WORK

COUNT = 1_000
NAMES = "angle: a theta; motor: M_tool; line: L1 L9; rotation: q_tool; point: elbow target; plane: ceiling"
TASKS = (
    exercise("motor", NAMES, "screw(L1, theta)*M_tool"),
    exercise("jacobian", NAMES, "a*cos(theta)"),
    exercise("incidence", NAMES, "meet(join(elbow, target), ceiling)"),
    exercise("quaternion product", NAMES, "q_tool*(cos(a/2) + sin(a/2)*k)"),
)


def answered(task: LineExercise, line: str) -> bool:
    """Check a line; returns whether it has a value."""
    verdict = check_line(task, line)
    if isinstance(verdict, Refused):
        assert 0 <= verdict.error.start < verdict.error.end <= len(line) + 40
        return False
    if isinstance(verdict, WrongTerm):
        assert 0 <= verdict.span.start < verdict.span.end <= len(line)
        assert verdict.title.en
        assert verdict.title.pt_BR
        assert verdict.expected
    return True


def test_generated_lines_get_a_verdict_within_the_bounds(monkeypatch: pytest.MonkeyPatch) -> None:
    spent: list[int] = []
    spend = Budget.spend

    def counted(budget: Budget, work: int) -> None:
        spend(budget, work)
        spent.append(work)

    monkeypatch.setattr(Budget, "spend", counted)
    source, given = random.Random(2026), 0
    for n in range(COUNT):
        spent.clear()
        given += answered(TASKS[n % len(TASKS)], fuzzed(source))
        assert sum(spent) <= MOST_WORK + (SAMPLES + 2) * MOST_OF_A_SHEET
    assert given > COUNT / 10


@pytest.mark.parametrize("line", HOSTILE)
def test_hostile_lines_get_a_verdict(line: str) -> None:
    for task in TASKS:
        answered(task, line)
