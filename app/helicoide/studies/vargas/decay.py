"""Sims. 1 and 2 of Vargas 2013: how fast the error of a closed loop decays."""

from __future__ import annotations

from functools import partial
from math import pi
from typing import Any

import numpy as np

from helicoide.ik.clik import Aiming
from helicoide.studies.study import Figure, Progress, Result
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import path_1, places
from helicoide.studies.vargas.readings import LINKS
from helicoide.studies.vargas.runs import Experiment, Run, Way, each, largest, record, way
from helicoide.studies.vargas.table import (
    FASTEST,
    WISHED,
    errors_chart,
    finished,
    in_steps,
    joints_chart,
    planar_motions,
    rates_chart,
    row,
    stated,
    valued,
    way_chart,
)
from helicoide.text import Text

START = [pi / 6] * 3
SECONDS = 10.0
RATES = (1.0, 2.0)
SLOPE = Text(en="slope of ln‖e‖", pt_BR="inclinação de ln‖e‖")


def slope(run: Run) -> float:
    """d ln‖e‖/dt between 0.5 and 3 s, 1/s: −λ where the error decays as e^(−λt)."""
    between = (run.t > 0.5) & (run.t < 3)
    return float(np.polyfit(run.t[between], np.log(run.size[between]), 1)[0])


def decays(options: Any, aiming: Aiming, by: Way, dt: float, figures: str, progress: Progress) -> Result:
    """The errors of a method with λ = 1 and 2, compared with the filtered inverse.

    figures: where the source shows errors, joint velocities and joint angles.
    """
    arm, soft = planar(), way("filtered", f"γ = {options.gain:g}", gain=options.gain)
    plans = {(by, 1.0): by, (by, 2.0): by, (soft, 2.0): soft}
    experiments = {rate: Experiment(arm, aiming, rate, START, dt, SECONDS) for rate in RATES}
    runs = each({key: partial(record, experiments[key[1]], one) for key, one in plans.items()}, progress)
    title, rows = in_steps(SLOPE, dt), []
    for rate in RATES:
        law = stated(
            f"exponential decay, ė + λe = 0: −{rate:g}",
            f"decaimento exponencial, ė + λe = 0: −{rate:g}",
            "eq. 2.34",
            -rate,
            within=0.01 * rate,
        )
        rows.append(row(title, valued("λ", rate), slope(runs[by, rate]), "1/s", law, fitted=(LINKS,)))
    fastest = {by: Figure(figures), soft: None}
    rows += [row(FASTEST, one.title, largest(runs[one, 2.0].rates), "rad/s", source) for one, source in fastest.items()]
    rated = Text(en="{of}, {rate}", pt_BR="{of}, {rate}")
    shown = {rated.format(of=one.title, rate=valued("λ", rate)): run for (one, rate), run in runs.items()}
    wished = places(path_1, runs[by, 2.0].t)[:, :2]
    ways = {name: wished - run.e[:, :2] for name, run in shown.items()}
    inverted, filtered = runs[by, 2.0], runs[soft, 2.0]
    charts = (
        errors_chart(shown, "ℓ", figures, log=True),
        rates_chart(inverted, by.title, figures),
        joints_chart(inverted, by.title, figures),
        rates_chart(filtered, soft.title),
        way_chart({WISHED: wished, **ways}, "x, ℓ", "y, ℓ"),
    )
    return finished(rows, charts, planar_motions(shown))
