"""S4: a trocar that moves, as a breathing body moves it."""

from __future__ import annotations

from helicoide.studies._coutinho_rows import Options, stays
from helicoide.studies._coutinho_runs import ROBOT, Run
from helicoide.studies._coutinho_simulation import simulated
from helicoide.studies.study import Progress, Result, Row, printed
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
ALONG = Text(
    en="largest velocity of the shaft at the entry point, along {axis}",
    pt_BR="maior velocidade da haste no ponto de entrada, ao longo de {axis}",
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: at 100 ms."""
    return simulated("S4", options, short, progress, stated, "figs. 4.20–4.24", "fig. 4.22b")


def stated(got: Run) -> list[Row]:
    """What the source prints of S4."""
    largest = {"x": got["v_x"].max(), "−z": (-got["v_z"]).max()}
    return [
        stays(got, "§4.1.2", FOLLOWS),
        *(
            Row(ALONG.format(axis=axis), float(value), "mm/s", printed("5", "eq. 4.6"))
            for axis, value in largest.items()
        ),
    ]
