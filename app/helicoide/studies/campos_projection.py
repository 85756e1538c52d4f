"""A general goal for an arm with few joints: brought to the nearest pose that the arm can take."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.geometry import euler, rotation
from helicoide.ik.closed import motoman_l3
from helicoide.ik.method import Quantity
from helicoide.ik.postures import subspace
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.library import load
from helicoide.studies._campos_arms import planar, upright
from helicoide.studies._campos_rows import posed, row
from helicoide.studies.study import Chart, Line, Progress, Result
from helicoide.text import Text, same

TITLE = Text(en="Goals that an arm cannot take", pt_BR="Alvos que o braço não pode assumir")
SOURCE = "Campos 1998, s.13, s.27–36"
ABOUT = Text(
    en="With fewer than six joints most poses are out of question. The goal is taken to the nearest pose of the arm's "
    "subspace first: a planar arm lays it flat, the polar arm keeps its point, the L-3 turns its pointing axis by "
    "exactly the angle at which it leaves the plane of the arm.",
    pt_BR="Com menos de seis juntas, a maioria das poses está fora de questão. Primeiro o alvo é levado à pose mais "
    "próxima do subespaço do braço: o braço planar o deita no plano, o polar mantém o ponto, o L-3 gira o eixo da mão "
    "exatamente pelo ângulo com que ele sai do plano do braço.",
)
ROBOT = "motoman_l3"

FEW = 200


@dataclass(frozen=True)
class Options:
    """How many random goals are taken to each subspace."""

    goals: Annotated[float, Quantity(Text(en="random goals", pt_BR="alvos aleatórios"), 100, 5000, decades=True)] = 1000


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Random goals for three arms; short: 200 for each."""
    count = FEW if short else int(options.goals)
    goals = [_goal(draw) for draw in np.random.default_rng(36).uniform(-1, 1, (count, 6))]
    l3, angles, nearer = _l3(goals)
    progress(1 / 3)
    polar = _polar(goals)
    progress(2 / 3)
    flat = _planar(goals)
    progress(1.0)
    robot = load(ROBOT)
    shown = [motoman_l3.solve(robot, T, robot.poses["ready"]).branches for T in goals[:40]]
    return Result(
        rows=(
            row(BY_ANGLE, l3, 0, 1e-9),
            row(NEARER, nearer, 0, 1e-9, "rad", relation="≤"),
            row(POLAR, polar, 0, 1e-12),
            row(FLAT, flat, 0, 1e-9),
        ),
        charts=(
            Chart(
                Text(en="How far goals of the L-3 are turned", pt_BR="Quanto são girados os alvos do L-3"),
                Text(en="share of goals", pt_BR="fração dos alvos"),
                same("|θ|, °"),
                (Line(same("asin |M·Ẑ|"), np.arange(1, count + 1) / count, np.degrees(np.sort(angles))),),
            ),
        ),
        motion=posed(ROBOT, [branches[0].q for branches in shown if branches]),
    )


def _goal(draw: Array) -> Array:
    """A random pose (4, 4), m, from six numbers in [−1, 1], within half a metre."""
    T = np.eye(4)
    T[:3, :3] = euler.matrix(np.pi * draw[3:] * [1, 0.49, 1], "zyx")
    T[:3, 3] = 0.5 * draw[:3]
    return T


def _l3(goals: list[Array]) -> tuple[float, Array, float]:
    """How far sin |θ| is from |M·Ẑ|, the angles, rad, and by how much another pose of the subspace comes nearer.

    The others: the projected pose turned about the arm's normal, and about its own pointing axis, by small angles.
    """
    robot, now = load(ROBOT), np.zeros(5)
    off, angles, nearer = 0.0, [], 0.0
    for T in goals:
        turn = motoman_l3.pointed(robot, T, now)
        found = subspace.project(robot, T, now)
        off = max(off, abs(np.sin(found.turned) - abs(float(turn.M @ T[:3, 2]))), found.moved)
        angles.append(found.turned)
        for axis in (turn.M, found.T_world_goal[:3, 2]):
            for angle in (-0.05, 0.05):
                other = found.T_world_goal.copy()
                other[:3, :3] = rotation.exponential(angle * axis) @ other[:3, :3]
                nearer = max(nearer, found.turned - between(T, other)[1])
    return off, np.array(angles), nearer


def _polar(goals: list[Array]) -> float:
    """The largest difference of the polar arm's pose from the matrix of the slides. Source: Campos 1998, s.31–34."""
    robot, worst = load("polar_rp"), 0.0
    for T in goals:
        x, y = T[:2, 3]
        rho = np.hypot(x, y)
        expected = [[y / rho, 0, x / rho, x], [-x / rho, 0, y / rho, y], [0, -1, 0, 0], [0, 0, 0, 1]]
        at = tool_at(robot, frozen([np.arctan2(-x, y), rho]))
        projected = subspace.project(robot, T, np.zeros(2)).T_world_goal
        worst = max(worst, *(float(np.abs(pose - expected).max()) for pose in (at, projected)))
    return worst


def _planar(goals: list[Array]) -> float:
    """The largest difference from z = 0 and φ' = Atan2(r₂₁ − r₁₂, r₁₁ + r₂₂). Source: Campos 1998, s.29."""
    robot, worst = planar("planar3r", 1.0, 0.7, 0.2), 0.0
    for T in goals:
        R = T[:3, :3]
        expected = upright(T[0, 3], T[1, 3], float(np.arctan2(R[1, 0] - R[0, 1], R[0, 0] + R[1, 1])))
        worst = max(worst, float(np.abs(subspace.project(robot, T, np.zeros(3)).T_world_goal - expected).max()))
    return worst


BY_ANGLE = Text(en="L-3: sin |θ| from |M·Ẑ|, largest difference", pt_BR="L-3: sen |θ| e |M·Ẑ|, maior diferença")
NEARER = Text(en="L-3: by how much a neighbour comes nearer", pt_BR="L-3: quanto uma pose vizinha chega mais perto")
POLAR = Text(en="polar arm: from the matrix of the slides", pt_BR="braço polar: em relação à matriz dos slides")
FLAT = Text(en="planar arm: from z = 0 and φ'", pt_BR="braço planar: em relação a z = 0 e φ'")
