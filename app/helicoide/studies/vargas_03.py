"""Sim. 3 of Vargas 2013: six joints pass near a singular posture of the shoulder."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from math import pi
from typing import Annotated

import numpy as np

from helicoide.kinematics.chain import Array
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.studies.vargas.arms import TOOL_DOWN, zebra_wrist
from helicoide.studies.vargas.paths import faster, path_10
from helicoide.studies.vargas.runs import POSE, Run, Way, each, largest, record, sizes, tracking, turned, way
from helicoide.studies.vargas.table import (
    SECONDS,
    Gain,
    Sheet,
    Step,
    choice,
    is_changed,
    rates_chart,
    thinned,
    zebra_motion,
)
from helicoide.text import Text, same

TITLE = Text(en="Simulation 3: past the shoulder's singularity", pt_BR="Simulação 3: rente à singularidade do ombro")
SOURCE = "Vargas 2013, §3.3, sim. 3, figs. 3.4–3.5"
ABOUT = Text(
    en="""The wrist passes close to the axis of the waist while the hand keeps its orientation. Look at the wrist's \
joints at that moment: the inverse turns them at 14 rad/s, and at 35 rad/s when the path is run faster. All others \
let the orientation go for a while and find it again; the modified filtered inverse keeps the position best.""",
    pt_BR="""O punho passa rente ao eixo da cintura enquanto a mão mantém a orientação. Observe as juntas do punho \
nesse instante: a inversa as gira a 14 rad/s, e a 35 rad/s quando o caminho é percorrido mais depressa. Todos os \
outros largam a orientação por um momento e a recuperam; a inversa filtrada modificada é a que melhor mantém a \
posição.""",
)
ROBOT = "zebra_zero"
ASSUMED = Text(
    en="start, with the hand downwards; time as printed in App. C", pt_BR="partida, mão para baixo; tempo como no Ap. C"
)
ARM = Text(en="fastest joint of the arm after 3 s", pt_BR="junta mais rápida do braço após 3 s")
WRIST = Text(en="fastest joint of the wrist after 3 s", pt_BR="junta mais rápida do punho após 3 s")
OFF = Text(en="largest error of position after 3 s", pt_BR="maior erro de posição após 3 s")
ASKEW = Text(en="largest error of orientation after 3 s", pt_BR="maior erro de orientação após 3 s")
# Of the digest: joints of the arm and of the wrist, rad/s; errors, cm and degrees. The inverse's error of position is
# 3e-4 cm with q by Euler's rule; the digest has 1e-4 on the exact path. Last: the share that the short form may miss.
Found = tuple[str, str, str, str, tuple[float | None, float | None, float | None, float | None]]
FOUND: dict[str, Found] = {
    "inverse": ("1.56", "14.1", "1e-4", "0.10", (0.02, None, None, None)),
    "damping_0.01": ("1.40", "6.67", "0.260", "26.1", (None, None, None, None)),
    "damping_0.1": ("1.35", "1.29", "0.093", "11.4", (0.02, 0.05, 0.05, 0.05)),
    "damping_1": ("1.19", "0.95", "0.409", "20.6", (0.02, 0.05, 0.05, 0.05)),
    "filtered_1": ("1.53", "1.47", "0.178", "67.1", (0.02, 0.05, 0.05, 0.05)),
    "filtered_10": ("1.49", "2.19", "0.283", "45.8", (0.02, 0.05, 0.05, 0.05)),
    "modified_1": ("1.59", "1.48", "0.196", "16.4", (0.02, 0.05, 0.05, 0.05)),
    "modified_10": ("1.49", "1.42", "0.045", "19.7", (0.02, 0.05, 0.05, 0.05)),
}
AT_SPEED = {"inverse": ("3.89", "35.5"), "filtered_1": ("3.46", "3.14"), "modified_1": ("3.77", "3.08")}
COARSE_AT_SPEED = {"inverse": (0.02, None), "filtered_1": (0.02, 0.05), "modified_1": (0.02, 0.05)}
FAST = 2.5
AT = Text(en="{of}, 2.5 times as fast", pt_BR="{of}, 2,5 vezes mais rápido")


def ways_of(gain: float) -> dict[str, Way]:
    """The inverse, three dampings, and the filtered inverses with γ and ten times it."""
    damped = {
        f"damping_{delta:g}": way("damped_by_manipulability", f"δ₀ = {delta:g}", damping=delta, threshold=1e3)
        for delta in (0.01, 0.1, 1.0)
    }
    filtered = {
        f"{kind}_{times}": way(name, f"γ = {times * gain:g}", gain=times * gain)
        for kind, name in (("filtered", "filtered"), ("modified", "filtered_modified"))
        for times in (1, 10)
    }
    return {"inverse": way("inverse"), **damped, **filtered}


@dataclass(frozen=True)
class Options:
    """gain: the smaller γ, 1/(cm² s); dt, s, half of it at speed; shown: whose motion the arm shows."""

    gain: Gain = 1.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(1.0))] = "modified_10"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Eight methods with λ = 5 on trajectory 10, three of them also at 2.5 times its speed."""
    arm, ways, sheet = zebra_wrist(), ways_of(options.gain), Sheet(short, is_changed(options))
    dt = max(options.dt, 1e-2) if short else options.dt
    usual, fast = (tracking(arm, faster(path_10, k), POSE, turned(1, pi / 2)) for k in (1.0, FAST))
    half = max(options.dt, 5e-3) if short else dt / 2
    plans = {(key, 1.0): partial(record, arm, one, usual, 5.0, TOOL_DOWN, dt, 31.5) for key, one in ways.items()}
    plans |= {(key, FAST): partial(record, arm, ways[key], fast, 5.0, TOOL_DOWN, half, 12.6) for key in AT_SPEED}
    runs = each(plans, progress)
    slow = {key: runs[key, 1.0] for key in ways}
    rows = [row for key, found in FOUND.items() for row in _passage(sheet, ways[key].title, slow[key], found)]
    rows += _recovered(sheet, ways["modified_10"].title, slow["modified_10"])
    for key, found in AT_SPEED.items():
        rows += _speeds(sheet, AT.format(of=ways[key].title), runs[key, FAST], found, COARSE_AT_SPEED[key])
    return Result(tuple(rows), _charts(ways, slow, options.shown), zebra_motion(slow[options.shown]))


def angles(run: Run) -> Array:
    """The angle of the error of orientation, (k,), degrees: e is sin(ϑ/2) times its axis."""
    return np.asarray(np.degrees(2 * np.arcsin(np.minimum(1, sizes(run.e[:, 3:])))))


def _speeds(
    sheet: Sheet, of: Text, run: Run, found: tuple[str, str], coarse: tuple[float | None, float | None]
) -> list[Row]:
    """The fastest joints of arm and wrist."""
    later = run.t > 3
    return [
        sheet.row(title, of, largest(rates, later), digest, "rad/s", coarse=share, assumed=ASSUMED)
        for title, rates, digest, share in zip(
            (ARM, WRIST), (run.rates[:, :3], run.rates[:, 3:]), found, coarse, strict=True
        )
    ]


def _passage(sheet: Sheet, of: Text, run: Run, found: Found) -> list[Row]:
    of_arm, of_wrist, position, orientation, (a, b, c, d) = found
    later = run.t > 3
    off, askew = largest(sizes(run.e[:, :3]), later), largest(angles(run), later)
    return [
        *_speeds(sheet, of, run, (of_arm, of_wrist), (a, b)),
        sheet.row(OFF, of, off, position, "cm", coarse=c, assumed=ASSUMED),
        sheet.row(ASKEW, of, askew, orientation, "°", coarse=d, assumed=ASSUMED),
    ]


def _recovered(sheet: Sheet, of: Text, run: Run) -> list[Row]:
    """What is left of the passage after 29 s."""
    late = run.t > 29
    position = Text(en="error of position after 29 s", pt_BR="erro de posição após 29 s")
    orientation = Text(en="error of orientation ‖Δε‖ after 29 s", pt_BR="erro de orientação ‖Δε‖ após 29 s")
    return [
        sheet.row(position, of, largest(run.e[late, :3]), "9e-5", "cm", within=3e-5, relation="≤", coarse=10.0),
        sheet.row(orientation, of, largest(run.e[late, 3:]), "8e-4", within=4e-4, relation="≤", coarse=0.5),
    ]


def _charts(ways: Mapping[str, Way], runs: Mapping[str, Run], shown: str) -> tuple[Chart, ...]:
    """Errors of position and orientation, the condition number, and the joint rates of the inverse and another."""

    def chart(title: Text, up: str, value: Callable[[Run], Array]) -> Chart:
        lines = (Line(ways[key].title, thinned(run.t), thinned(value(run))) for key, run in runs.items())
        return Chart(title, SECONDS, same(up), tuple(lines))

    return (
        chart(Text(en="error of position", pt_BR="erro de posição"), "‖e_p‖, cm", lambda run: sizes(run.e[:, :3])),
        chart(Text(en="error of orientation", pt_BR="erro de orientação"), "ϑ, °", angles),
        chart(Text(en="condition number", pt_BR="número de condição"), "σ₁/σ₆", condition),
        *(rates_chart(runs[key], ways[key].title) for key in dict.fromkeys(("inverse", shown))),
    )


def condition(run: Run) -> Array:
    """σ₁/σ₆ of J, lengths in cm, (k,)."""
    return np.asarray(run.sigma[:, 0] / run.sigma[:, -1])
