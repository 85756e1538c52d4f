"""How many postures zero link lengths allow: the table of the slides, and arms of each of its rows, searched."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import closed
from helicoide.ik.closed import pieper
from helicoide.ik.method import Quantity
from helicoide.ik.postures import numeric
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import LENGTHS, arm_from_dh, puma_with_lengths, random_pose, random_spherical_arm
from helicoide.studies._campos_rows import campos_result
from helicoide.studies.study import Chart, ChartLine, Progress, Result, Row, printed_statement
from helicoide.text import Text, untranslated

TITLE = Text(en="Zero link lengths and the count of postures", pt_BR="Elos de comprimento zero e o número de posturas")
SOURCE = "Campos 1998, s.22 (Craig); Primrose 1986"
ABOUT = Text(
    en="A table that the slides take from a book of Craig bounds the postures of six turning joints by which link "
    "lengths are zero. Here arms of each row, random ones and one that is known for many, are searched for every "
    "posture of a pose, without a bound. The first two rows are exceeded, by random arms too; nothing was ever found "
    "beyond sixteen, and with a spherical wrist nothing beyond eight.",
    pt_BR="Uma tabela que os slides tomam de um livro de Craig limita as posturas de seis juntas de revolução segundo "
    "os elos de comprimento zero. Aqui se buscam, sem limite, todas as posturas de uma pose em braços de cada linha: "
    "aleatórios e um conhecido por ter muitas. As duas primeiras linhas são ultrapassadas, também por braços "
    "aleatórios; nunca se achou nada além de dezesseis nem, com punho esférico, além de oito.",
)
ROBOT = "puma560"

# Zero link lengths of each row of the table, and its bound.
ROWS: tuple[tuple[tuple[int, ...], int], ...] = (((1, 3, 5), 4), ((3, 5), 8), ((3,), 16), ((), 16))
# In a row whose bound does not hold: the number of the entry about it.
WRONG = {(1, 3, 5): "campos-1", (3, 5): "campos-2"}
RIGHT = pi / 2
# An arm of the first row with sixteen postures for one pose: α = 90°, a2 = 0.6, a4 = 0.7, d3 = 0.4, d4 = d5 = 0.2 m;
# link lengths that are not to be zero are SHORT, m, which leaves all sixteen. And one of these postures, rad.
KNOWN = ((0.0, 0.0), (0.0, 0.0), (0.6, 0.4), (0.0, 0.2), (0.7, 0.2), (0.0, 0.0))
SHORT, POSTURE = 0.02, frozen([-1.3, -2.8, -0.7, -0.6, -2.9, -2.8])
# No count of a pose reaches this; a search ends after 150 times in a row that it came to a posture that was known.
ENDLESS = 64
FAMILIES, FEW = ("general", "a1 = 0", "sin α1 = 0"), 20


@dataclass(frozen=True)
class Options:
    """How many random arms of each row, and of each family with a spherical wrist, are counted."""

    arms: Annotated[float, Quantity(Text(en="random arms", pt_BR="braços aleatórios"), 10, 1500, decades=True)] = 100


def with_zeros(zeros: tuple[int, ...], draw: np.random.Generator) -> Robot:
    """An arm with random DH rows, in which the given link lengths are zero; twists are right angles or any."""
    a, d = draw.uniform(0.1, 1, (2, 6))
    a[[0, *zeros]] = 0
    alpha = draw.choice([-RIGHT, RIGHT], 6) if draw.random() < 0.5 else draw.uniform(0.3, 2.8, 6)
    rows = [(float(x), float(y), float(z)) for x, y, z in zip(alpha, a, d, strict=True)]
    return arm_from_dh(rows, random_pose(draw), random_pose(draw))


def known_arm(zeros: tuple[int, ...]) -> Robot:
    """The arm of `KNOWN`, in the row with these link lengths zero."""
    a = [length or SHORT * (i > 0 and i not in zeros) for i, (length, _) in enumerate(KNOWN)]
    return arm_from_dh([(RIGHT * (i > 0), a[i], d) for i, (_, d) in enumerate(KNOWN)], np.eye(4), np.eye(4))


def count_postures(robot: Robot, q: Array) -> int:
    """The number of postures that random searches find for the pose of a posture (6,), rad: a lower bound."""
    goal = np.ascontiguousarray(tool_at(robot, q))
    return len(numeric.distinct_postures(robot, goal, np.zeros(6), True, ENDLESS)[0])


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Arms of each row of the table, the PUMA, and arms with a spherical wrist; short: twenty of each."""
    arms = FEW if short else int(options.arms)
    draw, found = np.random.default_rng(22), dict[tuple[int, ...], list[int]]()
    for part, (zeros, _) in enumerate(ROWS):
        found[zeros] = [count_postures(known_arm(zeros), POSTURE)]
        for done in range(arms):
            found[zeros].append(count_postures(with_zeros(zeros, draw), draw.uniform(-pi, pi, 6)))
            progress((part + (done + 1) / arms) / (len(ROWS) + 1))
    wrists = _spherical(arms, draw, lambda share: progress((len(ROWS) + share) / (len(ROWS) + 1)))
    puma_0 = count_postures(puma_with_lengths(*LENGTHS[2]), np.array([0.3, -0.5, 0.7, 0.4, 0.9, -1.1]))
    rows = [
        *(
            Row(
                MOST.format(zeros=_named(zeros)),
                max(found[zeros]),
                "",
                printed_statement(f"≤ {bound}", "s.22, Craig"),
                erratum=WRONG.get(zeros, ""),
            )
            for zeros, bound in ROWS
        ),
        Row(PUMA, puma_0, "", printed_statement("≤ 4", "s.22, Craig"), erratum="campos-1"),
        *(
            Row(RANDOM.format(zeros=_named(zeros), bound=bound), float(np.mean(np.array(found[zeros][1:]) > bound)))
            for zeros, bound in ROWS[:2]
        ),
        Row(WRIST, max(wrists)),
    ]
    values = np.arange(1.0, 18.0)
    lines = [(_named(zeros), found[zeros][1:]) for zeros, _ in ROWS] + [(WITH_WRIST, wrists)]
    chart = Chart(
        TITLE,
        Text(en="postures", pt_BR="posturas"),
        Text(en="share of random arms", pt_BR="fração dos braços aleatórios"),
        tuple(ChartLine(name, values, np.array([np.mean(np.array(n) == v) for v in values])) for name, n in lines),
    )
    return campos_result(rows, (chart,))


def _spherical(arms: int, draw: np.random.Generator, progress: Progress) -> list[int]:
    """How many postures random arms with a spherical wrist have for a pose of theirs, by Pieper's solution."""
    counts: list[int] = []
    for done in range(arms):
        robot = random_spherical_arm(draw, FAMILIES[done % len(FAMILIES)], right_wrist=False)
        counts.append(
            len(closed.solve_closed_form(pieper, robot, tool_at(robot, draw.uniform(-pi, pi, 6)), np.zeros(6)).branches)
        )
        progress((done + 1) / arms)
    return counts


def _named(zeros: tuple[int, ...]) -> Text:
    if not zeros:
        return Text(en="no aᵢ = 0", pt_BR="nenhum aᵢ = 0")
    return untranslated(" = ".join([*(f"a{number}" for number in zeros), "0"]))


MOST = Text(en="most postures of one pose, {zeros}", pt_BR="mais posturas de uma pose, {zeros}")
PUMA = Text(en="postures of the PUMA with a3 = d3 = 0", pt_BR="posturas do PUMA com a3 = d3 = 0")
RANDOM = Text(
    en="share of random arms with more than {bound} postures, {zeros}",
    pt_BR="fração dos braços aleatórios com mais de {bound} posturas, {zeros}",
)
WRIST = Text(
    en="most postures of random arms with a spherical wrist", pt_BR="mais posturas de braços com punho esférico"
)
WITH_WRIST = Text(en="spherical wrist", pt_BR="punho esférico")
