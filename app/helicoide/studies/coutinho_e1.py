"""E1: the comparison of methods on the robot, through a singularity and with an entry point that moves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.ik.rcm.follow import PSEUDOINVERSE, Inverse, inverse
from helicoide.studies._coutinho_hand import GAINS, STEP
from helicoide.studies._coutinho_rows import (
    BY_STEP,
    ENTRY,
    MEASURES,
    OF,
    SHARE,
    TIMES,
    charts_of,
    motions_of,
    rows_of,
    stays,
)
from helicoide.studies._coutinho_runs import E1_DEPTH, E1_START, FILTERED, ROBOT, Run, control, crossings
from helicoide.studies._coutinho_runs import run as run_along
from helicoide.studies._coutinho_simulation import part
from helicoide.studies.study import Fitted, Progress, Result, Row, Statement, printed, unstated
from helicoide.text import Text, same

TITLE = Text(en="E1: three methods beside each other", pt_BR="E1: três métodos lado a lado")
SOURCE = "Coutinho 2015, §4.2.1, figs. 4.27–4.30, tab. 4.3"
ABOUT = Text(
    en="The experiment on the robot: tool and entry point swing to and fro, and on the way the wrist passes θ₇ = 0. "
    "There the plain inverse makes the joints race; damping and the filtered inverse trade accuracy of the tip for "
    "calm joints, and which of them is better depends on κ, Γ and the path. At every instant all hold the entry "
    "point still; over steps of 2 ms the racing joints of the plain inverse nevertheless carry the shaft away from it.",
    pt_BR="O experimento no robô: ponta e ponto de entrada oscilam, e no caminho o punho passa por θ₇ = 0. Ali a "
    "inversa simples faz as juntas dispararem; o amortecimento e a inversa filtrada trocam precisão da ponta por "
    "juntas calmas, e qual é melhor depende de κ, Γ e da trajetória. A cada instante todos mantêm parado o ponto de "
    "entrada; mas, a passos de 2 ms, as juntas disparadas da inversa simples afastam dele a haste.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

# The short form ends before the singularity.
SECONDS = 4.0
INVERSES: Mapping[str, tuple[Text, Inverse]] = {
    "plain": (Text(en="plain inverse", pt_BR="inversa simples"), PSEUDOINVERSE),
    "damped": (Text(en="damped, κ = 0.01", pt_BR="amortecida, κ = 0,01"), inverse("damped", damping=0.01)),
    "filtered": (Text(en="filtered inverse, Γ = 5", pt_BR="inversa filtrada, Γ = 5"), FILTERED),
}
GAIN = Text(en="gains", pt_BR="ganhos")
CHOICES = {name: same(f"Kp = {Kp:g}, Ko = {Ko:g}") for name, (Kp, Ko) in GAINS.items()}
SAMPLES = 5000
# By tests/studies/fits/coutinho_e1.py.
STARTED = (
    Fitted(same("l_a(0)"), E1_DEPTH, 0.074, 0.0957, "m"),
    Fitted(same("θ₇(0)"), 0.142, 0.1349, 0.1491, "rad"),
    Fitted(same("θ₈(0)"), -2.58, -2.838, -2.322, "rad"),
)
LAGS = Text(
    en="Θ follows the inverse with Γ = 5 more slowly than κ = 0.01 lets the damped one give way",
    pt_BR="Θ segue a inversa com Γ = 5 mais devagar do que κ = 0,01 deixa a amortecida ceder",
)
TWO = Text(en="two points of singularity", pt_BR="dois pontos de singularidade")
WITHIN = same("θ₇ ∈ [−π/36, π/4]")
NOT_VIABLE = Text(en="not viable near the singularity", pt_BR="inviável perto da singularidade")
GOOD = Text(en="good results", pt_BR="bons resultados")
BETTER = Text(en="the filtered inverse slightly better", pt_BR="a inversa filtrada um pouco melhor")
FOLLOWS = same("H V_r = v_rd")
FASTEST = BY_STEP.format(what=SHARE, step=1e3 * STEP)
LASTED = Text(en="duration of 5000 samples of 2 ms", pt_BR="duração de 5000 amostras de 2 ms")
RATIO = Text(
    en="largest error of the tip, filtered inverse over damped",
    pt_BR="maior erro da ponta, inversa filtrada sobre amortecida",
)
FIGURES = "figs. 4.27–4.30"
CHARTS = ("tip", "entry", "command", "outside", "rate", "q7", "w", "lateral")
MEASURED = ("tip", "angle", "lateral", "outside_max", "rate")


@dataclass(frozen=True)
class Options:
    """Kp and Ko: those of the simulations (table 4.2), or those of the experiments (table 4.3)."""

    gains: Annotated[str, OneOf(GAIN, CHOICES)] = "experiments"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A run for each inverse at 2 ms; short: 4 s of them, which end before the singularity."""
    Kp, Ko = GAINS[options.gains]
    runs: dict[str, Run] = {}
    for done, (name, (_, of_tool)) in enumerate(INVERSES.items()):
        gained = control(of_tool=of_tool, position=Kp, orientation=Ko)
        told = part(progress, done, len(INVERSES))
        runs[name] = run_along("E1", gained, STEP, E1_START, E1_DEPTH, SECONDS if short else None, told)
    titled = {INVERSES[name][0]: got for name, got in runs.items()}
    rows = (
        *_always(titled),
        *(() if short else _crossed(runs)),
        *(one for which, got in titled.items() for one in rows_of(got, which, STEP, FIGURES, MEASURED, MEASURED)),
    )
    return Result(
        rows=rows if options == Options() else unstated(rows),
        charts=charts_of(titled, dict.fromkeys(CHARTS, FIGURES), ("tip", "rate")),
        motions=motions_of(titled),
    )


def _always(titled: Mapping[Text, Run]) -> list[Row]:
    """What holds from the beginning on: the entry point, and the times that are printed."""
    rows = [stays(got, "eq. 3.30", FOLLOWS, which) for which, got in titled.items()]
    for which, got in titled.items():
        rows.append(
            Row(OF.format(what=ENTRY, which=which), 0.1 * float(got["v_x"].max()), "cm/s", printed("1", "§4.2.1"))
        )
    return [*rows, Row(LASTED, SAMPLES * STEP, "s", printed("≈ 45", "§4.2.1"), erratum="coutinho-10")]


def _crossed(runs: Mapping[str, Run]) -> list[Row]:
    """What the source says of the singularity."""
    rows = []
    for name in ("damped", "filtered"):
        got, which = runs[name], INVERSES[name][0]
        stated = (
            (TIMES, crossings(got["q7"]), "", Statement(TWO, "§4.2.1", 2.0)),
            (MEASURES["q7_min"].title, float(got["q7"].min()), "rad", Statement(WITHIN, "§4.2.1", -pi / 36, "≥")),
            (MEASURES["q7_max"].title, float(got["q7"].max()), "rad", Statement(WITHIN, "§4.2.1", pi / 4, "≤", 1e-3)),
            (FASTEST, float(got["of_speed"].max()), "", Statement(GOOD, "§4.2.1", 1.0, "≤")),
        )
        rows += [Row(OF.format(what=what, which=which), ours, unit, said, STARTED) for what, ours, unit, said in stated]
    plain, which = runs["plain"], INVERSES["plain"][0]
    raced = Statement(NOT_VIABLE, "§4.2.1", 1.0, ">")
    ratio = float(runs["filtered"]["tip_mm"].max() / runs["damped"]["tip_mm"].max())
    return [
        *rows,
        Row(OF.format(what=FASTEST, which=which), float(plain["of_speed"].max()), "", raced, STARTED),
        Row(RATIO, ratio, "", Statement(BETTER, "§4.2.1", 1.0, "<"), why=LAGS),
    ]
