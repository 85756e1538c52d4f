"""The studies that people run: a process for each run, its progress and its result posted to the desk of the person."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from typing import Any

from helicoide import studies
from helicoide.jobs.process import JobFailed, ProcessJob, Report, follow_job
from helicoide.session.seats import Place
from helicoide.studies import panel_state as desks
from helicoide.studies.panel_state import CompletedRun, StudyPanelState, StudyPanelUpdate
from helicoide.text import HelicoideError, Text

BUSY = Text(
    en="{n} studies run already: wait until one of them has ended.",
    pt_BR="Já há {n} estudos em execução: espere um deles terminar.",
)
FAILED = Text(en="The study failed; see the terminal.", pt_BR="O estudo falhou; veja o terminal.")
MOST = 2
log = logging.getLogger("helicoide")


def study(report: Report, name: str, options: Any, short: bool) -> object:
    """Run a study in a process of its own."""
    return studies.run_study(name, options, short, report)


class Studies:
    """What each person has before them of the studies, and what runs. Only on the event loop."""

    def __init__(self, write: Callable[[], object]) -> None:
        self.write = write
        self._running: dict[Place, ProcessJob] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def redesk(self, place: Place, update: StudyPanelUpdate) -> None:
        """A person wishes something: a run may begin or end by it."""
        before = place.desk
        try:
            after = update(before)
        except HelicoideError as refusal:
            after = desks.with_failure(refusal.text)(before)
        begins = after.progress is not None and before.progress is None
        if begins and len(self._running) >= MOST:
            after = desks.with_failure(BUSY.format(n=len(self._running)))(after)
        elif begins:
            self._begin(place, after)
        elif after.progress is None and place in self._running:
            self._running.pop(place).stop()
        self._put(place, after)

    def forget(self, place: Place) -> None:
        """End what a person runs whose last window is gone; the results stay for when they come back."""
        if place in self._running:
            self.redesk(place, desks.with_run_ended)

    def close(self) -> None:
        """End everything."""
        while self._running:
            self._running.popitem()[1].stop()

    def _put(self, place: Place, desk: StudyPanelState) -> None:
        place.desk = desk
        self.write()

    def _begin(self, place: Place, desk: StudyPanelState) -> None:
        self._running[place] = job = ProcessJob(study, desk.study, desk.current_options(), desk.short)
        task = asyncio.get_running_loop().create_task(self._follow(place, job, desk))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _follow(self, place: Place, job: ProcessJob, desk: StudyPanelState) -> None:
        """Tell the desk what a run reports, and what it came to, unless the person ended it."""

        def is_wanted() -> bool:
            return self._running.get(place) is job

        def tell(update: StudyPanelUpdate) -> None:
            if is_wanted():
                self._put(place, update(place.desk))

        ended = desks.with_failure(FAILED)
        try:
            await follow_job(job, lambda share: tell(desks.with_progress(share)))
            if job.result is not None:
                ended = desks.with_result(CompletedRun(desk.study, desk.current_options(), desk.short, job.result))
            elif is_wanted():
                log.error("the process of the study %s was ended from outside", desk.study)
        except JobFailed as failure:
            log.error("the study %s failed:\n%s", desk.study, failure)
        except Exception:  # it could not be started, or was killed in the middle of a message
            log.exception("the study %s failed", desk.study)
        tell(ended)
        if is_wanted():
            del self._running[place]
