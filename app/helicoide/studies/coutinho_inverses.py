"""The inverses of the constrained Jacobian beside each other, through the singularity of S3."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.studies._coutinho_rows import FIGURES, OF, STEP, STEPS, charts_of, motion_of, row, rows_of
from helicoide.studies._coutinho_runs import DLS, ROBOT, Run, control
from helicoide.studies._coutinho_runs import run as run_along
from helicoide.studies.coutinho_s3 import FILTERED_LAST, INVERSES, SECONDS, SHORT, TABLE
from helicoide.studies.study import Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="Four inverses at a singularity", pt_BR="Quatro inversas numa singularidade")
SOURCE = "Coutinho 2015, §3.6, eqs. 3.43–3.50; §4.1.2, eqs. 4.3, 4.4"
ABOUT = Text(
    en="The same path through θ₇ = 0 by the plain inverse, two kinds of damping and the filtered inverse: compare what "
    "each costs the tip, and what it saves the joints. Damping the wrist beyond the trocar leaves the entry point "
    "exact; damping the arm before it as well does not, and the shaft drifts by millimetres.",
    pt_BR="A mesma trajetória por θ₇ = 0 com a inversa simples, dois tipos de amortecimento e a inversa filtrada: "
    "compare quanto cada uma custa à ponta e quanto poupa às juntas. Amortecer o punho além do trocarte mantém exato o "
    "ponto de entrada; amortecer também o braço antes dele não, e a haste deriva milímetros.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

# Damping of J_i as well, at 20 ms: drift by gain Kr, mm.
LEAKS = {0.0: "16.9", 5.0: "0.15"}
LEAK = Text(en="arm damped too, Kr = {gain:g}", pt_BR="braço também amortecido, Kr = {gain:g}")


@dataclass(frozen=True)
class Options:
    """The sample time, ms."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "2"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A run for each inverse, and two with the arm damped too; short: 30 s of the four at 20 ms."""
    step = 20 if short else int(options.step)
    runs: dict[str, Run] = {}
    parts = len(INVERSES) + (0 if short else len(LEAKS))
    rows: list[Row] = []
    for done, (name, (title, of_tool)) in enumerate(INVERSES.items()):
        seconds = SECONDS if short else None
        got = run_along(
            "S3", control(of_tool=of_tool), step / 1000, seconds=seconds, progress=_part(progress, done, parts)
        )
        printed = SHORT[name] if short else TABLE.get((step, name), {})
        rows += rows_of(got, title, printed, FILTERED_LAST if name == "filtered" else 0.55)
        runs[name] = got
    for done, (gain, printed_drift) in enumerate(() if short else LEAKS.items(), start=len(INVERSES)):
        rows += _leak(gain, printed_drift, _part(progress, done, parts))
    return Result(
        rows=tuple(rows),
        charts=charts_of({INVERSES[name][0]: got for name, got in runs.items()}, ("tip_mm", "rate", "q7", "w_r")),
        motion=motion_of(runs["damped"]),
    )


def _leak(gain: float, drift: str, progress: Progress) -> tuple[Row, Row]:
    """What the entry point loses where J_i is damped as well: always at 20 ms."""
    got = run_along("S3", control(gain, of_tool=DLS, of_arm=DLS), 0.02, progress=progress)
    which = LEAK.format(gain=gain)
    lateral, slip = FIGURES["lateral"], FIGURES["slip"]
    return (
        row(OF.format(what=lateral[0], which=which), lateral[2](got), drift, lateral[1]),
        row(OF.format(what=slip[0], which=which), slip[2](got), "≥0.1", slip[1]),
    )


def _part(progress: Progress, done: int, parts: int) -> Progress:
    """The progress of one of several runs, as a part of the whole."""
    return lambda share: progress((done + share) / parts)
