"""The Movemaster round an ellipse in closed loop, pitch and roll held: with the velocity of the path, and without."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.studies.cerbaro_runs import arms
from helicoide.studies.cerbaro_runs.runs import (
    Run,
    error_chart,
    joint_chart,
    motion,
    part,
    turned_chart,
    way_chart,
)
from helicoide.studies.cerbaro_runs.tracking import DT, ELLIPSE, TURN, ellipse, eq_32, round_once, unfed
from helicoide.studies.study import Chart, Progress, Reading, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="The Movemaster round an ellipse", pt_BR="O Movemaster numa elipse")
SOURCE = "Cerbaro 2022, §4.4.4, dem. 2, eq. 32, figs. 35, 36"
ROBOT = "movemaster"
ABOUT = Text(
    en="One turn in a minute, the tool 60° below level all the time: five tasks for five joints. With the velocity of "
    "the path fed forward the error of position stays below a nanometre; without it, or with the one that eq. 32 "
    "prints, it has the order that the source tells of fig. 36. J3 runs beyond the limit of table 3, since no freedom "
    "is left to avoid it.",
    pt_BR="Uma volta por minuto, com o efetuador sempre 60° abaixo da horizontal: cinco tarefas para cinco juntas. Com "
    "a velocidade da trajetória antecipada, o erro de posição fica abaixo de um nanômetro; sem ela, ou com a que a eq. "
    "32 imprime, tem a ordem que a fonte conta da fig. 36. J3 passa do limite da tabela 3, pois não sobra liberdade "
    "para evitá-lo.",
)
SHORT, SETTLED = 5.0, 0.1
EXACT = Text(en="ẋ_d of the path", pt_BR="ẋ_d da trajetória")
NONE = Text(en="no ẋ_d", pt_BR="sem ẋ_d")
PRINTED = Text(en="ẋ_d of eq. 32", pt_BR="ẋ_d da eq. 32")
FED = Text(
    en="the loop is that of eq. 9 with the derivative of eq. 31; the order told of fig. 36 is at least 2800 times that",
    pt_BR="a malha é a da eq. 9 com a derivada da eq. 31; a ordem contada da fig. 36 é ao menos 2800 vezes maior",
)
DAMPED = Text(
    en="only the damping turns the tool; the printed λ = 0.1, in mm/rad, gives a tenth of what is told of fig. 36, 0.3 "
    "to 0.9 would give its order",
    pt_BR="só o amortecimento gira o efetuador; o λ = 0,1 impresso, em mm/rad, dá um décimo do que se conta da fig. "
    "36; de 0,3 a 0,9 daria a sua ordem",
)
OTHERWISE = Text(en="3.6 × 10⁻⁷ mm with that of the path", pt_BR="3,6 × 10⁻⁷ mm com a da trajetória")
WITHOUT = Reading(Text(en="the loop ran without ẋ_d", pt_BR="a malha funcionou sem ẋ_d"), OTHERWISE)
BY_EQ_32 = Reading(
    Text(en="the loop ran with ẋ_d of eq. 32, in mm/s", pt_BR="a malha funcionou com o ẋ_d da eq. 32, em mm/s"),
    OTHERWISE,
)


@dataclass(frozen=True)
class Options:
    """place, turn: K of position and of orientation, as in the source."""

    place: Annotated[float, Quantity(Text(en="K of position", pt_BR="K da posição"), 50.0, 1900.0, "1/s")] = 1800.0
    turn: Annotated[float, Quantity(Text(en="K of orientation", pt_BR="K da orientação"), 50.0, 1900.0, "1/s")] = 1200.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three turns of 60 000 steps of 1 ms; short: the first 5 s of each."""
    fed, seconds = ((EXACT, ELLIPSE.velocity), (NONE, unfed), (PRINTED, eq_32)), SHORT if short else TURN
    named = tuple(
        (title, ellipse(DT, options.place * DT, options.turn * DT, part(progress, i, len(fed)), seconds, velocity))
        for i, (title, velocity) in enumerate(fed)
    )
    start = tuple((title, one.until(SETTLED)) for title, one in named)
    charts = (
        *(way_chart("fig. 35", arms.movemaster(), axes, round_once(ELLIPSE), named[1]) for axes in ("xy", "xz")),
        error_chart("fig. 36", *named),
        turned_chart("fig. 36", *named),
        _first(error_chart("fig. 36", *start)),
        joint_chart("fig. 35", named[0][1], (1, 2, 3, 4, 5)),
    )
    found = rows([one for _, one in named], short)
    motions = tuple(motion(ROBOT, title, one) for title, one in named)
    return Result(found, charts, motions)


def _of_order(words: str, size: float) -> Statement:
    said = Text(en="of order {size}", pt_BR="da ordem de {size}").format(size=words)
    return Statement(said, "§4.4.4, fig. 36", size, "~")


def _first(chart: Chart) -> Chart:
    title = Text(en="Position error, the first {t:g} s", pt_BR="Erro de posição, primeiros {t:g} s")
    return replace(chart, title=title.format(t=SETTLED))


def rows(runs: Sequence[Run], short: bool) -> tuple[Row, ...]:
    """The orders that fig. 36 shows beside three loops, and where J3 goes."""
    exact, none, printed = runs
    place = Text(
        en="largest position error after {t:g} s, {which}", pt_BR="maior erro de posição após {t:g} s, {which}"
    )
    turn = Text(en="largest orientation error, {which}", pt_BR="maior erro de orientação, {which}")
    begins = Text(en="largest position error at the start, {which}", pt_BR="maior erro de posição na partida, {which}")
    small, smaller = _of_order("10⁻³", 1e-3), _of_order("10⁻⁵", 1e-5)
    named = ((exact, EXACT, ()), (none, NONE, (WITHOUT,)), (printed, PRINTED, (BY_EQ_32,)))
    settled = [
        Row(place.format(t=SETTLED, which=which), float(one.since(SETTLED).error.max()), "mm", small, taken, why=FED)
        for one, which, taken in named
    ]
    found = [
        *settled,
        Row(turn.format(which=EXACT), float(exact.turned.max()), "rad", smaller, why=DAMPED),
        Row(begins.format(which=NONE), float(none.error.max()), "mm"),
        Row(Text(en="J3, least", pt_BR="J3, mínimo"), exact.degrees(3)[0], "°"),
    ]
    if not short:
        fast = float(np.degrees(exact.fastest.max()))
        found.append(Row(Text(en="fastest joint", pt_BR="junta mais rápida"), fast, "°/s"))
    return tuple(found)
