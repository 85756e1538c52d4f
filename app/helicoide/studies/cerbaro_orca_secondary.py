"""The ORCA round its circle with its heading free: the freedom keeps the joints off their limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.confined import limit_margins
from helicoide.studies.cerbaro_runs.runs import (
    LoopRun,
    error_chart,
    joint_charts,
    loop_motion,
    mean_cost,
    pitch,
    pitch_chart,
    share_of_runs,
)
from helicoide.studies.cerbaro_runs.tracking import DT, DT_SHORT, gain_in_degrees, run_free_circle
from helicoide.studies.study import Figure, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="The ORCA keeps off its joint limits", pt_BR="O ORCA se afasta dos limites de junta")
SOURCE = "Cerbaro 2022, §4.4.3, dem. 3, eqs. 12, 14, fig. 33"
ROBOT = "orca"
ABOUT = Text(
    en="The circle once more, but only the position counts: one freedom is left, and the gradient of w, which measures "
    "the distance from the joint limits (eq. 12), moves the arm in it. The limits of the arm are in a figure only; "
    "ours, ±120°, ±150° and ±140°, stand in for them, so that no verdict is due. Angles are counted in radians: in "
    "degrees k₀ would do next to nothing.",
    pt_BR="De novo o círculo, mas só a posição conta: sobra uma liberdade, e nela o gradiente de w, que mede a "
    "distância aos limites de junta (eq. 12), move o braço. Os limites do braço só estão numa figura; aqui valem os "
    "nossos, ±120°, ±150° e ±140°, e por isso não cabe veredito. Os ângulos são contados em radianos: em graus, k₀ não "
    "faria quase nada.",
)

LIMITS = Text(en="the limits were put in", pt_BR="os limites são dados de entrada")
FARTHER = Statement(
    Text(
        en="the joints stay farther from their limits than with k₀ = 0",
        pt_BR="as juntas ficam mais longe dos limites do que com k₀ = 0",
    ),
    "§4.4.3, fig. 33",
    0.0,
    ">",
)


@dataclass(frozen=True)
class Options:
    """gain: k₀ of the source."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 1.0, 1000.0, "1/s")] = 250.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms with k₀ and without; in a quick run a tenth of them."""
    dt = DT_SHORT if short else DT
    gains = (0.0, options.gain, gain_in_degrees(options.gain, 3))
    plain, pushed, in_deg = (run_free_circle(k0, dt, share_of_runs(progress, i, 3)) for i, k0 in enumerate(gains))
    named = ((Text(en="k₀ = 0", pt_BR="k₀ = 0"), plain), (Text(en="with k₀", pt_BR="com k₀"), pushed))
    charts = (
        *joint_charts("fig. 33", setups.orca(), (1, 2, 3), *named),
        pitch_chart("fig. 33d", "φ", *named),
        error_chart("", *named),
    )
    found = _rows(plain, pushed, in_deg, short)
    motions = tuple(loop_motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def _rows(plain: LoopRun, pushed: LoopRun, in_deg: LoopRun, short: bool) -> tuple[Row, ...]:
    farther = Text(
        en="least margin of a joint to its limits with k₀, less that without",
        pt_BR="menor folga de uma junta até os limites com k₀, menos a sem k₀",
    )
    better = Text(en="mean of −w with k₀, as a share of that without", pt_BR="média de −w com k₀, fração da sem k₀")
    weaker = Text(
        en="mean of −w with k₀ in degrees, as a share of that without",
        pt_BR="média de −w com k₀ em graus, fração da sem k₀",
    )
    turned = Text(en="range of φ, left free, {which}", pt_BR="variação de φ, deixado livre, {which}")
    off = Text(en="largest position error, {which}", pt_BR="maior erro de posição, {which}")
    named, orca = (("k₀ = 0", plain), ("k₀", pushed)), setups.orca()
    least, most = (mean_cost(orca, run.q) / mean_cost(orca, plain.q) for run in (pushed, in_deg))
    more = float(limit_margins(orca, pushed.q).min() - limit_margins(orca, plain.q).min())
    found = [
        Row(farther, more, "°", FARTHER, given=LIMITS),
        Row(better, least),
        Row(weaker, most),
        *(
            Row(turned.format(which=which), float(np.degrees(np.ptp(pitch(one.q)))), "°", Figure("fig. 33d"))
            for which, one in named
        ),
    ]
    if not short:
        found += [Row(off.format(which=which), float(one.position_error.max()), "mm") for which, one in named]
    return tuple(found)
