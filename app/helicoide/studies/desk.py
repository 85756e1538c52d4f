"""What a person has before them of the studies: which one, with what settings, how far it is, and what came of it."""

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
    """A run that has ended: of which study, with which options, and its result."""

    study: str
    options: Any
    short: bool
    result: Result


@dataclass(frozen=True, eq=False)
class Desk:
    """study: its name, none at first; options: of studies, by name, where they are not the defaults; short: whether the
    short form is wanted; progress: the share that is done, None while nothing runs; last and before: the last two runs;
    compared: whether the one before is shown as well; failure: why there is no result.
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
        """The options of the study, as they are set."""
        return self.options.get(self.study) or studies.named(self.study).Options()

    @property
    def shown(self) -> tuple[Run, ...]:
        """The runs of this study that are shown: the last, and the one before where they are compared."""
        runs = (self.last, self.before) if self.compared else (self.last,)
        return tuple(run for run in runs if run is not None and run.study == self.study)


DeskUpdate = Callable[[Desk], Desk]
EMPTY = Desk()


def choose(name: str) -> DeskUpdate:
    """Take another study; what runs is ended. Raises HelicoideError for one that there is not."""
    if name:
        studies.named(name)
    return lambda desk: replace(desk, study=name, progress=None, failure=None)


def set_option(name: str, value: object) -> DeskUpdate:
    """One setting of the study; raises HelicoideError, which names what is valid."""

    def update(desk: Desk) -> Desk:
        options = changed(desk.chosen(), name, value)
        return replace(desk, options=MappingProxyType({**desk.options, desk.study: options}))

    return update


def start(desk: Desk) -> Desk:
    """Run the study, unless one runs already."""
    return desk if desk.progress is not None or not desk.study else replace(desk, progress=0.0, failure=None)


def end(desk: Desk) -> Desk:
    """End what runs."""
    return replace(desk, progress=None)


def told(share: float) -> DeskUpdate:
    """What runs tells how far it is."""
    return lambda desk: desk if desk.progress is None else replace(desk, progress=share)


def done(run: Run) -> DeskUpdate:
    """What ran has ended: it is the last run now."""
    return lambda desk: replace(desk, progress=None, last=run, before=desk.last)


def failed(why: Text) -> DeskUpdate:
    """What ran has ended without a result."""
    return lambda desk: replace(desk, progress=None, failure=why)
