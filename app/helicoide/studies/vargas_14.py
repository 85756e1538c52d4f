"""Sim. 14 of Vargas 2013: out of reach, the gains say what counts more, position or orientation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from math import pi

import numpy as np

from helicoide.studies.study import Chart, Figure, Fitted, Interpretation, Progress, Result, Row, Statement
from helicoide.studies.vargas.arms import TOOL_DOWN, zebra
from helicoide.studies.vargas.paths import Vector, path_11, path_points
from helicoide.studies.vargas.readings import EXACT_STEP
from helicoide.studies.vargas.runs import (
    POSE,
    Experiment,
    MethodRun,
    largest_absolute,
    method_settings,
    rotation_about,
    row_norms,
    run_each,
    run_method,
    tracking,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    GainInDm,
    Step,
    fastest_chart,
    joint_velocity_chart,
    joints_chart,
    over_time,
    path_chart,
    run_row,
    sentence_statement,
    study_result,
    zebra_motions,
)
from helicoide.text import Text

TITLE = Text(en="Simulation 14: gains as priorities", pt_BR="Simulação 14: ganhos como prioridades")
SOURCE = "Vargas 2013, §4.6, sim. 14, figs. 4.34–4.36"
ABOUT = Text(
    en="""For a while the path asks for a place and an orientation that the arm cannot have together. Look at both \
errors: the modified law rests where the weighted errors are least, so that the larger gain wins. Only the ratio of \
the gains counts: compare 10, 10 with 100, 100. A larger gain for one axis favours that axis.""",
    pt_BR="""Durante algum tempo o caminho pede um lugar e uma orientação que o braço não pode ter juntos. Observe os \
dois erros: a lei modificada repousa onde os erros ponderados são mínimos, de modo que o ganho maior vence. Só a razão \
entre os ganhos conta: compare 10, 10 com 100, 100. Um ganho maior em um eixo favorece esse eixo.""",
)
ROBOT = "zebra_zero"
HALF, PLACE = 7.854, "sim. 14, figs. 4.34–4.36"  # s: when trajectory 11 is farthest
FARTHEST = Interpretation(
    Text(en="read when the path is farthest, 7.854 s", pt_BR="lido quando o caminho está mais longe, 7,854 s"),
    Text(
        en="the root mean square errors from 2 to 14.2 s have the ratios 0.12, 0.35, 0.16 and 0.16",
        pt_BR="os valores eficazes dos erros de 2 a 14,2 s estão nas razões 0,12; 0,35; 0,16 e 0,16",
    ),
)
EQUAL = Fitted(Text(en="equal gains", pt_BR="ganhos iguais"), 10, 1, 100, "s⁻¹")
ONE_AXIS = Fitted(Text(en="larger gain of one axis", pt_BR="ganho maior de um eixo"), 100, 20, 300, "s⁻¹")
# Λ_p by axes, and λ_o
Gains = tuple[float, float, float, float]
CASES: dict[str, Gains] = {
    "100, 10": (100, 100, 100, 10),
    "10, 10": (10, 10, 10, 10),
    "100, 100": (100, 100, 100, 100),
    "10, 100": (10, 10, 10, 100),
    "diag(100, 10, 10), 100": (100, 10, 10, 100),
    "diag(10, 10, 100), 100": (10, 10, 100, 100),
}
# those whose gains the source prints
PRINTED = ("100, 10", "10, 100")


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(dm² s); dt, s."""

    gain: GainInDm = 25.0
    dt: Step = 5e-4


def weighted_run(
    gains: Gains, gain: float, dt: float, seconds: float, progress: Progress = lambda share: None
) -> MethodRun:
    """The effector on trajectory 11, R_d = R_y(π), by the modified law, dm. Args: gains of x, y, z and orientation."""
    arm = zebra()

    def in_dm(t: float) -> tuple[Vector, Vector]:
        (x, y, z), (a, b, c) = path_11(t)
        return (x / 10, y / 10, z / 10), (a / 10, b / 10, c / 10)

    rows = np.array([*gains[:3], *[gains[3]] * 3])
    aiming = tracking(arm, in_dm, POSE, rotation_about(1, pi))
    experiment = Experiment(arm, aiming, rows, TOOL_DOWN, dt, seconds)
    return run_method(experiment, method_settings("filtered_modified", gain=gain), progress)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Six pairs of gains for 32 s; to the farthest point in a quick run."""
    dt, seconds = (max(options.dt, 8e-3), 10.0) if short else (options.dt, 32.0)
    runs = run_each(
        {key: partial(weighted_run, case, options.gain, dt, seconds) for key, case in CASES.items()}, progress
    )
    rows = _statements(runs)
    for key, one in runs.items():
        rows += _errors(NAMES[key], one, key in PRINTED)
    if not short:
        for key, one in runs.items():
            rows += _back(NAMES[key], one, key in PRINTED)
    return study_result(rows, _charts(runs), zebra_motions({NAMES[key]: one for key, one in runs.items()}))


NAMES = {key: Text(en=f"Λₚ, λₒ = {key}", pt_BR=f"Λₚ, λₒ = {key}") for key in CASES}


def errors_at_farthest(run: MethodRun) -> tuple[float, float, float, float]:
    """|e_x|, |e_z| and ‖e_p‖, cm, and ‖Δε‖ when the trajectory is farthest."""
    e = run.e[int(np.abs(run.t - HALF).argmin())]
    return (
        10 * abs(float(e[0])),
        10 * abs(float(e[2])),
        10 * float(np.hypot.reduce(e[:3])),
        float(np.hypot.reduce(e[3:])),
    )


def _statements(runs: Mapping[str, MethodRun]) -> list[Row]:
    """That the larger gain wins: an error with it, times that with equal gains."""
    ends = {key: errors_at_farthest(one) for key, one in runs.items()}
    wins = sentence_statement("the larger gain wins", "o ganho maior vence", PLACE, 1.0, "<")
    favours = sentence_statement("diagonal Λₚ favours one axis", "Λₚ diagonal favorece um eixo", PLACE, 1.0, "<")
    cases: list[tuple[str, int, str, str, Statement, Fitted]] = [
        ("‖e_p‖", 2, "100, 10", "10, 10", wins, EQUAL),
        ("‖Δε‖", 3, "10, 100", "10, 10", wins, EQUAL),
        ("|e_x|", 0, "diag(100, 10, 10), 100", "10, 100", favours, ONE_AXIS),
        ("|e_z|", 1, "diag(10, 10, 100), 100", "10, 100", favours, ONE_AXIS),
    ]
    title = Text(
        en="{e} at 7.854 s, gains ({first}) over ({second})", pt_BR="{e} em 7,854 s, ganhos ({first}) sobre ({second})"
    )
    return [
        run_row(
            title.format(e=e, first=first, second=second),
            None,
            ends[first][i] / ends[second][i],
            "",
            said,
            fitted=(value, FARTHEST, EXACT_STEP),
        )
        for e, i, first, second, said, value in cases
    ]


def _errors(of: Text, run: MethodRun, printed: bool) -> list[Row]:
    there = Text(en="{e} at 7.854 s", pt_BR="{e} em 7,854 s")
    _, _, position, turn = errors_at_farthest(run)
    shown = Figure(PLACE) if printed else None
    return [
        run_row(there.format(e="‖e_p‖"), of, position, "cm", shown),
        run_row(there.format(e="‖Δε‖"), of, turn, "", shown),
    ]


def _back(of: Text, run: MethodRun, printed: bool) -> list[Row]:
    """Where both can be had again."""
    shown = Figure(PLACE) if printed else None
    back = (run.t >= 20) & (run.t <= 27)
    place = Text(en="largest ‖e_p‖ from 20 to 27 s", pt_BR="maior ‖e_p‖ de 20 a 27 s")
    turn = Text(en="largest ‖Δε‖ from 20 to 27 s", pt_BR="maior ‖Δε‖ de 20 a 27 s")
    return [
        run_row(place, of, 10 * largest_absolute(row_norms(run.e[back, :3])), "cm", shown),
        run_row(turn, of, largest_absolute(row_norms(run.e[back, 3:])), "", shown),
    ]


def _charts(runs: Mapping[str, MethodRun]) -> list[Chart]:
    """Both errors of every run, the errors by axes, the way, and the joints of the first."""
    names, first = {NAMES[key]: one for key, one in runs.items()}, next(iter(runs))
    one, desired = runs[first], path_points(path_11, runs[first].t)
    ways = {name: (desired - 10 * run.e[:, :3])[:, ::2] for name, run in names.items()}
    position = Text(en="error of position", pt_BR="erro de posição")
    turn = Text(en="error of orientation", pt_BR="erro de orientação")
    by_axis = Text(en="error of position along {axis}", pt_BR="erro de posição em {axis}")
    return [
        over_time(position, "‖e_p‖, cm", names, lambda run: 10 * row_norms(run.e[:, :3]), PLACE),
        over_time(turn, "‖Δε‖", names, lambda run: row_norms(run.e[:, 3:]), PLACE),
        over_time(by_axis.format(axis="x"), "e_x, cm", names, lambda run: 10 * run.e[:, 0], PLACE),
        over_time(by_axis.format(axis="z"), "e_z, cm", names, lambda run: 10 * run.e[:, 2], PLACE),
        path_chart({DESIRED: desired[:, ::2], **ways}, "x, cm", "z, cm"),
        joint_velocity_chart(one, NAMES[first], PLACE),
        joints_chart(one, NAMES[first]),
        fastest_chart(names),
    ]
