"""Sim. 10 of Vargas 2013: the filtered inverse where nothing is singular."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from helicoide.studies.study import Progress, Result, Row, printed
from helicoide.studies.vargas.arm import DAMPING, SINCE, Drawing, followers, result
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.crossing import crossing_rows
from helicoide.studies.vargas.paths import path_6
from helicoide.studies.vargas.readings import EXACT_STEP
from helicoide.studies.vargas.runs import Run, Way, largest, way
from helicoide.studies.vargas.table import MOVED, GainInCm, Step, row, stated
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
PLACE = "sim. 10, figs. 4.8–4.11"


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(cm² s); dt, s."""

    gain: GainInCm = 1.0
    dt: Step = 2e-3

    @property
    def ways(self) -> dict[str, Way]:
        """The filtered inverse, and what it is compared with."""
        return {"filtered": way("filtered", f"γ = {self.gain:g}", gain=self.gain), "damping": DAMPING}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Two methods on trajectory 6; 8 s of it in a quick run."""
    ways = options.ways
    dt, seconds = (max(options.dt, 5e-3), 8.0) if short else (options.dt, 20.0)
    runs = followers(path_6, FOLDED, ways, dt, seconds, progress)
    rows = [*_statements(ways, runs), *crossing_rows(ways, runs, PLACE, slow=printed("< 0.2", PLACE))]
    return result(rows, ways, runs, Drawing(path_6, (0, 1), PLACE, "fig. 4.9"), ("filtered", "damping"))


def _statements(ways: Mapping[str, Way], runs: Mapping[str, Run]) -> list[Row]:
    """That nothing damps, how alike the methods are, and how they start."""
    filtered, damped = runs["filtered"], runs["damping"]
    later = filtered.t >= SINCE
    never = stated("δ = 0", "δ = 0", PLACE, 0.0)
    alike = stated("practically identical", "praticamente idênticos", PLACE, MOVED, "<")
    apart = Text(en="largest difference of a joint from 5 s on", pt_BR="maior diferença de uma junta a partir de 5 s")
    first = Text(en="fastest joint in the first instant", pt_BR="junta mais rápida no primeiro instante")
    return [
        row(
            Text(en="largest damping δ", pt_BR="maior amortecimento δ"),
            None,
            float(damped.figure("δ").max()),
            "cm²",
            never,
        ),
        row(apart, None, largest(filtered.q - damped.q, later), "rad", alike, fitted=(EXACT_STEP,)),
        row(first, ways["filtered"].title, float(np.abs(filtered.rates[0]).max()), "rad/s"),
        row(first, ways["damping"].title, float(np.abs(damped.rates[0]).max()), "rad/s"),
    ]
