"""Algorithm 1: a gain for each joint, which grows whenever the joint is stopped at its limit."""

from __future__ import annotations

from dataclasses import dataclass
from math import log
from typing import Annotated

import numpy as np

from helicoide.ik.limit_gains import GROWTH, Memory
from helicoide.ik.method import Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_charts, motion, part
from helicoide.studies.cerbaro_runs.tracking import DT, TURN, free_ellipse, start_of_ellipse
from helicoide.studies.study import Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="Algorithm 1: gains that grow", pt_BR="Algoritmo 1: ganhos que crescem")
SOURCE = "Cerbaro 2022, §4.5, alg. 1, fig. 38"
ROBOT = "movemaster"
ABOUT = Text(
    en="After every step a joint beyond its limit is put back on it, and its gain grows by a hundredth. From the "
    "source’s start, which is itself out of range, five such steps are enough and the tool is thrown off for an "
    "instant; from a start within the limits nothing is lost.",
    pt_BR="Depois de cada passo, uma junta além do limite volta para ele, e seu ganho cresce um centésimo. Da partida "
    "da fonte, que já está fora da faixa, bastam cinco desses passos, e o efetuador é desviado por um instante; de uma "
    "partida dentro dos limites nada se perde.",
)
OTHER = Text(en="another gain than the source’s", pt_BR="ganho diferente do da fonte")
INSIDE, SETTLED, SHORT = -68.2, 0.05, 0.5


@dataclass(frozen=True)
class Options:
    """gain: k₀ with which every joint begins, that of the source."""

    gain: Annotated[float, Quantity(Text(en="first gain k₀", pt_BR="ganho inicial k₀"), 0.1, 1000.0, "1/s")] = 500.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A turn of the ellipse in steps of 1 ms by one gain and by growing ones, from outside and inside; short: 0.5 s."""
    seconds, outside, inside = SHORT if short else TURN, start_of_ellipse(), start_of_ellipse(INSIDE)
    asked = ((outside, False), (outside, True), (inside, False), (inside, True))
    one, grown, one_inside, grown_inside = (
        free_ellipse(q, options.gain, DT, grows, part(progress, i, len(asked)), seconds)
        for i, (q, grows) in enumerate(asked)
    )
    named = ((Text(en="one gain", pt_BR="um só ganho"), one), (Text(en="Algorithm 1", pt_BR="Algoritmo 1"), grown))
    lossless = Text(en="from a start within the limits", pt_BR="de uma partida dentro dos limites")
    charts = (
        *joint_charts(arms.movemaster(), (2, 3, 4), *named),
        error_chart(*named),
        error_chart((lossless, grown_inside)),
    )
    found = rows(grown, options)
    return Result((*found, *_feasible(one_inside, grown_inside, options)), charts, motion(ROBOT, grown))


def gains(run: Run) -> Array:
    """k₀ (n,) at the end of a run by Algorithm 1."""
    memory = run.last.memory
    assert isinstance(memory, Memory)
    return np.asarray(memory.gains)


def rows(grown: Run, options: Options) -> tuple[Row, ...]:
    """From the source's start: gain and clips of J3, joints within their limits, and the error that this costs."""
    other = None if options == Options() else OTHER
    limits, k3 = arms.movemaster().limits, float(gains(grown)[2])
    after = grown.q[1:]
    room = float(np.degrees(np.minimum(after - limits.lower, limits.upper - after)[:, 1:4].min()))
    settled = float(grown.since(SETTLED).error.max())
    clips = Text(en="clips of J3", pt_BR="paradas de J3 no limite")
    within = Text(en="J2 to J4 stay inside by at least", pt_BR="folga mínima de J2 a J4 até os limites")
    kept = Text(en="inside limits", pt_BR="dentro dos limites")
    thrown = Text(en="position error after the first clip", pt_BR="erro de posição após a primeira parada")
    later = Text(en="largest position error from 0.05 s on", pt_BR="maior erro de posição a partir de 0,05 s")
    return (
        Row(Text(en="gain of J3 at the end", pt_BR="ganho de J3 no fim"), k3, 525.5, 0.06, "1/s", assumed=other),
        Row(clips, log(k3 / options.gain) / log(GROWTH), 5, 0.01, assumed=other),
        Row(within, room, 0.0, 1e-9, "°", kept, "≥"),
        Row(thrown, float(grown.error.max()), 75.0, 0.5, "mm", assumed=other),
        Row(later, settled, unit="mm"),
    )


def _feasible(one: Run, grown: Run, options: Options) -> tuple[Row, ...]:
    other = None if options == Options() else OTHER
    same = Text(en="error unchanged", pt_BR="erro inalterado")
    quantity = Text(
        en="start inside: error by Algorithm 1 less that by one gain",
        pt_BR="partida dentro: erro pelo Algoritmo 1 menos o por um só ganho",
    )
    return (Row(quantity, float(np.abs(grown.error - one.error).max()), 0.0, 1e-12, "mm", same, assumed=other),)
