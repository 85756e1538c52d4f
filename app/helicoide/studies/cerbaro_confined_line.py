"""The second path of chapter 6: a straight line from wall to wall, there and back."""

from __future__ import annotations

from helicoide.studies.cerbaro_runs import chapter6
from helicoide.studies.cerbaro_runs.chapter6_rows import Told
from helicoide.studies.cerbaro_runs.chapter6_runs import Options
from helicoide.studies.cerbaro_runs.confined import LINE
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="Confined: the line", pt_BR="Confinado: a linha")
SOURCE = "Cerbaro 2022, §6.1–6.2.3, eqs. 31, 34 (500 → 50 mm), 36, 37, figs. 53–58"
ROBOT = "movemaster"
ABOUT = Text(
    en="The tool is to run along a straight line that begins and ends inside the warning zones of both side walls. "
    "With its orientation held the arm stays below the ceiling but bends the wrist beyond its limit; left free, the "
    "elbow rises, and the target has to give way.",
    pt_BR="O efetuador deve percorrer uma reta que começa e termina nas zonas de alerta das duas paredes laterais. "
    "Com a orientação mantida, o braço fica abaixo do teto, mas dobra o punho além do limite; com ela livre, o "
    "cotovelo sobe, e o alvo tem de ceder.",
)
TOLD = Told(
    untouched=(171.2, 55.6, 55.9),
    ceiling=((171.2, 110.0), (81.6, 116.8), (81.6, 116.8)),
    planes={2: (81.6, 117.6, 110.0, 177.9), 3: (81.6, 117.6, 110.0, 177.9)},
    deviation={1: 12.0, 2: 50.5, 3: 50.5},
    turned_down=325,
    undamped=25.0,
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three cases by the source's rules, read in several ways, and the guarded step beside them."""
    return chapter6.study(LINE, TOLD, options, short, progress)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
