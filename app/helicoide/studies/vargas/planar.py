"""Sims. 4, 5 and 7 of Vargas 2013: methods beside each other on the planar arm, λ = 2.

The source gives no settings of damping and feedback for them, and no starts for two; those here are the digest's.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from helicoide.studies.study import FIGURE_ONLY, Progress, Result, Row
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import Path, places
from helicoide.studies.vargas.runs import IN_PLANE, Run, Way, compared, largest, tracking, way
from helicoide.studies.vargas.table import (
    ERROR_LATER,
    FASTEST_LATER,
    Gain,
    Sheet,
    Step,
    choice,
    errors_chart,
    figures_chart,
    planar_motion,
    rates_chart,
    titled,
    w_chart,
    way_chart,
)
from helicoide.text import Text

SECONDS = 40.0
DAMPED: dict[str, Any] = {"damping": 0.1, "threshold": 1.0}
FEEDBACK: dict[str, Any] = {"gain": 60.0, "coupling": 0.3, "leak": 0.5}
PSEUDOINVERSE, DAMPING = way("pseudoinverse"), way("damped_by_manipulability", **DAMPED)
FED_BACK = way("feedback", **FEEDBACK)
ASSUMED = Text(
    en="link lengths 2, 1, 1; start, δ₀ = 0.1, w₀ = 1 and the feedback's gains",
    pt_BR="comprimentos dos elos 2, 1, 1; partida, δ₀ = 0,1, w₀ = 1 e os ganhos da realimentada",
)
# of the digest: the fastest joint and the largest error from 5 s on, and the share that the short form may miss of each
Found = tuple[str, str, float | None, float | None]


def filters(gains: Sequence[float]) -> dict[str, Way]:
    """The filtered inverse and the modified one, with each γ."""
    kinds = {"filtered": "filtered", "modified": "filtered_modified"}
    several = len(gains) > 1
    return {
        f"{kind}_{i}" if several else kind: way(name, f"γ = {gain:g}", gain=gain)
        for kind, name in kinds.items()
        for i, gain in enumerate(gains)
    }


def ways_of(*gains: float) -> dict[str, Way]:
    """The methods that are beside each other, the filtered inverses with each γ."""
    return {"pseudoinverse": PSEUDOINVERSE, "damping": DAMPING, "feedback": FED_BACK, **filters(gains)}


@dataclass(frozen=True)
class Five:
    """Settings of five methods. gain: γ of the filtered inverses; dt, s; shown: whose motion the arm shows."""

    gain: Gain = 5.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(5.0))] = "filtered"


def followers(
    path: Path, start: Sequence[float], ways: Mapping[str, Way], dt: float, short: bool, progress: Progress
) -> dict[str, Run]:
    """A run of each method along a trajectory; short: in steps of 10 ms at least."""
    dt = max(dt, 1e-2) if short else dt
    return compared(planar(), ways, tracking(planar(), path, IN_PLANE), 2.0, start, dt, SECONDS, progress)


def compared_rows(
    sheet: Sheet, ways: Mapping[str, Way], runs: Mapping[str, Run], found: Mapping[str, Found], source: str = ""
) -> tuple[Row, ...]:
    """The fastest joint and the largest error from 5 s on, of each method; source: what it says of the speed."""
    rows = []
    for key, (fastest, error, coarse_rate, coarse_error) in found.items():
        run, of = runs[key], ways[key].title
        later = run.t >= 5
        said: Any = source if source and key in ("damping", "feedback") else FIGURE_ONLY
        rates, worst = largest(run.rates, later), largest(run.size, later)
        rows += [
            sheet.row(FASTEST_LATER, of, rates, fastest, "rad/s", coarse=coarse_rate, source=said, assumed=ASSUMED),
            sheet.row(ERROR_LATER, of, worst, error, "ℓ", coarse=coarse_error, assumed=ASSUMED),
        ]
    return tuple(rows)


def result(rows: tuple[Row, ...], path: Path, ways: Mapping[str, Way], runs: Mapping[str, Run], shown: str) -> Result:
    """Rows, charts of the errors, of the joint rates of two methods, w and δ, the way, and the motion of one."""
    names, one = titled(ways, runs), runs[shown]
    wished = places(path, one.t)[:, :2]
    charts = (
        errors_chart(names, "ℓ"),
        rates_chart(one, ways[shown].title),
        rates_chart(runs["damping"], DAMPING.title),
        w_chart(names, "ℓ²"),
        figures_chart(Text(en="damping", pt_BR="amortecimento"), "δ", {DAMPING.title: runs["damping"]}, "ℓ²"),
        way_chart(
            {Text(en="wished", pt_BR="desejado"): wished, ways[shown].title: wished - one.e},
            "x, ℓ",
            "y, ℓ",
        ),
    )
    return Result(rows, charts, planar_motion(one))
