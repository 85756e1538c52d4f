"""Sims. 4 to 7 of Vargas 2013: methods compared on the planar arm.

The source names the works from which it takes the settings of both methods, and prints none: one set for all four was
searched at which its statements hold (tests/studies/fits/vargas_planar.py).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.studies.study import (
    Chart,
    ChartLine,
    Fitted,
    Interpretation,
    Progress,
    Result,
    Row,
    Statement,
    printed_statement,
)
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import PathFunction, path_points
from helicoide.studies.vargas.readings import EXPONENT, TRANSPOSE
from helicoide.studies.vargas.runs import (
    PLANAR_ROWS,
    Experiment,
    MethodRun,
    MethodSettings,
    largest_absolute,
    method_settings,
    run_methods,
    tracking,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    ERROR_FROM,
    FASTEST,
    FASTEST_FROM,
    Gain,
    Step,
    condition_chart,
    errors_chart,
    fastest_chart,
    figures_chart,
    joint_velocity_chart,
    joints_chart,
    path_chart,
    planar_motions,
    run_row,
    runs_by_title,
    study_result,
    transient_end,
)
from helicoide.text import Text, untranslated, with_decimal_comma

SECONDS, LENGTH = 40.0, 4.0
PSEUDOINVERSE = method_settings("pseudoinverse")
COMPARED = ("damping", "feedback")


@dataclass(frozen=True)
class OpenValues:
    """Values that the source omits: λ; δ₀ and w₀ of the damping; g, c and α of the feedback inverse."""

    rate: float = 1.0
    damping: float = 0.1
    threshold: float = 1.0
    gain: float = 240.0
    coupling: float = 0.6
    leak: float = 8.0

    @property
    def methods(self) -> dict[str, MethodSettings]:
        """The damped inverse and the feedback inverse with these values."""
        return {
            "damping": method_settings("damped_by_manipulability", damping=self.damping, threshold=self.threshold),
            "feedback": method_settings("feedback", gain=self.gain, coupling=self.coupling, leak=self.leak),
        }


VALUES = OpenValues()
_RATE = Fitted(untranslated("λ"), VALUES.rate, 0.909, 1.2, "s⁻¹")
SINCE = transient_end(VALUES.rate)
FITTED: dict[str, tuple[Fitted | Interpretation, ...]] = {
    "damping": (
        _RATE,
        Fitted(untranslated("δ₀"), VALUES.damping, 0.0833, 0.12, "ℓ²"),
        Fitted(untranslated("w₀"), VALUES.threshold, 0.833, 1.2, "ℓ²"),
        EXPONENT,
    ),
    "feedback": (
        _RATE,
        Fitted(untranslated("g"), VALUES.gain, 200.0, 288.0, "ℓ⁻² s⁻¹"),
        Fitted(untranslated("c"), VALUES.coupling, 0.546, 0.72),
        Fitted(untranslated("α"), VALUES.leak, 6.67, 9.6, "s⁻¹"),
        TRANSPOSE,
    ),
}


def filtered_methods(gains: Sequence[float]) -> dict[str, MethodSettings]:
    """The filtered inverse and the modified one, with each γ."""
    kinds = {"filtered": "filtered", "modified": "filtered_modified"}
    return {
        f"{kind}_{gain:g}": method_settings(name, f"γ = {gain:g}", gain=gain)
        for kind, name in kinds.items()
        for gain in gains
    }


@dataclass(frozen=True)
class FiveMethods:
    """Settings of five methods. gain: γ of the filtered inverses; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3

    @property
    def methods(self) -> dict[str, MethodSettings]:
        """The compared methods."""
        return {"pseudoinverse": PSEUDOINVERSE, **VALUES.methods, **filtered_methods([self.gain])}


def run_on_planar(
    path: PathFunction,
    start: Sequence[float],
    ways: Mapping[str, MethodSettings],
    dt: float,
    progress: Progress,
    rate: float = VALUES.rate,
) -> dict[str, MethodRun]:
    """A run of each method along a trajectory, with λ."""
    aiming = tracking(planar_problem(), path, PLANAR_ROWS)
    return run_methods(Experiment(planar_problem(), aiming, rate, start, dt, SECONDS), ways, progress)


def rows_of_both(
    quantity: Text, computed: Mapping[str, float], unit: str, source: Statement, *more: Fitted | Interpretation
) -> list[Row]:
    """A row for each of the two methods, with the values chosen for it; more: further chosen values."""
    return [
        run_row(quantity, VALUES.methods[key].title, value, unit, source, fitted=(*FITTED[key], *more))
        for key, value in computed.items()
    ]


def velocity_bound_rows(bound: str, place: str, runs: Mapping[str, MethodRun], *more: Interpretation) -> list[Row]:
    """Rows that hold the joint velocities of both methods to a printed bound."""
    fastest = {key: largest_absolute(runs[key].joint_velocities) for key in COMPARED}
    return rows_of_both(FASTEST, fastest, "rad/s", printed_statement(bound, place), *more)


def computed_rows(ways: Mapping[str, MethodSettings], runs: Mapping[str, MethodRun]) -> list[Row]:
    """Largest joint velocity and error after the transient, of methods that the source does not apply here."""
    rows = []
    for key in [key for key in runs if key not in COMPARED]:
        later = runs[key].t >= SINCE
        rows += [
            run_row(
                FASTEST_FROM.format(since=SINCE),
                ways[key].title,
                largest_absolute(runs[key].joint_velocities, later),
                "rad/s",
            ),
            run_row(
                ERROR_FROM.format(since=SINCE), ways[key].title, largest_absolute(runs[key].error_norm, later), "ℓ"
            ),
        ]
    return rows


def planar_result(
    rows: Sequence[Row],
    path: PathFunction,
    ways: Mapping[str, MethodSettings],
    runs: Mapping[str, MethodRun],
    figures: str,
    more: tuple[Chart, ...] = (),
) -> Result:
    """The result: rows, the charts that the source shows, and motions.

    figures: where the source shows them.
    """
    names = runs_by_title(ways, runs)
    desired = path_points(path, next(iter(runs.values())).t)[:, :2]
    damped, fed_back = (ways[key].title for key in COMPARED)
    charts = (
        errors_chart(names, "ℓ", figures, log=True),
        fastest_chart(names, figures),
        joint_velocity_chart(runs["damping"], damped, figures),
        joint_velocity_chart(runs["feedback"], fed_back, figures),
        condition_chart({ways[key].title: runs[key] for key in COMPARED}, figures),
        figures_chart(Text(en="damping", pt_BR="amortecimento"), "δ", {damped: runs["damping"]}, "ℓ²", figures),
        *more,
        path_chart({DESIRED: desired, **{name: desired - run.e for name, run in names.items()}}, "x, ℓ", "y, ℓ"),
        joints_chart(runs["damping"], damped),
    )
    return study_result(rows, charts[:8], planar_motions(names))


def ellipse_chart(path: PathFunction, run: MethodRun, instants: Sequence[float], size: float = 0.3) -> Chart:
    """The manipulability ellipses at some times, s, drawn at the end effector and scaled by `size`.

    Source: Vargas 2013, eq. 3.4: axes uᵢ, semi-lengths σᵢ.
    """
    turn: Array = np.linspace(0, 2 * np.pi, 121)
    desired, lines = path_points(path, run.t)[:, :2], []
    for at in instants:
        i = int(np.abs(run.t - at).argmin())
        here = analyse_jacobian(run.J[i]).velocity_ellipsoid
        round_it = (here.axes * here.lengths) @ np.stack([np.cos(turn), np.sin(turn)])
        x, y = (desired[i] - run.e[i])[:, None] + size * round_it
        lines.append(ChartLine(with_decimal_comma(f"t = {at:g} s"), x, y))
    title = Text(en="manipulability ellipses on the way", pt_BR="elipses de manipulabilidade no percurso")
    return Chart(title, untranslated("x, ℓ"), untranslated("y, ℓ"), tuple(lines), "fig. 3.1")
