"""Sim. 11 of Vargas 2013: through singular postures of the shoulder, where the filtered inverse is at its best."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.kinematics.chain import Array
from helicoide.studies.study import Progress, Result, Row
from helicoide.studies.vargas.arm import DAMPING, PSEUDOINVERSE, SQUARED, followers, result
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.crossing import Found, crossing_rows, pseudoinverse_rows
from helicoide.studies.vargas.paths import path_7
from helicoide.studies.vargas.runs import Run, Way, largest, way
from helicoide.studies.vargas.table import Gain, Sheet, Step, choice, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 11: through singular postures", pt_BR="Simulação 11: através de singularidades")
SOURCE = "Vargas 2013, §4.5, sim. 11, figs. 4.12–4.17"
ABOUT = Text(
    en="""The path crosses the axis of the waist every five seconds, where the shoulder is singular and the \
pseudoinverse asks for ten thousand radians a second. Look at the error at those instants: damping leaves the path by \
millimetres, the filtered inverse by a quarter of one, at the same joint rates. Compare V_c with δ: both rise where J \
is badly conditioned.""",
    pt_BR="""O caminho cruza o eixo da cintura a cada cinco segundos, onde o ombro é singular e a pseudoinversa pede \
dez mil radianos por segundo. Observe o erro nesses instantes: o amortecimento sai do caminho por milímetros, a \
inversa filtrada por um quarto de milímetro, com as mesmas velocidades de junta. Compare V_c com δ: ambos crescem \
onde J é mal condicionado.""",
)
ROBOT = "zebra_zero"
FOUND = {
    "filtered": Found("2.76", "0.134", "0.0246", "0.0046", (0.02, 0.005, 0.05, 0.05)),
    "modified": Found("2.75", "0.134", "0.0054", "0.0011", (0.02, 0.005, 0.05, None)),
    "damping": Found("2.82", "0.139", "0.260", "0.056", (0.01, 0.005, 0.05, 0.05)),
    "squared": Found("2.82", "0.131", "0.189", "0.039", (0.01, 0.005, 0.05, 0.05)),
}
# the largest joint acceleration from 5 s on, rad/s²
JERKY = {"filtered": "0.254", "modified": "0.055", "damping": "4.69"}


def ways_of(gain: float) -> dict[str, Way]:
    """The filtered inverses with their γ, and the others."""
    filtered, modified = way("filtered", gain=gain), way("filtered_modified", gain=gain)
    rest = {"damping": DAMPING, "squared": SQUARED, "pseudoinverse": PSEUDOINVERSE}
    return {"filtered": filtered, "modified": modified, **rest}


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(cm² s); dt, s; shown: whose motion the arm shows."""

    gain: Gain = 1.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(1.0))] = "filtered"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 7, for 20 s."""
    ways, sheet = ways_of(options.gain), Sheet(short, is_changed(options))
    runs = followers(path_7, FOLDED, ways, max(options.dt, 5e-3) if short else options.dt, 20.0, progress)
    rows = crossing_rows(sheet, ways, runs, FOUND, 1, "")
    rows += pseudoinverse_rows(sheet, runs["pseudoinverse"], "10710", "0.011")
    push = Text(en="largest acceleration from 5 s on", pt_BR="maior aceleração a partir de 5 s")
    for key, most in JERKY.items():
        found = runs[key].push
        rows.append(sheet.row(push, ways[key].title, largest(found, runs[key].t[1:] >= 5), most, "rad/s²"))
    rows += _of_theta(sheet, runs["filtered"], runs["damping"])
    return result(rows, ways, runs, options.shown)


def _of_theta(sheet: Sheet, filtered: Run, damped: Run) -> list[Row]:
    """How near to singular the arm comes, how large Θ becomes, and how alike V_c and δ are."""
    later = filtered.shown >= 5
    V_c, delta = filtered.figure("V_c"), damped.figure("δ")
    smallest = Text(en="smallest singular value", pt_BR="menor valor singular")
    alike = Text(en="correlation of V_c and δ from 5 s on", pt_BR="correlação de V_c e δ a partir de 5 s")
    sigma: Array = filtered.sigma[filtered.t >= 5, -1]
    return [
        sheet.row(smallest, None, float(sigma.min()), "9e-5", "cm"),
        sheet.row(Text(en="largest ‖Θ‖", pt_BR="maior ‖Θ‖"), None, float(filtered.figure("‖Θ‖").max()), "0.81", "1/cm"),
        sheet.row(Text(en="largest V_c", pt_BR="maior V_c"), None, float(V_c[later].max()), "2.05"),
        sheet.row(alike, None, float(np.corrcoef(V_c[later], delta[later])[0, 1]), "0.61"),
    ]
