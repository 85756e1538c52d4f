"""The Movemaster round an ellipse in closed loop, pitch and roll held: with the velocity of the path, and without."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.runs import (
    LoopRun,
    error_chart,
    joint_chart,
    loop_motion,
    orientation_error_chart,
    share_of_runs,
    tool_path_chart,
)
from helicoide.studies.cerbaro_runs.tracking import (
    DT,
    ELLIPSE,
    TURN,
    closed_path_points,
    eq_32,
    run_ellipse,
    zero_feedforward,
)
from helicoide.studies.study import Chart, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="The Movemaster round an ellipse", pt_BR="O Movemaster numa elipse")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 2, eq. 32, figs. 35, 36"
ROBOT = "movemaster"
ABOUT = Text(
    en="One turn in a minute, the end effector 60° below level all the time: five tasks for five joints. With the "
    "velocity of the path fed forward the error of position stays below a nanometre; without it, or with the one that "
    "eq. 32 prints, it has the order that is stated for fig. 36, if that is in mm. J3 runs beyond the limit of table "
    "3, since no freedom is left to avoid it.",
    pt_BR="Uma volta por minuto, com o efetuador sempre 60° abaixo da horizontal: cinco tarefas para cinco juntas. Com "
    "a velocidade da trajetória antecipada, o erro de posição fica abaixo de um nanômetro; sem ela, ou com a que a eq. "
    "32 imprime, tem a ordem que se diz da fig. 36, se ela está em mm. J3 passa do limite da tabela 3, pois não sobra "
    "liberdade para evitá-lo.",
)
SHORT, SETTLED = 5.0, 0.1
EXACT = Text(en="ẋ_d of the path", pt_BR="ẋ_d da trajetória")
NONE = Text(en="no ẋ_d", pt_BR="sem ẋ_d")
PRINTED = Text(en="ẋ_d of eq. 32", pt_BR="ẋ_d da eq. 32")
FED = Text(
    en="the order stated for fig. 36, in mm, is at least 2800 times that; without ẋ_d it would be met (0.0055 mm), "
    "with that of eq. 32 in mm/s too (0.0061 mm)",
    pt_BR="a ordem que se diz da fig. 36, em mm, é ao menos 2800 vezes maior; sem ẋ_d caberia (0,0055 mm), e com o da "
    "eq. 32 em mm/s também (0,0061 mm)",
)
DAMPED = Text(
    en="only the damping turns the end effector; the printed λ = 0.1, which we suppose in mm/rad, gives a tenth of "
    "what is stated for fig. 36, 0.3 to 0.9 would give its order",
    pt_BR="só o amortecimento gira o efetuador; o λ = 0,1 impresso, que supomos em mm/rad, dá um décimo do que se diz "
    "da fig. 36; de 0,3 a 0,9 daria a sua ordem",
)


@dataclass(frozen=True)
class Options:
    """place, turn: K of position and of orientation, as in the source."""

    place: Annotated[float, Quantity(Text(en="K of position", pt_BR="K da posição"), 50.0, 1900.0, "1/s")] = 1800.0
    turn: Annotated[float, Quantity(Text(en="K of orientation", pt_BR="K da orientação"), 50.0, 1900.0, "1/s")] = 1200.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three turns of 60 000 steps of 1 ms; short: the first 5 s of each."""
    fed, seconds = ((EXACT, ELLIPSE.velocity), (NONE, zero_feedforward), (PRINTED, eq_32)), SHORT if short else TURN
    named = tuple(
        (
            title,
            run_ellipse(
                DT, options.place * DT, options.turn * DT, share_of_runs(progress, i, len(fed)), seconds, velocity
            ),
        )
        for i, (title, velocity) in enumerate(fed)
    )
    start = tuple((title, one.until(SETTLED)) for title, one in named)
    charts = (
        *(
            tool_path_chart("fig. 35", setups.movemaster(), axes, closed_path_points(ELLIPSE), named[1])
            for axes in ("xy", "xz")
        ),
        error_chart("fig. 36", *named),
        orientation_error_chart("fig. 36", *named),
        _first(error_chart("fig. 36", *start)),
        joint_chart("fig. 35", named[0][1], (1, 2, 3, 4, 5)),
    )
    found = ellipse_rows([one for _, one in named], short)
    motions = tuple(loop_motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def _of_order(words: str, size: float) -> Statement:
    said = Text(en="of order {size}", pt_BR="da ordem de {size}").format(size=words)
    return Statement(said, "§4.4.4, fig. 36", size, "~")


def _first(chart: Chart) -> Chart:
    title = Text(en="Position error, the first {t:g} s", pt_BR="Erro de posição, primeiros {t:g} s")
    return replace(chart, title=title.format(t=SETTLED))


def ellipse_rows(runs: Sequence[LoopRun], short: bool) -> tuple[Row, ...]:
    """The orders that are stated for fig. 36, errors of three loops, and where J3 goes."""
    exact, none, printed = runs
    place = Text(
        en="largest position error after {t:g} s, {which}", pt_BR="maior erro de posição após {t:g} s, {which}"
    )
    turn = Text(en="largest orientation error, {which}", pt_BR="maior erro de orientação, {which}")
    begins = Text(en="largest position error at the start, {which}", pt_BR="maior erro de posição na partida, {which}")
    small, smaller = _of_order("10⁻³", 1e-3), _of_order("10⁻⁵", 1e-5)
    named = ((exact, EXACT, small), (none, NONE, None), (printed, PRINTED, None))
    settled = [
        Row(place.format(t=SETTLED, which=which), float(one.since(SETTLED).position_error.max()), "mm", said, why=FED)
        for one, which, said in named
    ]
    found = [
        *settled,
        Row(turn.format(which=EXACT), float(exact.orientation_error.max()), "rad", smaller, why=DAMPED),
        Row(begins.format(which=NONE), float(none.position_error.max()), "mm"),
        Row(Text(en="J3, least", pt_BR="J3, mínimo"), exact.degrees(3)[0], "°"),
    ]
    if not short:
        fast = float(np.degrees(exact.largest_velocity.max()))
        found.append(Row(Text(en="fastest joint", pt_BR="junta mais rápida"), fast, "°/s"))
    return tuple(found)
