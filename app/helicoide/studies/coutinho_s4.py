"""S4: a trocar that moves, as a breathing body moves it."""

from __future__ import annotations

from helicoide.ik.rcm import wrists
from helicoide.studies._coutinho_rows import Options
from helicoide.studies._coutinho_runs import ROBOT
from helicoide.studies._coutinho_simulation import Beginning, simulated
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="S4: an entry point that moves", pt_BR="S4: um ponto de entrada que se move")
SOURCE = "Coutinho 2015, §4.1.2, eqs. 4.5, 4.6"
ABOUT = Text(
    en="The path of S2 again, while the entry point itself moves by up to 106 mm along both forbidden directions, as "
    "breathing might move it. The shaft takes up its velocity exactly, and the tip does not notice.",
    pt_BR="De novo a trajetória de S2, enquanto o próprio ponto de entrada se move até 106 mm ao longo das duas "
    "direções proibidas, como a respiração poderia movê-lo. A haste assume exatamente essa velocidade, e a ponta não "
    "percebe.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

_ALIKE = {
    "tip": "0.0014", "angle": "0.0001", "slip": "≤1e-11", "q7_min": "-2.075", "outside_min": "0.146",
    "outside_max": "0.205", "w_r": "0.374", "rate": "0.115",
}  # fmt: skip
TABLE = {
    (2, 0.0): {"lateral": "0.233", "q7_max": "-0.600", **_ALIKE},
    (2, 5.0): {"lateral": "0.0005", "q7_max": "-0.601", **_ALIKE},
    (20, 5.0): {"lateral": "≤0.01", "slip": "≤1e-11", "tip": "≤0.02"},
}
# Of the first seconds at 20 ms, in which the entry point moves by 53 mm.
SHORT = Beginning(50.0, {(20, 5.0): TABLE[20, 5.0], (20, 0.0): {"slip": "≤1e-11", "tip": "≤0.02"}})


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: 50 s of them at 20 ms."""
    return simulated("S4", options, SHORT if short else None, progress, TABLE, (wrists.w_zy_trocar, "3.42"))
