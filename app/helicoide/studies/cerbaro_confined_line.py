"""The second path of chapter 6: a straight line from wall to wall, there and back."""

from __future__ import annotations

from helicoide.studies.cerbaro_runs import chapter6
from helicoide.studies.cerbaro_runs.chapter6_runs import Options
from helicoide.studies.cerbaro_runs.confined import LINE
from helicoide.studies.study import Progress, Result
from helicoide.text import Text, join_texts

TITLE = Text(en="Confined: the line", pt_BR="Confinado: a reta")
SOURCE = "Cerbaro 2022, §6.1–6.2.3, eqs. 31, 34 (500 → 50 mm), 36, 37, figs. 53–58"
ROBOT = "movemaster"
ABOUT = join_texts(
    (
        Text(
            en="The end effector is to run along a straight line, from its middle to both ends, which lie nearer to "
            "the side walls than the critical 80 mm. With its orientation held the arm stays below the ceiling but "
            "bends the wrist beyond its limit; left free, the elbow rises, and the target has to give way.",
            pt_BR="O efetuador deve percorrer uma reta, do meio até os dois extremos, que ficam a menos dos 80 mm "
            "críticos das paredes laterais. Com a orientação mantida, o braço fica abaixo do teto, mas dobra o punho "
            "além do limite; com ela livre, o cotovelo sobe, e o alvo tem de ceder.",
        ),
        chapter6.ABOUT_CASES,
    ),
    " ",
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three cases by the source's rules, read in several ways, and the constrained QP step for comparison."""
    return chapter6.confined_study(LINE, (53, 58), options, short, progress)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
