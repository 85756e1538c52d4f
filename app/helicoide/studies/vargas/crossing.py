"""The rows that Sims. 10, 11 and 11b of Vargas 2013 share."""

from __future__ import annotations

from collections.abc import Mapping

from helicoide.studies.study import Figure, Row, Statement
from helicoide.studies.vargas.position_arm import ERROR_LATER, FASTEST_LATER, SINCE
from helicoide.studies.vargas.readings import EXACT_STEP
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute
from helicoide.studies.vargas.table import FASTEST, run_row

COMPARED = ("filtered", "damping")


def axis_crossing_rows(
    ways: Mapping[str, MethodSettings],
    runs: Mapping[str, MethodRun],
    figures: str,
    follows: Statement | None = None,
    slow: Statement | None = None,
) -> list[Row]:
    """The largest joint velocity, in the whole run and after the transient, and the largest error after it.

    figures: those of the two methods that the source compares; follows: its statement about the filtered inverse;
    slow: its statement about the joints of both methods.
    """
    rows = []
    for key in [key for key in runs if key != "pseudoinverse"]:
        of, run, shown = ways[key].title, runs[key], Figure(figures) if key in COMPARED else None
        later, filtered = run.t >= SINCE, key == "filtered"
        rows += [
            run_row(FASTEST, of, largest_absolute(run.joint_velocities), "rad/s", shown),
            run_row(
                FASTEST_LATER,
                of,
                largest_absolute(run.joint_velocities, later),
                "rad/s",
                slow or shown,
                fitted=(EXACT_STEP,) if slow and filtered else (),
            ),
            run_row(
                ERROR_LATER,
                of,
                largest_absolute(run.error_norm, later),
                "cm",
                (follows if filtered else None) or shown,
                fitted=(EXACT_STEP,) if follows and filtered else (),
            ),
        ]
    return rows
