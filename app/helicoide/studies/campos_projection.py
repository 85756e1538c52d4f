"""A general goal for an arm with few joints: brought to the nearest pose that the arm can take."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler, rotation
from helicoide.ik import closed
from helicoide.ik.closed import motoman_l3
from helicoide.ik.method import Quantity
from helicoide.ik.postures import subspace
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar_pose, planar_with_lengths
from helicoide.studies._campos_rows import NEAR_POSE, campos_result, posture_motion, slide_statement
from helicoide.studies.study import BY_CONSTRUCTION, Chart, ChartLine, Interpretation, Progress, Result, Row
from helicoide.text import Text, untranslated

TITLE = Text(en="Goals that an arm cannot take", pt_BR="Alvos que o braço não pode assumir")
SOURCE = "Campos 1998, s.13, s.27–36"
ABOUT = Text(
    en="With fewer than six joints most poses are out of the question. The goal is taken to the nearest pose of the "
    "arm's subspace first: a planar arm lays it flat, the polar arm keeps its point, the L-3 turns its pointing axis "
    "by exactly the angle at which it leaves the plane of the arm.",
    pt_BR="Com menos de seis juntas, a maioria das poses está fora de questão. Primeiro o alvo é levado à pose mais "
    "próxima do subespaço do braço: o braço planar o deita no plano, o polar mantém o ponto, o L-3 gira o eixo da mão "
    "exatamente pelo ângulo com que ele sai do plano do braço.",
)
ROBOT = "motoman_l3"

FEW, SHOWN = 200, 40
Z = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Options:
    """How many random goals are taken to each subspace."""

    goals: Annotated[float, Quantity(Text(en="random goals", pt_BR="alvos aleatórios"), 100, 5000, decades=True)] = 1000


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Random goals for three arms; short: 200 for each."""
    goals = [
        _goal(draw) for draw in np.random.default_rng(36).uniform(-1, 1, (FEW if short else int(options.goals), 6))
    ]
    robot, polar, flat = load_robot(ROBOT), load_robot("polar_rp"), planar_with_lengths("planar3r", 1.0, 0.7, 0.2)
    off, angles, nearer = projection_angles(robot, goals)
    progress(0.4)
    ahead, down, across = polar_frame(polar, goals)
    progress(0.6)
    found = [closed.solve_closed_form(motoman_l3, robot, T, robot.poses["ready"]).branches for T in goals]
    progress(0.8)
    rows = [
        *(_taken(arm, goals) for arm in (robot, polar, flat)),
        Row(
            NEARER,
            nearer,
            "rad",
            slide_statement("as near as possible", "o mais próximo possível", "s.36", 0, "≤", 1e-9),
            (NEAR_POSE,),
        ),
        Row(
            OUTSIDE, sum(not branches for branches in found), "", slide_statement(*STILL_OUT, "s.36", 0, ">"), (DRAWN,)
        ),
        Row(
            AHEAD,
            ahead,
            "rad",
            slide_statement("Ẑ₂ along (x, y, 0)", "Ẑ₂ ao longo de (x, y, 0)", "s.32–33", 0, "=", 1e-9),
        ),
        Row(
            DOWN,
            down,
            "rad",
            slide_statement("Ŷ₂ always straight down", "Ŷ₂ sempre para baixo", "s.32–33", 0, "=", 1e-9),
        ),
        Row(
            ACROSS,
            across,
            "",
            slide_statement("X̂₂ = Ŷ₂ × Ẑ₂", "X̂₂ = Ŷ₂ × Ẑ₂", "s.33", 0, "=", 1e-9),
            given=BY_CONSTRUCTION,
        ),
        Row(
            FLAT,
            _flat(flat),
            "",
            slide_statement("cφ, −sφ; sφ, cφ; x, y; z = 0", "cφ, −sφ; sφ, cφ; x, y; z = 0", "s.29", 0, "=", 1e-9),
        ),
        Row(BY_ANGLE, off),
    ]
    progress(1.0)
    shown = [branches[0].q for branches in found[:SHOWN] if branches]
    return campos_result(rows, _charts(angles), [posture_motion(ROBOT, shown)])


def _taken(arm: Robot, goals: list[Array]) -> Row:
    """How many goals an arm reaches as they are."""
    return Row(
        TAKEN.format(robot=arm.title), goals_in_subspace(arm, goals), "", slide_statement(*FEWER, "s.13, s.27", 0)
    )


def _goal(draw: Array) -> Array:
    """A random pose (4, 4), m, from six numbers in [−1, 1], within 0.6 m each way."""
    T = np.eye(4)
    T[:3, :3] = euler.euler_matrix(np.pi * draw[3:] * [1, 0.49, 1], "zyx")
    T[:3, 3] = 0.6 * draw[:3]
    return T


def goals_in_subspace(robot: Robot, goals: list[Array]) -> int:
    """The number of goals that lie in the subspace of the arm without projection."""
    now = np.zeros(len(robot.variables))
    return sum(subspace.project_to_subspace(robot, T, now).words is None for T in goals)


def projection_angles(robot: Robot, goals: list[Array]) -> tuple[float, Array, float]:
    """How far sin |θ| is from |M·Ẑ|, the angles, rad, and by how much another pose of the subspace comes nearer.

    The others: the projected pose turned about the arm's normal, and about its own pointing axis, by small angles.
    """
    now = np.zeros(5)
    off, angles, nearer = 0.0, [], 0.0
    for T in goals:
        turn = motoman_l3.pointed(robot, T, now)
        found = subspace.project_to_subspace(robot, T, now)
        off = max(off, abs(np.sin(found.turned) - abs(float(turn.M @ T[:3, 2]))), found.moved)
        angles.append(found.turned)
        for axis in (turn.M, found.T_world_goal[:3, 2]):
            for angle in (-0.05, 0.05):
                other = found.T_world_goal.copy()
                other[:3, :3] = rotation.exponential(angle * axis) @ other[:3, :3]
                nearer = max(nearer, found.turned - between(T, other)[1])
    return off, np.array(angles), nearer


def polar_frame(robot: Robot, goals: list[Array]) -> tuple[float, float, float]:
    """Of the tool's frame, in random postures and in projected goals: how far Ẑ₂ is from (x, y, 0), Ŷ₂ from straight
    down, rad, and X̂₂ from Ŷ₂ × Ẑ₂.
    """
    draw = np.random.default_rng(31).uniform([-np.pi, 0.1], [np.pi, 1.0], (len(goals), 2))
    poses = [tool_at(robot, q) for q in draw]
    poses += [subspace.project_to_subspace(robot, T, np.zeros(2)).T_world_goal for T in goals]
    ahead = max(_largest_difference(T[:3, 2], T[:3, 3] * [1, 1, 0]) for T in poses)
    down = max(_largest_difference(T[:3, 1], -Z) for T in poses)
    across = max(float(np.abs(np.cross(T[:3, 1], T[:3, 2]) - T[:3, 0]).max()) for T in poses)
    return ahead, down, across


def _largest_difference(a: Array, b: Array) -> float:
    """The angle between two directions, rad."""
    return float(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))


def _flat(robot: Robot) -> float:
    """How far the tool of random postures is from the matrix with its own x, y and φ = θ₁ + θ₂ + θ₃."""
    worst = 0.0
    for q in np.random.default_rng(29).uniform(-np.pi, np.pi, (FEW, 3)):
        T = tool_at(robot, frozen(q))
        worst = max(worst, float(np.abs(T - planar_pose(T[0, 3], T[1, 3], float(q.sum()))).max()))
    return worst


def _charts(angles: Array) -> list[Chart]:
    share = np.arange(1, len(angles) + 1) / len(angles)
    line = ChartLine(untranslated("asin |M·Ẑ|"), share, np.degrees(np.sort(angles)))
    return [Chart(HOW_FAR, Text(en="share of goals", pt_BR="fração dos alvos"), untranslated("|θ|, °"), (line,))]


FEWER = ("fewer than six joints: no general poses", "menos de seis juntas: não alcança poses quaisquer")
STILL_OUT = ("it may still be outside the workspace", "ainda pode ficar fora do espaço de trabalho")
DRAWN = Interpretation(
    Text(
        en="links of the L-3 of 400 and 500 mm, goals within 0.6 m along each axis",
        pt_BR="elos do L-3 de 400 e 500 mm, alvos até 0,6 m ao longo de cada eixo",
    ),
    Text(
        en="of 1000 goals within 0.4 m 6 stay outside, within 0.2 m 67",
        pt_BR="de 1000 alvos até 0,4 m ficam fora 6; até 0,2 m, 67",
    ),
)
TAKEN = Text(
    en="random goals that the arm takes as they are, {robot}", pt_BR="alvos aleatórios aceitos como são, {robot}"
)
NEARER = Text(
    en="L-3: by how much a neighbouring pose of its subspace is nearer",
    pt_BR="L-3: quanto uma pose vizinha do subespaço fica mais perto",
)
OUTSIDE = Text(en="L-3: projected goals without a posture", pt_BR="L-3: alvos projetados sem postura")
AHEAD = Text(en="polar arm: Ẑ₂ from (x, y, 0), at most", pt_BR="braço polar: maior ângulo entre Ẑ₂ e (x, y, 0)")
DOWN = Text(en="polar arm: Ŷ₂ from straight down, at most", pt_BR="braço polar: maior ângulo entre Ŷ₂ e a vertical")
ACROSS = Text(en="polar arm: X̂₂ from Ŷ₂ × Ẑ₂, at most", pt_BR="braço polar: maior diferença entre X̂₂ e Ŷ₂ × Ẑ₂")
FLAT = Text(
    en="planar arm: the end effector from that matrix, at most", pt_BR="braço planar: maior diferença para essa matriz"
)
BY_ANGLE = Text(en="L-3: sin |θ| from |M·Ẑ|, largest difference", pt_BR="L-3: sen |θ| e |M·Ẑ|, maior diferença")
HOW_FAR = Text(en="How far goals of the L-3 are turned", pt_BR="Quanto são girados os alvos do L-3")
