"""Three links in a plane: two postures by two roads, and which of them is nearer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.closed import planar3r
from helicoide.ik.method import OneOf
from helicoide.ik.postures import choice
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar, upright
from helicoide.studies._campos_rows import millimetres, posed, row
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.text import Text, same

TITLE = Text(en="Three links, two postures", pt_BR="Três elos, duas posturas")
SOURCE = "Campos 1998, s.15–18, s.38–54"
ABOUT = Text(
    en="For a point and an orientation three links have two postures, elbow up and elbow down, and algebra and "
    "geometry lead to the same angles. Which of the two is nearer depends on how much the large joints count.",
    pt_BR="Para um ponto e uma orientação, três elos têm duas posturas, cotovelo para cima e para baixo, e a álgebra e "
    "a geometria levam aos mesmos ângulos. Qual das duas está mais perto depende de quanto pesam as juntas grandes.",
)
ROBOT = "planar3r"

L1, L2, L3 = 1.0, 0.7, 0.2
# For (x, y, φ) = (1, 0.8, 0.5) of the third axis, rad.
GOAL = (1.0, 0.8, 0.5)
POSTURES = frozen([[0.100185, 1.463447, -1.063633], [1.249296, -1.463447, 0.714151]])
# The choice: where the arm is, the goal, its two postures, and what each costs by weights.
NOW, CHOICE = frozen([0.5, 0.2, -1.0]), (-0.7, -1.1, -1.4)
A, B = (-2.6971, 1.4202, -0.1232), (-1.5780, -1.4202, 1.5982)
COSTS = {"alike": ((1, 1, 1), (5.183, 6.296), A), "falling": ((3, 2, 1), (12.073, 12.576), B)}
WEIGHTS = {"alike": same("1, 1, 1"), "falling": same("3, 2, 1")}
FEW, MANY = 500, 20_000


@dataclass(frozen=True)
class Options:
    """The weights of the joints in the choice."""

    weights: Annotated[str, OneOf(Text(en="weights of the joints", pt_BR="pesos das juntas"), WEIGHTS)] = "falling"


def of_third_axis(x: float, y: float, phi: float) -> Array:
    """The tool's pose (4, 4), m, where the third axis stands at (x, y), m, and the hand points to φ, rad."""
    return upright(x + L3 * np.cos(phi), y + L3 * np.sin(phi), phi)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The digest's example, the choice, and random postures by both roads; short: 500 of them."""
    robot = planar(ROBOT, L1, L2, L3)
    found = [branch.q for branch in planar3r.solve(robot, of_third_axis(*GOAL), np.zeros(3)).branches]
    missed, apart, lost, counts = both_roads(robot, FEW if short else MANY, progress)
    weights, costs, best = COSTS[options.weights]
    ranked = choice.ranked(robot, planar3r.solve(robot, of_third_axis(*CHOICE), NOW).branches, NOW, weights)
    rows: list[Row] = [
        *(
            row(ANGLE.format(which=which, joint=joint + 1), q[joint], expected[joint], 5.1e-7, "rad")
            for which, q, expected in zip((DOWN, UP), found, POSTURES, strict=True)
            for joint in range(3)
        ),
        *(
            row(COST.format(which=which), one.cost, cost, 6e-4)
            for which, one, cost in zip((NEARER, FARTHER), ranked, costs, strict=True)
        ),
        *(
            row(CHOSEN.format(joint=joint + 1), ranked[0].branch.q[joint], best[joint], 5.1e-5, "rad")
            for joint in range(3)
        ),
        row(LEAST, min(counts), 2, source="2"),
        row(MOST, max(counts), 2, source="2"),
        row(MISSED, missed, 0, 1e-9),
        row(ROADS, apart, 0, 1e-9, "rad"),
        row(LOST, lost, 0, 1e-9, "rad"),
    ]
    lines = tuple(Line(which, np.arange(1.0, 4.0), np.degrees(q)) for which, q in zip((DOWN, UP), found, strict=True))
    chart = Chart(TITLE, Text(en="joint", pt_BR="junta"), same("θ, °"), lines)
    motion = posed(ROBOT, [NOW, *(one.q for one in ranked)], millimetres(l1=L1, l2=L2, l3=L3))
    return Result(tuple(rows), (chart,), motion)


def both_roads(robot: Robot, count: int, progress: Progress) -> tuple[float, float, float, set[int]]:
    """Of random postures: the worst miss, how far algebra and geometry are apart, rad, the generating one, the counts.

    Geometry: θ₁ = β + ψ where θ₂ < 0, and β − ψ where θ₂ > 0. Source: Campos 1998, s.54.
    """
    missed, apart, lost, counts = 0.0, 0.0, 0.0, set[int]()
    for done, q in enumerate(np.random.default_rng(20).uniform(-np.pi, np.pi, (count, 3)), start=1):
        answer = planar3r.solve(robot, tool_at(robot, frozen(q)), np.zeros(3))
        counts.add(len(answer.branches))
        missed = max(missed, *(max(branch.missed, branch.turned) for branch in answer.branches))
        lost = max(lost, min(float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches))
        for steps in answer.values:
            psi = steps["ψ"] if steps["θ₂"] < 0 else -steps["ψ"]
            apart = max(apart, abs(float(wrap(steps["β"] + psi - steps["θ₁"]))))
        progress(done / count)
    return missed, apart, lost, counts


DOWN = Text(en="elbow down", pt_BR="cotovelo para baixo")
UP = Text(en="elbow up", pt_BR="cotovelo para cima")
ANGLE = Text(en="{which}: θ{joint}", pt_BR="{which}: θ{joint}")
COST = Text(en="cost of the {which} posture", pt_BR="custo da postura {which}")
NEARER, FARTHER = Text(en="nearer", pt_BR="mais próxima"), Text(en="farther", pt_BR="mais distante")
CHOSEN = Text(en="the one that is chosen: θ{joint}", pt_BR="a escolhida: θ{joint}")
LEAST = Text(en="least number of postures of random poses", pt_BR="menor número de posturas de poses aleatórias")
MOST = Text(en="largest number of postures of random poses", pt_BR="maior número de posturas de poses aleatórias")
MISSED = Text(en="worst miss of any posture", pt_BR="maior erro de qualquer postura")
ROADS = Text(en="largest difference of algebra and geometry", pt_BR="maior diferença entre álgebra e geometria")
LOST = Text(en="worst distance of the generating posture", pt_BR="maior distância da postura geradora")
