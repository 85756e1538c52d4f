"""Arms with elbow and wrist, of six joints or of five with a turret, which the same forms take by other steps."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from helicoide.arrays import Array
from helicoide.ik.families.elbow_wrist import ElbowWrist, elbow_wrist
from helicoide.ik.families.listed import Steps, listed
from helicoide.ik.families.turret import Turret, turret
from helicoide.ik.postures.answer import Found
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

Six = Callable[[Robot, ElbowWrist, Array, Array], Iterator[Steps]]
Five = Callable[[Robot, Turret, Array, Array], Iterator[Steps]]
OR_FIVE = Text(
    en="This form is for arms as the PUMA (six turning joints: shoulder square to the waist that it crosses, elbow "
    "alongside it, a spherical wrist with right angles) or as the Movemaster (five: shoulder, elbow and bend alongside "
    "each other, a roll that carries the tool).",
    pt_BR="Esta forma vale para braços como o PUMA (seis juntas de revolução: ombro perpendicular à cintura, que ele "
    "cruza, cotovelo paralelo a ele, punho esférico com ângulos retos) ou como o Movemaster (cinco: ombro, cotovelo e "
    "flexão paralelos, e um rolamento que leva o efetuador).",
)


def refusal(robot: Robot) -> Text | None:
    """Why a robot is no such arm; None where it is."""
    return OR_FIVE if elbow_wrist(robot) is None and turret(robot) is None else None


def solved(robot: Robot, T_world_tool: Array, q: Array, by_six: Six, by_five: Five) -> Found:
    """Every posture for a tool pose (4, 4), m, by the steps for the kind of arm; q (n,), rad: kept where one is free.

    Raises HelicoideError for what is no pose and for another kind of arm.
    """
    if (six := elbow_wrist(robot)) is not None:
        return listed(robot, T_world_tool, q, lambda T, now: by_six(robot, six, T, now))
    if (five := turret(robot)) is not None:
        return listed(robot, T_world_tool, q, lambda T, now: by_five(robot, five, T, now))
    raise HelicoideError(OR_FIVE)
