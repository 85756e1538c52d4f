"""Sim. 10 of Vargas 2013: the filtered inverse where nothing is singular."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arm import DAMPING, PSEUDOINVERSE, followers, result
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.crossing import Found, crossing_rows
from helicoide.studies.vargas.paths import path_6
from helicoide.studies.vargas.runs import Way, largest, way
from helicoide.studies.vargas.table import APART, Gain, Sheet, Step, choice, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 10: away from singular postures", pt_BR="Simulação 10: longe de singularidades")
SOURCE = "Vargas 2013, §4.5, sim. 10, figs. 4.8–4.11"
ABOUT = Text(
    en="""Three joints of the Zebra-ZERO draw a figure of eight in the middle of the workspace. Look at the first two \
seconds: the filtered inverse starts from rest, since Θ begins at zero, and then moves exactly as the pseudoinverse \
does. The damping never comes on.""",
    pt_BR="""Três juntas do Zebra-ZERO desenham um oito no meio do espaço de trabalho. Observe os dois primeiros \
segundos: a inversa filtrada parte do repouso, pois Θ começa em zero, e depois se move exatamente como a \
pseudoinversa. O amortecimento nunca entra.""",
)
ROBOT = "zebra_zero"
# What the digest has is read every 20 ms: the first peak of the filtered inverse, 0.824 rad/s, falls between.
EVERY = 0.02
FOUND = {
    "filtered": Found("0.761", "0.133", None, "8.3e-4", (0.03, 0.015, None, 1.6)),
    "damping": Found("0.842", "0.133", None, "7.5e-4", (1e-3, 0.015, None, 1.6)),
    "pseudoinverse": Found("0.842", "0.133", None, "7.5e-4", (1e-3, 0.015, None, 1.6)),
}


def ways_of(gain: float) -> dict[str, Way]:
    """The filtered inverse with its γ, and the others."""
    return {"filtered": way("filtered", gain=gain), "damping": DAMPING, "pseudoinverse": PSEUDOINVERSE}


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(cm² s); dt, s; shown: whose motion the arm shows."""

    gain: Gain = 1.0
    dt: Step = 2e-3
    shown: Annotated[str, choice(ways_of(1.0))] = "filtered"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three methods on trajectory 6; 8 s of it in the short form."""
    ways, sheet = ways_of(options.gain), Sheet(short, is_changed(options))
    dt, seconds = (max(options.dt, 5e-3), 8.0) if short else (options.dt, 20.0)
    runs = followers(path_6, FOLDED, ways, dt, seconds, progress)
    rows = crossing_rows(sheet, ways, runs, FOUND, max(1, round(EVERY / dt)), "< 0.2")
    filtered, damped, plain = (runs[key] for key in ("filtered", "damping", "pseudoinverse"))
    never = Text(en="largest damping δ", pt_BR="maior amortecimento δ")
    later = filtered.t >= 5
    rows += [
        sheet.row(never, None, float(damped.figure("δ").max()), "0", "cm²", within=0.0, coarse=0.0, source="0"),
        sheet.row(APART, DAMPING.title, largest(damped.q - plain.q), "0", "rad", within=1e-12, coarse=0.0),
        sheet.row(
            Text(en="the same from 5 s on", pt_BR="o mesmo a partir de 5 s"),
            ways["filtered"].title,
            largest(filtered.q - plain.q, later),
            "0",
            "rad",
            within=2e-3,
            coarse=0.0,
        ),
        sheet.row(
            Text(en="fastest joint in the first instant", pt_BR="junta mais rápida no primeiro instante"),
            ways["filtered"].title,
            float(np.abs(filtered.rates[0]).max()),
            "0",
            "rad/s",
            within=0.0,
            coarse=0.0,
        ),
    ]
    return result(rows, ways, runs, options.shown)
