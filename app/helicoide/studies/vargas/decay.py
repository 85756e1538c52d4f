"""Sims. 1 and 2 of Vargas 2013: how fast the error of a closed loop decays."""

from __future__ import annotations

from functools import partial
from math import pi
from typing import Any

import numpy as np

from helicoide.ik.clik import TaskFunction
from helicoide.studies.study import Figure, Progress, Result
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import path_1, path_points
from helicoide.studies.vargas.readings import LINKS
from helicoide.studies.vargas.runs import (
    Experiment,
    MethodRun,
    MethodSettings,
    largest_absolute,
    method_settings,
    run_each,
    run_method,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    FASTEST,
    errors_chart,
    joint_velocity_chart,
    joints_chart,
    path_chart,
    planar_motions,
    run_row,
    sentence_statement,
    study_result,
    symbol_value,
    with_step,
)
from helicoide.text import Text

START = [pi / 6] * 3
SECONDS = 10.0
RATES = (1.0, 2.0)
SLOPE = Text(en="slope of ln‖e‖", pt_BR="inclinação de ln‖e‖")


def log_error_slope(run: MethodRun) -> float:
    """d ln‖e‖/dt between 0.5 and 3 s, 1/s: −λ where the error decays as e^(−λt)."""
    between = (run.t > 0.5) & (run.t < 3)
    return float(np.polyfit(run.t[between], np.log(run.error_norm[between]), 1)[0])


def decay_result(
    options: Any, aiming: TaskFunction, by: MethodSettings, dt: float, figures: str, progress: Progress
) -> Result:
    """The errors of a method with λ = 1 and 2, compared with the filtered inverse.

    figures: where the source shows errors, joint velocities and joint angles.
    """
    arm, soft = planar_problem(), method_settings("filtered", f"γ = {options.gain:g}", gain=options.gain)
    plans = {(by, 1.0): by, (by, 2.0): by, (soft, 2.0): soft}
    experiments = {rate: Experiment(arm, aiming, rate, START, dt, SECONDS) for rate in RATES}
    runs = run_each({key: partial(run_method, experiments[key[1]], one) for key, one in plans.items()}, progress)
    title, rows = with_step(SLOPE, dt), []
    for rate in RATES:
        law = sentence_statement(
            f"exponential decay, ė + λe = 0: −{rate:g}",
            f"decaimento exponencial, ė + λe = 0: −{rate:g}",
            "eq. 2.34",
            -rate,
            within=0.01 * rate,
        )
        rows.append(
            run_row(title, symbol_value("λ", rate), log_error_slope(runs[by, rate]), "1/s", law, fitted=(LINKS,))
        )
    fastest = {by: Figure(figures), soft: None}
    rows += [
        run_row(FASTEST, one.title, largest_absolute(runs[one, 2.0].joint_velocities), "rad/s", source)
        for one, source in fastest.items()
    ]
    rated = Text(en="{of}, {rate}", pt_BR="{of}, {rate}")
    shown = {rated.format(of=one.title, rate=symbol_value("λ", rate)): run for (one, rate), run in runs.items()}
    desired = path_points(path_1, runs[by, 2.0].t)[:, :2]
    ways = {name: desired - run.e[:, :2] for name, run in shown.items()}
    inverted, filtered = runs[by, 2.0], runs[soft, 2.0]
    charts = (
        errors_chart(shown, "ℓ", figures, log=True),
        joint_velocity_chart(inverted, by.title, figures),
        joints_chart(inverted, by.title, figures),
        joint_velocity_chart(filtered, soft.title),
        path_chart({DESIRED: desired, **ways}, "x, ℓ", "y, ℓ"),
    )
    return study_result(rows, charts, planar_motions(shown))
