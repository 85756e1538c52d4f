"""Runs of studies: each has its own process, and posts its progress and its result to the study panel of its seat."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from typing import Any

from helicoide import studies
from helicoide.jobs.process import JobFailed, ProcessJob, Report, follow_job
from helicoide.session.seats import Place
from helicoide.studies import panel_state
from helicoide.studies.panel_state import CompletedRun, StudyPanelState, StudyPanelUpdate
from helicoide.text import HelicoideError, Text

BUSY = Text(
    en="{n} studies are already running: wait for one to end.",
    pt_BR="Já há {n} estudos em execução: espere um deles terminar.",
)
FAILED = Text(en="The study failed; see the terminal.", pt_BR="O estudo falhou; veja o terminal.")
MOST = 2
log = logging.getLogger("helicoide")


def study(report: Report, name: str, options: Any, short: bool) -> object:
    """Run a study; this is the function that runs in the process."""
    return studies.run_study(name, options, short, report)


class Studies:
    """The study panels of all places, and the runs. Use it only on the event loop."""

    def __init__(self, write: Callable[[], object]) -> None:
        self.write = write
        self._running: dict[Place, ProcessJob] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    def change(self, place: Place, update: StudyPanelUpdate) -> None:
        """Update the study panel of a place, which may start or end a run."""
        before = place.study_panel
        try:
            after = update(before)
        except HelicoideError as refusal:
            after = panel_state.with_failure(refusal.text)(before)
        begins = after.progress is not None and before.progress is None
        if begins and len(self._running) >= MOST:
            after = panel_state.with_failure(BUSY.format(n=len(self._running)))(after)
        elif begins:
            self._begin(place, after)
        elif after.progress is None and place in self._running:
            self._running.pop(place).stop()
        self._put(place, after)

    def forget(self, place: Place) -> None:
        """End the run of a place whose last window has closed; its results are kept."""
        if place in self._running:
            self.change(place, panel_state.with_run_ended)

    def close(self) -> None:
        """End all runs."""
        while self._running:
            self._running.popitem()[1].stop()

    def _put(self, place: Place, panel: StudyPanelState) -> None:
        place.study_panel = panel
        self.write()

    def _begin(self, place: Place, panel: StudyPanelState) -> None:
        self._running[place] = job = ProcessJob(study, panel.study, panel.current_options(), panel.short)
        task = asyncio.get_running_loop().create_task(self._follow(place, job, panel))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _follow(self, place: Place, job: ProcessJob, panel: StudyPanelState) -> None:
        """Post the progress and the result of a run to the study panel, unless the run was ended there."""

        def is_wanted() -> bool:
            return self._running.get(place) is job

        def tell(update: StudyPanelUpdate) -> None:
            if is_wanted():
                self._put(place, update(place.study_panel))

        ended = panel_state.with_failure(FAILED)
        try:
            await follow_job(job, lambda share: tell(panel_state.with_progress(share)))
            if job.result is not None:
                ended = panel_state.with_result(
                    CompletedRun(panel.study, panel.current_options(), panel.short, job.result)
                )
            elif is_wanted():
                log.error("the process of the study %s was ended from outside", panel.study)
        except JobFailed as failure:
            log.error("the study %s failed:\n%s", panel.study, failure)
        except Exception:  # it could not be started, or was killed in the middle of a message
            log.exception("the study %s failed", panel.study)
        tell(ended)
        if is_wanted():
            del self._running[place]
