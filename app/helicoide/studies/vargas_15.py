"""Sim. 15 of Vargas 2013: a limit of the elbow as one more row of the task."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from math import pi
from typing import Annotated

import numpy as np

from helicoide.ik.method import OneOf
from helicoide.ik.secondary import augmented
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.studies.vargas.arms import limited
from helicoide.studies.vargas.paths import path_1
from helicoide.studies.vargas.runs import Run, each, largest, rms
from helicoide.studies.vargas.secondary import ASSUMED, SECONDS, chosen, filtered, follow
from helicoide.studies.vargas.table import (
    FASTEST_AFTER_3,
    RMS_AFTER_3,
    WORST_AFTER_3,
    Gain,
    Sheet,
    Step,
    errors_chart,
    is_changed,
    planar_motion,
    rates_chart,
    thinned,
)
from helicoide.studies.vargas.table import SECONDS as IN_SECONDS
from helicoide.text import Text, same

TITLE = Text(en="Simulation 15: a limit of the elbow", pt_BR="Simulação 15: um limite do cotovelo")
SOURCE = "Vargas 2013, §4.7, sim. 15, figs. 4.39–4.40"
ABOUT = Text(
    en="""The arm has a joint to spare, and a steep barrier asks the elbow to stay within −1 ± ζ. Look at q₂: without \
the barrier it runs out of the range; with ζ = 0.5 it stays inside and the path is kept all the same; with ζ = 0.2 \
there is too little room, and the path pays.""",
    pt_BR="""O braço tem uma junta de sobra, e uma barreira íngreme pede que o cotovelo fique em −1 ± ζ. Observe q₂: \
sem a barreira ele sai da faixa; com ζ = 0,5 fica dentro dela e o caminho é mantido mesmo assim; com ζ = 0,2 o espaço \
é pouco e o caminho paga.""",
)
ROBOT = "planar3r"
MIDDLE = -1.0
# ζ, joint 2 at the start; of the digest from 3 s on: its range, rad, largest and rms error, fastest joint, rad/s
Case = tuple[float | None, float, tuple[str, str], str, str, str]
CASES: dict[str, Case] = {
    "none": (None, -pi / 6, ("-1.623", "-1.121"), "2e-4", "1e-4", "0.097"),
    "0.5": (0.5, -pi / 6, ("-1.290", "-0.590"), "5e-4", "2e-4", "0.144"),
    "0.2": (0.2, -0.82, ("-1.156", "-0.843"), "0.055", "0.015", "0.474"),
}
NAMES = {
    "none": Text(en="no limit", pt_BR="sem limite"),
    "0.5": same("ζ = 0.5"),
    "0.2": same("ζ = 0.2"),
}
SHOWN = OneOf(Text(en="run that the arm shows", pt_BR="simulação que o braço mostra"), NAMES)


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s; shown: whose motion the arm shows."""

    gain: Gain = 5.0
    dt: Step = 1e-3
    shown: Annotated[str, SHOWN] = "0.5"


def barrier(case: Case, gain: float, dt: float, seconds: float, progress: Progress) -> Run:
    """Joint 2 kept at −1 ± ζ; α = 5, k = 10."""
    zeta, elbow = case[:2]
    aiming, start = follow(path_1), (pi / 6, elbow, -pi / 6)
    if zeta is not None:
        here = limited(1, MIDDLE - zeta, MIDDLE + zeta)
        aiming = augmented(here, chosen("joint_barrier"), aiming)
    return filtered(aiming, start, gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Without a limit, and with two."""
    sheet, dt = Sheet(short, is_changed(options)), max(options.dt, 1e-2) if short else options.dt
    plans = {key: partial(barrier, case, options.gain, dt, SECONDS) for key, case in CASES.items()}
    runs = each(plans, progress)
    rows = [row for key in CASES for row in _rows(sheet, key, runs[key])]
    shown = runs[options.shown]
    charts = (*_charts(runs), rates_chart(shown, NAMES[options.shown]))
    return Result(tuple(rows), charts, planar_motion(shown))


def _rows(sheet: Sheet, key: str, run: Run) -> list[Row]:
    zeta, _, (low, high), error, mean, fastest = CASES[key]
    of, late, q_2 = NAMES[key], run.t >= 3.0 - 1e-9, run.q[:, 1]
    size = run.size[late]
    tight = 6e-5 if float(error) < 1e-3 else 5e-4
    slack = 2e-4 / float(error)
    # the short form may miss an error by 2e-4 and a range by 1.5e-3
    rows = [
        sheet.row(Text(en="least q₂", pt_BR="menor q₂"), of, float(q_2[late].min()), low, "rad", coarse=1e-3),
        sheet.row(Text(en="greatest q₂", pt_BR="maior q₂"), of, float(q_2[late].max()), high, "rad", coarse=2e-3),
        sheet.row(WORST_AFTER_3, of, float(size.max()), error, "ℓ", within=tight, coarse=slack, assumed=ASSUMED),
        sheet.row(RMS_AFTER_3, of, rms(size), mean, "ℓ", within=tight, assumed=ASSUMED),
        sheet.row(FASTEST_AFTER_3, of, largest(run.rates, late), fastest, "rad/s", coarse=0.0085, assumed=ASSUMED),
    ]
    if zeta is not None:
        out = Text(
            en="greatest distance of q₂ from −1, of the whole run",
            pt_BR="maior distância de q₂ a −1, na simulação inteira",
        )
        rows.append(sheet.row(out, of, float(np.abs(q_2 - MIDDLE).max()), f"{zeta:g}", "rad", relation="≤", coarse=0.0))
    return rows


def _charts(runs: Mapping[str, Run]) -> tuple[Chart, Chart]:
    elbow = tuple(Line(NAMES[key], thinned(run.t), thinned(run.q[:, 1])) for key, run in runs.items())
    return (
        Chart(Text(en="the elbow", pt_BR="o cotovelo"), IN_SECONDS, same("q₂, rad"), elbow),
        errors_chart({NAMES[key]: run for key, run in runs.items()}, "ℓ"),
    )
