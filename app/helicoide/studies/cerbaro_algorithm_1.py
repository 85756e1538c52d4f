"""Algorithm 1: a gain for each joint, which grows whenever the joint is clipped at its limit."""

from __future__ import annotations

from dataclasses import dataclass
from math import log
from typing import Annotated

from helicoide.ik.limit_gains import GROWTH, Memory
from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.confined import margins
from helicoide.studies.cerbaro_runs.runs import (
    FARTHER,
    NEAREST,
    Run,
    error_chart,
    joint_charts,
    mean_cost,
    motion,
    part,
)
from helicoide.studies.cerbaro_runs.tracking import (
    DT,
    TURN,
    LimitGain,
    free_ellipse,
    in_degrees,
    start_inside,
    start_of_ellipse,
    unfed,
)
from helicoide.studies.study import CONSTRUCTED, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="Algorithm 1: gains that grow", pt_BR="Algoritmo 1: ganhos que crescem")
SOURCE = "Cerbaro 2022, §4.5, alg. 1, fig. 38"
ROBOT = "movemaster"
ABOUT = Text(
    en="After every step a joint beyond its limit is clipped, that is, put back on it, and its gain grows by a "
    "hundredth. Where the ellipse begins, J3 is already 9.9° out of range, and the first clip throws the tool off for "
    "an instant; it also brings the arm into another posture, in which J3 then stays farther from its limit, whether "
    "the gains grow or not. With k₀ = 500 counted in degrees, with the 6 that eq. 14 prints, and with J3 just inside "
    "its limit at the start, all that is said of figs. 37 and 38 of J3 and of the error comes out, "
    "not what is said of J4: with one gain J3 passes its limit, with gains that grow it stays inside, and the tool "
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
    en="J3 begins 9.9° beyond its limit; to put it there at once moves the tool by 75 mm",
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
class Runs:
    """Runs with one gain, growing gains, and clips alone, from the printed start; two in degrees, from inside."""

    one: Run
    grown: Run
    clipped: Run
    one_in_degrees: Run
    grown_in_degrees: Run


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The turn in steps of 1 ms without ẋ_d, as the errors of the source have it; short: its first 4 s."""
    runs = made(options, SHORT if short else TURN, progress)
    named = (
        (Text(en="one gain", pt_BR="um só ganho"), runs.one),
        (Text(en="Algorithm 1", pt_BR="Algoritmo 1"), runs.grown),
        (Text(en="gains that do not grow", pt_BR="ganhos que não crescem"), runs.clipped),
        (Text(en="one gain, k₀ in degrees", pt_BR="um só ganho, k₀ em graus"), runs.one_in_degrees),
        (Text(en="Algorithm 1, k₀ in degrees", pt_BR="Algoritmo 1, k₀ em graus"), runs.grown_in_degrees),
    )
    charts = (*joint_charts("fig. 38", arms.movemaster(), (2, 3, 4), *named), error_chart("fig. 38", *named))
    found = rows(runs, short)
    motions = tuple(motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def made(options: Options, seconds: float, progress: Progress) -> Runs:
    """The five runs."""
    printed, inside = start_of_ellipse(), start_inside(options.inside)
    in_radians, in_deg = options.gain, in_degrees(options.gain, len(inside))
    asked = (
        (printed, LimitGain(in_radians)),
        (printed, LimitGain(in_radians, GROWTH)),
        (printed, LimitGain(in_radians, 1.0)),
        (inside, LimitGain(in_deg)),
        (inside, LimitGain(in_deg, GROWTH)),
    )
    return Runs(
        *(free_ellipse(q, gain, DT, part(progress, i, len(asked)), seconds, unfed) for i, (q, gain) in enumerate(asked))
    )


def growth_of_j3(run: Run) -> float:
    """The final gain of J3 over its initial value, which J1 keeps as it is never at its limit."""
    memory = run.last.memory
    assert isinstance(memory, Memory)
    return float(memory.gains[2] / memory.gains[0])


def room(run: Run, *joints: int) -> float:
    """The least margin of joints, the first is 0, to their limits after the first step, degrees."""
    return float(margins(arms.movemaster(), run.since(DT).q)[[*joints]].min())


def settled_room(run: Run) -> float:
    """The least margin of any joint to its limits once the first clips are over, degrees."""
    return float(margins(arms.movemaster(), run.since(SETTLED).q).min())


def worse(grown: Run, one: Run) -> float:
    """The largest position error by Algorithm 1 as a share of that by one gain."""
    return float(grown.error.max() / one.error.max())


def rows(runs: Runs, short: bool) -> tuple[Row, ...]:
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
        Row(staying, room(runs.grown, *BENT), "°", KEPT, given=CONSTRUCTED),
        Row(share, worse(runs.grown, runs.one), "", UNCHANGED, why=OUTSIDE),
    ]
    if not short:
        one_gain, movemaster = settled_room(runs.one), arms.movemaster()
        less = mean_cost(movemaster, runs.grown.q) / mean_cost(movemaster, runs.one.q)
        stated += [
            Row(farther, settled_room(runs.grown) - one_gain, "°", FARTHER, (NEAREST,)),
            Row(steady, settled_room(runs.clipped) - one_gain, "°"),
            Row(mean, less),
        ]
    one, grown, growth = runs.one_in_degrees, runs.grown_in_degrees, growth_of_j3(runs.grown_in_degrees)
    apart = Text(en="k₀ in degrees, start inside: {what}", pt_BR="k₀ em graus, partida dentro: {what}")
    other = (
        (Text(en="one gain: least margin of J3", pt_BR="um só ganho: menor folga de J3"), room(one, 2), "°"),
        (staying, room(grown, *BENT), "°"),
        (share, worse(grown.since(SETTLED), one.since(SETTLED)), ""),
        (Text(en="clips of J3", pt_BR="saturações de J3"), log(growth) / log(GROWTH), ""),
        (Text(en="gain of J3 at the end, over k₀", pt_BR="ganho de J3 no fim, sobre k₀"), growth, ""),
    )
    return (
        *stated,
        Row(thrown, float(runs.grown.error.max()), "mm"),
        *(Row(apart.format(what=what), ours, unit) for what, ours, unit in other),
    )
