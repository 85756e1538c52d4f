"""Sim. 1 of Vargas 2013: position and angle of the planar arm by the inverse of its Jacobian."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.decay import decay_result
from helicoide.studies.vargas.paths import path_1
from helicoide.studies.vargas.runs import WITH_ANGLE, method_settings, rotation_about, tracking
from helicoide.studies.vargas.table import Gain, Step
from helicoide.text import Text

TITLE = Text(en="Simulation 1: an error that fades", pt_BR="Simulação 1: um erro que se apaga")
SOURCE = "Vargas 2013, §2.4, sim. 1, figs. 2.6–2.7"
ABOUT = Text(
    en="""The arm starts away from its path, and the closed loop takes the error away. Look at the error: it halves \
in equal times, twice as fast with λ = 2 as with λ = 1, whatever the arm does meanwhile. The price is paid in the \
first instant, when the inverse throws the joints; the filtered inverse starts from rest and is six times gentler.""",
    pt_BR="""O braço parte longe do caminho e a malha fechada elimina o erro. Observe o erro: ele cai à metade em \
tempos iguais, duas vezes mais rápido com λ = 2 do que com λ = 1, não importa o que o braço faça. O preço aparece no \
primeiro instante, quando a inversa arremessa as juntas; a inversa filtrada parte do repouso e é seis vezes mais \
suave.""",
)
ROBOT = "planar3r"


@dataclass(frozen=True)
class Options:
    """gain: γ of the filtered inverse beside the inverse; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The inverse with λ = 1 and 2, and the filtered inverse."""
    aiming = tracking(planar_problem(), path_1, WITH_ANGLE, rotation_about(2, pi / 2), "rotation vector")
    dt = max(options.dt, 2e-3) if short else options.dt
    return decay_result(options, aiming, method_settings("inverse"), dt, "figs. 2.6–2.7", progress)
