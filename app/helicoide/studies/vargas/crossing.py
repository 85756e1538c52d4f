"""The rows that Sims. 10, 11 and 11b of Vargas 2013 share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from helicoide.studies.study import FIGURE_ONLY, Row
from helicoide.studies.vargas.arm import PSEUDOINVERSE
from helicoide.studies.vargas.runs import Run, Way, largest, rms
from helicoide.studies.vargas.table import ERROR_LATER, FASTEST, FASTEST_LATER, RMS_LATER, Sheet
from helicoide.text import Text


@dataclass(frozen=True)
class Found:
    """What the digest has: fastest joint, rad/s, of all and from 5 s on; largest and rms error from then on, cm.

    coarse: the share that the short form may miss of each, None where it does not hold the number.
    """

    fastest: str
    later: str
    error: str | None
    mean: str
    coarse: tuple[float | None, float | None, float | None, float | None]


def crossing_rows(
    sheet: Sheet, ways: Mapping[str, Way], runs: Mapping[str, Run], found: Mapping[str, Found], every: int, source: str
) -> list[Row]:
    """Four numbers of each method; every: 2 where every second step counts; source: what it says of the speed."""
    rows = []
    for key, one in found.items():
        of, run = ways[key].title, runs[key]
        t, rates, size = run.t[::every], run.rates[::every], run.size[::every]
        later = t >= 5
        a, b, c, d = one.coarse
        said: str | Text = source or FIGURE_ONLY
        rows += [
            sheet.row(FASTEST, of, largest(rates), one.fastest, "rad/s", coarse=a),
            sheet.row(FASTEST_LATER, of, largest(rates, later), one.later, "rad/s", coarse=b, source=said),
            sheet.row(ERROR_LATER, of, largest(size, later), one.error, "cm", coarse=c),
            sheet.row(RMS_LATER, of, rms(size[later]), one.mean, "cm", coarse=d),
        ]
    return rows


def pseudoinverse_rows(sheet: Sheet, run: Run, fastest: str, error: str) -> list[Row]:
    """Undamped peaks at an exact singularity hang on the step: half the digest's at least, three times its error."""
    later, of = run.t >= 5, PSEUDOINVERSE.title
    half, twice = 0.5 * float(fastest), 2 * float(error)
    rates, worst = largest(run.rates, later), largest(run.size, later)
    return [
        sheet.row(FASTEST_LATER, of, rates, fastest, "rad/s", within=half, relation="≥"),
        sheet.row(ERROR_LATER, of, worst, error, "cm", within=twice, relation="≤"),
    ]
