"""Shares are told when they moved or some time has passed; counts and words are told one by one."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from helicoide.jobs.parallel import Progress, run_parallel, run_timed
from helicoide.jobs.process import ProcessJob, Report
from helicoide.jobs.throttle import MAX_PERIOD, MIN_STEP, throttled


class Listener:
    """What was told, and when, by a clock that is put on by hand."""

    def __init__(self) -> None:
        self.now, self.heard = 0.0, list[tuple[float, Any]]()
        self.tell = throttled(lambda what: self.heard.append((self.now, what)), lambda: self.now)

    def reported(self, shares: Any, period: float) -> list[Any]:
        """What is told of shares that come one every period, s."""
        for share in shares:
            self.tell(share)
            self.now += period
        return [what for _, what in self.heard]


def test_fast_work_is_told_by_its_steps() -> None:
    count = 22_000  # ten seconds of 2,200 reports
    listener = Listener()
    told = listener.reported((np.arange(count) + 1) / count, 1 / 2200)
    assert len(told) <= 1 / MIN_STEP + 10 / MAX_PERIOD
    assert told[-1] == 1
    assert all(later - earlier >= 0.999 * MIN_STEP for earlier, later in pairwise(told[:-1]))


def test_slow_work_is_told_now_and_then() -> None:
    listener = Listener()
    listener.reported(np.linspace(0, MIN_STEP / 2, 1000), 0.01)
    times = [when for when, _ in listener.heard]
    assert len(times) == pytest.approx(1000 * 0.01 / MAX_PERIOD, abs=2)
    assert all(later - earlier > 0.999 * MAX_PERIOD for earlier, later in pairwise(times))


def test_the_end_is_told_once_however_near_it_was() -> None:
    assert Listener().reported([0.999, 0.9995, 1.0, 1.0, 1.0], 0.0) == [0.999, 1.0]


def test_a_share_that_goes_back_is_told() -> None:
    assert Listener().reported([0.5, 0.2, 0.205, 0.5], 0.0) == [0.5, 0.2, 0.5]


def test_counts_and_words_are_told_one_by_one() -> None:
    assert Listener().reported([1, 1, 2, "begun", "begun", 0, 1], 0.0) == [1, 1, 2, "begun", "begun", 0, 1]


def chatters(report: Report) -> str:
    for k in range(20_000):
        report((k + 1) / 20_000)
    return "done"


def chatters_of(given: int, progress: Progress) -> str:
    return chatters(progress)


def test_a_process_sends_few_of_its_reports() -> None:
    job = ProcessJob(chatters)
    heard = list(job.reports())
    assert job.result == "done"
    assert heard[-1] == 1.0
    assert len(heard) < 1000


def test_work_done_here_tells_few_of_its_reports() -> None:
    heard: list[float] = []
    assert run_timed(chatters_of, 0, heard.append).value == "done"
    assert heard[-1] == 1.0
    assert len(heard) < 1000


def test_several_processes_send_few_of_their_reports(monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[float] = []
    assert [outcome.value for outcome in run_parallel(chatters_of, [1, 2], 2, heard.append)] == ["done", "done"]
    assert heard[-1] == 1.0
    assert len(heard) < 1000
