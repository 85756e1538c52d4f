"""The Movemaster round an ellipse in closed loop, pitch and roll held."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs.runs import Run, error_chart, joint_chart, motion, ranges
from helicoide.studies.cerbaro_runs.tracking import DT, DT_SHORT, ELLIPSE, ellipse
from helicoide.studies.study import FIGURE_ONLY, Progress, Result, Row
from helicoide.text import Text

TITLE = Text(en="The Movemaster round an ellipse", pt_BR="O Movemaster numa elipse")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 2, figs. 35, 36"
ROBOT = "movemaster"
ABOUT = Text(
    en="One turn in a minute, the tool 60° below level all the time: five tasks for five joints. The errors stay far "
    "below a micrometre, and yet J3 runs beyond the limit of table 3, since no freedom is left to avoid it.",
    pt_BR="Uma volta por minuto, com o efetuador sempre 60° abaixo da horizontal: cinco tarefas para cinco juntas. Os "
    "erros ficam bem abaixo de um micrômetro; ainda assim J3 passa do limite da tabela 3, pois não sobra liberdade "
    "para evitá-lo.",
)
RANGES = ((-8.85, 8.85), (33.2, 62.4), (-129.97, -76.2), (-22.0, 18.0))
OTHER = Text(en="another gain than the source’s", pt_BR="ganho diferente do da fonte")


@dataclass(frozen=True)
class Options:
    """place, turn: K of position and of orientation, as in the source."""

    place: Annotated[float, Quantity(Text(en="K of position", pt_BR="K da posição"), 50.0, 1900.0, "1/s")] = 1800.0
    turn: Annotated[float, Quantity(Text(en="K of orientation", pt_BR="K da orientação"), 50.0, 1900.0, "1/s")] = 1200.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms; in short form a tenth of them."""
    found = ellipse(DT_SHORT if short else DT, options.place * DT, options.turn * DT, progress)
    charts = (joint_chart(found, (1, 2, 3, 4)), error_chart((Text(en="of the tool", pt_BR="do efetuador"), found)))
    return Result(rows(found, options, short), charts, motion(ROBOT, found))


def rows(found: Run, options: Options, short: bool) -> tuple[Row, ...]:
    """What the digest gives: ranges, errors and speed; the sizes of errors for steps of 1 ms only."""
    other = None if options == Options() else OTHER
    place = Text(en="largest position error", pt_BR="maior erro de posição")
    turn = Text(en="largest orientation error", pt_BR="maior erro de orientação")
    turned = float(np.abs(found.q[:, 1:4].sum(axis=1) - ELLIPSE.pitch).max())
    order = Text(en="order of {size}", pt_BR="ordem de {size}")
    fast = float(np.degrees(found.fastest.max()))
    all_of_them = [
        Row(place, float(found.error.max()), 1e-3, 0.0, "mm", order.format(size="1e-3"), "≤", assumed=other),
        *ranges(found, RANGES, 0.06, None),
        Row(Text(en="fastest joint", pt_BR="junta mais rápida"), fast, 2.74, 0.006, "°/s", FIGURE_ONLY),
    ]
    if not short:
        all_of_them += [
            Row(place, float(found.error.max()), 6e-7, 6e-8, "mm", FIGURE_ONLY, assumed=other),
            Row(turn, turned, 1e-6, 2e-7, "rad", order.format(size="1e-5"), assumed=other),
        ]
    return tuple(all_of_them)
