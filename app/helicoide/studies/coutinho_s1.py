"""S1: a slit that forbids one direction, while the tool withdraws by 132 mm."""

from __future__ import annotations

import numpy as np

from helicoide.ik.postures.branch import tool_at
from helicoide.studies._coutinho_rows import FITTED_START, FOLLOWED, NULL, SAMPLED, Options, leaving_rate_row
from helicoide.studies._coutinho_runs import ROBOT, Run, dia10
from helicoide.studies._coutinho_simulation import Simulation, simulation_result, tool_displacement
from helicoide.studies.study import INPUT_VALUE, Progress, Result, Row, Statement
from helicoide.text import Text, untranslated

TITLE = Text(en="S1: a slit for the instrument", pt_BR="S1: uma fenda para o instrumento")
SOURCE = "Coutinho 2015, §4.1.1, eq. 4.1"
ABOUT = Text(
    en="The instrument passes a slit that forbids it one sideways direction, and its end effector goes in and out by "
    "132 mm. l_a and l_b are the distances of the entry point from joint 6 and from joint 7. It is held in velocity "
    "alone, H V_r = 0, so that over whole steps the shaft drifts away from it; a feedback Kr of that distance brings "
    "it back.",
    pt_BR="O instrumento passa por uma fenda que lhe proíbe uma direção lateral, e a ponta recua e avança 132 mm. l_a "
    "e l_b são as distâncias do ponto de entrada às juntas 6 e 7. Ele é mantido só em velocidade, H V_r = 0, de modo "
    "que ao longo de passos inteiros a haste se afasta dele; a realimentação Kr dessa distância a traz de volta.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

# Of table 4.2, m.
PLACE = np.array([0.194, 1.019, 0.958])
FOLLOWS = Text(en="follows its path near l_b = 0 too", pt_BR="segue a trajetória também perto de l_b = 0")
PLACED = Text(en="end effector at the start, from its printed place", pt_BR="efetuador no início, até o lugar impresso")
AT = Text(en="(19.4, 101.9, 95.8) cm", pt_BR="(19,4; 101,9; 95,8) cm")
CLOSEST = Text(en="smallest l_b", pt_BR="menor l_b")
ERROR = Text(
    en="largest error of the tip in the tenth of the run in which l_b is smallest",
    pt_BR="maior erro da ponta no décimo da execução em que l_b é menor",
)
WITHDRAWN = Text(en="largest withdrawal of the end effector", pt_BR="maior recuo do efetuador")
WAY = Text(en="2.2A cos 2ωt − 2.2A, A = 3 cm", pt_BR="2,2A cos 2ωt − 2,2A, A = 3 cm")


KEPT = Statement(untranslated("H V_r = 0"), "eqs. 3.1, 3.22", NULL, "≤")


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: at 100 ms."""
    simulation = Simulation("S1", s1_rows, "figs. 4.3–4.8", "fig. 4.6b")
    return simulation_result(simulation, options, short, progress)


def s1_rows(got: Run, dt: float) -> list[Row]:
    """What the source prints of the start and of S1."""
    placed = 1e3 * float(np.linalg.norm(tool_at(dia10(), got["q"][0])[:3, 3] - PLACE))
    inside = 1e3 * got["inside"]
    error = got["tip_mm"][inside <= np.quantile(inside, 0.1)].max()
    withdrawn = float(-tool_displacement(got)[:, 1].min())
    return [
        Row(ERROR, float(error), "mm", Statement(FOLLOWS, "§4.1.1", FOLLOWED, "≤"), (*FITTED_START, SAMPLED)),
        leaving_rate_row(got, dt, KEPT, (*FITTED_START, SAMPLED)),
        Row(PLACED, placed, "mm", Statement(AT, "tab. 4.2", 0.0, "=", 0.5), given=INPUT_VALUE),
        Row(WITHDRAWN, withdrawn, "mm", Statement(WAY, "eq. 4.1", 132.0, "=", 1.0), given=INPUT_VALUE),
        Row(CLOSEST, float(inside.min()), "mm"),
    ]
