"""Convergence from home to a target, each step a constant fraction of the error: number of steps, and the end."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.clik import TaskFunction
from helicoide.ik.converge import IterativeSolver, Report, converged, solver_of
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.study import Chart, ChartLine, Interpretation, Motion, Result, Row, Statement
from helicoide.text import Text, untranslated

STEP_FACTOR = Text(en="step factor κ", pt_BR="fator de passo κ")
INFERRED = Text(
    en="κ = {factor}, inferred from the {count} steps, which it gives from {least} to {most}",
    pt_BR="κ = {factor}, tirado dos {count} passos, que dá de {least} a {most}",
)
OTHER_FACTOR = Text(
    en="{count} steps with the {factor} of the {other}", pt_BR="{count} passos com o {factor} do {other}"
)


@dataclass(frozen=True, eq=False)
class ConvergenceCase:
    """A task from home, the printed number of iterations, the step factor inferred from it, and other factors."""

    problem: Problem
    aiming: TaskFunction
    statement: Statement
    interpretation: Interpretation
    other_factors: tuple[float, ...]
    figure: str


def convergence_result(coming: ConvergenceCase, factor: float, damping: float) -> Result:
    """The number of iterations with the chosen factor and with others, and the posture reached."""
    reports = {f: _came(coming, f, damping) for f in sorted({factor, *coming.other_factors})}
    quantity = Text(en="iterations, step factor {f:g}", pt_BR="iterações, fator de passo {f:g}")
    stated = Row(quantity.format(f=factor), reports[factor].iterations, "", coming.statement, (coming.interpretation,))
    others = [Row(quantity.format(f=f), reports[f].iterations) for f in coming.other_factors if f != factor]
    rows = (stated, *others, *_margin(coming))
    ways = tuple(_motion(coming, f, damping, report) for f, report in reports.items())
    return Result(rows, _charts(coming, reports, ways[[*reports].index(factor)]), ways)


def _solver(coming: ConvergenceCase, factor: float, damping: float) -> IterativeSolver:
    return solver_of(coming.problem, setups.damped_inverse(damping), factor)


def _came(coming: ConvergenceCase, factor: float, damping: float) -> Report:
    return converged(_solver(coming, factor, damping), coming.aiming, coming.problem.robot.poses["home"])


def _motion(coming: ConvergenceCase, factor: float, damping: float, report: Report) -> Motion:
    run, robot = _solver(coming, factor, damping).run, coming.problem.robot
    way = np.array([m.q for m in islice(run(coming.aiming, robot.poses["home"], None), report.iterations + 1)])
    return Motion(robot.name, np.arange(float(len(way))), way, title=_name(factor))


def _margin(coming: ConvergenceCase) -> tuple[Row, ...]:
    """The least margin of the exact solution to the joint limits, degrees."""
    limits = coming.problem.limits
    q = setups.solved_posture(coming.problem, coming.aiming, coming.problem.robot.poses["home"])
    quantity = Text(en="exact solution: least margin to its limits", pt_BR="solução exata: menor folga até os limites")
    return (Row(quantity, float(np.degrees(np.minimum(q - limits.lower, limits.upper - q).min())), "°"),)


def _charts(coming: ConvergenceCase, reports: dict[float, Report], shown: Motion) -> tuple[Chart, ...]:
    steps = Text(en="iteration", pt_BR="iteração")
    named = (
        (Text(en="Position error", pt_BR="Erro de posição"), Text(en="error (mm)", pt_BR="erro (mm)"), 0, 1e3),
        (Text(en="Orientation error", pt_BR="Erro de orientação"), Text(en="error (rad)", pt_BR="erro (rad)"), 1, 1.0),
    )
    errors = [
        Chart(title, steps, up, _lines(reports, column, scale), coming.figure, log=True)
        for title, up, column, scale in named
    ]
    q = np.degrees(shown.q)
    joints = tuple(ChartLine(untranslated(f"J{j}"), shown.times, q[:, j - 1]) for j in range(1, q.shape[1] + 1))
    title = Text(en="Joints, {factor}", pt_BR="Juntas, {factor}").format(factor=shown.title)
    return (*errors, Chart(title, steps, Text(en="joint (°)", pt_BR="junta (°)"), joints, coming.figure))


def _lines(reports: dict[float, Report], column: int, scale: float) -> tuple[ChartLine, ...]:
    return tuple(_line(f, scale * report.errors[:, column]) for f, report in reports.items())


def _line(factor: float, errors: Array) -> ChartLine:
    return ChartLine(_name(factor), np.arange(float(len(errors))), errors)


def _name(factor: float) -> Text:
    return untranslated("κ = {factor:g}").format(factor=factor)
