"""Algorithm 1: a gain for each joint, which grows whenever the joint is clipped at its limit."""

from __future__ import annotations

from dataclasses import dataclass
from math import log
from typing import Annotated

from helicoide.ik.limit_gains import GROWTH, LimitGainMemory
from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.confined import limit_margins
from helicoide.studies.cerbaro_runs.runs import (
    FARTHER,
    NEAREST,
    LoopRun,
    error_chart,
    joint_charts,
    loop_motion,
    mean_cost,
    share_of_runs,
)
from helicoide.studies.cerbaro_runs.tracking import (
    DT,
    TURN,
    LimitGain,
    gain_in_degrees,
    run_free_ellipse,
    start_inside,
    start_of_ellipse,
    zero_feedforward,
)
from helicoide.studies.study import BY_CONSTRUCTION, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="Algorithm 1: gains that grow", pt_BR="Algoritmo 1: ganhos que crescem")
SOURCE = "Cerbaro 2022, §4.5, alg. 1, fig. 38"
ROBOT = "movemaster"
ABOUT = Text(
    en="After every step a joint beyond its limit is clipped, that is, put back on it, and its gain grows by a "
    "hundredth. Where the ellipse begins, J3 is already 9.9° out of range, and the first clip throws the end effector "
    "off for an instant; it also brings the arm into another posture, in which J3 then stays farther from its limit, "
    "whether the gains grow or not. With k₀ = 500 counted in degrees, with the 6 that eq. 14 prints, and with J3 just "
    "inside its limit at the start, all that is said of figs. 37 and 38 of J3 and of the error comes out, not what is "
    "said of J4: with one gain J3 passes its limit, with gains that grow it stays inside, and the end effector "
    "notices nothing. These numbers stand apart, since 500 in degrees does not fit the other demonstrations. Here no "
    "velocity ẋ_d of the path is fed forward, as the errors that are stated for fig. 36 suggest. −w (eq. 12) measures "
    "how far all joints are from the middle of their ranges.",
    pt_BR="Depois de cada passo, uma junta além do limite é saturada, isto é, volta para ele, e seu ganho cresce um "
    "centésimo. Na postura em que a elipse começa, J3 já está 9,9° fora da faixa, e a primeira saturação desvia o "
    "efetuador por um instante; ela também leva o braço a outra postura, em que J3 fica depois mais longe do seu "
    "limite, cresçam os ganhos ou não. Com k₀ = 500 contado em graus, com o 6 que a eq. 14 imprime, e com J3 "
    "partindo logo antes do limite, acontece tudo o que se diz das figs. 37 e 38 de J3 e do erro, não o que se diz de "
    "J4: com um só ganho J3 ultrapassa o limite, com ganhos que crescem fica dentro, e o efetuador nem percebe. Esses "
    "números ficam à parte, pois 500 em graus não combina com as outras demonstrações. Aqui não se antecipa nenhuma "
    "velocidade ẋ_d da trajetória, como sugerem os erros que se dizem da fig. 36. −w (eq. 12) mede quanto todas as "
    "juntas se afastam do meio das suas faixas.",
)
SHORT, SETTLED = 4.0, 0.1
BENT = (1, 2, 3)  # J2 to J4

KEPT = Statement(
    Text(en="J2 to J4 stay inside their limits", pt_BR="J2 a J4 ficam dentro dos limites"),
    "§4.5, fig. 38",
    0.0,
    "≥",
    1e-9,
)
UNCHANGED = Statement(
    Text(en="the profile of the position error is unchanged", pt_BR="o perfil do erro de posição não muda"),
    "§4.5, fig. 38",
    1.0,
    "=",
    0.1,
)
OUTSIDE = Text(
    en="J3 begins 9.9° beyond its limit; to put it there at once moves the end effector by 75 mm",
    pt_BR="J3 parte 9,9° além do limite; levá-la até ele de uma vez desloca o efetuador 75 mm",
)


@dataclass(frozen=True)
class Options:
    """gain: k₀ of the source; inside: how far inside its limit J3 begins where k₀ is counted in degrees."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 1.0, 1000.0, "1/s")] = 500.0
    inside: Annotated[
        float,
        Quantity(
            Text(
                en="with k₀ in degrees: J3 begins inside its limit by",
                pt_BR="com k₀ em graus: J3 parte aquém do limite por",
            ),
            0.0,
            20.0,
            "°",
        ),
    ] = 0.1


@dataclass(frozen=True, eq=False)
class GainRuns:
    """Runs with one gain, growing gains, and clips alone, from the printed start; two in degrees, from inside."""

    one: LoopRun
    grown: LoopRun
    clipped: LoopRun
    one_in_degrees: LoopRun
    grown_in_degrees: LoopRun


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The turn in steps of 1 ms without ẋ_d, as the errors of the source have it; short: its first 4 s."""
    runs = gain_runs(options, SHORT if short else TURN, progress)
    named = (
        (Text(en="one gain", pt_BR="um só ganho"), runs.one),
        (Text(en="Algorithm 1", pt_BR="Algoritmo 1"), runs.grown),
        (Text(en="gains that do not grow", pt_BR="ganhos que não crescem"), runs.clipped),
        (Text(en="one gain, k₀ in degrees", pt_BR="um só ganho, k₀ em graus"), runs.one_in_degrees),
        (Text(en="Algorithm 1, k₀ in degrees", pt_BR="Algoritmo 1, k₀ em graus"), runs.grown_in_degrees),
    )
    charts = (*joint_charts("fig. 38", setups.movemaster(), (2, 3, 4), *named), error_chart("fig. 38", *named))
    found = algorithm_1_rows(runs, short)
    motions = tuple(loop_motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def gain_runs(options: Options, seconds: float, progress: Progress) -> GainRuns:
    """The five runs."""
    printed, inside = start_of_ellipse(), start_inside(options.inside)
    in_radians, in_deg = options.gain, gain_in_degrees(options.gain, len(inside))
    asked = (
        (printed, LimitGain(in_radians)),
        (printed, LimitGain(in_radians, GROWTH)),
        (printed, LimitGain(in_radians, 1.0)),
        (inside, LimitGain(in_deg)),
        (inside, LimitGain(in_deg, GROWTH)),
    )
    return GainRuns(
        *(
            run_free_ellipse(q, gain, DT, share_of_runs(progress, i, len(asked)), seconds, zero_feedforward)
            for i, (q, gain) in enumerate(asked)
        )
    )


def growth_of_j3(run: LoopRun) -> float:
    """The final gain of J3 over its initial value, which J1 keeps as it is never at its limit."""
    memory = run.last.memory
    assert isinstance(memory, LimitGainMemory)
    return float(memory.gains[2] / memory.gains[0])


def margin_after_start(run: LoopRun, *joints: int) -> float:
    """The least margin of joints, the first is 0, to their limits after the first step, degrees."""
    return float(limit_margins(setups.movemaster(), run.since(DT).q)[[*joints]].min())


def margin_after_clips(run: LoopRun) -> float:
    """The least margin of any joint to its limits once the first clips are over, degrees."""
    return float(limit_margins(setups.movemaster(), run.since(SETTLED).q).min())


def error_ratio(grown: LoopRun, one: LoopRun) -> float:
    """The largest position error by Algorithm 1 as a share of that by one gain."""
    return float(grown.position_error.max() / one.position_error.max())


def algorithm_1_rows(runs: GainRuns, short: bool) -> tuple[Row, ...]:
    """What the source says of fig. 38, then the other unit; a quick run does not cover the whole turn."""
    staying = Text(
        en="Algorithm 1: least margin of J2 to J4 to their limits",
        pt_BR="Algoritmo 1: menor folga de J2 a J4 até os limites",
    )
    share = Text(
        en="largest position error, over that by one gain", pt_BR="maior erro de posição, sobre o de um só ganho"
    )
    farther = Text(
        en="least margin by Algorithm 1 after {t:g} s, less that by one gain",
        pt_BR="menor folga com o Algoritmo 1 após {t:g} s, menos a de um só ganho",
    ).format(t=SETTLED)
    steady = Text(
        en="least margin by clips alone, gains not growing, after {t:g} s, less that by one gain",
        pt_BR="menor folga só com a saturação, sem crescerem os ganhos, após {t:g} s, menos a de um só ganho",
    ).format(t=SETTLED)
    mean = Text(
        en="mean of −w by Algorithm 1, over that by one gain",
        pt_BR="média de −w com o Algoritmo 1, sobre a de um só ganho",
    )
    thrown = Text(en="position error after the first clip", pt_BR="erro de posição após a primeira saturação")
    stated = [
        Row(staying, margin_after_start(runs.grown, *BENT), "°", KEPT, given=BY_CONSTRUCTION),
        Row(share, error_ratio(runs.grown, runs.one), "", UNCHANGED, why=OUTSIDE),
    ]
    if not short:
        one_gain, movemaster = margin_after_clips(runs.one), setups.movemaster()
        less = mean_cost(movemaster, runs.grown.q) / mean_cost(movemaster, runs.one.q)
        stated += [
            Row(farther, margin_after_clips(runs.grown) - one_gain, "°", FARTHER, (NEAREST,)),
            Row(steady, margin_after_clips(runs.clipped) - one_gain, "°"),
            Row(mean, less),
        ]
    one, grown, growth = runs.one_in_degrees, runs.grown_in_degrees, growth_of_j3(runs.grown_in_degrees)
    apart = Text(en="k₀ in degrees, start inside: {what}", pt_BR="k₀ em graus, partida dentro: {what}")
    other = (
        (
            Text(en="one gain: least margin of J3", pt_BR="um só ganho: menor folga de J3"),
            margin_after_start(one, 2),
            "°",
        ),
        (staying, margin_after_start(grown, *BENT), "°"),
        (share, error_ratio(grown.since(SETTLED), one.since(SETTLED)), ""),
        (Text(en="clips of J3", pt_BR="saturações de J3"), log(growth) / log(GROWTH), ""),
        (Text(en="gain of J3 at the end, over k₀", pt_BR="ganho de J3 no fim, sobre k₀"), growth, ""),
    )
    return (
        *stated,
        Row(thrown, float(runs.grown.position_error.max()), "mm"),
        *(Row(apart.format(what=what), ours, unit) for what, ours, unit in other),
    )
