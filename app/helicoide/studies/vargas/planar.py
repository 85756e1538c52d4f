"""Sims. 4 to 7 of Vargas 2013: methods compared on the planar arm.

The source names the works from which it takes the settings of both methods, and prints none: one set for all four was
searched at which its statements hold (tests/studies/fits/vargas_planar.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.manipulability import analysed
from helicoide.studies.study import Chart, Fitted, Line, Progress, Reading, Result, Row, Statement, printed
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import Path, places
from helicoide.studies.vargas.readings import EXPONENT, TRANSPOSE
from helicoide.studies.vargas.runs import IN_PLANE, Experiment, Run, Way, compared, largest, tracking, way
from helicoide.studies.vargas.table import (
    ERROR_FROM,
    FASTEST,
    FASTEST_FROM,
    WISHED,
    Gain,
    Step,
    condition_chart,
    errors_chart,
    fastest_chart,
    figures_chart,
    finished,
    joints_chart,
    planar_motions,
    rates_chart,
    row,
    settled,
    titled,
    way_chart,
)
from helicoide.text import Text, same

SECONDS, LENGTH = 40.0, 4.0
PSEUDOINVERSE = way("pseudoinverse")
COMPARED = ("damping", "feedback")


@dataclass(frozen=True)
class Values:
    """Values that the source omits: λ; δ₀ and w₀ of the damping; g, c and α of the feedback inverse."""

    rate: float = 1.0
    damping: float = 0.1
    threshold: float = 1.0
    gain: float = 240.0
    coupling: float = 0.6
    leak: float = 8.0

    @property
    def ways(self) -> dict[str, Way]:
        """The damped inverse and the feedback inverse with these values."""
        return {
            "damping": way("damped_by_manipulability", damping=self.damping, threshold=self.threshold),
            "feedback": way("feedback", gain=self.gain, coupling=self.coupling, leak=self.leak),
        }


VALUES = Values()
_RATE = Fitted(same("λ"), VALUES.rate, 0.909, 1.2, "s⁻¹")
SINCE = settled(VALUES.rate)
FITTED: dict[str, tuple[Fitted | Reading, ...]] = {
    "damping": (
        _RATE,
        Fitted(same("δ₀"), VALUES.damping, 0.0833, 0.12, "ℓ²"),
        Fitted(same("w₀"), VALUES.threshold, 0.833, 1.2, "ℓ²"),
        EXPONENT,
    ),
    "feedback": (
        _RATE,
        Fitted(same("g"), VALUES.gain, 200.0, 288.0, "ℓ⁻² s⁻¹"),
        Fitted(same("c"), VALUES.coupling, 0.546, 0.72),
        Fitted(same("α"), VALUES.leak, 6.67, 9.6, "s⁻¹"),
        TRANSPOSE,
    ),
}


def filters(gains: Sequence[float]) -> dict[str, Way]:
    """The filtered inverse and the modified one, with each γ."""
    kinds = {"filtered": "filtered", "modified": "filtered_modified"}
    return {f"{kind}_{gain:g}": way(name, f"γ = {gain:g}", gain=gain) for kind, name in kinds.items() for gain in gains}


@dataclass(frozen=True)
class Five:
    """Settings of five methods. gain: γ of the filtered inverses; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, Way]:
        """The compared methods."""
        return {"pseudoinverse": PSEUDOINVERSE, **VALUES.ways, **filters([self.gain])}


def followers(
    path: Path,
    start: Sequence[float],
    ways: Mapping[str, Way],
    dt: float,
    progress: Progress,
    rate: float = VALUES.rate,
) -> dict[str, Run]:
    """A run of each method along a trajectory, with λ."""
    aiming = tracking(planar(), path, IN_PLANE)
    return compared(Experiment(planar(), aiming, rate, start, dt, SECONDS), ways, progress)


def of_both(
    quantity: Text, ours: Mapping[str, float], unit: str, source: Statement, *more: Fitted | Reading
) -> list[Row]:
    """A row for each of the two methods, with the values chosen for it; more: further chosen values."""
    return [
        row(quantity, VALUES.ways[key].title, value, unit, source, fitted=(*FITTED[key], *more))
        for key, value in ours.items()
    ]


def below(bound: str, place: str, runs: Mapping[str, Run], *more: Reading) -> list[Row]:
    """Rows that hold the joint velocities of both methods to a printed bound."""
    fastest = {key: largest(runs[key].rates) for key in COMPARED}
    return of_both(FASTEST, fastest, "rad/s", printed(bound, place), *more)


def ours(ways: Mapping[str, Way], runs: Mapping[str, Run]) -> list[Row]:
    """Largest joint velocity and error after the transient, of methods that the source does not apply here."""
    rows = []
    for key in [key for key in runs if key not in COMPARED]:
        later = runs[key].t >= SINCE
        rows += [
            row(FASTEST_FROM.format(since=SINCE), ways[key].title, largest(runs[key].rates, later), "rad/s"),
            row(ERROR_FROM.format(since=SINCE), ways[key].title, largest(runs[key].size, later), "ℓ"),
        ]
    return rows


def result(
    rows: Sequence[Row],
    path: Path,
    ways: Mapping[str, Way],
    runs: Mapping[str, Run],
    figures: str,
    more: tuple[Chart, ...] = (),
) -> Result:
    """The result: rows, the charts that the source shows, and motions.

    figures: where the source shows them.
    """
    names = titled(ways, runs)
    wished = places(path, next(iter(runs.values())).t)[:, :2]
    damped, fed_back = (ways[key].title for key in COMPARED)
    charts = (
        errors_chart(names, "ℓ", figures, log=True),
        fastest_chart(names, figures),
        rates_chart(runs["damping"], damped, figures),
        rates_chart(runs["feedback"], fed_back, figures),
        condition_chart({ways[key].title: runs[key] for key in COMPARED}, figures),
        figures_chart(Text(en="damping", pt_BR="amortecimento"), "δ", {damped: runs["damping"]}, "ℓ²", figures),
        *more,
        way_chart({WISHED: wished, **{name: wished - run.e for name, run in names.items()}}, "x, ℓ", "y, ℓ"),
        joints_chart(runs["damping"], damped),
    )
    return finished(rows, charts[:8], planar_motions(names))


def ellipses(path: Path, run: Run, instants: Sequence[float], size: float = 0.3) -> Chart:
    """The manipulability ellipses at some times, s, drawn at the end effector and scaled by `size`.

    Source: Vargas 2013, eq. 3.4: axes uᵢ, semi-lengths σᵢ.
    """
    turn: Array = np.linspace(0, 2 * np.pi, 121)
    wished, lines = places(path, run.t)[:, :2], []
    for at in instants:
        i = int(np.abs(run.t - at).argmin())
        here = analysed(run.J[i]).velocity_ellipsoid
        round_it = (here.axes * here.lengths) @ np.stack([np.cos(turn), np.sin(turn)])
        x, y = (wished[i] - run.e[i])[:, None] + size * round_it
        lines.append(Line(same(f"t = {at:g} s"), x, y))
    title = Text(en="manipulability ellipses on the way", pt_BR="elipses de manipulabilidade no percurso")
    return Chart(title, same("x, ℓ"), same("y, ℓ"), tuple(lines), "fig. 3.1")
