"""The rows that Sims. 10, 11 and 11b of Vargas 2013 share."""

from __future__ import annotations

from collections.abc import Mapping

from helicoide.studies.study import Figure, Row, Statement
from helicoide.studies.vargas.arm import ERROR_LATER, FASTEST_LATER, SINCE
from helicoide.studies.vargas.readings import EXACT_STEP
from helicoide.studies.vargas.runs import Run, Way, largest
from helicoide.studies.vargas.table import FASTEST, row

COMPARED = ("filtered", "damping")


def crossing_rows(
    ways: Mapping[str, Way],
    runs: Mapping[str, Run],
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
            row(FASTEST, of, largest(run.rates), "rad/s", shown),
            row(
                FASTEST_LATER,
                of,
                largest(run.rates, later),
                "rad/s",
                slow or shown,
                fitted=(EXACT_STEP,) if slow and filtered else (),
            ),
            row(
                ERROR_LATER,
                of,
                largest(run.size, later),
                "cm",
                (follows if filtered else None) or shown,
                fitted=(EXACT_STEP,) if follows and filtered else (),
            ),
        ]
    return rows
