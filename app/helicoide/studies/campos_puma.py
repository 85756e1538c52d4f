"""The eight postures of the PUMA for one pose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.closed import puma560
from helicoide.ik.method import Quantity
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.chain import frozen
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_rows import posed, row
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.text import Text, same

TITLE = Text(en="Eight postures of the PUMA", pt_BR="Oito posturas do PUMA")
SOURCE = "Campos 1998, s.19–21, s.55 (Craig)"
ABOUT = Text(
    en="Shoulder left or right, elbow up or down, wrist flipped or not: eight postures bring the tool to the same "
    "pose. The flip of the wrist, θ₄ + 180°, −θ₅, θ₆ + 180°, leaves the tool exactly where it is.",
    pt_BR="Ombro à esquerda ou à direita, cotovelo para cima ou para baixo, punho virado ou não: oito posturas levam o "
    "efetuador à mesma pose. Virar o punho, θ₄ + 180°, −θ₅, θ₆ + 180°, deixa o efetuador exatamente onde está.",
)
ROBOT = "puma560"

# The postures, degrees, for the pose of EXAMPLE, rad.
EXAMPLE = frozen([0.3, -0.5, 0.7, 0.4, 0.9, -1.1])
POINT = frozen([0.262305, 0.211356, -0.220210])
TABLE = frozen(
    [
        [17.1887, -28.6479, 40.1070, 22.9183, 51.5662, -63.0254],
        [17.1887, -28.6479, 40.1070, -157.0817, -51.5662, 116.9746],
        [17.1887, 98.8955, 145.2762, 79.3309, 161.9162, 30.4899],
        [17.1887, 98.8955, 145.2762, -100.6691, -161.9162, -149.5101],
        [-119.4674, 81.1045, 40.1070, -103.7593, 125.3785, 52.1355],
        [-119.4674, 81.1045, 40.1070, 76.2407, -125.3785, -127.8645],
        [-119.4674, -151.3521, 145.2762, -113.4273, 59.6660, -64.3108],
        [-119.4674, -151.3521, 145.2762, 66.5727, -59.6660, 115.6892],
    ]
)
FEW = 1_000


@dataclass(frozen=True)
class Options:
    """How many random poses are solved."""

    poses: Annotated[float, Quantity(Text(en="random poses", pt_BR="poses aleatórias"), 100, 100_000, decades=True)] = (
        20_000
    )


def there_and_back(
    arm: Robot, count: int, seed: int, progress: Progress = lambda share: None
) -> tuple[float, float, int, int]:
    """The worst miss of any posture (m, and 1 for rotations), the worst distance of the generating one, rad.

    Then the least and the largest number of postures.
    """
    lengths, missed, apart, counts = puma560.lengths_of(arm).copy(), 0.0, 0.0, [8]
    for done, q in enumerate(np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, 6))):
        T = tool_at(arm, q)
        found, exists = puma560.postures(lengths, T, np.zeros(6))
        counts.append(int(exists.sum()))
        missed = max(missed, *(float(np.abs(tool_at(arm, row) - T).max()) for row in found[exists]))
        apart = max(apart, float(np.abs(wrap(found[exists] - q)).max(axis=1).min()))
        if done % 100 == 99:
            progress((done + 1) / count)
    return missed, apart, min(counts), max(counts)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The table, the flip and random poses; short: 1,000 of them."""
    arm = load(ROBOT)
    T = tool_at(arm, EXAMPLE)
    postures = [branch.q for branch in puma560.solve(arm, T, np.zeros(6)).branches]
    missed, apart, least, most = there_and_back(arm, FEW if short else int(options.poses), 560, progress)
    progress(1.0)
    return Result(
        rows=(
            *_table(postures),
            row(AWAY, np.abs(T[:3, 3] - POINT).max(), 0, 5e-7, "m"),
            row(FLIP, _moved_by_flip(arm), 0, 1e-12),
            row(LEAST, least, 8, source="8"),
            row(MOST, most, 8, source="8"),
            row(MISSED, missed, 0, 1e-9),
            row(APART, apart, 0, 1e-8, "rad"),
        ),
        charts=(
            Chart(
                Text(en="The eight postures", pt_BR="As oito posturas"),
                Text(en="joint", pt_BR="junta"),
                same("θ, °"),
                tuple(
                    Line(same(str(number + 1)), np.arange(1.0, 7.0), np.degrees(q)) for number, q in enumerate(postures)
                ),
            ),
        ),
        motion=posed(ROBOT, postures),
    )


def _table(postures: list[np.ndarray[tuple[int], np.dtype[np.float64]]]) -> list[Row]:
    """Each posture beside its row of the table: the joint that differs most, degrees."""
    off = np.degrees(np.abs(wrap(np.array(postures) - np.radians(TABLE)))).max(axis=1)
    return [row(POSTURE.format(number=number + 1), value, 0, 5.1e-5, "°") for number, value in enumerate(off)]


def _moved_by_flip(arm: Robot) -> float:
    flipped = EXAMPLE * [1, 1, 1, 1, -1, 1] + [0, 0, 0, np.pi, 0, np.pi]
    return float(np.abs(tool_at(arm, flipped) - tool_at(arm, EXAMPLE)).max())


POSTURE = Text(
    en="posture {number}: largest difference from the table", pt_BR="postura {number}: maior diferença da tabela"
)
AWAY = Text(en="wrist centre from that of the table", pt_BR="centro do punho em relação ao da tabela")
FLIP = Text(en="how far a flip of the wrist moves the tool", pt_BR="quanto virar o punho move o efetuador")
LEAST = Text(en="least number of postures of random poses", pt_BR="menor número de posturas de poses aleatórias")
MOST = Text(en="largest number of postures of random poses", pt_BR="maior número de posturas de poses aleatórias")
MISSED = Text(en="worst miss of any posture", pt_BR="maior erro de qualquer postura")
APART = Text(en="worst distance of the generating posture", pt_BR="maior distância da postura geradora")
