"""S2: a trocar that forbids both sideways directions."""

from __future__ import annotations

from helicoide.studies._coutinho_rows import FITTED_START, NULL, SAMPLED, Options, leaving_rate_row
from helicoide.studies._coutinho_runs import ROBOT, Run
from helicoide.studies._coutinho_simulation import Simulation, simulation_result, tool_displacement
from helicoide.studies.study import INPUT_VALUE, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="S2: a trocar that stands still", pt_BR="S2: um trocarte parado")
SOURCE = "Coutinho 2015, §4.1.2, eq. 4.2"
ABOUT = Text(
    en="The instrument passes a trocar, which lets it slide and turn but not move sideways, and its end effector draws "
    "a closed curve beyond it with its orientation held. Over whole steps the shaft drifts a little away from the "
    "entry point, unless a feedback Kr of its distance brings it back.",
    pt_BR="O instrumento passa por um trocarte, que o deixa deslizar e girar mas não se mover de lado, e a ponta "
    "percorre uma curva fechada com a orientação mantida. Ao longo de passos inteiros a haste se afasta um pouco do "
    "ponto de entrada, a não ser que a realimentação Kr dessa distância a traga de volta.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

STILL = Text(en="velocity of the entry point about 0", pt_BR="velocidade do ponto de entrada praticamente nula")
WITHDRAWN = Text(en="largest withdrawal of the end effector", pt_BR="maior recuo do efetuador")
WAY = Text(en="−2A sin(3ωt − π/2) − 2A, A = 3 cm", pt_BR="−2A sen(3ωt − π/2) − 2A, A = 3 cm")


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: at 100 ms."""
    simulation = Simulation("S2", s2_rows, "figs. 4.9–4.14", "fig. 4.12b")
    return simulation_result(simulation, options, short, progress)


def s2_rows(got: Run, dt: float) -> list[Row]:
    """What the source prints of S2."""
    withdrawn = float(-tool_displacement(got)[:, 1].min())
    return [
        leaving_rate_row(got, dt, Statement(STILL, "§4.1.2", NULL, "≤"), (*FITTED_START, SAMPLED)),
        Row(WITHDRAWN, withdrawn, "mm", Statement(WAY, "eq. 4.2", 120.0, "=", 1.0), given=INPUT_VALUE),
    ]
