"""The four postures of the Motoman L-3, after its goal was turned into the plane of the arm, and its ball screws."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, cast

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler, rotation
from helicoide.ik import closed
from helicoide.ik.closed import motoman_l3
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.actuators import Actuators
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_rows import (
    NEAR_POSE,
    POSES,
    campos_result,
    posture_chart,
    posture_motion,
    slide_statement,
)
from helicoide.studies.study import Chart, ChartLine, Motion, Progress, Result, Row
from helicoide.text import HelicoideError, Text, untranslated

TITLE = Text(en="Four postures of the L-3", pt_BR="Quatro posturas do L-3")
SOURCE = "Campos 1998, s.36, s.55 (Craig)"
ABOUT = Text(
    en="Five joints cannot take every pose: the hand of the L-3 always points within the vertical plane of the arm. A "
    "general goal is turned into that plane by as little as may be, and then four postures reach it, to the front or "
    "over the back, elbow up or down. Two of its joints are moved by ball screws, whose travel allows some of the "
    "postures only.",
    pt_BR="Cinco juntas não assumem qualquer pose: a mão do L-3 sempre aponta dentro do plano vertical do braço. Um "
    "alvo qualquer é girado para esse plano o mínimo possível, e então quatro posturas o alcançam, à frente ou para "
    "trás, com o cotovelo para cima ou para baixo. Duas de suas juntas são movidas por fusos de esferas, cujo "
    "curso permite só algumas das posturas.",
)
ROBOT = "motoman_l3"
FEW, SAMPLES, DIRECTIONS = 300, 101, 3600


@dataclass(frozen=True)
class Options:
    """How many random poses of the subspace are solved."""

    poses: Annotated[float, POSES] = 20_000


def goal() -> Array:
    """p = (0.5, 0.2, 0.3) m, R = Rz(20°) Ry(110°) Rx(15°): (4, 4)."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = euler.euler_matrix(np.radians([20, 110, 15]), "zyx"), (0.5, 0.2, 0.3)
    return T


def run(options: Options, short: bool, progress: Progress) -> Result:
    """A goal that is turned, random poses of the subspace, and the screws on a way; short: 300 poses."""
    robot, now = load_robot(ROBOT), np.zeros(5)
    actuators = cast(Actuators, robot.actuators)
    turn = motoman_l3.pointed(robot, goal(), now)
    branches = closed.solve_closed_form(motoman_l3, robot, goal(), now).branches
    missed, lost, counts = round_trip(robot, FEW if short else int(options.poses), progress)
    way = actuator_motion(robot, actuators)
    rows = [
        Row(TURNED, np.degrees(least_rotation(turn.M, goal()[:3, :3]) - abs(turn.angle)), "°", NEAREST, (NEAR_POSE,)),
        Row(ANGLE, np.degrees(abs(turn.angle)), "°"),
        Row(LEAST, min(counts)),
        Row(MOST, max(counts)),
        Row(MISSED, missed),
        Row(LOST, lost, "rad"),
    ]
    rows += [Row(HELD, sum(_allowed(actuators, branch.q) for branch in branches)), *_screws(actuators, branches[0].q)]
    charts = [posture_chart(TITLE, [(branch.name, branch.q) for branch in branches]), *_lengths(actuators, way)]
    motions = [posture_motion(ROBOT, [branch.q for branch in branches], title=TITLE), way]
    return campos_result(rows, charts, motions)


def least_rotation(M: Array, R: Array) -> float:
    """The least angle, rad, from R (3, 3) to any frame whose Z is at a right angle to M (3,), by trying directions.

    With Z and R given, the trace is largest over the frames that are turned about Z in closed form.
    """
    first = np.column_stack([M, np.cross([0.0, 0.0, 1.0], M), [0.0, 0.0, 1.0]])
    turns = (rotation.exponential(angle * M) for angle in np.linspace(0, 2 * np.pi, DIRECTIONS, endpoint=False))
    seen = np.array([(turn @ first).T @ R for turn in turns])
    trace = np.hypot(seen[:, 0, 0] + seen[:, 1, 1], seen[:, 1, 0] - seen[:, 0, 1]) + seen[:, 2, 2]
    return float(np.arccos(np.clip(0.5 * (trace.max() - 1), -1, 1)))


def round_trip(robot: Robot, count: int, progress: Progress) -> tuple[float, float, set[int]]:
    """For random postures: worst residual, m or rad, distance to the generating posture, rad, and solution counts."""
    missed, lost, counts = 0.0, 0.0, set[int]()
    for done, q in enumerate(np.random.default_rng(20).uniform(-np.pi, np.pi, (count, 5)), start=1):
        answer = closed.solve_closed_form(motoman_l3, robot, tool_at(robot, frozen(q)), robot.poses["ready"])
        counts.add(len(answer.branches))
        missed = max(missed, *(max(branch.missed, branch.turned) for branch in answer.branches))
        lost = max(lost, min(float(np.abs(wrap(branch.q - q)).max()) for branch in answer.branches))
        progress(done / count)
    return missed, lost, counts


def actuator_motion(robot: Robot, actuators: Actuators) -> Motion:
    """The motion when actuator 2 alone moves back and forth from the posture ready."""
    times = np.linspace(0, 5, SAMPLES)
    pulses = np.tile(actuators.from_joints(robot.poses["ready"]), (SAMPLES, 1))
    pulses[:, 1] += 0.3 * abs(pulses[0, 1]) * np.sin(2 * np.pi * times / 5)
    return Motion(ROBOT, times, actuators.to_joints(pulses), title=ALONE)


def _allowed(actuators: Actuators, q: Array) -> bool:
    try:
        actuators.from_joints(q)
    except HelicoideError:
        return False
    return True


def _screws(actuators: Actuators, q: Array) -> list[Row]:
    lengths = zip(actuators.labels, actuators.lengths(q), strict=True)
    return [Row(SCREW.format(label=label), 1000 * length, "mm") for label, length in lengths if np.isfinite(length)]


def _lengths(actuators: Actuators, way: Motion) -> list[Chart]:
    lengths = 1000 * actuators.lengths(way.q)
    lines = [
        ChartLine(untranslated(label), way.times, lengths[:, i])
        for i, label in enumerate(actuators.labels)
        if np.isfinite(lengths[:, i]).all()
    ]
    angles = [
        ChartLine(untranslated(name), way.times, np.degrees(values))
        for name, values in (("θ₂", way.q[:, 1]), ("θ₃", way.q[:, 2]), ("θ₂ + θ₃", way.q[:, 1] + way.q[:, 2]))
    ]
    time = Text(en="time, s", pt_BR="tempo, s")
    return [Chart(SCREWS, time, untranslated("mm"), tuple(lines)), Chart(ALONE, time, untranslated("°"), tuple(angles))]


NEAREST = slide_statement("as near as possible", "o mais próximo possível", "s.36", 0, "≥", 1e-6)
TURNED = Text(
    en="how much farther the goal would be turned by the best of 3600 other directions in the plane",
    pt_BR="quanto mais o alvo giraria com a melhor de outras 3600 direções no plano",
)
ANGLE = Text(en="how far the goal is turned", pt_BR="quanto o alvo é girado")
LEAST = Text(en="least number of postures of random poses", pt_BR="menor número de posturas de poses aleatórias")
MOST = Text(en="largest number of postures of random poses", pt_BR="maior número de posturas de poses aleatórias")
MISSED = Text(en="worst miss of any posture", pt_BR="maior erro de qualquer postura")
LOST = Text(en="worst distance of the generating posture", pt_BR="maior distância da postura geradora")
HELD = Text(
    en="postures of the goal that the travel of the screws allows",
    pt_BR="posturas do alvo que o curso dos fusos permite",
)
SCREW = Text(en="length of the screw of {label}, first posture", pt_BR="comprimento do fuso de {label}, 1ª postura")
SCREWS = Text(en="Lengths of the ball screws", pt_BR="Comprimentos dos fusos de esferas")
ALONE = Text(en="Actuator 2 runs alone", pt_BR="Só o atuador 2 gira")
