"""The ORCA round a circle in closed loop, its heading held."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_chart, motion, part, ranges
from helicoide.studies.cerbaro_runs.tracking import DT, DT_SHORT, circle
from helicoide.studies.study import FIGURE_ONLY, Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="The ORCA round a circle", pt_BR="O ORCA num círculo")
SOURCE = "Cerbaro 2022, §4.4.3, dem. 2, figs. 31, 32"
ROBOT = "orca"
ABOUT = Text(
    en="One turn in a minute, the gripper level. The error of each step is fed back with a gain K, so that it never "
    "grows; without it (K = 0) what Euler’s rule leaves out adds up to a drift. With K Δt near 2 the error changes its "
    "sign at every step.",
    pt_BR="Uma volta por minuto, com a garra nivelada. O erro de cada passo é realimentado com um ganho K e por isso "
    "nunca cresce; sem ele (K = 0), o que a regra de Euler deixa de fora se acumula como deriva. Com K Δt perto de 2, "
    "o erro troca de sinal a cada passo.",
)
RANGES = ((-40.76, 11.59), (83.55, 141.06), (-130.22, -76.69))
OTHER = Text(en="another gain than the source’s", pt_BR="ganho diferente do da fonte")


@dataclass(frozen=True)
class Options:
    """place, turn: K of position and of heading, as in the source."""

    place: Annotated[float, Quantity(Text(en="K of position", pt_BR="K da posição"), 50.0, 1900.0, "1/s")] = 800.0
    turn: Annotated[float, Quantity(Text(en="K of heading", pt_BR="K da orientação"), 50.0, 1900.0, "1/s")] = 500.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms, closed and open; in short form a tenth of them."""
    dt = DT_SHORT if short else DT
    closed = circle(dt, options.place * DT, options.turn * DT, part(progress, 0, 2))
    still_open = circle(dt, 0.0, 0.0, part(progress, 1, 2))
    named = ((Text(en="closed loop", pt_BR="malha fechada"), closed), (Text(en="K = 0", pt_BR="K = 0"), still_open))
    charts = (joint_chart(closed, (1, 2, 3)), *(error_chart(one) for one in named))
    return Result(rows(closed, still_open, options, short), charts, motion(ROBOT, closed))


def rows(closed: Run, still_open: Run, options: Options, short: bool) -> tuple[Row, ...]:
    """What the digest gives: ranges, errors and speed; the sizes of errors for steps of 1 ms only."""
    other = None if options == Options() else OTHER
    largest = Text(en="largest position error", pt_BR="maior erro de posição")
    fast = float(np.degrees(closed.fastest.max()))
    small = Text(en="small, oscillating", pt_BR="pequeno, oscilante")
    found = [
        Row(largest, float(closed.error.max()), 1e-3, 0.0, "mm", small, "≤", assumed=other),
        Row(
            Text(en="largest error of φ", pt_BR="maior erro de φ"),
            float(np.abs(closed.q.sum(axis=1)).max()),
            1e-10,
            unit="rad",
            source="< 1e-10 rad",
            relation="≤",
        ),
        *ranges(closed, RANGES, 0.006, None),
        Row(Text(en="fastest joint", pt_BR="junta mais rápida"), fast, 3.91, 0.006, "°/s", FIGURE_ONLY),
    ]
    if not short:
        found += [
            Row(largest, float(closed.error.max()), 1.1e-6, 1.1e-7, "mm", FIGURE_ONLY, assumed=other),
            Row(
                Text(en="drift of the open loop after a turn", pt_BR="deriva da malha aberta após uma volta"),
                float(still_open.error[-1]),
                0.009,
                5e-4,
                "mm",
            ),
        ]
    return tuple(found)
