"""The four postures of the Motoman L-3, after its goal was turned into the plane of the arm."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.geometry import euler
from helicoide.ik.closed import motoman_l3
from helicoide.ik.method import Quantity
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_rows import posed, row
from helicoide.studies.study import Chart, Line, Progress, Result
from helicoide.text import Text, same

TITLE = Text(en="Four postures of the L-3", pt_BR="Quatro posturas do L-3")
SOURCE = "Campos 1998, s.36, s.55 (Craig)"
ABOUT = Text(
    en="Five joints cannot take every pose: the hand of the L-3 always points within the vertical plane of the arm. A "
    "general goal is turned into that plane by as little as may be, and then four postures reach it, to the front or "
    "over the back, elbow up or down.",
    pt_BR="Cinco juntas não assumem qualquer pose: a mão do L-3 sempre aponta dentro do plano vertical do braço. Um "
    "alvo qualquer é girado para esse plano o mínimo possível, e então quatro posturas o alcançam, à frente ou para "
    "trás, com o cotovelo para cima ou para baixo.",
)
ROBOT = "motoman_l3"

# The names of the postures for the goal, and their joints, degrees.
SOLUTIONS = {
    "front, elbow up": (21.8014, -83.1026, 94.3012, 98.9770, 0.6431),
    "front, elbow down": (21.8014, 24.8595, -94.3012, 179.6174, 0.6431),
    "back, elbow down": (-158.1986, 155.1405, 94.3012, 0.3826, -179.3569),
    "back, elbow up": (-158.1986, -96.8974, -94.3012, 81.0230, -179.3569),
}
ANGLE, POINTING = -16.6918, frozen([0.871505, 0.348602, -0.344899])
FEW = 300


@dataclass(frozen=True)
class Options:
    """How many random poses of the subspace are solved."""

    poses: Annotated[float, Quantity(Text(en="random poses", pt_BR="poses aleatórias"), 100, 100_000, decades=True)] = (
        20_000
    )


def goal() -> Array:
    """p = (0.5, 0.2, 0.3) m, R = Rz(20°) Ry(110°) Rx(15°): (4, 4)."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = euler.matrix(np.radians([20, 110, 15]), "zyx"), (0.5, 0.2, 0.3)
    return T


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The digest's goal and random poses of the subspace; short: 300 of them."""
    robot, now = load(ROBOT), np.zeros(5)
    turn = motoman_l3.pointed(robot, goal(), now)
    postures = [branch.q for branch in motoman_l3.solve(robot, goal(), now).branches]
    missed, lost, counts = there_and_back(robot, FEW if short else int(options.poses), progress)
    off = [
        float(np.abs(np.degrees(wrap(q - np.radians(expected)))).max())
        for q, expected in zip(postures, SOLUTIONS.values(), strict=True)
    ]
    return Result(
        rows=(
            row(TURNED, np.degrees(turn.angle), ANGLE, 5.1e-5, "°"),
            row(AXIS, np.abs(turn.Z - POINTING).max(), 0, 5.1e-7),
            *(
                row(POSTURE.format(name=name), value, 0, 5.1e-5, "°")
                for name, value in zip(SOLUTIONS, off, strict=True)
            ),
            row(LEAST, min(counts), 4),
            row(MOST, max(counts), 4),
            row(MISSED, missed, 0, 1e-9),
            row(LOST, lost, 0, 1e-9, "rad"),
        ),
        charts=(
            Chart(
                TITLE,
                Text(en="joint", pt_BR="junta"),
                same("θ, °"),
                tuple(
                    Line(same(name), np.arange(1.0, 6.0), np.degrees(q))
                    for name, q in zip(SOLUTIONS, postures, strict=True)
                ),
            ),
        ),
        motion=posed(ROBOT, postures),
    )


def there_and_back(robot: Robot, count: int, progress: Progress) -> tuple[float, float, set[int]]:
    """Of random postures: the worst miss of any answer, m or rad, the generating one's distance, rad, the counts."""
    missed, lost, counts = 0.0, 0.0, set[int]()
    for done, q in enumerate(np.random.default_rng(20).uniform(-np.pi, np.pi, (count, 5)), start=1):
        answer = motoman_l3.solve(robot, tool_at(robot, frozen(q)), robot.poses["ready"])
        counts.add(len(answer.branches))
        missed = max(missed, *(max(branch.missed, branch.turned) for branch in answer.branches))
        lost = max(lost, min(float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches))
        progress(done / count)
    return missed, lost, counts


TURNED = Text(en="how far the goal is turned", pt_BR="quanto o alvo é girado")
AXIS = Text(en="the turned pointing axis, from the digest's", pt_BR="o eixo girado da mão, em relação ao da síntese")
POSTURE = Text(
    en="{name}: largest difference from the digest's joints", pt_BR="{name}: maior diferença para as juntas da síntese"
)
LEAST = Text(en="least number of postures of random poses", pt_BR="menor número de posturas de poses aleatórias")
MOST = Text(en="largest number of postures of random poses", pt_BR="maior número de posturas de poses aleatórias")
MISSED = Text(en="worst miss of any posture", pt_BR="maior erro de qualquer postura")
LOST = Text(en="worst distance of the generating posture", pt_BR="maior distância da postura geradora")
