"""The state of the study panel of a window: selected study, options, progress and results."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from helicoide import studies
from helicoide.ik.method import changed
from helicoide.studies.study import Result
from helicoide.text import Text

NOTHING: Mapping[str, Any] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class Run:
    """A completed run: study, options, whether it was a quick run, and its result."""

    study: str
    options: Any
    short: bool
    result: Result


@dataclass(frozen=True, eq=False)
class Desk:
    """The study panel: selection, options, progress and results.

    study: its name, empty at first; options: by study name, where they differ from the defaults; short: whether a quick
    run is requested; progress: the completed fraction, None while nothing runs; last and before: the last two completed
    runs; compared: whether the previous run is shown too; failure: why there is no result.
    """

    study: str = ""
    options: Mapping[str, Any] = field(default_factory=lambda: NOTHING)
    short: bool = True
    progress: float | None = None
    last: Run | None = None
    before: Run | None = None
    compared: bool = False
    failure: Text | None = None

    def chosen(self) -> Any:
        """The current options of the selected study."""
        return self.options.get(self.study) or studies.named(self.study).Options()

    @property
    def shown(self) -> tuple[Run, ...]:
        """The runs of the selected study to show: the last, and the previous one if they are compared."""
        runs = (self.last, self.before) if self.compared else (self.last,)
        return tuple(run for run in runs if run is not None and run.study == self.study)


DeskUpdate = Callable[[Desk], Desk]
EMPTY = Desk()


def choose(name: str) -> DeskUpdate:
    """Select another study and end the current run; raises HelicoideError for an unknown name."""
    if name:
        studies.named(name)
    return lambda desk: replace(desk, study=name, progress=None, failure=None)


def set_option(name: str, value: object) -> DeskUpdate:
    """Set one option of the selected study; raises HelicoideError, which lists the valid values."""

    def update(desk: Desk) -> Desk:
        options = changed(desk.chosen(), name, value)
        return replace(desk, options=MappingProxyType({**desk.options, desk.study: options}))

    return update


def start(desk: Desk) -> Desk:
    """Start the selected study, unless one is running."""
    return desk if desk.progress is not None or not desk.study else replace(desk, progress=0.0, failure=None)


def end(desk: Desk) -> Desk:
    """End the current run."""
    return replace(desk, progress=None)


def told(share: float) -> DeskUpdate:
    """Update the progress of the current run."""
    return lambda desk: desk if desk.progress is None else replace(desk, progress=share)


def done(run: Run) -> DeskUpdate:
    """Store a completed run as the last one."""
    return lambda desk: replace(desk, progress=None, last=run, before=desk.last)


def failed(why: Text) -> DeskUpdate:
    """End the current run without a result."""
    return lambda desk: replace(desk, progress=None, failure=why)
