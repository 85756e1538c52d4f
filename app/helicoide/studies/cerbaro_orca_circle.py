"""The ORCA round a circle in closed loop, its heading held."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import (
    TIME,
    Run,
    error_chart,
    few,
    joint_chart,
    motion,
    part,
    turned_chart,
    way_chart,
)
from helicoide.studies.cerbaro_runs.tracking import CIRCLE, DT, DT_SHORT, circle, round_once
from helicoide.studies.study import CONSTRUCTED, Chart, Figure, Line, Progress, Result, Row, Statement, printed
from helicoide.text import Text, same

TITLE = Text(en="The ORCA round a circle", pt_BR="O ORCA num círculo")
SOURCE = "Cerbaro 2022, §4.4.3, dem. 2, figs. 31, 32"
ROBOT = "orca"
ABOUT = Text(
    en="One turn in a minute, the gripper level. The error of each step is fed back with a gain K, so that it never "
    "grows; without it (K = 0) what Euler’s rule leaves out adds up to a drift. With K Δt above 1 an error would "
    "change its sign at every step; here K Δt is 0.8 and 0.5. That it oscillates, as is said, we read of the whole "
    "turn: an error that follows a circle cannot but do so.",
    pt_BR="Uma volta por minuto, com a garra nivelada. O erro de cada passo é realimentado com um ganho K e por isso "
    "nunca cresce; sem ele (K = 0), o que a regra de Euler deixa de fora se acumula como deriva. Com K Δt acima de 1, "
    "um erro trocaria de sinal a cada passo; aqui K Δt é 0,8 e 0,5. Que ele oscila, como se diz, lemos da volta "
    "inteira: um erro que acompanha um círculo não pode deixar de oscilar.",
)
OSCILLATES = Statement(
    Text(en="the position error oscillates", pt_BR="o erro de posição oscila"), "§4.4.3, fig. 32", 2.0, "≥"
)


@dataclass(frozen=True)
class Options:
    """place, turn: K of position and of heading, as in the source."""

    place: Annotated[float, Quantity(Text(en="K of position", pt_BR="K da posição"), 50.0, 1900.0, "1/s")] = 800.0
    turn: Annotated[float, Quantity(Text(en="K of heading", pt_BR="K da orientação"), 50.0, 1900.0, "1/s")] = 500.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """60 000 steps of 1 ms, closed and open; in a quick run a tenth of them."""
    dt = DT_SHORT if short else DT
    closed = circle(dt, options.place * DT, options.turn * DT, part(progress, 0, 2))
    still_open = circle(dt, 0.0, 0.0, part(progress, 1, 2))
    named = ((Text(en="closed loop", pt_BR="malha fechada"), closed), (Text(en="K = 0", pt_BR="K = 0"), still_open))
    charts = (
        way_chart("fig. 31", arms.orca(), "xy", round_once(CIRCLE), *named),
        components_chart(closed),
        error_chart("fig. 32", *named),
        turned_chart("fig. 32", *named),
        joint_chart("fig. 31", closed, (1, 2, 3)),
    )
    found = rows(closed, still_open, short)
    motions = tuple(motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def components_chart(run: Run) -> Chart:
    """Both components of the position error, mm."""
    names, up = (same("eₓ"), same("e_y")), Text(en="error (mm)", pt_BR="erro (mm)")
    lines = tuple(Line(name, few(run.t[1:]), few(run.errors[1:, i])) for i, name in enumerate(names))
    title = Text(en="Components of the position error", pt_BR="Componentes do erro de posição")
    return Chart(title, TIME, up, lines, "fig. 32")


def rows(closed: Run, still_open: Run, short: bool) -> tuple[Row, ...]:
    """What the source says of fig. 32; the size of the errors for steps of 1 ms only."""
    signs = np.sign(closed.errors[1:, :2])
    changes = int((np.diff(signs, axis=0) != 0).sum())
    heading = Text(en="largest error of φ", pt_BR="maior erro de φ")
    found = [
        Row(heading, float(np.abs(closed.q.sum(axis=1)).max()), "rad", printed("< 1 × 10⁻¹⁰", "§4.4.3, fig. 32")),
        Row(
            Text(en="changes of sign of eₓ and e_y in a turn", pt_BR="trocas de sinal de eₓ e e_y numa volta"),
            changes,
            "",
            OSCILLATES,
            given=CONSTRUCTED,
        ),
    ]
    if not short:
        largest = Text(en="largest position error", pt_BR="maior erro de posição")
        drift = Text(en="drift of the open loop after a turn", pt_BR="deriva da malha aberta após uma volta")
        found += [
            Row(largest, float(closed.error.max()), "mm", Figure("fig. 32")),
            Row(drift, float(still_open.error[-1]), "mm"),
        ]
    return (
        *found,
        Row(Text(en="fastest joint", pt_BR="junta mais rápida"), float(np.degrees(closed.fastest.max())), "°/s"),
    )
