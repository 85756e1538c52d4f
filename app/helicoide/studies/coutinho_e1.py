"""E1: the comparison of methods on the robot, through a singularity and with an entry point that moves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.ik.rcm.follow import PSEUDOINVERSE, Inverse, inverse
from helicoide.ik.rcm.paths import SAMPLE
from helicoide.studies._coutinho_hand import ENTRY_SPEED, GAINS, STEP
from helicoide.studies._coutinho_rows import (
    BY_STEP,
    ENTRY,
    LOW,
    MEASURES,
    MISSED,
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
from helicoide.studies.study import PUT_IN, Fitted, Progress, Reading, Result, Row, Statement, printed
from helicoide.text import Text, same

TITLE = Text(en="E1: three methods beside each other", pt_BR="E1: três métodos lado a lado")
SOURCE = "Coutinho 2015, §4.2.1, figs. 4.27–4.30, tab. 4.3"
ABOUT = Text(
    en="The experiment on the robot: tool and entry point swing to and fro, and on the way the wrist passes θ₇ = 0. "
    "There the plain inverse makes the joints race; damping and the filtered inverse trade accuracy of the tip for "
    "calm joints, and which of them is better depends on κ, Γ and the path. At each instant all three follow the entry "
    "point; over steps of 2 ms the racing joints of the plain inverse carry the shaft 118 mm away from it, the other "
    "two keep it to 0.01 mm. The start is ours: of 1551 random ones only two show what is told of E1.",
    pt_BR="O experimento no robô: ponta e ponto de entrada oscilam, e no caminho o punho passa por θ₇ = 0. Ali a "
    "inversa simples faz as juntas dispararem; o amortecimento e a inversa filtrada trocam precisão da ponta por "
    "juntas calmas, e qual é melhor depende de κ, Γ e da trajetória. A cada instante os três acompanham o ponto de "
    "entrada; a passos de 2 ms, as juntas disparadas da inversa simples levam a haste a 118 mm dele, e as outras duas "
    "o mantêm a 0,01 mm. O início é nosso: de 1551 aleatórios, só dois mostram o que se conta de E1.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

# The short form comes through the singularity once.
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
CHOSEN = Reading(
    Text(en="a rare start", pt_BR="um início raro"),
    Text(
        en="in 1549 of 1551 random starts not all of this holds",
        pt_BR="em 1549 de 1551 inícios aleatórios nem tudo isso vale",
    ),
)
STARTED = (
    Fitted(same("l_a(0)"), E1_DEPTH, 0.074, 0.0957, "m"),
    Fitted(same("θ₇(0)"), 0.142, 0.1349, 0.1491, "rad"),
    Fitted(same("θ₈(0)"), -2.58, -2.838, -2.322, "rad"),
    CHOSEN,
)
CONTAINED = Reading(
    Text(en="θ₇ stays within the range", pt_BR="θ₇ fica dentro da faixa"),
    Text(
        en="it would have to run through all of it, which ours does not: −0.02 to 0.57 rad",
        pt_BR="teria de percorrê-la toda, o que o nosso não faz: de −0,02 a 0,57 rad",
    ),
)
LAGS = Text(
    en="with Γ = 5, Θ lags behind the inverse, which costs more than damping by κ = 0.01",
    pt_BR="com Γ = 5, Θ se atrasa em relação à inversa, o que custa mais do que amortecer com κ = 0,01",
)
RACES = Text(
    en="near θ₇ = 0 the joints are so fast that a step of 2 ms is too long",
    pt_BR="perto de θ₇ = 0 as juntas são tão rápidas que um passo de 2 ms é longo demais",
)
TWO = Text(en="two points of singularity", pt_BR="dois pontos de singularidade")
WITHIN = same("θ₇ ∈ [−π/36, π/4]")
NOT_VIABLE = Text(en="not viable near the singularity", pt_BR="inviável perto da singularidade")
GOOD = Text(en="good results", pt_BR="bons resultados")
BETTER = Text(en="the filtered inverse slightly better", pt_BR="a inversa filtrada um pouco melhor")
FOLLOWED = Statement(same("H V_r = v_rd"), "eq. 3.30", 1e3 * MISSED * ENTRY_SPEED, "≤")
FASTEST = BY_STEP.format(what=SHARE, step=1e3 * STEP)
LASTED = Text(
    en="duration of 5000 samples of the path, 9 ms each", pt_BR="duração de 5000 amostras da trajetória, de 9 ms cada"
)
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
    """A run for each inverse at 2 ms; short: 4 s of them, in which the wrist comes through the singularity once."""
    Kp, Ko = GAINS[options.gains]
    runs: dict[str, Run] = {}
    for done, (name, (_, of_tool)) in enumerate(INVERSES.items()):
        gained = control(of_tool=of_tool, position=Kp, orientation=Ko)
        told = part(progress, done, len(INVERSES))
        runs[name] = run_along("E1", gained, STEP, E1_START, E1_DEPTH, SECONDS if short else None, told)
    titled = {INVERSES[name][0]: got for name, got in runs.items()}
    rows = (
        *(() if short else _crossed(runs)),
        *_followed(runs),
        *_put_in(runs["plain"]),
        *(one for name, got in runs.items() for one in _measured(name, got, short)),
    )
    return Result(
        rows=rows,
        charts=charts_of(titled, dict.fromkeys(CHARTS, FIGURES), ("tip", "rate")),
        motions=motions_of(titled),
    )


def _put_in(got: Run) -> list[Row]:
    """How fast the entry point moves, and how long it takes."""
    return [
        Row(ENTRY, 0.1 * float(got["v_x"].max()), "cm/s", printed("1", "§4.2.1"), given=PUT_IN),
        Row(LASTED, SAMPLES * SAMPLE, "s", printed("≈ 45", "§4.2.1"), given=PUT_IN),
    ]


def _measured(name: str, got: Run, short: bool) -> list[Row]:
    """What nobody printed; the error of the tip only where no sentence is about it."""
    names = MEASURED if short or name == "plain" else MEASURED[1:]
    return rows_of(got, INVERSES[name][0], STEP, FIGURES, names, MEASURED)


def _crossed(runs: Mapping[str, Run]) -> list[Row]:
    """What the source says of the way through the singularity."""
    rows = []
    for name in ("damped", "filtered"):
        got, which = runs[name], INVERSES[name][0]
        low, high = Statement(WITHIN, "§4.2.1", -pi / 36, "≥"), Statement(WITHIN, "§4.2.1", pi / 4, "≤", 1e-3)
        tip, least, most = (MEASURES[measure] for measure in ("tip", "q7_min", "q7_max"))
        missed = BY_STEP.format(what=tip.title, step=1e3 * STEP)
        lags = LAGS if name == "filtered" else None
        rows += [
            Row(_of(TIMES, which), crossings(got["q7"]), "", Statement(TWO, "§4.2.1", 2.0), STARTED),
            Row(_of(least.title, which), float(least.of(got)), "rad", low, (*STARTED, CONTAINED)),
            Row(_of(most.title, which), float(most.of(got)), "rad", high, (*STARTED, CONTAINED)),
            Row(_of(FASTEST, which), float(got["of_speed"].max()), "", Statement(GOOD, "§4.2.1", 1.0, "≤"), STARTED),
            Row(_of(missed, which), float(tip.of(got)), "mm", Statement(GOOD, "§4.2.1", LOW, "≤"), STARTED, why=lags),
        ]
    ratio = float(runs["filtered"]["tip_mm"].max() / runs["damped"]["tip_mm"].max())
    return [*rows, Row(RATIO, ratio, "", Statement(BETTER, "§4.2.1", 1.0, "<"), STARTED, why=LAGS)]


def _followed(runs: Mapping[str, Run]) -> list[Row]:
    """Whether the joints race, and whether the shaft follows its entry point all the same."""
    raced = Statement(NOT_VIABLE, "§4.2.1", 1.0, ">")
    fastest = float(runs["plain"]["of_speed"].max())
    whys = {"plain": RACES}
    return [
        Row(_of(FASTEST, INVERSES["plain"][0]), fastest, "", raced, STARTED),
        *(stays(got, STEP, FOLLOWED, STARTED, INVERSES[name][0], whys.get(name)) for name, got in runs.items()),
    ]


def _of(what: Text, which: Text) -> Text:
    return OF.format(what=what, which=which)
