"""The motion through the taught waypoints, computed before it is played."""

from __future__ import annotations

from functools import partial

import numpy as np

from helicoide.arrays import Array
from helicoide.gate.enclosure import say
from helicoide.gate.replaying import replay
from helicoide.ik.joints_along import joints_along
from helicoide.kinematics.robot import Robot
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.program import gripper_commands, program_legs, program_path
from helicoide.trajectory.waypoints import MOVE_TYPES

# 1/s: an arm whose file gives no acceleration reaches full speed in a quarter of a second.
GENTLE = 4.0
TITLE = Text(en="Running the waypoints", pt_BR="Executando os pontos")
NONE = Text(en="There are no waypoints yet.", pt_BR="Ainda não há pontos.")
BLOCKED = Text(
    en="The arm cannot reach waypoint {name} by {way}. Choose another move type or add a waypoint before it.",
    pt_BR="O braço não chega ao ponto {name} por {way}. Escolha outro tipo de movimento ou adicione um ponto antes "
    "dele.",
)


def replay_through(state: State) -> Update:
    """The update that follows the waypoints from the current posture, or says why that is not possible."""
    robot = state.robot
    if not state.taught.waypoints:
        return say(NONE)
    try:
        ways = list(
            program_legs(
                state.taught, state.arm.q, partial(joints_along, robot), state.taught.shape, acceleration(robot)
            )
        )
    except HelicoideError as refusal:
        return say(refusal.text)
    blocked = next((leg.waypoint for leg in ways if leg.blocked), None)
    if blocked is not None:
        return say(BLOCKED.format(name=blocked.name, way=MOVE_TYPES[blocked.move_type]))
    path = program_path(ways)
    return say(NONE) if path is None else replay(path, TITLE, tuple(gripper_commands(ways)))


def acceleration(robot: Robot) -> Array:
    """The acceleration limits of the joints, (n,), rad/s² or m/s²; gentle ones where the file gives none."""
    return np.where(np.isfinite(robot.acceleration), robot.acceleration, GENTLE * robot.speed)
