"""Sim. 11 of Vargas 2013 from another start: beside the upright arm, where J is badly conditioned."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arm import DAMPED, DAMPING, PSEUDOINVERSE, followers, result
from helicoide.studies.vargas.arms import NEARLY_UPRIGHT
from helicoide.studies.vargas.crossing import Found, crossing_rows, pseudoinverse_rows
from helicoide.studies.vargas.paths import path_7
from helicoide.studies.vargas.runs import Way, way
from helicoide.studies.vargas.table import Gain, Sheet, Step, choice, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 11b: an ill-conditioned start", pt_BR="Simulação 11b: partida mal condicionada")
SOURCE = "Vargas 2013, §4.5, figs. 4.18–4.19"
ABOUT = Text(
    en="""The path of simulation 11, from a posture beside the upright arm. Look at δ: damping stays on for more than \
twenty seconds and the arm does not follow, since small joint rates count more than the path. The filtered inverse is \
on the path within a few seconds.""",
    pt_BR="""O caminho da simulação 11, a partir de uma postura junto ao braço na vertical. Observe δ: o \
amortecimento fica ligado por mais de vinte segundos e o braço não acompanha, pois velocidades pequenas contam mais \
do que o caminho. A inversa filtrada chega ao caminho em poucos segundos.""",
)
ROBOT = "zebra_zero"
FOUND = {
    "filtered": Found("4.33", "0.134", "0.0016", "4.7e-4", (0.05, 0.005, None, None)),
    "modified": Found("5.88", "0.134", "0.0008", "4.8e-4", (0.08, 0.005, None, None)),
    "damping": Found("9.30", "9.30", "5.07", "2.54", (None, None, 1e-3, None)),
}


def ways_of(gain: float) -> dict[str, Way]:
    """The filtered inverses with their γ, and the others."""
    filtered, modified = way("filtered", gain=gain), way("filtered_modified", gain=gain)
    return {"filtered": filtered, "modified": modified, "damping": DAMPING, "pseudoinverse": PSEUDOINVERSE}


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(cm² s); dt, s; shown: whose motion the arm shows."""

    gain: Gain = 1.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(1.0))] = "filtered"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Four methods on trajectory 7, for 40 s, 20 s in the short form."""
    ways, sheet = ways_of(options.gain), Sheet(short, is_changed(options))
    dt, seconds = (max(options.dt, 5e-3), 20.0) if short else (options.dt, 40.0)
    runs = followers(path_7, NEARLY_UPRIGHT, ways, dt, seconds, progress)
    rows = crossing_rows(sheet, ways, runs, FOUND, 1, "")
    rows += pseudoinverse_rows(sheet, runs["pseudoinverse"], "898", "0.0029")
    damped = runs["damping"]
    first = damped.t <= 20
    free = np.append(damped.t[damped.w >= DAMPED["threshold"]], np.inf)[0]
    off = Text(en="share of the first 20 s more than 1 cm off", pt_BR="parte dos primeiros 20 s a mais de 1 cm")
    until = Text(en="damping is on until", pt_BR="amortecimento ligado até")
    rows += [
        sheet.row(Text(en="w at the start", pt_BR="w na partida"), None, float(damped.w[0]), "306", "cm³", coarse=0.0),
        sheet.row(until, None, float(free), "22.25", "s"),
        sheet.row(off, DAMPING.title, float(np.mean(damped.size[first] > 1)), "0.5", relation="≥", coarse=0.0),
    ]
    for key in ("filtered", "modified"):
        late = runs[key].size[runs[key].t >= 5]
        title = Text(en="error from 5 s on, at most", pt_BR="erro a partir de 5 s, no máximo")
        rows.append(sheet.row(title, ways[key].title, float(late.max()), "0.002", "cm", relation="≤", coarse=0.5))
    return result(rows, ways, runs, options.shown)
