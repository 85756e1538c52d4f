"""Sim. 14 of Vargas 2013: out of reach, the gains say what counts more, position or orientation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from math import pi
from typing import Annotated

import numpy as np

from helicoide.ik.method import OneOf
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.studies.vargas.arms import TOOL_DOWN, zebra
from helicoide.studies.vargas.paths import Vector, path_11
from helicoide.studies.vargas.runs import POSE, Run, each, largest, record, sizes, tracking, turned, way
from helicoide.studies.vargas.table import (
    FASTEST,
    SECONDS,
    Gain,
    Sheet,
    Step,
    is_changed,
    rates_chart,
    thinned,
    zebra_motion,
)
from helicoide.text import Text, same

TITLE = Text(en="Simulation 14: gains as priorities", pt_BR="Simulação 14: ganhos como prioridades")
SOURCE = "Vargas 2013, §4.6, sim. 14, figs. 4.34–4.36"
ABOUT = Text(
    en="""For twelve seconds the path asks for a place and an orientation that the arm cannot have together. Look at \
both errors: the modified law rests where the weighted errors are least, so that the larger gain wins, and only the \
ratio of the gains counts. A larger gain for one axis favours that axis.""",
    pt_BR="""Durante doze segundos o caminho pede um lugar e uma orientação que o braço não pode ter ao mesmo tempo. \
Observe os dois erros: a lei modificada repousa onde os erros ponderados são mínimos, de modo que o ganho maior vence \
e só a razão entre os ganhos conta. Um ganho maior em um eixo favorece esse eixo.""",
)
ROBOT = "zebra_zero"
HALF = 7.854  # s: where trajectory 11 is farthest
# Λ_p and λ_o; of the digest: the largest errors from 6 to 10 s, cm and ‖Δε‖, and those at `HALF`, dm and ‖Δε‖
Gains = tuple[float, float, float, float]
CASES: dict[str, tuple[Gains, str, str, tuple[str, str] | None]] = {
    "100, 10": ((100, 100, 100, 10), "0.15", "0.240", ("0.0151", "0.2402")),
    "10, 10": ((10, 10, 10, 10), "1.31", "0.204", ("0.1310", "0.2044")),
    "100, 100": ((100, 100, 100, 100), "1.31", "0.205", ("0.1310", "0.2044")),
    "10, 100": ((10, 10, 10, 100), "5.25", "0.073", ("0.5246", "0.0734")),
    "diag(100, 10, 10), 100": ((100, 10, 10, 100), "5.10", "0.126", None),
    "diag(10, 10, 100), 100": ((10, 10, 100, 100), "5.43", "0.106", None),
}
# |e_x| and |e_z| at `HALF`, cm
BY_AXIS = {
    "10, 100": ("3.99", "3.40"),
    "diag(100, 10, 10), 100": ("0.66", "5.06"),
    "diag(10, 10, 100), 100": ("5.40", "0.53"),
}
SHOWN = OneOf(
    Text(en="gains Λₚ, λₒ of the run that the arm shows", pt_BR="ganhos Λₚ, λₒ da simulação que o braço mostra"),
    {key: same(key) for key in CASES},
)


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(dm² s); dt, s; shown: whose motion the arm shows."""

    gain: Gain = 25.0
    dt: Step = 5e-4
    shown: Annotated[str, SHOWN] = "100, 10"


def weighted(gains: Gains, gain: float, dt: float, seconds: float, progress: Progress = lambda share: None) -> Run:
    """The effector on trajectory 11, R_d = R_y(π), by the modified law, dm. Args: gains of x, y, z and orientation."""
    arm = zebra()

    def in_dm(t: float) -> tuple[Vector, Vector]:
        (x, y, z), (a, b, c) = path_11(t)
        return (x / 10, y / 10, z / 10), (a / 10, b / 10, c / 10)

    rows = np.array([*gains[:3], *[gains[3]] * 3])
    aiming = tracking(arm, in_dm, POSE, turned(1, pi))
    return record(arm, way("filtered_modified", gain=gain), aiming, rows, TOOL_DOWN, dt, seconds, progress)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Six pairs of gains for 32 s; to the farthest point in the short form."""
    sheet = Sheet(short, is_changed(options))
    dt, seconds = (max(options.dt, 8e-3), 10.0) if short else (options.dt, 32.0)
    plans = {key: partial(weighted, case[0], options.gain, dt, seconds) for key, case in CASES.items()}
    runs = each(plans, progress)
    rows = [row for key in CASES for row in _case_rows(sheet, key, runs[key])]
    shown = Text(en="gains {of}", pt_BR="ganhos {of}").format(of=options.shown)
    charts = (*_charts(runs), rates_chart(runs[options.shown], shown))
    return Result(tuple(rows), charts, zebra_motion(runs[options.shown]))


def _case_rows(sheet: Sheet, key: str, run: Run) -> list[Row]:
    _, position, turn, at_half = CASES[key]
    of, lost = same(key), (run.t >= 6) & (run.t <= 10)
    e_p, e_o = sizes(run.e[:, :3]), sizes(run.e[:, 3:])
    now = int(np.abs(run.t - HALF).argmin())
    worst = Text(en="largest ‖{e}‖ from 6 to 10 s", pt_BR="maior ‖{e}‖ de 6 a 10 s")
    there = Text(en="{e} at 7.854 s", pt_BR="{e} em 7,854 s")
    rows = [
        sheet.row(worst.format(e="e_p"), of, 10 * largest(e_p, lost), position, "cm", coarse=0.03),
        sheet.row(worst.format(e="Δε"), of, largest(e_o, lost), turn, coarse=0.015),
    ]
    if at_half:
        pair = zip(("‖e_p‖", "‖Δε‖"), (e_p[now], e_o[now]), at_half, ("dm", ""), strict=True)
        rows += [
            sheet.row(there.format(e=e), of, float(ours), digest, unit, within=3e-4, coarse=0.02)
            for e, ours, digest, unit in pair
        ]
    for axis, digest in zip((0, 2), BY_AXIS.get(key, ()), strict=False):
        name, ours = "|e_x|" if axis == 0 else "|e_z|", 10 * abs(float(run.e[now, axis]))
        rows.append(sheet.row(there.format(e=name), of, ours, digest, "cm", within=0.02, coarse=0.01))
    return rows + _whole_rows(sheet, of, run)


def _whole_rows(sheet: Sheet, of: Text, run: Run) -> list[Row]:
    """Where both can be had again, and how fast the joints are; the first second has up to 18 rad/s at λ_p = 100."""
    back, later = (run.t >= 20) & (run.t <= 27), run.t > 1
    if not back.any():
        return []
    place = Text(en="largest ‖e_p‖ from 20 to 27 s", pt_BR="maior ‖e_p‖ de 20 a 27 s")
    turn = Text(en="largest ‖Δε‖ from 20 to 27 s", pt_BR="maior ‖Δε‖ de 20 a 27 s")
    after = Text(en="fastest joint after 1 s", pt_BR="junta mais rápida após 1 s")
    fastest = largest(run.rates, later)
    return [
        sheet.row(place, of, largest(sizes(run.e[back, :3])), "2e-5", "dm", within=3e-5, relation="≤"),
        sheet.row(turn, of, largest(sizes(run.e[back, 3:])), "3e-5", within=3e-5, relation="≤"),
        sheet.row(after, of, fastest, "1.0", "rad/s", within=0.1, relation="≥"),
        sheet.row(after, of, fastest, "2.5", "rad/s", within=0.1, relation="≤"),
        sheet.row(FASTEST, of, largest(run.rates), "18", "rad/s", within=1.0, relation="≤"),
    ]


def _charts(runs: Mapping[str, Run]) -> tuple[Chart, Chart]:
    """Both errors of every run."""
    e_p = tuple(Line(same(key), thinned(run.t), 10 * thinned(sizes(run.e[:, :3]))) for key, run in runs.items())
    e_o = tuple(Line(same(key), thinned(run.t), thinned(sizes(run.e[:, 3:]))) for key, run in runs.items())
    return (
        Chart(Text(en="error of position", pt_BR="erro de posição"), SECONDS, same("‖e_p‖, cm"), e_p),
        Chart(Text(en="error of orientation", pt_BR="erro de orientação"), SECONDS, same("‖Δε‖"), e_o),
    )
