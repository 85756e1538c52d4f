"""E1: the comparison of methods on the robot, near a singularity and with an entry point that moves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.ik.rcm.follow import PSEUDOINVERSE, Inverse, inverse
from helicoide.studies._coutinho_rows import charts_of, motion_of, rows_of
from helicoide.studies._coutinho_runs import DLS, E1_START, FILTERED, ROBOT, Run, control
from helicoide.studies._coutinho_runs import run as run_along
from helicoide.studies.study import Progress, Result, Row
from helicoide.text import Text, same

TITLE = Text(en="E1: three methods beside each other", pt_BR="E1: três métodos lado a lado")
SOURCE = "Coutinho 2015, §4.2.1, figs. 4.27–4.30, tab. 4.3"
ABOUT = Text(
    en="The experiment on the robot: tool and entry point swing to and fro, and on the way the wrist comes near θ₇ = "
    "0. Damping and the filtered inverse trade accuracy of the tip for calm joints, and which of them is better "
    "depends on κ, Γ and the path; the entry point is kept by all. The source reports that the plain inverse was not "
    "viable.",
    pt_BR="O experimento no robô: ponta e ponto de entrada oscilam, e no caminho o punho chega perto de θ₇ = 0. O "
    "amortecimento e a inversa filtrada trocam precisão da ponta por juntas calmas, e qual é melhor depende de κ, Γ e "
    "da trajetória; todos mantêm o ponto de entrada. A fonte relata que a inversa simples não foi viável.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

STEP, SECONDS = 0.002, 4.0
INVERSES: Mapping[str, tuple[Text, Inverse]] = {
    "plain": (Text(en="plain inverse", pt_BR="inversa simples"), PSEUDOINVERSE),
    "damped": (Text(en="damped, κ = 0.01", pt_BR="amortecida, κ = 0,01"), inverse("damped", damping=0.01)),
    "more": (Text(en="damped, κ = 0.05", pt_BR="amortecida, κ = 0,05"), DLS),
    "filtered": (Text(en="filtered inverse, Γ = 5", pt_BR="inversa filtrada, Γ = 5"), FILTERED),
}
# Kp and Ko, 1/s.
GAINS = {"simulations": (5.0, 10.0), "experiments": (270.0, 1500.0)}
GAIN = Text(en="gains", pt_BR="ganhos")
CHOICES = {name: same(f"Kp = {Kp:g}, Ko = {Ko:g}") for name, (Kp, Ko) in GAINS.items()}


def _row(tip: str, q7_min: str, lateral: str, rate: str) -> Mapping[str, str]:
    return {"tip": tip, "q7_min": q7_min, "q7_max": "0.785", "lateral": lateral, "rate": rate}


TABLE: Mapping[tuple[str, str], Mapping[str, str]] = {
    ("simulations", "plain"): _row("0.0043", "0.010", "0.072", "2.38"),
    ("simulations", "damped"): _row("5.31", "-0.346", "0.012", "0.861"),
    ("simulations", "more"): _row("12.8", "-0.374", "0.036", "0.305"),
    ("simulations", "filtered"): _row("25.5", "-0.303", "0.055", "0.256"),
    ("experiments", "plain"): _row("0.0001", "0.010", "0.072", "2.38"),
    ("experiments", "damped"): _row("0.92", "0.009", "0.072", "2.35"),
    ("experiments", "more"): _row("7.4", "-0.002", "0.021", "2.49"),
    ("experiments", "filtered"): _row("10.6", "-0.352", "0.012", "0.761"),
}
# The digest's filtered rows are of another integration of Θ: so many units of the last digit.
FILTERED_LAST = 1.2
# The first seconds, without a singularity: what the whole does not exceed, and a micrometre for the plain inverse.
_BEGUN = {"slip": "≤1e-11", "lateral": "≤0.072"}


@dataclass(frozen=True)
class Options:
    """Kp and Ko: those of the simulations (table 4.2), or those of the experiments (table 4.3)."""

    gains: Annotated[str, OneOf(GAIN, CHOICES)] = "experiments"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A run for each inverse at 2 ms; short: 4 s of them."""
    runs: dict[str, Run] = {}
    rows: list[Row] = []
    for done, (name, (title, of_tool)) in enumerate(INVERSES.items()):
        Kp, Ko = GAINS[options.gains]
        gained = control(of_tool=of_tool, position=Kp, orientation=Ko)
        got = run_along("E1", gained, STEP, E1_START, SECONDS if short else None, _part(progress, done))
        rows += rows_of(got, title, _printed(options.gains, name, short), FILTERED_LAST if name == "filtered" else 0.55)
        runs[name] = got
    return Result(
        rows=tuple(rows),
        charts=charts_of(
            {INVERSES[name][0]: got for name, got in runs.items()}, ("tip_mm", "lateral_mm", "rate", "q7", "w_r")
        ),
        motion=motion_of(runs["filtered"]),
    )


def _printed(gains: str, name: str, short: bool) -> Mapping[str, str]:
    if not short:
        return TABLE[gains, name]
    tip = "1e-3" if (gains, name) == ("experiments", "plain") else TABLE[gains, name]["tip"]
    return {**_BEGUN, "tip": f"≤{tip}"}


def _part(progress: Progress, done: int) -> Progress:
    return lambda share: progress((done + share) / len(INVERSES))
