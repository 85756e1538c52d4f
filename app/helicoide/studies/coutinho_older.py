"""Older ways to keep the entry point give the same joint rates, as long as nothing is singular."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.follow import Moment, command
from helicoide.ik.rcm.older import entry_first, entry_jacobian, extended, tool_jacobian
from helicoide.ik.rcm.paths import PATHS
from helicoide.kinematics.chain import Array
from helicoide.studies._coutinho_rows import TIME, row
from helicoide.studies._coutinho_runs import ROBOT, START, control, dia10, moments
from helicoide.studies.study import Chart, Line, Motion, Progress, Result
from helicoide.text import Text, same

TITLE = Text(en="Three ways to the same joint rates", pt_BR="Três caminhos para as mesmas velocidades")
SOURCE = "Coutinho 2015, §1.2.1, eqs. 3.9, 3.18"
ABOUT = Text(
    en="Before the constrained Jacobian, the entry point was kept by stacking its Jacobian under that of the tool, or "
    "by giving it priority. Along S2 all three ask the same of the joints to rounding; what differs is where they "
    "break down, and whether the entry point is still kept there.",
    pt_BR="Antes do Jacobiano restrito, mantinha-se o ponto de entrada empilhando seu Jacobiano sob o da ponta, ou "
    "dando-lhe prioridade. Ao longo de S2 os três pedem o mesmo das juntas, a menos de arredondamento; o que muda é "
    "onde falham, e se o ponto de entrada ainda é mantido ali.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

STEP, EVERY, SHORT = 0.02, 25, 50.0
FEEDBACK = Text(en="drift feedback Kr", pt_BR="realimentação da deriva Kr")


@dataclass(frozen=True)
class Options:
    """The gain Kr, 1/s."""

    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 5.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Along S2 at 20 ms, compared every half second; short: its first 50 s."""
    seconds = SHORT if short else PATHS["S2"].duration
    count = round(seconds / STEP / EVERY) + 1
    found = []
    wished = PATHS["S2"].wished(tool_at(dia10(), START))
    for done, moment in enumerate(islice(moments("S2", control(options.feedback), STEP), 0, None, EVERY)):
        if done == count:
            break
        ahead = wished(moment.t).ahead
        nu = command(moment.at.T_world_tool[:3, :3], ahead, moment.error, 5.0, 10.0)
        found.append((moment.t, moment.q, *_apart(moment, nu)))
        progress((done + 1) / count)
    t, q, stacked, first, determinant = (np.array(column) for column in zip(*found, strict=True))
    difference = Text(en="largest relative difference of joint rates", pt_BR="maior diferença relativa das velocidades")
    of = Text(en="{what}, {which}", pt_BR="{what}, {which}")
    titles = (STACKED, FIRST, DETERMINANT)
    return Result(
        rows=(
            row(of.format(what=difference, which=STACKED), stacked.max(), "≤1e-10"),
            row(of.format(what=difference, which=FIRST), first.max(), "≤1e-10"),
            row(DETERMINANT, determinant.max(), "≤1e-9"),
        ),
        charts=(
            Chart(
                Text(en="How far the ways are apart", pt_BR="Quanto os caminhos diferem"),
                TIME,
                same("log₁₀"),
                tuple(
                    Line(title, t, np.log10(np.maximum(y, 1e-17)))
                    for title, y in zip(titles, (stacked, first, determinant), strict=True)
                ),
            ),
        ),
        motion=Motion(ROBOT, t, q),
    )


STACKED = Text(en="extended Jacobian", pt_BR="Jacobiano estendido")
FIRST = Text(en="the entry point first", pt_BR="o ponto de entrada primeiro")
DETERMINANT = Text(
    en="largest relative difference of |det stack| from l_a² w_i w_r",
    pt_BR="maior diferença relativa entre |det| do empilhado e l_a² w_i w_r",
)


def _apart(moment: Moment, nu: Array) -> tuple[float, float, float]:
    """How far both older ways are from θ̇, as a part of it, and the determinant of the stack from its factors."""
    at, rates = moment.at, moment.rates
    size = float(np.linalg.norm(rates))
    ways = (way(at, nu, moment.asked) for way in (extended, entry_first))
    stacked, first = (float(np.linalg.norm(way - rates)) / size for way in ways)
    determinant = abs(np.linalg.det(np.vstack([tool_jacobian(at), entry_jacobian(at)])))
    factors = at.place.outside**2 * at.of_arm.w * at.of_tool.w
    return stacked, first, abs(determinant - factors) / factors
