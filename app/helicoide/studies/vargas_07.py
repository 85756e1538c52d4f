"""Sim. 7 of Vargas 2013: the planar arm passes right through the origin, where it is singular."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.paths import path_4
from helicoide.studies.vargas.planar import Found, compared_rows, followers, result, ways_of
from helicoide.studies.vargas.runs import Way
from helicoide.studies.vargas.table import Gain, Sheet, Step, choice, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 7: through a singular posture", pt_BR="Simulação 7: através de uma postura singular")
SOURCE = "Vargas 2013, §3.5, sim. 7, figs. 3.14–3.15"
ABOUT = Text(
    en="""The path leads through the axis of the shoulder, where no joint moves the tool along it; the arm gets there \
after 32 s. The pseudoinverse asks for hundreds of radians a second. Compare the filtered inverses: the larger γ is, \
the smaller the error, for little more speed of the joints.""",
    pt_BR="""O caminho passa pelo eixo do ombro, onde nenhuma junta move o efetuador ao longo dele; o braço chega lá \
em 32 s. A pseudoinversa pede centenas de radianos por segundo. Compare as inversas filtradas: quanto maior γ, menor \
o erro, por um pouco mais de velocidade nas juntas.""",
)
ROBOT = "planar3r"
START = (pi / 2, 0.1, 0.1)
FOUND: dict[str, Found] = {
    "pseudoinverse": ("726", "0.10", None, None),
    "damping": ("0.795", "0.184", 0.03, 0.03),
    "feedback": ("4.59", "0.189", None, None),
    "filtered_0": ("1.37", "0.530", 0.03, 0.03),
    "filtered_1": ("1.38", "0.162", 0.03, 0.03),
    "filtered_2": ("2.02", "0.075", None, None),
    "modified_0": ("1.99", "0.634", None, None),
    "modified_1": ("2.25", "0.242", None, None),
    "modified_2": ("3.03", "0.111", None, None),
}


def with_gains(gain: float) -> dict[str, Way]:
    """The methods, the filtered inverses with γ and ten and a hundred times it."""
    return ways_of(gain, 10 * gain, 100 * gain)


@dataclass(frozen=True)
class Options:
    """gain: the smallest γ of the filtered inverses; dt, s; shown: whose motion the arm shows."""

    gain: Gain = 5.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(with_gains(5.0))] = "filtered_1"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Methods on trajectory 4, the filtered inverses with three gains."""
    ways = with_gains(options.gain)
    runs = followers(path_4, START, ways, options.dt, short, progress)
    rows = compared_rows(Sheet(short, is_changed(options)), ways, runs, FOUND, "< 0.7")
    return result(rows, path_4, ways, runs, options.shown)
