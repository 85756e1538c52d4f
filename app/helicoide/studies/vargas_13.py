"""Sim. 13 of Vargas 2013: a path that leaves the workspace, by the modified filtered inverse."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arm import dips, followers, off_the_border, re_entry, result
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.paths import path_8
from helicoide.studies.vargas.reach import Found, reach_rows
from helicoide.studies.vargas.runs import Way, way
from helicoide.studies.vargas.table import Gain, Sheet, Step, choice, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 13: out of reach, at rest", pt_BR="Simulação 13: fora do alcance, em repouso")
SOURCE = "Vargas 2013, §4.6, sim. 13, figs. 4.29–4.33"
ABOUT = Text(
    en="""The path of simulation 12 by the modified law, q̇ = ΘΘᵀJᵀν, which drops what the arm cannot reach. Look at \
the error out of reach: the elbow does not swing any more, and the effector rests on the border at the point nearest \
to the path. With the larger γ it is back on the path within a quarter of a second.""",
    pt_BR="""O caminho da simulação 12 pela lei modificada, q̇ = ΘΘᵀJᵀν, que descarta o que o braço não alcança. \
Observe o erro fora do alcance: o cotovelo já não oscila e o efetuador repousa na fronteira, no ponto mais próximo do \
caminho. Com o γ maior ele volta ao caminho em um quarto de segundo.""",
)
ROBOT = "zebra_zero"
BACK = {1: ("0.57", "1.15", "0.10"), 25: ("0.017", "0.013", "0.006")}
FOUND = {
    "modified_1": Found("4.91", "1.156", "0.155", BACK[1], "0.04", "111", (0.05, 0.05, None, 0.05)),
    "modified_25": Found("5.71", "0.099", "0.007", BACK[25], "0", "397", (0.12, None, None, None)),
}


def ways_of(gain: float) -> dict[str, Way]:
    """The modified filtered inverse with γ and twenty-five times it."""
    return {f"modified_{k}": way("filtered_modified", f"γ = {k * gain:g}", gain=k * gain) for k in (1, 25)}


@dataclass(frozen=True)
class Options:
    """gain: the smaller γ, 1/(cm² s); dt, s; shown: whose motion the arm shows."""

    gain: Gain = 1.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(1.0))] = "modified_25"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Two gains on trajectory 8 for 20 s, 15 s in the short form."""
    ways, sheet = ways_of(options.gain), Sheet(short, is_changed(options))
    dt, seconds = (max(options.dt, 2e-3), 15.0) if short else (options.dt, 20.0)
    runs = followers(path_8, FOLDED, ways, dt, seconds, progress)
    rows = [row for key, found in FOUND.items() for row in reach_rows(sheet, ways[key], runs[key], found)]
    large, of = runs["modified_25"], ways["modified_25"].title
    off = Text(
        en="largest distance from the nearest point of the border", pt_BR="maior distância ao ponto da fronteira"
    )
    swings = Text(en="dips behind the border", pt_BR="recuos atrás da fronteira")
    back = Text(en="largest error after coming back", pt_BR="maior erro após a volta")
    rows += [
        sheet.row(off, of, off_the_border(large), "0.013", "cm", within=5e-4, relation="≤", coarse=0.04),
        sheet.row(swings, of, float(dips(large)[0].size), "0", within=0.0, coarse=0.0, source="0"),
        sheet.row(back, of, max(re_entry(large)), "0.02", "cm", relation="≤", coarse=0.0),
    ]
    return result(rows, ways, runs, options.shown)
