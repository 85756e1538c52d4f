"""The state of the study panel of a window: selected study, options, progress and results."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from helicoide import studies
from helicoide.ik.method import changed
from helicoide.studies.study import Motion, Result
from helicoide.text import Text

NO_OPTIONS: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class CompletedRun:
    """A completed run: study, options, whether it was a quick run, and its result."""

    study: str
    options: Any
    short: bool
    result: Result


@dataclass(frozen=True, eq=False)
class StudyPanelState:
    """The study panel: selection, options, progress and results.

    study: its name, empty at first; options: by study name, where they differ from the defaults; short: whether a quick
    run is requested; progress: the completed fraction, None while nothing runs; last and previous: the last two
    completed runs; compares_previous: whether the previous run is shown too; failure: why there is no result.
    """

    study: str = ""
    options: Mapping[str, Any] = field(default_factory=lambda: NO_OPTIONS)
    short: bool = True
    progress: float | None = None
    last: CompletedRun | None = None
    previous: CompletedRun | None = None
    compares_previous: bool = False
    failure: Text | None = None

    def current_options(self) -> Any:
        """The current options of the selected study."""
        return self.options.get(self.study) or studies.study_named(self.study).Options()

    @property
    def shown_runs(self) -> tuple[CompletedRun, ...]:
        """The runs of the selected study to show: the last, and the previous one if they are compared."""
        runs = (self.last, self.previous) if self.compares_previous else (self.last,)
        return tuple(run for run in runs if run is not None and run.study == self.study)

    @property
    def motions(self) -> tuple[Motion, ...]:
        """The motions of the last run of the selected study."""
        return self.shown_runs[0].result.motions if self.shown_runs else ()


StudyPanelUpdate = Callable[[StudyPanelState], StudyPanelState]
NO_STUDY = StudyPanelState()


def with_study(name: str) -> StudyPanelUpdate:
    """Select another study and end the current run; raises HelicoideError for an unknown name."""
    if name:
        studies.study_named(name)
    return lambda panel: replace(panel, study=name, progress=None, failure=None)


def with_study_option(name: str, value: object) -> StudyPanelUpdate:
    """Set one option of the selected study; raises HelicoideError, which lists the valid values."""

    def update(panel: StudyPanelState) -> StudyPanelState:
        options = changed(panel.current_options(), name, value)
        return replace(panel, options=MappingProxyType({**panel.options, panel.study: options}))

    return update


def with_run_started(panel: StudyPanelState) -> StudyPanelState:
    """Start the selected study, unless one is running."""
    return panel if panel.progress is not None or not panel.study else replace(panel, progress=0.0, failure=None)


def with_run_ended(panel: StudyPanelState) -> StudyPanelState:
    """End the current run."""
    return replace(panel, progress=None)


def with_progress(share: float) -> StudyPanelUpdate:
    """Update the progress of the current run."""
    return lambda panel: panel if panel.progress is None else replace(panel, progress=share)


def with_result(run: CompletedRun) -> StudyPanelUpdate:
    """Store a completed run as the last one."""
    return lambda panel: replace(panel, progress=None, last=run, previous=panel.last)


def with_failure(why: Text) -> StudyPanelUpdate:
    """End the current run without a result."""
    return lambda panel: replace(panel, progress=None, failure=why)
