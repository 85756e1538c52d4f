"""Sim. 11 of Vargas 2013 from another start: beside the upright arm, where J is badly conditioned."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.studies.study import Interpretation, Progress, Result, Row
from helicoide.studies.vargas.arms import NEARLY_UPRIGHT, REACH
from helicoide.studies.vargas.crossing import axis_crossing_rows
from helicoide.studies.vargas.paths import path_7
from helicoide.studies.vargas.position_arm import (
    DAMPED,
    DAMPING,
    PSEUDOINVERSE,
    SINCE,
    Drawing,
    position_result,
    run_on_zebra,
)
from helicoide.studies.vargas.readings import EXPONENT
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute, method_settings
from helicoide.studies.vargas.table import TRACKED, GainInCm, Step, run_row, sentence_statement
from helicoide.text import Text

TITLE = Text(en="Simulation 11b: an ill-conditioned start", pt_BR="Simulação 11b: partida mal condicionada")
SOURCE = "Vargas 2013, §4.5, figs. 4.18–4.19"
ABOUT = Text(
    en="""The path of simulation 11, from a posture beside the upright arm. Look at δ: as long as damping is on, for \
more than twenty seconds, the arm does not follow, since small joint velocities count more than the path; when it goes \
off, the joints race. The filtered inverse is on the path within five seconds.""",
    pt_BR="""O caminho da simulação 11, a partir de uma postura junto ao braço na vertical. Observe δ: enquanto há \
amortecimento, por mais de vinte segundos, o braço não acompanha, pois velocidades pequenas contam mais do que o \
caminho; quando ele sai, as juntas disparam. A inversa filtrada chega ao caminho em cinco segundos.""",
)
ROBOT = "zebra_zero"
PLACE = "sim. 11, figs. 4.18–4.19"
JUDGED_UNTIL = 20.0
SEEN = Interpretation(
    Text(
        en="the first 20 s, since the length of the run is not given",
        pt_BR="os 20 s iniciais, pois a duração da simulação não é dada",
    ),
    Text(en="damping goes off at 22.25 s", pt_BR="o amortecimento sai em 22,25 s"),
)


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(cm² s); dt, s."""

    gain: GainInCm = 1.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The filtered inverses with their γ, and the others."""
        filtered, modified = (
            method_settings(name, f"γ = {self.gain:g}", gain=self.gain) for name in ("filtered", "filtered_modified")
        )
        return {"filtered": filtered, "modified": modified, "damping": DAMPING, "pseudoinverse": PSEUDOINVERSE}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Four methods on trajectory 7, for 40 s, 20 s in a quick run."""
    ways = options.ways
    dt, seconds = (max(options.dt, 5e-3), JUDGED_UNTIL) if short else (options.dt, 40.0)
    runs = run_on_zebra(path_7, NEARLY_UPRIGHT, ways, dt, seconds, progress)
    damped = runs["damping"]
    follows = sentence_statement(
        "the filtered inverse tracks", "a inversa filtrada rastreia", PLACE, TRACKED * REACH, "≤"
    )
    rows = [*_statements(damped), *axis_crossing_rows(ways, runs, PLACE, follows)]
    rows.append(run_row(Text(en="w at the start", pt_BR="w na partida"), None, float(damped.w[0]), "cm³"))
    if not short:
        free = np.append(damped.t[damped.w >= DAMPED["threshold"]], seconds)[0]
        until = Text(en="damping goes off at", pt_BR="o amortecimento sai em")
        rows.append(run_row(until, None, float(free), "s"))
        last = damped.t >= SINCE
        when = Text(en="the joints are fastest at, damped", pt_BR="as juntas são mais rápidas em, amortecida")
        rows.append(
            run_row(when, None, float(damped.t[last][np.abs(damped.joint_velocities[last]).max(axis=1).argmax()]), "s")
        )
    return position_result(rows, ways, runs, Drawing(path_7, (1, 2), PLACE, "fig. 4.18"), ("filtered", "damping"))


def _statements(damped: MethodRun) -> list[Row]:
    """That the damped does not follow, and that its damping is on, as long as it is watched."""
    first = (damped.t >= SINCE) & (damped.t <= JUDGED_UNTIL)
    watched = damped.figure_times <= JUDGED_UNTIL
    least = Text(en="least damping δ in 20 s", pt_BR="menor amortecimento δ em 20 s")
    error = Text(en="largest error from 5 to 20 s, damped", pt_BR="maior erro de 5 a 20 s, amortecida")
    fails = sentence_statement(
        "the damped one fails to track", "a amortecida não consegue rastrear", PLACE, TRACKED * REACH, ">"
    )
    on = sentence_statement("δ > 0 for all t", "δ > 0 para todo t", PLACE, 0.0, ">")
    return [
        run_row(error, None, largest_absolute(damped.error_norm, first), "cm", fails, fitted=(SEEN, EXPONENT)),
        run_row(least, None, float(damped.figure("δ")[watched].min()), "cm²", on, fitted=(SEEN, EXPONENT)),
    ]
