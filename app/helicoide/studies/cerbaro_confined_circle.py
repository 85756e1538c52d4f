"""The third path of chapter 6: a level circle, partly beyond reach where the orientation is held."""

from __future__ import annotations

from helicoide.studies.cerbaro_runs import chapter6
from helicoide.studies.cerbaro_runs.chapter6_rows import Told
from helicoide.studies.cerbaro_runs.chapter6_runs import Options
from helicoide.studies.cerbaro_runs.confined import CIRCLE
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="Confined: the circle", pt_BR="Confinado: o círculo")
SOURCE = "Cerbaro 2022, §6.1–6.2.4, eqs. 31, 35–37, figs. 59–64"
ROBOT = "movemaster"
ABOUT = Text(
    en="A level circle brings the arm near its base, where the tool folds back and the wrist comes within 40 mm of a "
    "wall that the source watches for the tool alone. It also shows what Algorithm 1 is good for: with one gain J3 "
    "goes 10° beyond its limit, with gains that grow it stays 8° inside.",
    pt_BR="Um círculo horizontal traz o braço para perto da base, onde o efetuador se dobra para trás e o punho chega "
    "a menos de 40 mm de uma parede que a fonte só vigia para o efetuador. Mostra também para que serve o Algoritmo 1: "
    "com um só ganho, J3 passa 10° do limite; com ganhos que crescem, fica 8° para dentro.",
)
TOLD = Told(
    untouched=(18.4, 14.3, 38.1),
    ceiling=((80.5, 110.0), (80.1, 40.9), (80.3, 35.3)),
    planes={2: (80.1, 110.0, 186.5, 108.5), 3: (80.3, 110.0, 186.0, 109.7)},
    deviation={2: 53.7, 3: 51.0},
    turned_down=5,
    undamped=32.0,
    j3={2: -10.2, 3: 8.0},
    far=True,
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three cases by the source's rules, read in several ways, and the guarded step beside them."""
    return chapter6.study(CIRCLE, TOLD, options, short, progress)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
