"""E1: the comparison of methods on the robot, through a singularity and with an entry point that moves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi
from typing import Annotated

import numpy as np

from helicoide.ik.method import ConfiguredMethod, OneOf
from helicoide.ik.methods import configured_method
from helicoide.ik.rcm.follow import PSEUDOINVERSE
from helicoide.ik.rcm.paths import SAMPLE
from helicoide.studies._coutinho_hand import BODY_FRAME_ERROR, ENTRY_SPEED, GAINS, STEP
from helicoide.studies._coutinho_rows import (
    ARM,
    BY_STEP,
    ENTRY,
    MISSED,
    OF,
    SHARE,
    TIMES,
    leaving_rate_row,
    measure_rows,
    run_charts,
    run_motions,
)
from helicoide.studies._coutinho_runs import (
    E1_DEPTH,
    E1_START,
    FILTERED,
    ROBOT,
    Run,
    RunStart,
    sign_changes,
    source_control,
)
from helicoide.studies._coutinho_runs import run_path as run_along
from helicoide.studies._coutinho_simulation import share_of_progress
from helicoide.studies.study import (
    BY_CONSTRUCTION,
    INPUT_VALUE,
    Fitted,
    Interpretation,
    Progress,
    Result,
    Row,
    Statement,
    printed_statement,
)
from helicoide.text import Text, untranslated

TITLE = Text(en="E1: three methods compared", pt_BR="E1: comparação de três métodos")
SOURCE = "Coutinho 2015, §4.2.1, figs. 4.27–4.30, tab. 4.3"
ABOUT = Text(
    en="The experiment on the robot: end effector and entry point swing to and fro, and on the way the wrist passes θ₇ "
    "= 0. There the plain inverse makes the joints race; damping and the filtered inverse trade accuracy of the tip "
    "for calm joints, and which of them is better depends on κ, Γ and the path. At each instant the shaft follows the "
    "entry point by all three, H V_r = v_rd: its velocity there across its axis, H V_r, is that of the point, v_rd; "
    "over steps of 2 ms the racing joints of the plain inverse carry it 118 mm away, the other two keep it to 0.01 mm. "
    "The start is ours: of 1551 random ones two show the crossings and the racing joints that are told of E1; that the "
    "filtered inverse is slightly better was not reproduced from it.",
    pt_BR="O experimento no robô: ponta e ponto de entrada oscilam, e no caminho o punho passa por θ₇ = 0. Ali a "
    "inversa simples faz as juntas dispararem; o amortecimento e a inversa filtrada trocam precisão da ponta por "
    "juntas calmas, e qual é melhor depende de κ, Γ e da trajetória. A cada instante a haste acompanha o ponto de "
    "entrada com os três, H V_r = v_rd: a velocidade dela ali, transversal ao eixo, H V_r, é a do ponto, v_rd; a "
    "passos de 2 ms, as juntas disparadas da inversa simples a levam a 118 mm dele, e as outras duas a mantêm a 0,01 "
    "mm. O início é nosso: de 1551 aleatórios, dois mostram os cruzamentos e as juntas disparadas de que se fala em "
    "E1; que a inversa filtrada seja um pouco melhor não se reproduziu a partir dele.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

# A quick run passes through the singularity once.
SECONDS = 4.0
INVERSES: Mapping[str, tuple[Text, ConfiguredMethod]] = {
    "plain": (Text(en="plain inverse", pt_BR="inversa simples"), PSEUDOINVERSE),
    "damped": (Text(en="damped, κ = 0.01", pt_BR="amortecida, κ = 0,01"), configured_method("damped", damping=0.01)),
    "filtered": (Text(en="filtered inverse, Γ = 5", pt_BR="inversa filtrada, Γ = 5"), FILTERED),
}
GAIN = Text(en="gains", pt_BR="ganhos")
CHOICES = {
    name: Text(en=f"Kp = {Kp:g}, Ko = {Ko:g}", pt_BR=f"Kp = {Kp:g}; Ko = {Ko:g}".replace(".", ","))
    for name, (Kp, Ko) in GAINS.items()
}
SAMPLES = 5000
CHOSEN = Interpretation(
    Text(en="a rare start", pt_BR="um início raro"),
    Text(
        en="from 1549 of 1551 random starts not all of it comes out",
        pt_BR="de 1549 entre 1551 inícios aleatórios nem tudo isso resulta",
    ),
)
# By tests/studies/fits/coutinho_e1.py.
STARTED = (
    ARM,
    Fitted(untranslated("l_a(0)"), E1_DEPTH, 0.074, 0.0957, "m"),
    Fitted(untranslated("θ₇(0)"), 0.142, 0.1349, 0.1491, "rad"),
    Fitted(untranslated("θ₈(0)"), -2.58, -2.838, -2.322, "rad"),
    CHOSEN,
    BODY_FRAME_ERROR,
)
CONTAINED = Text(
    en="from our start θ₇ stays within the range, −0.02 to 0.57 rad, and does not run through it",
    pt_BR="do nosso início θ₇ fica dentro da faixa, de −0,02 a 0,57 rad, e não a percorre toda",
)
LAGS = Text(
    en="not reproduced from our start, where with Γ = 5 Θ lags behind the inverse",
    pt_BR="não reproduzido a partir do nosso início, em que, com Γ = 5, Θ se atrasa em relação à inversa",
)
TWO = Text(en="two points of singularity", pt_BR="dois pontos de singularidade")
WITHIN = untranslated("θ₇ ∈ [−π/36, π/4]")
NOT_VIABLE = Text(en="not viable near the singularity", pt_BR="inviável perto da singularidade")
GOOD = Text(en="good results", pt_BR="bons resultados")
BETTER = Text(en="the filtered inverse slightly better", pt_BR="a inversa filtrada um pouco melhor")
FOLLOWED = Statement(untranslated("H V_r = v_rd"), "eq. 3.30", 1e3 * MISSED * ENTRY_SPEED, "≤")
HALF_A_DEGREE = pi / 360
FASTEST = BY_STEP.format(what=SHARE, step=1e3 * STEP)
LASTED = Text(
    en="duration of 5000 samples of the path, 9 ms each", pt_BR="duração de 5000 amostras da trajetória, de 9 ms cada"
)
RANGE = Text(
    en="how far the ends of the way of θ₇ are from those of its range, at most",
    pt_BR="quanto os extremos do percurso de θ₇ distam dos da faixa, no máximo",
)
OF_ALL = Text(en="all three", pt_BR="os três")
AT_ONCE = Text(
    en="at each instant, by how much the velocity of the shaft at the entry point misses v_rd",
    pt_BR="a cada instante, quanto a velocidade da haste no ponto de entrada difere de v_rd",
)
BOUNDED = Text(en="damped and filtered", pt_BR="amortecida e filtrada")
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
        gained = source_control(of_tool=of_tool, position=Kp, orientation=Ko)
        told = share_of_progress(progress, done, len(INVERSES))
        runs[name] = run_along("E1", gained, STEP, RunStart(E1_START, E1_DEPTH), SECONDS if short else None, told)
    titled = {INVERSES[name][0]: got for name, got in runs.items()}
    rows = (
        *(() if short else _crossed(runs)),
        *_followed_path(runs),
        *_put_in(runs["plain"]),
        *(one for name, got in runs.items() for one in _measured(name, got, short)),
    )
    return Result(
        rows=rows,
        charts=run_charts(titled, dict.fromkeys(CHARTS, FIGURES), ("tip", "rate")),
        motions=run_motions(titled),
    )


def _put_in(got: Run) -> list[Row]:
    """How fast the entry point moves, and how long it takes."""
    return [
        Row(ENTRY, 0.1 * float(got["v_x"].max()), "cm/s", printed_statement("1", "§4.2.1"), given=INPUT_VALUE),
        Row(LASTED, SAMPLES * SAMPLE, "s", printed_statement("≈ 45", "§4.2.1"), given=INPUT_VALUE),
    ]


def _measured(name: str, got: Run, short: bool) -> list[Row]:
    """What the source does not print; the ends of the way of θ₇ only where the whole of it was run."""
    names = MEASURED if short or name == "plain" else (*MEASURED, "q7_min", "q7_max")
    return measure_rows(got, INVERSES[name][0], STEP, FIGURES, names, MEASURED)


def _crossed(runs: Mapping[str, Run]) -> list[Row]:
    """What the source says of the way through the singularity."""
    rows = []
    for name in ("damped", "filtered"):
        got, which = runs[name], INVERSES[name][0]
        rows += [
            Row(_of(TIMES, which), sign_changes(got["q7"]), "", Statement(TWO, "§4.2.1", 2.0), STARTED),
            Row(_of(FASTEST, which), float(got["of_speed"].max()), "", Statement(GOOD, "§4.2.1", 1.0, "≤"), STARTED),
        ]
    bounded = (runs["damped"], runs["filtered"])
    ends = [(got["q7"].min() + pi / 36, got["q7"].max() - pi / 4) for got in bounded]
    apart = float(np.abs(ends).max())
    ratio = float(runs["filtered"]["tip_mm"].max() / runs["damped"]["tip_mm"].max())
    ranged = Statement(WITHIN, "§4.2.1", 0.0, "=", HALF_A_DEGREE)
    return [
        *rows,
        Row(_of(RANGE, BOUNDED), apart, "rad", ranged, STARTED, why=CONTAINED),
        Row(RATIO, ratio, "", Statement(BETTER, "§4.2.1", 1.0, "<"), STARTED, why=LAGS),
    ]


def _followed_path(runs: Mapping[str, Run]) -> list[Row]:
    """Whether the joints race, and how the shaft follows its entry point: at each instant, and over steps."""
    raced = Statement(NOT_VIABLE, "§4.2.1", 1.0, ">")
    fastest = float(runs["plain"]["of_speed"].max())
    slip = max(float(got["slip_mm_s"].max()) for got in runs.values())
    return [
        Row(_of(FASTEST, INVERSES["plain"][0]), fastest, "", raced, STARTED),
        Row(_of(AT_ONCE, OF_ALL), slip, "mm/s", FOLLOWED, given=BY_CONSTRUCTION),
        *(leaving_rate_row(got, STEP, which=INVERSES[name][0]) for name, got in runs.items()),
    ]


def _of(what: Text, which: Text) -> Text:
    return OF.format(what=what, which=which)
