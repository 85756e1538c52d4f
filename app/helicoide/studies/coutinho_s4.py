"""S4: a trocar that moves, as a breathing body moves it."""

from __future__ import annotations

import numpy as np

from helicoide.studies._coutinho_rows import ENTRY, FITTED_START, MISSED, SAMPLED_S4, Options, leaving_rate_row
from helicoide.studies._coutinho_runs import ROBOT, Run
from helicoide.studies._coutinho_simulation import Simulation, simulation_result
from helicoide.studies.study import INPUT_VALUE, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="S4: an entry point that moves", pt_BR="S4: um ponto de entrada que se move")
SOURCE = "Coutinho 2015, §4.1.2, eqs. 4.5, 4.6"
ABOUT = Text(
    en="The path of S2 again, while the entry point itself moves by up to 106 mm along both forbidden directions, as "
    "breathing might move it. The shaft takes up its velocity, and the tip does not notice; "
    "as it is held in velocity alone, it drifts by some millimetres, which the feedback Kr brings back.",
    pt_BR="De novo a trajetória de S2, enquanto o próprio ponto de entrada se move até 106 mm ao longo das duas "
    "direções proibidas, como a respiração poderia movê-lo. A haste assume essa velocidade, e a ponta não percebe; "
    "como só a velocidade é mantida, há uma deriva de alguns milímetros, que a realimentação Kr corrige.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

FOLLOWS = Text(en="the velocity of the entry point follows v_rd", pt_BR="a velocidade do ponto de entrada segue v_rd")
GIVEN = Text(en="v_rd = 5 (sin 3ωt, 0, −sin 3ωt) mm/s", pt_BR="v_rd = 5 (sen 3ωt, 0, −sen 3ωt) mm/s")
SPEED = 5.0  # mm/s


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: at 100 ms, which is too long a step to judge whether the entry point is followed."""
    simulation = Simulation("S4", entry_motion_rows if short else s4_rows, "figs. 4.20–4.24", "fig. 4.22b")
    return simulation_result(simulation, options, short, progress)


def s4_rows(got: Run, dt: float) -> list[Row]:
    """What the source prints of S4."""
    followed = Statement(FOLLOWS, "§4.1.2", MISSED * SPEED, "≤")
    return [leaving_rate_row(got, dt, followed, (*FITTED_START, SAMPLED_S4)), *entry_motion_rows(got, dt)]


def entry_motion_rows(got: Run, dt: float) -> list[Row]:
    """How fast the entry point is moved."""
    fastest = float(max(np.abs(got["v_x"]).max(), np.abs(got["v_z"]).max()))
    return [Row(ENTRY, fastest, "mm/s", Statement(GIVEN, "eq. 4.6", SPEED, "=", 0.5), given=INPUT_VALUE)]
