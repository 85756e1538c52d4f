"""Older ways to keep the entry point give the same joint velocities, as long as nothing is singular."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from typing import Annotated

import numpy as np

from helicoide.ik.method import Quantity
from helicoide.ik.rcm.follow import RcmStep
from helicoide.ik.rcm.older import avoiding, entry_first, entry_jacobian, extended, older_tool_jacobian
from helicoide.ik.rcm.paths import PATHS
from helicoide.studies._coutinho_rows import FEEDBACK, TIME
from helicoide.studies._coutinho_runs import ROBOT, path_steps, source_control
from helicoide.studies.study import Chart, ChartLine, Motion, Progress, Result, Row, Statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Four ways to the same joint velocities", pt_BR="Quatro caminhos para as mesmas velocidades")
SOURCE = "Coutinho 2015, §1.2.1, eqs. 1.1–1.4, 3.9, 3.18"
ABOUT = Text(
    en="Before the constrained Jacobian, the entry point was kept by stacking its Jacobian under that of the end "
    "effector, or by putting one task before the other. Along S2, where nothing is singular, all of them ask the same "
    "of the joints to rounding: det of the stack is l_a² w_i w_r, zero where the arm or the wrist is singular.",
    pt_BR="Antes do Jacobiano restrito, mantinha-se o ponto de entrada empilhando seu Jacobiano sob o do efetuador, ou "
    "pondo uma tarefa à frente da outra. Ao longo de S2, onde nada é singular, todos pedem o mesmo das juntas, a menos "
    "de arredondamento: o determinante do empilhado é l_a² w_i w_r, nulo onde o braço ou o punho é singular.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

STEP, EVERY, SHORT = 0.02, 25, 50.0
STACKED = Text(en="extended Jacobian", pt_BR="Jacobiano estendido")
FIRST = Text(en="the entry point first", pt_BR="o ponto de entrada primeiro")
SECOND = Text(en="the end effector first", pt_BR="o efetuador primeiro")
DETERMINANT = Text(
    en="largest relative difference of |det stack| from l_a² w_i w_r",
    pt_BR="maior diferença relativa entre |det| do empilhado e l_a² w_i w_r",
)
DIFFERENCE = Text(
    en="largest relative difference of joint velocities, {which}",
    pt_BR="maior diferença relativa das velocidades, {which}",
)
SAME = Text(en="the inverse of the stack, for α = 1 and rank n", pt_BR="a inversa do empilhado, com α = 1 e posto n")


@dataclass(frozen=True)
class Options:
    """The gain Kr, 1/s."""

    feedback: Annotated[float, Quantity(FEEDBACK, 0.0, 20.0, "1/s")] = 5.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Along S2 at 20 ms, compared every half second; short: its first 50 s."""
    seconds = SHORT if short else PATHS["S2"].duration
    count = round(seconds / STEP / EVERY) + 1
    found = []
    every = islice(path_steps("S2", source_control(options.feedback), STEP), 0, (count - 1) * EVERY + 1, EVERY)
    for done, moment in enumerate(every):
        found.append((moment.t, moment.q, *_largest_difference(moment)))
        progress((done + 1) / count)
    t, q, stacked, first, second, determinant = (np.array(column) for column in zip(*found, strict=True))
    ways = {STACKED: stacked, FIRST: first}
    return Result(
        rows=(
            Row(DIFFERENCE.format(which=SECOND), float(second.max()), "", Statement(SAME, "eq. 1.3", 0.0, "=", 1e-9)),
            *(Row(DIFFERENCE.format(which=title), float(y.max())) for title, y in ways.items()),
            Row(DETERMINANT, float(determinant.max())),
        ),
        charts=(
            Chart(
                Text(en="How far the ways are apart", pt_BR="Quanto os caminhos diferem"),
                TIME,
                untranslated("|Δθ̇| / |θ̇|"),
                tuple(ChartLine(title, t, y) for title, y in {**ways, SECOND: second}.items()),
                log=True,
            ),
        ),
        motions=(Motion(ROBOT, t, q),),
    )


def _largest_difference(moment: RcmStep) -> tuple[float, float, float, float]:
    """How far the older ways are from θ̇, as a part of it, and the determinant of the stack from its factors.

    The last way takes the tool first and the entry point as its obstacle, which is the stack by eq. 1.3.
    """
    at, nu, asked = moment.at, moment.command, moment.task
    J_e, J_c = older_tool_jacobian(at), entry_jacobian(at)
    stack = np.vstack([J_e, J_c])
    inverted = np.linalg.solve(stack, np.concatenate([nu, asked]))
    determinant, factors = abs(np.linalg.det(stack)), at.place.outside**2 * at.of_arm.w * at.of_tool.w
    return (
        _difference(extended(at, nu, asked), moment.rates),
        _difference(entry_first(at, nu, asked), moment.rates),
        _difference(avoiding(J_e, nu, J_c, asked), inverted),
        abs(determinant - factors) / factors,
    )


def _difference(a: np.ndarray, b: np.ndarray) -> float:
    return float(np.linalg.norm(a - b) / np.linalg.norm(b))
