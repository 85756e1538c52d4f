"""The rows that Sims. 12 and 13 of Vargas 2013 share: a path that leaves the workspace and comes back."""

from __future__ import annotations

from helicoide.studies.study import Figure, Row
from helicoide.studies.vargas.arm import FASTEST_LATER, SINCE, re_entry, unreachable
from helicoide.studies.vargas.runs import Run, Way, largest
from helicoide.studies.vargas.table import in_steps, row
from helicoide.text import Text

REACHABLE = Text(en="largest error where the path is within reach", pt_BR="maior erro onde o caminho está ao alcance")
AFTER = Text(en="error 0.5 s after coming back", pt_BR="erro 0,5 s após a volta")


def reach_rows(one: Way, run: Run, shown: Figure | None, dt: float | None = None) -> list[Row]:
    """The rows of a method after the transient; dt: the step, s, if they depend on it."""
    later = run.t >= SINCE
    of = one.title if dt is None else in_steps(one.title, dt)
    return [
        row(FASTEST_LATER, of, largest(run.rates, later), "rad/s", shown),
        row(REACHABLE, of, largest(run.size, later & ~unreachable(run.t)), "cm", shown),
        row(AFTER, of, re_entry(run)[1], "cm", shown),
    ]
