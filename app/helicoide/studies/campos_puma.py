"""The eight postures of the PUMA for one pose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import closed
from helicoide.ik.closed import puma560
from helicoide.ik.families import puma_arm
from helicoide.ik.families.frames import pose_rows
from helicoide.ik.postures import numeric, solvability
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_rows import (
    POSES,
    PUMA_LENGTHS,
    campos_result,
    posture_chart,
    posture_motion,
    slide_statement,
)
from helicoide.studies.study import Progress, Result, Row, printed_statement
from helicoide.text import Text

TITLE = Text(en="Eight postures of the PUMA", pt_BR="Oito posturas do PUMA")
SOURCE = "Campos 1998, s.19–26, s.55 (Craig)"
ABOUT = Text(
    en="Shoulder left or right, elbow up or down, wrist flipped or not: eight postures bring the end effector to the "
    "same pose. The flip of the wrist, θ₄ + 180°, −θ₅, θ₆ + 180°, leaves the end effector exactly where it is. "
    "Searches that know nothing of the closed form find no ninth.",
    pt_BR="Ombro à esquerda ou à direita, cotovelo para cima ou para baixo, punho virado ou não: oito posturas levam o "
    "efetuador à mesma pose. Virar o punho, θ₄ + 180°, −θ₅, θ₆ + 180°, deixa o efetuador exatamente onde está. Buscas "
    "que nada sabem da forma fechada não encontram uma nona.",
)
ROBOT = "puma560"

# The pose of these joint values, rad, is the one that is shown.
EXAMPLE = frozen([0.3, -0.5, 0.7, 0.4, 0.9, -1.1])
FEW, SEARCHED = 1_000, 10
CHOSEN = (PUMA_LENGTHS,)


@dataclass(frozen=True)
class Options:
    """How many random poses are solved."""

    poses: Annotated[float, POSES] = 20_000


def puma_round_trip(
    arm: Robot, count: int, seed: int, progress: Progress = lambda share: None
) -> tuple[float, float, int, int]:
    """The worst miss of any posture (m, and 1 for rotations), the worst distance of the generating one, rad.

    Then the least and the largest number of postures.
    """
    lengths, missed, apart, counts = puma_arm.lengths_of(arm), 0.0, 0.0, list[int]()
    rows = np.empty((8, 7))
    for done, q in enumerate(np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, 6))):
        T = tool_at(arm, q)
        counts.append(puma_arm.puma_wrist_postures(lengths, pose_rows(T), (0.0, 0.0, 0.0), rows))
        found = rows[: counts[-1], :6]
        missed = max(missed, *(float(np.abs(tool_at(arm, row) - T).max()) for row in found))
        apart = max(apart, float(np.abs(wrap(found - q)).max(axis=1).min()))
        if done % 100 == 99:
            progress((done + 1) / count)
    return missed, apart, min(counts), max(counts)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """One pose, the flip, searches, and random poses; short: 1,000 of them."""
    arm = load_robot(ROBOT)
    branches = closed.solve_closed_form(puma560, arm, tool_at(arm, EXAMPLE), np.zeros(6)).branches
    missed, apart, least, most = puma_round_trip(arm, FEW if short else int(options.poses), 560, progress)
    meeting = solvability.meeting_axes(arm)
    rows = [
        Row(SHOULDERS, _distinct([branch.q[:3] for branch in branches]), "", printed_statement("4", "s.19"), CHOSEN),
        Row(LEAST, least, "", printed_statement("8", "s.20"), CHOSEN),
        Row(MOST, most, "", printed_statement("8", "s.20"), CHOSEN),
        Row(FLIP, _moved_by_flip(arm), "", FLIPPED),
        Row(UNKNOWN, _unknown_to_the_form(arm), "", ALL, CHOSEN),
        Row(MEETING, 0 if meeting is None else meeting[0][0] + 1, "", AXES),
        Row(MISSED, missed),
        Row(APART, apart, "rad"),
    ]
    progress(1.0)
    charts = [posture_chart(CHART, [(branch.name, branch.q) for branch in branches])]
    return campos_result(rows, charts, [posture_motion(ROBOT, [branch.q for branch in branches], title=CHART)])


def _distinct(arms: list[Array]) -> int:
    """The number of distinct rows of angles (k, 3), rad."""
    kept: list[Array] = []
    for arm in arms:
        if all(np.abs(wrap(arm - other)).max() > 1e-6 for other in kept):
            kept.append(arm)
    return len(kept)


def _moved_by_flip(arm: Robot) -> float:
    """How far the tool moves where the wrist is flipped, entry by entry of its pose: the worst of random postures."""
    moved = 0.0
    for q in np.random.default_rng(20).uniform(-np.pi, np.pi, (100, 6)):
        flipped = q * [1, 1, 1, 1, -1, 1] + [0, 0, 0, np.pi, 0, np.pi]
        moved = max(moved, float(np.abs(tool_at(arm, flipped) - tool_at(arm, q)).max()))
    return moved


def _unknown_to_the_form(arm: Robot) -> int:
    """The number of postures that only the closed form or only the searches find, for some poses."""
    unknown = 0
    for q in np.random.default_rng(23).uniform(-2.5, 2.5, (SEARCHED, 6)):
        T = tool_at(arm, q)
        formed = np.array([branch.q for branch in closed.solve_closed_form(puma560, arm, T, np.zeros(6)).branches])
        searched, _ = numeric.distinct_postures(arm, np.ascontiguousarray(T), np.zeros(6), True, 64)
        apart = np.abs(wrap(formed[:, None] - searched)).max(axis=2)
        unknown += int((apart.min(axis=0) > 1e-5).sum() + (apart.min(axis=1) > 1e-5).sum())
    return unknown


FLIPPED = slide_statement(
    "θ₄' = θ₄ + 180°, θ₅' = −θ₅, θ₆' = θ₆ + 180°", "θ₄' = θ₄ + 180°, θ₅' = −θ₅, θ₆' = θ₆ + 180°", "s.20", 0, "=", 1e-9
)
ALL = slide_statement(
    "solvable: an algorithm finds all sets of joint values",
    "solúvel: um algoritmo encontra todos os conjuntos de variáveis de junta",
    "s.23",
    0,
)
AXES = slide_statement("axes 4, 5 and 6 meet at a point", "os eixos 4, 5 e 6 se cruzam num ponto", "s.26", 4)
SHOULDERS = Text(en="postures of the arm, without the wrist", pt_BR="posturas do braço, sem o punho")
FLIP = Text(en="how far a flip of the wrist moves the end effector", pt_BR="quanto virar o punho move o efetuador")
LEAST = Text(en="least number of postures of random poses", pt_BR="menor número de posturas de poses aleatórias")
MOST = Text(en="largest number of postures of random poses", pt_BR="maior número de posturas de poses aleatórias")
UNKNOWN = Text(
    en="postures of ten poses that only one of closed form and searches finds",
    pt_BR="posturas de dez poses que só a forma fechada, ou só as buscas, encontram",
)
MEETING = Text(en="first of three adjacent axes that meet", pt_BR="primeiro de três eixos vizinhos que se cruzam")
MISSED = Text(en="worst miss of any posture", pt_BR="maior erro de qualquer postura")
APART = Text(en="worst distance of the generating posture", pt_BR="maior distância da postura geradora")
CHART = Text(en="The eight postures", pt_BR="As oito posturas")
