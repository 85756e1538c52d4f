"""How many postures zero link lengths allow: the table of the slides, and arms that do not keep to it."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated

import numpy as np

from helicoide.ik.closed import pieper
from helicoide.ik.method import Quantity
from helicoide.ik.postures import solvability
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import LENGTHS, of_rows, puma, some_pose, spherical
from helicoide.studies._campos_rows import row
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.text import Text, same

TITLE = Text(en="Zero link lengths and the count of postures", pt_BR="Elos de comprimento zero e o número de posturas")
SOURCE = "Campos 1998, s.22 (Craig); Primrose 1986"
ABOUT = Text(
    en="A table of the slides bounds the postures of six turning joints by which link lengths are zero. Its first row "
    "does not hold: the PUMA with a₃ = 0 has eight postures, and an arm without a spherical wrist sixteen; with a "
    "spherical wrist eight is the bound, and sixteen without.",
    pt_BR="Uma tabela dos slides limita as posturas de seis juntas de revolução segundo os elos de comprimento zero. A "
    "primeira linha não vale: o PUMA com a₃ = 0 tem oito posturas, e um braço sem punho esférico, dezesseis; com punho "
    "esférico o limite é oito, e sem ele dezesseis.",
)
ROBOT = "puma560"

# Zero link lengths of each row, and its bound.
ROWS: tuple[tuple[tuple[int, ...], int], ...] = (((1, 3, 5), 4), ((3, 5), 8), ((3,), 16), ((), 16))
# Of one pose, θ in rad, to be polished: α = 90°, a2 = 0.6, a4 = 0.7, d3 = 0.4, d4 = d5 = 0.2 m, all others zero.
SIXTEEN = frozen(
    [
        (-1.3, -2.8, -0.7, -0.6, -2.9, -2.8),
        (-1.33, -2.82, -0.65, -0.63, -2.87, -2.78),
        (-2.74, -2.41, -2.01, -2.35, -1.12, 0.74),
        (-2.5, -2.73, 1.57, -0.51, -1.71, -3.09),
        (-2.36, -1.23, 2.74, 0.95, 0.07, -0.7),
        (-2.06, -1.2, -0.71, 2.59, -2.72, 1.92),
        (-2.06, -2.96, 3.03, -1.69, -0.38, 1.16),
        (-0.91, -2.28, 1.35, -2.44, 0.69, 0.39),
        (0.28, 0.14, -1.58, 0.4, -0.86, -0.32),
        (0.45, 0.53, 0.81, 3.05, -1.47, 2.21),
        (1.0, 0.98, 0.07, 2.62, -0.46, 1.18),
        (1.23, -0.77, 0.53, -0.95, 0.17, -0.66),
        (1.43, 1.01, -2.98, 1.12, -2.52, -2.64),
        (1.98, -0.69, -2.25, -2.12, -2.92, 2.04),
        (2.31, -0.42, 1.88, 0.02, 0.55, -0.35),
        (2.31, -0.41, -1.82, -2.61, -3.14, 2.24),
    ]
)
FAMILIES = ("general", "a1 = 0", "sin α1 = 0")
FEW = 10


@dataclass(frozen=True)
class Options:
    """How many random arms of each family are counted."""

    arms: Annotated[float, Quantity(Text(en="random arms", pt_BR="braços aleatórios"), 10, 1500, decades=True)] = 100


def with_zeros(zeros: tuple[int, ...]) -> Robot:
    """An arm of random rows whose link lengths of these numbers are zero."""
    draw = np.random.default_rng(1)
    a = draw.uniform(0.1, 1, 6)
    a[list(zeros)] = 0
    alpha, d = draw.uniform(0.3, 2.8, 6), draw.uniform(0.1, 1, 6)
    rows = [(float(x), float(y), float(z)) for x, y, z in zip(alpha, a, d, strict=True)]
    return of_rows(rows, some_pose(draw), some_pose(draw))


def sixteen() -> tuple[Robot, Array]:
    """An arm of the table's first row, and sixteen postures (16, 6), rad, of one pose."""
    right = pi / 2
    rows = [(0, 0, 0), (right, 0, 0), (right, 0.6, 0.4), (right, 0, 0.2), (right, 0.7, 0.2), (right, 0, 0)]
    robot = of_rows(rows, np.eye(4), np.eye(4))
    goal = tool_at(robot, SIXTEEN[0])
    return robot, np.array([pieper.polished(robot, goal, np.array(q)) for q in SIXTEEN])


def distinct(robot: Robot, postures: Array) -> int:
    """How many postures (k, 6), rad, bring the tool to the pose of the first and differ from those before, by 0.01."""
    goal = tool_at(robot, postures[0])
    kept: list[Array] = []
    for q in postures:
        there = np.abs(tool_at(robot, q) - goal).max() < 1e-12
        if there and all(np.abs(wrap(q - other)).max() > 0.01 for other in kept):
            kept.append(q)
    return len(kept)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The rows of the table, the arms that exceed it, and random arms with a spherical wrist; short: ten of each."""
    counts = _counted(FEW if short else int(options.arms), progress)
    robot, postures = sixteen()
    arm = puma(*LENGTHS[2])
    q = np.array([0.3, -0.5, 0.7, 0.4, 0.9, -1.1])
    eight = len(pieper.solve(arm, tool_at(arm, q), np.zeros(6)).branches)
    rows: list[Row] = [
        row(
            PRINTED.format(zeros=_named(zeros)),
            solvability.table_row(with_zeros(zeros)) or 0,
            bound,
            source=f"≤ {bound}",
        )
        for zeros, bound in ROWS
    ]
    rows += [
        Row(PUMA, float(eight), 4.0, relation="≤", source="≤ 4", doubt="s.22"),
        Row(NO_WRIST, float(distinct(robot, postures)), 4.0, relation="≤", source="≤ 4", doubt="s.22"),
        row(BOUND_PUMA, eight, float(solvability.solution_bound(arm) or 0), relation="≤"),
        row(BOUND_NO_WRIST, distinct(robot, postures), float(solvability.solution_bound(robot) or 0), relation="≤"),
        *(row(MOST.format(family=family), max(found), 8, relation="≤") for family, found in counts.items()),
    ]
    values = np.arange(1.0, 17.0)
    lines = [
        Line(same(family), values, np.array([np.mean([n == v for n in found]) for v in values]))
        for family, found in counts.items()
    ]
    share = Text(en="share of arms", pt_BR="fração dos braços")
    return Result(tuple(rows), (Chart(TITLE, Text(en="postures", pt_BR="posturas"), share, tuple(lines)),))


def _counted(arms: int, progress: Progress) -> dict[str, list[int]]:
    """How many postures random arms of each family have for a pose of theirs."""
    draw, counts = np.random.default_rng(2), dict[str, list[int]]()
    for part, family in enumerate(FAMILIES):
        found = counts.setdefault(family, [])
        for done in range(arms):
            robot = spherical(draw, family, right_wrist=False)
            found.append(len(pieper.solve(robot, tool_at(robot, draw.uniform(-pi, pi, 6)), np.zeros(6)).branches))
            progress((part + (done + 1) / arms) / len(FAMILIES))
    return counts


def _named(zeros: tuple[int, ...]) -> Text:
    if not zeros:
        return Text(en="no length zero", pt_BR="nenhum comprimento nulo")
    return same(" = ".join([*(f"a{number}" for number in zeros), "0"]))


PRINTED = Text(en="bound by the table, {zeros}", pt_BR="limite pela tabela, {zeros}")
PUMA = Text(
    en="postures of the PUMA with a3 = 0 against its row", pt_BR="posturas do PUMA com a3 = 0 perante sua linha"
)
NO_WRIST = Text(
    en="postures of an arm without a spherical wrist against its row",
    pt_BR="posturas de um braço sem punho esférico perante sua linha",
)
BOUND_PUMA = Text(en="the same against 8 for a spherical wrist", pt_BR="as mesmas perante 8 para um punho esférico")
BOUND_NO_WRIST = Text(en="the same against 16 for any arm", pt_BR="as mesmas perante 16 para qualquer braço")
MOST = Text(en="most postures of random arms, {family}", pt_BR="mais posturas de braços aleatórios, {family}")
