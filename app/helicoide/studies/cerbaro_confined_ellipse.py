"""The first path of chapter 6: an ellipse that starts nearest the base."""

from __future__ import annotations

from helicoide.studies.cerbaro_runs import chapter6
from helicoide.studies.cerbaro_runs.chapter6_runs import Options
from helicoide.studies.cerbaro_runs.confined import ELLIPSE
from helicoide.studies.study import Progress, Result
from helicoide.text import Text, join_texts

TITLE = Text(en="Confined: the ellipse", pt_BR="Confinado: a elipse")
SOURCE = "Cerbaro 2022, §6.1–6.2.2, eqs. 31, 33, 36, 37, figs. 47–52"
ROBOT = "movemaster"
ABOUT = join_texts(
    (
        Text(
            en="The end effector is to run round an ellipse that leads past walls, ceiling and bench of a foam "
            "enclosure. The target gives way wherever a joint comes near the ceiling, or the end effector near a wall "
            "or the bench.",
            pt_BR="O efetuador deve percorrer uma elipse que passa perto de paredes, teto e bancada de um recinto de "
            "espuma. O alvo cede onde uma junta se aproxima do teto, ou o efetuador de uma parede ou da bancada.",
        ),
        chapter6.ABOUT_CASES,
    ),
    " ",
)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three cases by the source's rules, read in several ways, and the constrained QP step for comparison."""
    return chapter6.confined_study(ELLIPSE, (47, 52), options, short, progress)


__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]
