"""Sim. 10 of Vargas 2013: the filtered inverse where nothing is singular."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from helicoide.studies.study import Progress, Result, Row, printed_statement
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.crossing import axis_crossing_rows
from helicoide.studies.vargas.paths import path_6
from helicoide.studies.vargas.position_arm import DAMPING, SINCE, Drawing, position_result, run_on_zebra
from helicoide.studies.vargas.readings import EXACT_STEP
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute, method_settings
from helicoide.studies.vargas.table import MOTION_THRESHOLD, GainInCm, Step, run_row, sentence_statement
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
    def ways(self) -> dict[str, MethodSettings]:
        """The filtered inverse, and what it is compared with."""
        return {"filtered": method_settings("filtered", f"γ = {self.gain:g}", gain=self.gain), "damping": DAMPING}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Two methods on trajectory 6; 8 s of it in a quick run."""
    ways = options.ways
    dt, seconds = (max(options.dt, 5e-3), 8.0) if short else (options.dt, 20.0)
    runs = run_on_zebra(path_6, FOLDED, ways, dt, seconds, progress)
    rows = [*_statements(ways, runs), *axis_crossing_rows(ways, runs, PLACE, slow=printed_statement("< 0.2", PLACE))]
    return position_result(rows, ways, runs, Drawing(path_6, (0, 1), PLACE, "fig. 4.9"), ("filtered", "damping"))


def _statements(ways: Mapping[str, MethodSettings], runs: Mapping[str, MethodRun]) -> list[Row]:
    """That nothing damps, how alike the methods are, and how they start."""
    filtered, damped = runs["filtered"], runs["damping"]
    later = filtered.t >= SINCE
    never = sentence_statement("δ = 0", "δ = 0", PLACE, 0.0)
    alike = sentence_statement("practically identical", "praticamente idênticos", PLACE, MOTION_THRESHOLD, "<")
    apart = Text(en="largest difference of a joint from 5 s on", pt_BR="maior diferença de uma junta a partir de 5 s")
    first = Text(en="fastest joint in the first instant", pt_BR="junta mais rápida no primeiro instante")
    return [
        run_row(
            Text(en="largest damping δ", pt_BR="maior amortecimento δ"),
            None,
            float(damped.figure("δ").max()),
            "cm²",
            never,
        ),
        run_row(apart, None, largest_absolute(filtered.q - damped.q, later), "rad", alike, fitted=(EXACT_STEP,)),
        run_row(first, ways["filtered"].title, float(np.abs(filtered.joint_velocities[0]).max()), "rad/s"),
        run_row(first, ways["damping"].title, float(np.abs(damped.joint_velocities[0]).max()), "rad/s"),
    ]
