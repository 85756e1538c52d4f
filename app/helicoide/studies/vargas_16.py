"""Sim. 16 of Vargas 2013: the tool goes round an obstacle beside its path."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.ik.secondary import augmented
from helicoide.kinematics.chain import Array
from helicoide.studies.study import Progress, Result, Row
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import path_1, places
from helicoide.studies.vargas.runs import Run, each
from helicoide.studies.vargas.secondary import ASSUMED, SECONDS, chosen, filtered, follow, tool
from helicoide.studies.vargas.table import (
    Gain,
    Sheet,
    Step,
    errors_chart,
    is_changed,
    planar_motion,
    rates_chart,
    way_chart,
)
from helicoide.text import Text, same

TITLE = Text(en="Simulation 16: round an obstacle", pt_BR="Simulação 16: contornando um obstáculo")
SOURCE = "Vargas 2013, §4.7, sim. 16, fig. 4.41"
ABOUT = Text(
    en="""The path of simulation 1 passes an obstacle at 0.25. A hill of cost around it, of height α, pushes the tool \
away as one more row of the task. Look at the way of the tool: it keeps farther off the higher the hill is, and is \
back on its path behind it.""",
    pt_BR="""O caminho da simulação 1 passa a 0,25 de um obstáculo. Uma colina de custo em torno dele, de altura α, \
afasta o efetuador como mais uma linha da tarefa. Observe o percurso do efetuador: quanto mais alta a colina, mais \
longe ele passa, e depois dela volta ao caminho.""",
)
ROBOT = "planar3r"
START, MU = (0.6, -1.2, 0.4), (2.0, 0.75)
# α: of the digest from 2 s on, how near the tool comes, m, and its largest error
CASES = {
    0.1: ("0.251", "0.0015"),
    0.5: ("0.271", "0.022"),
    1.0: ("0.294", "0.046"),
    2.0: ("0.325", "0.077"),
    5.0: ("0.367", "0.120"),
    10.0: ("0.399", "0.152"),
}
CLOSEST = Text(en="closest to the obstacle after 2 s", pt_BR="menor distância ao obstáculo após 2 s")
WORST = Text(en="largest error after 2 s", pt_BR="maior erro após 2 s")
WEIGHT = Quantity(
    Text(en="height α of the run that the arm shows", pt_BR="altura α da simulação que o braço mostra"), 0.1, 10.0
)


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s; weight: α of the run that the arm shows, added to the others where it is none of them."""

    gain: Gain = 5.0
    dt: Step = 1e-3
    weight: Annotated[float, WEIGHT] = 5.0


def round_the_obstacle(weight: float, gain: float, dt: float, seconds: float, progress: Progress) -> Run:
    """A hill of height α and radius 0.2 at μ = (2, 0.75), felt by the tool."""
    hill = chosen("ellipsoid", weight=weight, x=MU[0], y=MU[1], z=0.0, a=0.2, b=0.2, c=0.2, where="tool")
    return filtered(augmented(planar(), hill, follow(path_1)), START, gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Six heights of the hill, three in the short form."""
    usual = Options(options.gain, options.dt)
    sheet, dt = Sheet(short, is_changed(usual)), max(options.dt, 1e-2) if short else options.dt
    weights: Sequence[float] = (0.1, 1.0, 10.0) if short else tuple(CASES)
    wanted = sorted({*weights, options.weight})
    runs = each({alpha: partial(round_the_obstacle, alpha, options.gain, dt, SECONDS) for alpha in wanted}, progress)
    rows = [row for alpha in wanted for row in _rows(sheet, alpha, runs[alpha])]
    names = {same(f"α = {alpha:g}"): one for alpha, one in runs.items()}
    ways: dict[Text, Array] = {Text(en="wished", pt_BR="desejado"): places(path_1, runs[wanted[0]].t)[:, :2]}
    ways |= {name: tool(one, path_1) for name, one in names.items()}
    shown = runs[options.weight]
    charts = (
        way_chart(ways, "x, ℓ", "y, ℓ"),
        errors_chart(names, "ℓ"),
        rates_chart(shown, same(f"α = {options.weight:g}")),
    )
    return Result(tuple(rows), charts, planar_motion(shown))


def _rows(sheet: Sheet, weight: float, run: Run) -> list[Row]:
    closest, worst = CASES.get(weight, (None, None))
    late, of = run.t >= 2.0 - 1e-9, same(f"α = {weight:g}")
    near = float(np.linalg.norm(tool(run, path_1)[late] - MU, axis=1).min())
    error = float(run.size[late].max())
    return [
        sheet.row(CLOSEST, of, near, closest, "ℓ", coarse=4e-3, assumed=ASSUMED),
        sheet.row(WORST, of, error, worst, "ℓ", within=6e-4, coarse=0.0075, assumed=ASSUMED),
    ]
