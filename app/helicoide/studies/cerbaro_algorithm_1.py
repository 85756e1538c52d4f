"""Algorithm 1: a gain for each joint, which grows whenever the joint is stopped at its limit."""

from __future__ import annotations

from dataclasses import dataclass
from math import log
from typing import Annotated

import numpy as np

from helicoide.ik.limit_gains import GROWTH, Memory
from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_charts, motion, part
from helicoide.studies.cerbaro_runs.tracking import DT, TURN, free_ellipse, start_inside, start_of_ellipse, unfed
from helicoide.studies.study import Fitted, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="Algorithm 1: gains that grow", pt_BR="Algoritmo 1: ganhos que crescem")
SOURCE = "Cerbaro 2022, §4.5, alg. 1, fig. 38"
ROBOT = "movemaster"
ABOUT = Text(
    en="After every step a joint beyond its limit is put back on it, and its gain grows by a hundredth. Where J3 "
    "begins just inside its limit and is pulled off it weakly, one gain lets it pass; with gains that grow it stays "
    "inside, and the tool notices nothing. From the posture of the demonstration before, which is itself out of range, "
    "the first stop throws the tool off for an instant.",
    pt_BR="Depois de cada passo, uma junta além do limite volta para ele, e seu ganho cresce um centésimo. Quando J3 "
    "parte logo antes do limite e é afastada dele com pouca força, um só ganho a deixa passar; com ganhos que crescem "
    "ela fica dentro, e o efetuador nem percebe. Da postura da demonstração anterior, que já está fora da faixa, a "
    "primeira parada desvia o efetuador por um instante.",
)
# Found by tests/studies/fits/cerbaro_algorithm_1.py.
GAIN = Fitted(Text(en="first gain k₀", pt_BR="ganho inicial k₀"), 0.25, 0.2, 0.35, "1/s")
INSIDE = Fitted(
    Text(en="J3 at the start, inside its limit by", pt_BR="J3 na partida, aquém do limite por"), 0.1, 0.02, 0.2, "°"
)
FITTED = (GAIN, INSIDE)
PRINTED_GAIN, SHORT, SETTLED = 500.0, 4.0, 0.1

PASSES = Statement(Text(en="J3 passes its limit", pt_BR="J3 ultrapassa o limite"), "§4.4.4, fig. 37", 0.0, "<")
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
FARTHER = Statement(
    Text(
        en="the joints tend to stay farther from their limits than with one gain",
        pt_BR="as juntas tendem a ficar mais longe dos limites do que com um só ganho",
    ),
    "§6.3",
    0.0,
    ">",
)
NEARER = Statement(
    Text(en="J4 ends nearer its limit than with k₀ = 0", pt_BR="J4 acaba mais perto do limite do que com k₀ = 0"),
    "§4.4.4, fig. 37",
    0.0,
    "<",
)
OUTSIDE = Text(
    en="J3 begins 9.9° beyond its limit; to put it there at once moves the tool by 75 mm",
    pt_BR="J3 parte 9,9° além do limite; levá-la até ele de uma vez desloca o efetuador 75 mm",
)


@dataclass(frozen=True)
class Options:
    """gain: k₀ with which every joint begins; inside: how far from its limit J3 does. Both are fitted."""

    gain: Annotated[float, Quantity(GAIN.name, 0.05, 1000.0, "1/s")] = GAIN.value
    inside: Annotated[float, Quantity(INSIDE.name, 0.0, 20.0, "°")] = INSIDE.value


@dataclass(frozen=True, eq=False)
class Runs:
    """A turn from inside the limits without the objective, by one gain and by growing ones; both from outside."""

    none: Run
    one: Run
    grown: Run
    one_outside: Run
    grown_outside: Run


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The turn in steps of 1 ms without ẋ_d, as the errors of the source have it; short: its first 4 s."""
    runs = made(options, SHORT if short else TURN, progress)
    named = (
        (Text(en="k₀ = 0", pt_BR="k₀ = 0"), runs.none),
        (Text(en="one gain", pt_BR="um só ganho"), runs.one),
        (Text(en="Algorithm 1", pt_BR="Algoritmo 1"), runs.grown),
    )
    outside = Text(en="Algorithm 1, start outside, k₀ = 500", pt_BR="Algoritmo 1, partida fora, k₀ = 500")
    charts = (
        *joint_charts("fig. 38", arms.movemaster(), (2, 3, 4), *named),
        error_chart("fig. 38", *named, (outside, runs.grown_outside)),
    )
    found = rows(runs, short)
    motions = tuple(motion(ROBOT, title, one) for title, one in (*named, (outside, runs.grown_outside)))
    return Result(found, charts, motions)


def made(options: Options, seconds: float, progress: Progress) -> Runs:
    """The five runs; those from outside end after a second."""
    inside, outside = start_inside(options.inside), start_of_ellipse()
    asked = (
        (inside, 0.0, False, seconds),
        (inside, options.gain, False, seconds),
        (inside, options.gain, True, seconds),
        (outside, PRINTED_GAIN, False, 1.0),
        (outside, PRINTED_GAIN, True, 1.0),
    )
    return Runs(
        *(
            free_ellipse(q, k0, DT, grows, part(progress, i, len(asked)), lasts, unfed)
            for i, (q, k0, grows, lasts) in enumerate(asked)
        )
    )


def growth_of_j3(run: Run) -> float:
    """How many times its first value the gain of J3 is at the end of a run; J1 is never at its limit."""
    memory = run.last.memory
    assert isinstance(memory, Memory)
    return float(memory.gains[2] / memory.gains[0])


def room(run: Run, *joints: int) -> float:
    """How far joints, the first is 1, stay inside their limits after the first step, degrees."""
    limits, chosen = arms.movemaster().limits, [j - 1 for j in joints]
    q = run.q[1:, chosen]
    return float(np.degrees(np.minimum(q - limits.lower[chosen], limits.upper[chosen] - q).min()))


def worse(grown: Run, one: Run, since: float) -> float:
    """The largest position error by Algorithm 1 from a time on, s, as a share of that by one gain."""
    return float(grown.since(since).error.max() / one.since(since).error.max())


def rows(runs: Runs, short: bool) -> tuple[Row, ...]:
    """What the source says of figs. 37 and 38; the short form does not see how the turn ends."""
    one, grown, growth = runs.one, runs.grown, growth_of_j3(runs.grown)
    passing = Text(en="one gain: J3 inside its limits by", pt_BR="um só ganho: J3 dentro dos limites por")
    staying = Text(en="Algorithm 1: J2 to J4 inside by", pt_BR="Algoritmo 1: J2 a J4 dentro por")
    share = Text(
        en="largest position error, over that by one gain", pt_BR="maior erro de posição, sobre o de um só ganho"
    )
    clips = Text(en="stops of J3 at its limit", pt_BR="paradas de J3 no limite")
    there = Text(en="start outside: {what}", pt_BR="partida fora: {what}")
    found = [
        Row(passing, room(one, 3), "°", PASSES, FITTED),
        Row(staying, room(grown, 2, 3, 4), "°", KEPT, FITTED),
        Row(share, worse(grown, one, SETTLED), "", UNCHANGED, FITTED),
        Row(there.format(what=staying), room(runs.grown_outside, 2, 3, 4), "°", KEPT),
        Row(there.format(what=share), worse(runs.grown_outside, runs.one_outside, 0.0), "", UNCHANGED, why=OUTSIDE),
        Row(clips, log(growth) / log(GROWTH)),
        Row(Text(en="gain of J3 at the end, over k₀", pt_BR="ganho de J3 no fim, sobre k₀"), growth),
        Row(
            Text(
                en="start outside: position error after the first stop",
                pt_BR="partida fora: erro após a primeira parada",
            ),
            float(runs.grown_outside.error.max()),
            "mm",
        ),
    ]
    return tuple(found) if short else (*found, *_of_the_turn(runs))


def _of_the_turn(runs: Runs) -> tuple[Row, ...]:
    lower = np.degrees(arms.movemaster().limits.lower[2])
    off = [float(np.degrees(run.q[:, 2].mean()) - lower) for run in (runs.grown, runs.one)]
    farther = Text(
        en="mean distance of J3 from its limit, more than by one gain",
        pt_BR="distância média de J3 ao limite, a mais que com um só ganho",
    )
    nearer = Text(
        en="one gain: J4 to its limit, more than for k₀ = 0",
        pt_BR="um só ganho: J4 até o limite, a mais que com k₀ = 0",
    )
    return (
        Row(farther, off[0] - off[1], "°", FARTHER, FITTED),
        Row(nearer, room(runs.one, 4) - room(runs.none, 4), "°", NEARER, FITTED),
    )
