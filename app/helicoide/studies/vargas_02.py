"""Sim. 2 of Vargas 2013: position alone, by the pseudoinverse of a planar arm that has a joint to spare."""

from __future__ import annotations

from dataclasses import dataclass

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.decay import decay_result
from helicoide.studies.vargas.paths import path_1
from helicoide.studies.vargas.runs import PLANAR_ROWS, method_settings, tracking
from helicoide.studies.vargas.table import Gain, Step
from helicoide.text import Text

TITLE = Text(en="Simulation 2: a redundant joint", pt_BR="Simulação 2: uma junta redundante")
SOURCE = "Vargas 2013, §2.4, sim. 2, figs. 2.9–2.10"
ABOUT = Text(
    en="""The same path as in simulation 1, but the angle of the end effector is free: three joints for two \
coordinates. The error fades as before, and of all motions that do it the pseudoinverse takes the smallest. Compare \
its fastest joint with that of simulation 1, which is three times faster.""",
    pt_BR="""O mesmo caminho da simulação 1, mas o ângulo do efetuador está livre: três juntas para duas coordenadas. \
O erro se apaga como antes e, de todos os movimentos que o fazem, a pseudoinversa escolhe o menor. Compare a junta \
mais rápida com a da simulação 1, três vezes mais veloz.""",
)
ROBOT = "planar3r"


@dataclass(frozen=True)
class Options:
    """gain: γ of the filtered inverse beside the pseudoinverse; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The pseudoinverse with λ = 1 and 2, and the filtered inverse."""
    aiming = tracking(planar_problem(), path_1, PLANAR_ROWS)
    dt = max(options.dt, 2e-3) if short else options.dt
    return decay_result(options, aiming, method_settings("pseudoinverse"), dt, "figs. 2.9–2.10", progress)
