"""The ORCA round a circle in closed loop, its heading held."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.runs import (
    TIME,
    LoopRun,
    error_chart,
    joint_chart,
    loop_motion,
    orientation_error_chart,
    share_of_runs,
    subsampled_loop,
    tool_path_chart,
)
from helicoide.studies.cerbaro_runs.tracking import CIRCLE, DT, DT_SHORT, closed_path_points, run_circle
from helicoide.studies.study import (
    BY_CONSTRUCTION,
    Chart,
    ChartLine,
    Figure,
    Progress,
    Result,
    Row,
    Statement,
    printed_statement,
)
from helicoide.text import Text, untranslated

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
    closed = run_circle(dt, options.place * DT, options.turn * DT, share_of_runs(progress, 0, 2))
    still_open = run_circle(dt, 0.0, 0.0, share_of_runs(progress, 1, 2))
    named = ((Text(en="closed loop", pt_BR="malha fechada"), closed), (Text(en="K = 0", pt_BR="K = 0"), still_open))
    charts = (
        tool_path_chart("fig. 31", setups.orca(), "xy", closed_path_points(CIRCLE), *named),
        components_chart(closed),
        error_chart("fig. 32", *named),
        orientation_error_chart("fig. 32", *named),
        joint_chart("fig. 31", closed, (1, 2, 3)),
    )
    found = circle_rows(closed, still_open, short)
    motions = tuple(loop_motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def components_chart(run: LoopRun) -> Chart:
    """Both components of the position error, mm."""
    names, up = (untranslated("x"), untranslated("y")), Text(en="error (mm)", pt_BR="erro (mm)")
    lines = tuple(
        ChartLine(name, subsampled_loop(run.t[1:]), subsampled_loop(run.errors[1:, i])) for i, name in enumerate(names)
    )
    title = Text(en="Components of the position error", pt_BR="Componentes do erro de posição")
    return Chart(title, TIME, up, lines, "fig. 32")


def circle_rows(closed: LoopRun, still_open: LoopRun, short: bool) -> tuple[Row, ...]:
    """What the source says of fig. 32; the size of the errors for steps of 1 ms only."""
    signs = np.sign(closed.errors[1:, :2])
    changes = int((np.diff(signs, axis=0) != 0).sum())
    heading = Text(en="largest error of φ", pt_BR="maior erro de φ")
    found = [
        Row(
            heading,
            float(np.abs(closed.q.sum(axis=1)).max()),
            "rad",
            printed_statement("< 1 × 10⁻¹⁰", "§4.4.3, fig. 32"),
        ),
        Row(
            Text(en="changes of sign of e_x and e_y in a turn", pt_BR="trocas de sinal de e_x e e_y numa volta"),
            changes,
            "",
            OSCILLATES,
            given=BY_CONSTRUCTION,
        ),
    ]
    if not short:
        largest = Text(en="largest position error", pt_BR="maior erro de posição")
        drift = Text(en="drift of the open loop after a turn", pt_BR="deriva da malha aberta após uma volta")
        found += [
            Row(largest, float(closed.position_error.max()), "mm", Figure("fig. 32")),
            Row(drift, float(still_open.position_error[-1]), "mm"),
        ]
    return (
        *found,
        Row(
            Text(en="fastest joint", pt_BR="junta mais rápida"), float(np.degrees(closed.largest_velocity.max())), "°/s"
        ),
    )
