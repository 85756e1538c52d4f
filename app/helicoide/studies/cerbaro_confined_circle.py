"""The third path of chapter 6: a level circle, partly beyond reach where the orientation is held."""

from __future__ import annotations

from helicoide.studies.cerbaro_runs import chapter6
from helicoide.studies.cerbaro_runs.chapter6_runs import Options
from helicoide.studies.cerbaro_runs.confined import CIRCLE
from helicoide.studies.study import Progress, Result
from helicoide.text import Text, join_texts

TITLE = Text(en="Confined: the circle", pt_BR="Confinado: o círculo")
SOURCE = "Cerbaro 2022, §6.1–6.2.4, eqs. 31, 35–37, figs. 59–64"
ROBOT = "movemaster"
ABOUT = join_texts(
    (
        Text(
            en="A level circle brings the arm near its base, where the end effector folds back and the wrist comes to "
            "31 mm from a wall; the source watches that for the end effector alone. With the orientation held, part "
            "of the circle is beyond reach. With Algorithm 1 the joint that comes nearest to its limit stays 13° "
            "farther from it; nearly as much, 12.6°, comes of the clips alone.",
            pt_BR="Um círculo horizontal traz o braço para perto da base, onde o efetuador se dobra para trás e o "
            "punho chega a 31 mm de uma parede que a fonte só vigia para o efetuador. Com a orientação mantida, parte "
            "do círculo está fora do alcance. Com o Algoritmo 1, a junta que mais se aproxima do seu limite fica "
            "13° mais longe dele; quase tudo isso, 12,6°, vem só da saturação.",
        ),
        chapter6.ABOUT_CASES,
    ),
    " ",
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three cases by the source's rules, read in several ways, and the constrained QP step for comparison."""
    return chapter6.confined_study(CIRCLE, (59, 64), options, short, progress)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
