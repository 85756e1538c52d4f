"""One piece of work in a process of its own: what it reports, returns and fails with, and that it can be ended."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from helicoide.jobs.apart import Apart, Failed, Report


def counts(report: Report, upto: int) -> int:
    for k in range(upto):
        report(k)
    return 10 * upto


def fails(report: Report) -> None:
    report("before")
    raise ValueError("no such thing")


def waits(report: Report, file: str) -> None:
    report("begun")
    time.sleep(600)
    Path(file).write_text("too late")


def test_reports_come_in_order_and_the_result_at_the_end() -> None:
    job = Apart(counts, 5)
    assert list(job.progress()) == [0, 1, 2, 3, 4]
    assert job.result == 50


def test_a_failure_comes_with_its_traceback() -> None:
    job = Apart(fails)
    reports = []
    with pytest.raises(Failed, match="no such thing"):
        reports.extend(job.progress())
    assert job.result is None


def test_work_is_ended_where_it_is(tmp_path: Path) -> None:
    job = Apart(waits, str(tmp_path / "done"))
    for said in job.progress():
        assert said == "begun"
        job.stop()
    assert job.result is None
    assert not (tmp_path / "done").exists()


def test_what_was_ended_before_it_began_ends_at_once(tmp_path: Path) -> None:
    job = Apart(waits, str(tmp_path / "done"))
    job.stop()
    assert list(job.progress()) in ([], ["begun"])
    assert job.result is None
