"""Coming from home to a target by a constant share of the error a step: how many steps it takes, and where it ends."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.clik import Aiming
from helicoide.ik.converge import Report, Run, by_method, converged
from helicoide.kinematics.chain import Array
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.study import FIGURE_ONLY, Chart, Line, Motion, Result, Row
from helicoide.text import Text, same

FACTOR = Text(
    en="the source does not give its step factor; this many steps need another",
    pt_BR="a fonte não informa o fator de passo; este número de iterações pede outro",
)


@dataclass(frozen=True, eq=False)
class Coming:
    """What is aimed at from home, and the digest's: iterations by step factor; exact solution, degrees."""

    problem: Problem
    aiming: Aiming
    source: int
    counts: dict[float, int]
    solution: tuple[float, ...]
    decimals: int


def result(coming: Coming, factor: float, damping: float) -> Result:
    """The count of iterations with the chosen factor and with those of the digest, and the exact solution."""
    home = coming.problem.robot.poses["home"]
    reports = {f: _came(coming, f, damping, home) for f in sorted({factor, *coming.counts})}
    run = _run(coming, factor, damping)
    way = np.array([m.q for m in islice(run(coming.aiming, home, None), reports[factor].iterations + 1)])
    exact = np.degrees(arms.start_at(coming.problem, coming.aiming, home))
    rows = (_counted(coming, factor, reports[factor]), *_others(coming, factor, reports), *_exact(coming, exact))
    return Result(rows, _charts(reports), Motion(coming.problem.robot.name, np.arange(float(len(way))), way))


def _run(coming: Coming, factor: float, damping: float) -> Run:
    return by_method(coming.problem, *arms.inverse(damping), factor)


def _came(coming: Coming, factor: float, damping: float, home: Array) -> Report:
    return converged(coming.problem, _run(coming, factor, damping), coming.aiming, home)


def _counted(coming: Coming, factor: float, report: Report) -> Row:
    quantity = Text(en="iterations, step factor {f:g}", pt_BR="iterações, fator de passo {f:g}").format(f=factor)
    other = None if coming.counts.get(factor) == coming.source else FACTOR
    return Row(quantity, report.iterations, coming.source, source=str(coming.source), assumed=other)


def _others(coming: Coming, factor: float, reports: dict[float, Report]) -> list[Row]:
    quantity = Text(en="iterations, step factor {f:g}", pt_BR="iterações, fator de passo {f:g}")
    others = [f for f in coming.counts if f != factor]
    return [Row(quantity.format(f=f), reports[f].iterations, coming.counts[f]) for f in others]


def _exact(coming: Coming, exact: Array) -> list[Row]:
    quantity = Text(en="J{joint} of the exact solution", pt_BR="J{joint} da solução exata")
    tolerance = 0.51 * 10.0**-coming.decimals
    return [
        Row(quantity.format(joint=j), float(ours), digest, tolerance, "°", FIGURE_ONLY)
        for j, (ours, digest) in enumerate(zip(exact, coming.solution, strict=True), 1)
    ]


def _charts(reports: dict[float, Report]) -> tuple[Chart, ...]:
    steps = Text(en="iteration", pt_BR="iteração")
    named = (
        (Text(en="Position error", pt_BR="Erro de posição"), same("log₁₀ (mm)"), 0, 1e3),
        (Text(en="Orientation error", pt_BR="Erro de orientação"), same("log₁₀ (rad)"), 1, 1.0),
    )
    return tuple(
        Chart(title, steps, up, tuple(_errors(f, report, column, scale) for f, report in reports.items()))
        for title, up, column, scale in named
    )


def _errors(factor: float, report: Report, column: int, scale: float) -> Line:
    errors = np.maximum(scale * report.errors[:, column], 1e-15)
    return Line(same(f"κ = {factor:g}"), np.arange(float(len(errors))), np.asarray(np.log10(errors)))
