"""S2: a trocar that forbids both sideways directions."""

from __future__ import annotations

from helicoide.ik.rcm import wrists
from helicoide.studies._coutinho_rows import Options
from helicoide.studies._coutinho_runs import ROBOT
from helicoide.studies._coutinho_simulation import Beginning, simulated
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="S2: a trocar that stands still", pt_BR="S2: um trocarte parado")
SOURCE = "Coutinho 2015, §4.1.2, eq. 4.2"
ABOUT = Text(
    en="The instrument passes a trocar, which lets it slide and turn but not move sideways, and its tool draws a "
    "closed curve beyond it with its orientation held. What is left of the tip's error falls with the sample time, and "
    "so does the drift at the entry point, unless a feedback Kr takes it away.",
    pt_BR="O instrumento passa por um trocarte, que o deixa deslizar e girar mas não se mover de lado, e a ponta "
    "percorre uma curva fechada com a orientação mantida. O que resta do erro da ponta diminui com o período de "
    "amostragem, assim como a deriva no ponto de entrada, a não ser que a realimentação Kr a elimine.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

_ALIKE = {"outside_min": "0.142", "outside_max": "0.235", "w_r": "0.157"}
TABLE = {
    (20, 0.0): {
        "tip": "0.0037", "angle": "0.0004", "lateral": "0.471", "slip": "≤1e-12", "q7_min": "-1.344",
        "q7_max": "-0.556", "rate": "0.0530", **_ALIKE,
    },
    (20, 5.0): {"tip": "≤0.01", "lateral": "≤0.002"},
    (2, 0.0): {
        "tip": "0.0004", "angle": "0.0000", "lateral": "0.047", "slip": "≤1e-11", "q7_min": "-1.346",
        "q7_max": "-0.558", "rate": "0.0531", **_ALIKE,
    },
    (2, 5.0): {
        "tip": "0.0004", "angle": "0.0000", "lateral": "0.00016", "slip": "≤1e-11", "q7_min": "-1.347",
        "q7_max": "-0.558", "rate": "0.0531", **_ALIKE,
    },
}  # fmt: skip
SAMPLES = {
    0: ("0.1500", "-0.6164", "0.8325", "0.02828"),
    25: ("0.2299", "-1.1107", "0.1698", "0.04441"),
    50: ("0.1936", "-0.8802", "0.3825", "0.04012"),
    100: ("0.2225", "-1.3181", "0.2258", "0.04622"),
    150: ("0.1936", "-0.8802", "0.3825", "0.03940"),
    200: ("0.1500", "-0.6164", "0.8325", "0.02828"),
}
# Of the first seconds at 20 ms: what the whole period does not exceed.
SHORT = Beginning(
    25.0,
    {
        (20, 0.0): {"tip": "≤0.0038", "angle": "≤0.0004", "lateral": "≤0.471", "slip": "≤1e-12", "rate": "≤0.0531"},
        (20, 5.0): {"tip": "≤0.01", "lateral": "≤0.002", "slip": "≤1e-12", "rate": "≤0.0531"},
    },
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both runs; short: 25 s of them at 20 ms."""
    return simulated("S2", options, SHORT if short else None, progress, TABLE, (wrists.w_zy_trocar, "3.42"), SAMPLES)
