"""Rows, charts and motions of the studies of Vargas 2013."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Any

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.method import Quantity
from helicoide.studies.study import Chart, ChartLine, Figure, Motion, Relation, Result, Row, Statement
from helicoide.studies.vargas.arms import LENGTHS
from helicoide.studies.vargas.runs import MethodRun, MethodSettings
from helicoide.text import Text, untranslated, with_decimal_comma

# γ counts in the unit of length of the arm, which has no name for the planar one (sources, Vargas 15).
OF_THE_PLANAR = Text(
    en="update gain γ (ℓ: unit of length of the planar arm)",
    pt_BR="ganho γ (ℓ: unidade de comprimento do braço planar)",
)
OF_THE_ZEBRA = Text(en="update gain γ", pt_BR="ganho γ")
Gain = Annotated[float, Quantity(OF_THE_PLANAR, 0.1, 1e4, "1/(ℓ² s)", decades=True)]
GainInCm = Annotated[float, Quantity(OF_THE_ZEBRA, 0.1, 1e4, "1/(cm² s)", decades=True)]
GainInDm = Annotated[float, Quantity(OF_THE_ZEBRA, 0.1, 1e4, "1/(dm² s)", decades=True)]
Step = Annotated[float, Quantity(Text(en="step", pt_BR="passo"), 1e-4, 2e-2, "s", decades=True)]

# The numbers that stand for words, the same in all studies (sources, Vargas 9). As fractions of the arm's reach: a null
# error, the error of an arm that tracks, a small error. As ratios: much, and the deviation from 1 that is similar.
NULL, TRACKED, SMALL = 0.001, 0.01, 0.05
MUCH, SIMILAR = 5.0, 0.25
# the correlation of two curves that look alike
SIMILAR_CORRELATION = 0.7
# rad: a joint that moves by more has moved; joints that differ by less are practically identical
MOTION_THRESHOLD = 0.01

SECONDS = Text(en="t, s", pt_BR="t, s")
DESIRED = Text(en="desired", pt_BR="desejado")
ERRORS = Text(en="error", pt_BR="erro")
FASTEST = Text(en="fastest joint", pt_BR="junta mais rápida")
FASTEST_FROM = Text(en="fastest joint from {since:g} s on", pt_BR="junta mais rápida a partir de {since:g} s")
ERROR_FROM = Text(en="largest error from {since:g} s on", pt_BR="maior erro a partir de {since:g} s")


def transient_end(rate: float) -> float:
    """The end of the transient, s, when ė = −λe has reduced the initial error to e⁻¹⁰."""
    return 10 / rate


def run_row(
    quantity: Text,
    of: Text | None,
    computed: float,
    unit: str = "",
    source: Statement | Figure | None = None,
    **more: Any,
) -> Row:
    """A row about one run; more: further fields of the row."""
    title = quantity if of is None else Text(en=f"{quantity.en}: {of.en}", pt_BR=f"{quantity.pt_BR}: {of.pt_BR}")
    return Row(title, computed, unit, source, **more)


def with_step(what: Text, dt: float) -> Text:
    """A quantity that depends on the step dt, s."""
    steps = Text(en="{what}, in steps of {ms:g} ms", pt_BR="{what}, em passos de {ms:g} ms")
    return steps.format(what=what, ms=1e3 * dt)


def sentence_statement(
    en: str, pt_BR: str, place: str, value: float, relation: Relation = "=", within: float = 0.0
) -> Statement:
    """A sentence of the source, as a condition on a number."""
    return Statement(Text(en=en, pt_BR=pt_BR), place, value, relation, within)


def study_result(rows: Sequence[Row], charts: Sequence[Chart], motions: Sequence[Motion] = ()) -> Result:
    """The result of a study."""
    return Result(tuple(rows), tuple(charts), tuple(motions))


def over_time(
    title: Text,
    up: str,
    runs: Mapping[Text, MethodRun],
    value: Callable[[MethodRun], Array],
    figure: str = "",
    log: bool = False,
) -> Chart:
    """A quantity of several runs, (k,) of each."""
    lines = tuple(ChartLine(name, subsampled(run.t), subsampled(value(run))) for name, run in runs.items())
    return Chart(title, SECONDS, untranslated(up), lines, figure, log)


def errors_chart(runs: Mapping[Text, MethodRun], unit: str, figure: str = "", log: bool = False) -> Chart:
    """‖e‖ of several runs."""
    return over_time(ERRORS, f"‖e‖, {unit}", runs, lambda run: run.error_norm, figure, log)


def condition_chart(runs: Mapping[Text, MethodRun], figure: str) -> Chart:
    """The condition number of J of several runs."""
    title = Text(en="condition number", pt_BR="número de condição")
    return over_time(title, "σ₁/σₚ", runs, lambda run: run.condition, figure, log=True)


def w_chart(runs: Mapping[Text, MethodRun], unit: str, figure: str = "") -> Chart:
    """The manipulability of several runs."""
    return over_time(Text(en="manipulability", pt_BR="manipulabilidade"), f"w, {unit}", runs, lambda run: run.w, figure)


def fastest_chart(runs: Mapping[Text, MethodRun], figure: str = "") -> Chart:
    """The largest joint velocity of several runs over time, logarithmic."""
    return over_time(
        FASTEST, "max |q̇ᵢ|, rad/s", runs, lambda run: np.abs(run.joint_velocities).max(axis=1), figure, log=True
    )


def joint_velocity_chart(run: MethodRun, of: Text, figure: str = "") -> Chart:
    """The joint velocities of a run."""
    title = Text(en="joint velocities, {of}", pt_BR="velocidades de junta, {of}").format(of=of)
    return _of_joints(title, run.t, run.joint_velocities, "q̇", "rad/s", figure)


def joints_chart(run: MethodRun, of: Text, figure: str = "") -> Chart:
    """The joint angles of a run."""
    title = Text(en="joint angles, {of}", pt_BR="ângulos de junta, {of}").format(of=of)
    return _of_joints(title, run.t, run.q, "q", "rad", figure)


def _of_joints(title: Text, t: Array, values: Array, symbol: str, unit: str, figure: str) -> Chart:
    columns = enumerate(subsampled(values).T, 1)
    lines = tuple(ChartLine(untranslated(f"{symbol}{i}"), subsampled(t), column) for i, column in columns)
    return Chart(title, SECONDS, untranslated(f"{symbol}, {unit}"), lines, figure)


def figures_chart(title: Text, symbol: str, runs: Mapping[Text, MethodRun], unit: str = "", figure: str = "") -> Chart:
    """A quantity that the method reports, such as V_c or δ, of several runs."""
    lines = tuple(ChartLine(name, run.figure_times, run.figure(symbol)) for name, run in runs.items())
    return Chart(title, SECONDS, untranslated(f"{symbol}{unit and ', ' + unit}"), lines, figure)


def path_chart(lines: Mapping[Text, Array], across: str, up: str, figure: str = "") -> Chart:
    """Paths in a plane, (k, 2) each."""
    title = Text(en="path of the end effector", pt_BR="percurso do efetuador")
    drawn = tuple(ChartLine(name, *subsampled(points).T) for name, points in lines.items())
    return Chart(title, untranslated(across), untranslated(up), drawn, figure)


def runs_by_title(ways: Mapping[str, MethodSettings], runs: Mapping[str, MethodRun]) -> dict[Text, MethodRun]:
    """The runs by their titles."""
    return {ways[key].title: run for key, run in runs.items()}


def symbol_value(symbol: str, value: float) -> Text:
    """A symbol with its value, such as "α = 0.5"."""
    return with_decimal_comma(f"{symbol} = {value:g}")


def subsampled(values: Array, most: int = 2000) -> Array:
    """About `most` of the values, evenly spaced."""
    return values[:: max(1, len(values) // most)]


# number of postures in a motion
POSTURES = 300


def planar_motions(runs: Mapping[Text, MethodRun]) -> list[Motion]:
    """The motions of the planar arm."""
    return [Motion("planar3r", *_postures(run), LENGTHS, title) for title, run in runs.items()]


def zebra_motions(runs: Mapping[Text, MethodRun]) -> list[Motion]:
    """The motions of the Zebra-ZERO; joints 4 to 6 are 0 in runs with three joints."""
    moved = {title: _postures(run) for title, run in runs.items()}
    return [
        Motion("zebra_zero", t, np.pad(q, ((0, 0), (0, 6 - q.shape[1]))), title=title)
        for title, (t, q) in moved.items()
    ]


def _postures(run: MethodRun) -> tuple[Array, Array]:
    return subsampled(run.t, POSTURES), subsampled(run.q, POSTURES)
