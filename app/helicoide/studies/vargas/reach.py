"""The rows that Sims. 12 and 13 of Vargas 2013 share: a path that leaves the workspace and comes back."""

from __future__ import annotations

from helicoide.studies.study import Figure, Row
from helicoide.studies.vargas.position_arm import FASTEST_LATER, SINCE, errors_after_return, outside_workspace
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute
from helicoide.studies.vargas.table import run_row, with_step
from helicoide.text import Text

REACHABLE = Text(en="largest error where the path is within reach", pt_BR="maior erro onde o caminho está ao alcance")
AFTER = Text(en="error 0.5 s after coming back", pt_BR="erro 0,5 s após a volta")


def reach_rows(one: MethodSettings, run: MethodRun, shown: Figure | None, dt: float | None = None) -> list[Row]:
    """The rows of a method after the transient; dt: the step, s, if they depend on it."""
    later = run.t >= SINCE
    of = one.title if dt is None else with_step(one.title, dt)
    return [
        run_row(FASTEST_LATER, of, largest_absolute(run.joint_velocities, later), "rad/s", shown),
        run_row(REACHABLE, of, largest_absolute(run.error_norm, later & ~outside_workspace(run.t)), "cm", shown),
        run_row(AFTER, of, errors_after_return(run)[1], "cm", shown),
    ]
