"""One piece of work in a process of its own: what it reports, returns and fails with, and that it can be ended."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import psutil
import pytest
from tests.jobs.works import breaks_off, counts, fails, has_a_child_of_its_own, is_killed, returns_nothing, waits

from helicoide.jobs.process import JobFailed, JobKilled, ProcessJob, kill_processes

ROOT = Path(__file__).parents[2]


def test_reports_come_in_order_and_the_result_at_the_end() -> None:
    job = ProcessJob(counts, 5)
    assert list(job.reports()) == [0, 1, 2, 3, 4]
    assert job.result == 50


def test_a_failure_comes_with_its_traceback() -> None:
    job = ProcessJob(fails)
    reports = []
    with pytest.raises(JobFailed, match="no such thing"):
        reports.extend(job.reports())
    assert job.result is None


def test_work_is_ended_where_it_is(tmp_path: Path) -> None:
    job = ProcessJob(waits, str(tmp_path / "done"))
    for said in job.reports():
        assert said == 0
        job.stop()
    assert job.result is None
    assert not (tmp_path / "done").exists()


def test_what_was_ended_before_it_began_ends_at_once(tmp_path: Path) -> None:
    job = ProcessJob(waits, str(tmp_path / "done"))
    job.stop()
    assert list(job.reports()) in ([], [0])
    assert job.result is None


def test_work_that_returns_nothing_has_ended_well() -> None:
    job = ProcessJob(returns_nothing)
    assert list(job.reports()) == [0]
    assert job.result is None


def until_killed(job: ProcessJob, hear: Callable[[Any], object]) -> None:
    """Take up what is reported until the process is killed."""
    with pytest.raises(JobKilled, match="-9"):
        list(map(hear, job.reports()))


def test_a_process_that_is_killed_is_noticed_at_once_and_can_be_started_again(tmp_path: Path) -> None:
    job, heard = ProcessJob(is_killed, str(tmp_path / "lives"), 1), list[float]()
    until_killed(job, lambda report: heard.append(time.monotonic()))
    took = time.monotonic() - heard[-1]
    print(f"noticed after {took:.2f} s")
    assert took < 20
    assert list(job.reports()) == [1, 2]


def test_half_a_message_is_none() -> None:
    heard: list[Any] = []
    until_killed(ProcessJob(breaks_off), heard.append)
    assert heard == [0]


def test_a_process_is_missed_though_a_child_of_its_own_lives_on() -> None:
    others: list[int] = []
    until_killed(ProcessJob(has_a_child_of_its_own), others.append)
    (other,) = map(psutil.Process, others)
    assert other.is_running()
    other.kill()


def test_every_process_is_ended_together(tmp_path: Path) -> None:
    until_killed(ProcessJob(waits, str(tmp_path / "done")), lambda report: kill_processes())


ORPHANED = """
from helicoide.jobs.process import ProcessJob
from tests.jobs.works import waits

if __name__ == "__main__":
    job = ProcessJob(waits, "")
    for _ in job.reports():
        print(job._child.pid, flush=True)
"""


def test_work_ends_with_the_process_that_asked_for_it(tmp_path: Path) -> None:
    script = tmp_path / "orphaned.py"
    script.write_text(ORPHANED)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT / "app"), str(ROOT)])}
    with subprocess.Popen([sys.executable, str(script)], env=environment, stdout=subprocess.PIPE, text=True) as parent:
        assert parent.stdout is not None
        child = psutil.Process(int(parent.stdout.readline()))
        parent.kill()
    child.wait(20)
