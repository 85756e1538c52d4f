"""Arms with elbow and wrist, with six joints or with five on a turret: the same closed forms by different steps."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from helicoide.arrays import Array
from helicoide.ik.families.elbow_wrist import ElbowWrist, elbow_wrist
from helicoide.ik.families.listed import Steps, distinct_branches
from helicoide.ik.families.turret import Turret, turret
from helicoide.ik.postures.answer import Found
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

Six = Callable[[Robot, ElbowWrist, Array, Array], Iterator[Steps]]
Five = Callable[[Robot, Turret, Array, Array], Iterator[Steps]]
OR_FIVE = Text(
    en="This form needs an arm like the PUMA (six revolute joints: the shoulder axis crosses the waist axis at a "
    "right angle, the elbow axis is parallel to it, a spherical wrist with axes at right angles) or like the "
    "Movemaster (five: shoulder, elbow and wrist pitch parallel, a wrist roll that carries the end effector).",
    pt_BR="Esta forma exige um braço como o PUMA (seis juntas de revolução: o eixo do ombro cruza o da cintura em "
    "ângulo reto, o do cotovelo é paralelo a ele, punho esférico com eixos em ângulo reto) ou como o Movemaster "
    "(cinco: ombro, cotovelo e arfagem do punho paralelos, e uma rolagem que leva o efetuador).",
)


def neither_kind(robot: Robot) -> Text | None:
    """Why a robot is neither kind of arm; None if it is one."""
    return OR_FIVE if elbow_wrist(robot) is None and turret(robot) is None else None


def postures_by_kind(robot: Robot, T_world_tool: Array, q: Array, by_six: Six, by_five: Five) -> Found:
    """Every posture for a tool pose (4, 4), m, by the steps for the kind of arm; q (n,), rad: kept where one is free.

    Raises HelicoideError for an invalid pose and for another kind of arm.
    """
    if (six := elbow_wrist(robot)) is not None:
        return distinct_branches(robot, T_world_tool, q, lambda T, now: by_six(robot, six, T, now))
    if (five := turret(robot)) is not None:
        return distinct_branches(robot, T_world_tool, q, lambda T, now: by_five(robot, five, T, now))
    raise HelicoideError(OR_FIVE)
