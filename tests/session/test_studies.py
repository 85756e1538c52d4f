"""Studies that people run: however a run ends, the panel says so, and another one may begin."""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Callable, Coroutine, Iterator
from typing import Any

import pytest

from helicoide import studies as all_studies
from helicoide.jobs.process import ProcessJob, Report
from helicoide.seat import Seat
from helicoide.session import studies
from helicoide.session.seats import Place
from helicoide.session.studies import FAILED, Studies
from helicoide.studies import panel_state
from helicoide.studies.panel_state import StudyPanelState

NAME = "cerbaro_orca_convergence"
PATIENCE = 300.0


def endless(report: Report, name: str, options: Any, short: bool) -> object:
    report(0.5)
    time.sleep(10 * PATIENCE)
    return None


def breaks(report: Report, name: str, options: Any, short: bool) -> object:
    report(0.5)
    raise ValueError("no such study")


class Torn(ProcessJob):
    """A run whose pipe breaks in the middle of a message."""

    def reports(self) -> Iterator[Any]:
        yield 0.5
        raise OSError("got end of file during message")


class Unstarted(ProcessJob):
    """A run for which the system has no process left."""

    def reports(self) -> Iterator[Any]:
        raise OSError("Cannot allocate memory")


@pytest.fixture
def running(monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Runs are of this work instead of a study."""
    return lambda work: monkeypatch.setattr(studies, "study", work)


class Person:
    """A person with a panel, and what they see there."""

    def __init__(self) -> None:
        self.studies = Studies(lambda: None)
        self.place = Place(Seat("token", "en"))

    @property
    def panel(self) -> StudyPanelState:
        return self.place.study_panel

    def begin(self) -> None:
        self.studies.change(self.place, panel_state.with_study(NAME))
        self.studies.change(self.place, panel_state.with_run_started)
        assert self.panel.progress == 0

    async def until(self, condition: Callable[[], object]) -> None:
        while not condition():
            await asyncio.sleep(0.01)

    async def killed(self) -> None:
        """Kill the process of what runs, as soon as there is one."""
        job = self.studies._running[self.place]
        await self.until(lambda: job._child is not None and job._child.pid is not None)
        job._child.kill()

    async def over(self) -> None:
        """Wait until what runs is not followed any more."""
        await self.until(lambda: not self.studies._tasks)


def live(run: Callable[[Person], Coroutine[object, object, None]]) -> Person:
    """Let something run, generously: what is slow is not wrong, what never comes must end."""
    person = Person()

    async def patient() -> None:
        try:
            await asyncio.wait_for(run(person), PATIENCE)
        finally:
            person.studies.close()

    asyncio.run(patient())
    return person


def is_free(person: Person) -> bool:
    """Whether nothing runs and nothing seems to."""
    return person.panel.progress is None and not person.studies._running


def test_a_study_comes_to_its_result() -> None:
    async def run(person: Person) -> None:
        person.begin()
        await person.over()

    person = live(run)
    assert person.panel.failure is None
    assert person.panel.last is not None
    assert person.panel.last.study == NAME
    assert len(person.panel.last.result.rows) == len(
        all_studies.study_named(NAME).run(person.panel.last.options, True, lambda share: None).rows
    )
    assert is_free(person)


def test_a_killed_process_is_said_and_another_run_may_begin(
    running: Callable[..., None], caplog: pytest.LogCaptureFixture
) -> None:
    running(endless)

    async def run(person: Person) -> None:
        for _ in range(studies.MOST + 1):
            person.begin()
            await person.until(lambda: person.panel.progress == 0.5)
            await person.killed()
            await person.over()
            assert person.panel.failure == FAILED
            assert is_free(person)

    live(run)
    assert "ended from outside" in caplog.text
    assert NAME in caplog.text


def test_a_process_that_is_killed_before_it_says_anything_is_said(running: Callable[..., None]) -> None:
    running(endless)

    async def run(person: Person) -> None:
        person.begin()
        await person.killed()
        await person.over()

    person = live(run)
    assert person.panel.failure == FAILED
    assert is_free(person)


@pytest.mark.parametrize(
    ("way", "words"), [(Torn, "end of file during message"), (Unstarted, "Cannot allocate memory")]
)
def test_a_pipe_that_breaks_and_a_process_that_does_not_start_are_said(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, way: type[ProcessJob], words: str
) -> None:
    monkeypatch.setattr(studies, "ProcessJob", way)

    async def run(person: Person) -> None:
        person.begin()
        await person.over()

    person = live(run)
    assert person.panel.failure == FAILED
    assert is_free(person)
    assert words in caplog.text


def test_a_study_that_breaks_is_said_with_its_traceback_in_the_log(
    running: Callable[..., None], caplog: pytest.LogCaptureFixture
) -> None:
    running(breaks)

    async def run(person: Person) -> None:
        person.begin()
        await person.over()

    person = live(run)
    assert person.panel.failure == FAILED
    assert is_free(person)
    assert "no such study" in caplog.text


@pytest.mark.parametrize(
    "end",
    [
        lambda person: person.studies.change(person.place, panel_state.with_run_ended),
        lambda person: person.studies.change(person.place, panel_state.with_study("")),
        lambda person: person.studies.forget(person.place),
        lambda person: person.studies.close(),
    ],
    ids=["end", "another study", "the last window closes", "the program ends"],
)
def test_what_is_ended_on_purpose_has_not_failed(
    running: Callable[..., None], caplog: pytest.LogCaptureFixture, end: Callable[[Person], None]
) -> None:
    running(endless)

    async def run(person: Person) -> None:
        person.begin()
        await person.until(lambda: person.panel.progress == 0.5)
        end(person)
        await person.over()

    with caplog.at_level(logging.WARNING):
        person = live(run)
    assert person.panel.failure is None
    assert caplog.records == []
    assert not person.studies._running
