"""Inverses of the constrained Jacobian compared, through the singularity of S3."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.studies._coutinho_rows import STEP, STEPS, measure_rows, run_charts, run_motions
from helicoide.studies._coutinho_runs import INVERSES, ROBOT, source_control
from helicoide.studies._coutinho_runs import run_path as run_along
from helicoide.studies._coutinho_simulation import SHORT, share_of_progress
from helicoide.studies.study import Progress, Result
from helicoide.text import Text

TITLE = Text(en="Four inverses at a singularity", pt_BR="Quatro inversas numa singularidade")
SOURCE = "Coutinho 2015, §3.6, eqs. 3.43–3.50; §4.1.2, eqs. 4.3, 4.4"
ABOUT = Text(
    en="The path of S3 through θ₇ = 0 by the plain inverse, two kinds of damping and the filtered inverse: compare "
    "what each costs the tip, and what it saves the joints. The source runs it with constant damping only, so that the "
    "comparison is ours. The plain inverse is exact at each instant, but its joints race, so that a step of 20 ms is "
    "too long for it: its tip errs most. The entry point is kept by all four.",
    pt_BR="A trajetória de S3 por θ₇ = 0 com a inversa simples, dois tipos de amortecimento e a inversa filtrada: "
    "compare quanto cada uma custa à ponta e quanto poupa às juntas. A fonte só a executa com amortecimento constante, "
    "de modo que a comparação é nossa. A inversa simples é exata a cada instante, mas suas juntas disparam, e um passo "
    "de 20 ms é longo demais para ela: é a ponta que mais erra. As quatro mantêm o ponto de entrada.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

MEASURED = ("tip", "angle", "lateral", "q7_min", "q7_max", "rate")
CHARTS = ("tip", "rate", "q7", "w", "lateral")


@dataclass(frozen=True)
class Options:
    """The sample time, ms."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "20"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A run for each inverse; short: at 100 ms."""
    dt = SHORT if short else int(options.step) / 1000
    runs = {
        title: run_along(
            "S3", source_control(of_tool=of_tool), dt, progress=share_of_progress(progress, done, len(INVERSES))
        )
        for done, (title, of_tool) in enumerate(INVERSES.values())
    }
    return Result(
        rows=tuple(
            one for which, got in runs.items() for one in measure_rows(got, which, dt, names=MEASURED, by_step=MEASURED)
        ),
        charts=run_charts(runs, dict.fromkeys(CHARTS, ""), ("tip", "rate")),
        motions=run_motions(runs),
    )
