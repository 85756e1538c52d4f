"""The ORCA round its circle with its heading free: the freedom keeps the joints off their limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.ik.objective import posture
from helicoide.ik.secondary import total
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, few, joint_charts, motion, part, pitch, pitch_chart
from helicoide.studies.cerbaro_runs.tracking import DT, DT_SHORT, free_circle
from helicoide.studies.study import Figure, Fitted, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="The ORCA keeps off its joint limits", pt_BR="O ORCA se afasta dos limites de junta")
SOURCE = "Cerbaro 2022, §4.4.3, dem. 3, eqs. 12, 14, fig. 33"
ROBOT = "orca"
ABOUT = Text(
    en="The circle once more, but only the position counts: one freedom is left, and the gradient of the distance from "
    "the joint limits moves the arm in it. The source draws its limits in a figure only; ours stand in for them.",
    pt_BR="De novo o círculo, mas só a posição conta: sobra uma liberdade, e nela o gradiente da distância aos limites "
    "de junta move o braço. A fonte só desenha os limites numa figura; aqui valem os nossos.",
)


# Found by tests/studies/fits/cerbaro_orca_secondary.py.
LIMITS = Fitted(Text(en="limits ±120°, ±150°, ±140°, times", pt_BR="limites ±120°, ±150°, ±140°, vezes"), 1.0, 0.6, 3.0)
FARTHER = Statement(
    Text(
        en="the joints stay farther from their limits than with k₀ = 0",
        pt_BR="as juntas ficam mais longe dos limites do que com k₀ = 0",
    ),
    "§4.4.3, fig. 33",
    1.0,
    "<",
)


@dataclass(frozen=True)
class Options:
    """gain: k₀ of the source."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 1.0, 1000.0, "1/s")] = 250.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms with k₀ and without; in short form a tenth of them."""
    dt = DT_SHORT if short else DT
    plain, pushed = (free_circle(k0, dt, part(progress, i, 2)) for i, k0 in enumerate((0.0, options.gain)))
    named = ((Text(en="k₀ = 0", pt_BR="k₀ = 0"), plain), (Text(en="with k₀", pt_BR="com k₀"), pushed))
    charts = (
        *joint_charts("fig. 33", arms.orca(), (1, 2, 3), *named),
        pitch_chart("fig. 33d", "φ", *named),
        error_chart("fig. 33", *named),
    )
    found = _rows(plain, pushed, short)
    motions = tuple(motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def mean_cost(run: Run, limits: float = 1.0) -> float:
    """The mean of f = −w along a run, 1/(2n) Σ (off the middle over the range)², by our limits times a factor."""
    orca, chosen = arms.orca(limits), arms.limit_distance()
    return float(np.mean([total(orca, chosen, posture(orca, q)).value for q in few(run.q)]))


def _rows(plain: Run, pushed: Run, short: bool) -> tuple[Row, ...]:
    better = Text(en="mean of −w with k₀, as a share of that without", pt_BR="média de −w com k₀, fração da sem k₀")
    turned = Text(en="range of φ, left free, {which}", pt_BR="variação de φ, deixado livre, {which}")
    off = Text(en="largest position error, {which}", pt_BR="maior erro de posição, {which}")
    named = (("k₀ = 0", plain), ("k₀", pushed))
    found = [
        Row(better, mean_cost(pushed) / mean_cost(plain), "", FARTHER, (LIMITS,)),
        *(
            Row(turned.format(which=which), float(np.degrees(np.ptp(pitch(one.q)))), "°", Figure("fig. 33d"))
            for which, one in named
        ),
    ]
    if not short:
        found += [Row(off.format(which=which), float(one.error.max()), "mm", Figure("fig. 33")) for which, one in named]
    return tuple(found)
