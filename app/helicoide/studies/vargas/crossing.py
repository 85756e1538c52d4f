"""The rows that Sims. 10, 11 and 11b of Vargas 2013 share."""

from __future__ import annotations

from collections.abc import Mapping

from helicoide.studies.study import Figure, Row, Statement
from helicoide.studies.vargas.arms import REACH
from helicoide.studies.vargas.runs import Run, Way, largest
from helicoide.studies.vargas.table import ERROR_LATER, FASTEST, FASTEST_LATER, NULL, row, stated

COMPARED = ("filtered", "damping")


def crossing_rows(
    ways: Mapping[str, Way], runs: Mapping[str, Run], figures: str, follows: Statement | None = None
) -> list[Row]:
    """The fastest joint, of all and from 5 s on, and the largest error from then on.

    figures: where the source shows both methods that it compares; follows: what it says of the filtered inverse.
    """
    rows = []
    for key in [key for key in runs if key != "pseudoinverse"]:
        of, run, shown = ways[key].title, runs[key], Figure(figures) if key in COMPARED else None
        later = run.t >= 5
        rows += [
            row(FASTEST, of, largest(run.rates), "rad/s", shown),
            row(FASTEST_LATER, of, largest(run.rates, later), "rad/s", shown),
            row(ERROR_LATER, of, largest(run.size, later), "cm", (follows if key == "filtered" else None) or shown),
        ]
    return rows


def null_error(en: str, pt_BR: str, place: str) -> Statement:
    """That a method follows: its error is null beside the reach of the arm."""
    return stated(en, pt_BR, place, NULL * REACH, "≤")
