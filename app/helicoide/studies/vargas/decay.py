"""Sims. 1 and 2 of Vargas 2013: how fast the error of a closed loop decays."""

from __future__ import annotations

from functools import partial
from math import pi

import numpy as np

from helicoide.ik.clik import Aiming
from helicoide.studies.study import Progress, Result, Row
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.runs import Run, Way, each, largest, record, way
from helicoide.studies.vargas.table import (
    FASTEST,
    NO_LENGTHS,
    Sheet,
    errors_chart,
    planar_motion,
    rates_chart,
)
from helicoide.text import Text, same

START = [pi / 6] * 3
SECONDS = 10.0
# λ: the slope of ln‖e‖, and the error after 1 s and 3 s
DECAYS = {1.0: ("-1.001", "0.874", "0.118"), 2.0: ("-2.002", "0.321", "0.0059")}
ASSUMED = Text(en="link lengths 2, 1, 1; γ = 5", pt_BR="comprimentos dos elos 2, 1, 1; γ = 5")


def slope(run: Run) -> float:
    """d ln‖e‖/dt between 0.5 and 3 s, 1/s: −λ where the error decays as e^(−λt)."""
    between = (run.t > 0.5) & (run.t < 3)
    return float(np.polyfit(run.t[between], np.log(run.size[between]), 1)[0])


def decays(
    aiming: Aiming, by: Way, fastest: tuple[str, str], gain: float, dt: float, sheet: Sheet, progress: Progress
) -> Result:
    """The errors of a method with λ = 1 and 2, and of the filtered inverse beside it.

    fastest: what the digest has for the fastest joint of both at λ = 2; gain: γ.
    """
    arm, soft = planar(), way("filtered", f"γ = {gain:g}", gain=gain)
    plans = {(by, 1.0): by, (by, 2.0): by, (soft, 2.0): soft}
    runs = each(
        {key: partial(record, arm, one, aiming, key[1], START, dt, SECONDS) for key, one in plans.items()}, progress
    )
    rows = [row for rate in DECAYS for row in _decay_rows(sheet, runs[by, rate], rate)]
    for one, most in zip((by, soft), fastest, strict=True):
        found = largest(runs[one, 2.0].rates)
        rows.append(sheet.row(FASTEST, one.title, found, most, "rad/s", coarse=0.01, assumed=ASSUMED))
    rated = Text(en="{of}, λ = {rate:g}", pt_BR="{of}, λ = {rate:g}")
    shown = {rated.format(of=one.title, rate=rate): run for (one, rate), run in runs.items()}
    logs = errors_chart(shown, "ℓ")
    return Result(
        tuple(rows),
        (logs, rates_chart(runs[by, 2.0], by.title), rates_chart(runs[soft, 2.0], soft.title)),
        planar_motion(runs[by, 2.0]),
    )


def _decay_rows(sheet: Sheet, run: Run, rate: float) -> list[Row]:
    fall, one, three = DECAYS[rate]
    of = same(f"λ = {rate:g}")
    after = [float(np.interp(at, run.t, run.size)) for at in (1.0, 3.0)]
    error = Text(en="error after {at} s", pt_BR="erro após {at} s")
    return [
        sheet.row(Text(en="slope of ln‖e‖", pt_BR="inclinação de ln‖e‖"), of, slope(run), fall, "1/s", coarse=0.01),
        sheet.row(error.format(at=1), of, after[0], one, within=0.01 * float(one), coarse=0.02, assumed=NO_LENGTHS),
        sheet.row(error.format(at=3), of, after[1], three, within=0.01 * float(three), coarse=0.02, assumed=NO_LENGTHS),
    ]
