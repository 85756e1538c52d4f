"""Work in processes: order, progress, failures, and a process that dies."""

from __future__ import annotations

import os
import time
from itertools import pairwise
from pathlib import Path

import pytest

from helicoide.jobs.parallel import Progress, run_parallel, run_timed
from helicoide.text import HelicoideError, untranslated


def doubled(given: int, progress: Progress) -> int:
    for step in range(10):
        progress((step + 1) / 10)
    return 2 * given


def waiting_for_the_second(given: tuple[int, Path], progress: Progress) -> tuple[int, int]:
    """The first piece ends only after another has begun, which another process must have taken."""
    number, begun = given
    while number == 0 and not begun.exists():
        time.sleep(0.01)
    begun.touch()
    return number, os.getpid()


def refusing(given: int, progress: Progress) -> int:
    if given == 1:
        raise HelicoideError(untranslated("not one"))
    return given


class Stubborn(Exception):
    """An error that can be pickled and not be read again."""

    def __init__(self, first: str, second: str) -> None:
        super().__init__(first + second)


def stubborn(given: int, progress: Progress) -> int:
    raise Stubborn("no ", "way")


def dying(given: int, progress: Progress) -> int:
    os._exit(3)


def nothing(share: float) -> None:
    pass


def test_values_come_in_the_order_of_what_was_given(tmp_path: Path) -> None:
    given = [(number, tmp_path / "begun") for number in range(4)]
    found = [outcome.value for outcome in run_parallel(waiting_for_the_second, given, 2, nothing)]
    assert [value[0] for value in found if value] == [0, 1, 2, 3]
    processes = {value[1] for value in found if value}
    assert len(processes) == 2
    assert os.getpid() not in processes


def test_progress_is_that_of_the_whole() -> None:
    shares: list[float] = []
    outcomes = run_parallel(doubled, [1, 2, 3], 1, shares.append)
    assert [outcome.value for outcome in outcomes] == [2, 4, 6]
    assert shares[-1] == 1.0
    assert all(0 <= a <= b <= 1 for a, b in pairwise(shares))
    assert run_parallel(doubled, [], 1, nothing) == []


def test_a_failure_is_an_outcome_and_keeps_its_words() -> None:
    outcomes = run_parallel(refusing, [0, 1, 2], 2, nothing)
    assert [outcome.value for outcome in outcomes] == [0, None, 2]
    assert isinstance(outcomes[1].failure, HelicoideError)
    assert outcomes[1].failure.text == untranslated("not one")


def test_an_error_that_does_not_come_through_leaves_its_words() -> None:
    [outcome] = run_parallel(stubborn, [1], 1, nothing)
    assert str(outcome.failure) == "Stubborn: no way"


def test_a_process_that_dies_is_a_failure_too() -> None:
    [outcome] = run_parallel(dying, [1], 1, nothing)
    assert outcome.value is None
    assert "process" in str(outcome.failure).lower()


@pytest.mark.parametrize(("given", "value"), [(0, 0), (1, None)])
def test_the_same_work_can_be_done_here(given: int, value: int | None) -> None:
    outcome = run_timed(refusing, given, nothing)
    assert outcome.value == value
    assert (outcome.failure is None) == (value is not None)
    assert outcome.seconds >= 0
