"""S1: a slit that forbids one direction, while the tool withdraws by 132 mm."""

from __future__ import annotations

from helicoide.ik.rcm import wrists
from helicoide.studies._coutinho_rows import Options
from helicoide.studies._coutinho_runs import ROBOT
from helicoide.studies._coutinho_simulation import Beginning, simulated
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="S1: a slit for the instrument", pt_BR="S1: uma fenda para o instrumento")
SOURCE = "Coutinho 2015, §4.1.1, eq. 4.1"
ABOUT = Text(
    en="The instrument passes a slit that forbids it one sideways direction, and its tool goes in and out by 132 mm. "
    "The entry point is held in velocity alone, so that it drifts with the sample time; a feedback Kr brings it back.",
    pt_BR="O instrumento passa por uma fenda que lhe proíbe uma direção lateral, e a ponta recua e avança 132 mm. "
    "O ponto de entrada é mantido só em velocidade e por isso deriva com o período de amostragem; a realimentação Kr o "
    "traz de volta.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

_ALIKE = {"outside_min": "0.147", "outside_max": "0.240", "w_r": "0.539"}
TABLE = {
    (20, 0.0): {
        "tip": "0.0028", "angle": "0.0003", "lateral": "0.191", "slip": "≤1e-12", "q7_min": "-1.430",
        "q7_max": "-0.571", "rate": "0.0462", **_ALIKE,
    },
    (20, 5.0): {
        "tip": "0.0028", "angle": "0.0003", "lateral": "0.0009", "slip": "≤1e-12", "rate": "0.0463", **_ALIKE,
    },
    (2, 0.0): {
        "tip": "0.0003", "angle": "0.0000", "lateral": "0.023", "slip": "≤1e-11", "rate": "0.0463", **_ALIKE,
    },
}  # fmt: skip
# Of the first seconds at 20 ms: what the whole period does not exceed.
SHORT = Beginning(
    25.0,
    {
        (20, 0.0): {"tip": "≤0.0028", "angle": "≤0.0003", "lateral": "≤0.191", "slip": "≤1e-12", "rate": "≤0.0463"},
        (20, 5.0): {"tip": "≤0.0028", "angle": "≤0.0003", "lateral": "≤0.001", "slip": "≤1e-12", "rate": "≤0.0463"},
    },
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: 25 s of them at 20 ms."""
    return simulated("S1", options, SHORT if short else None, progress, TABLE, (wrists.w_zy_slit, "3.40"))
