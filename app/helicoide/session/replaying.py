"""The way through taught waypoints, or along a path in the least time, worked out before it is gone."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from helicoide import gate
from helicoide.ik.joints_along import brought, joints_along
from helicoide.kinematics.chain import Array
from helicoide.kinematics.robot import Robot
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.fastest import fastest
from helicoide.trajectory.program import legs, whole
from helicoide.trajectory.spline import Spline
from helicoide.trajectory.waypoints import WAYS

# Of an arm whose file gives no acceleration: full speed in a quarter of a second.
GENTLE = 4.0
TITLE = Text(en="Going through the waypoints", pt_BR="Percorrendo os pontos ensinados")
NONE = Text(en="There are no waypoints to go through yet.", pt_BR="Ainda não há pontos a percorrer.")
BLOCKED = Text(
    en="The arm cannot come to waypoint {name} by: {way}. Choose another way, or a point between.",
    pt_BR="O braço não chega ao ponto {name} por: {way}. Escolha outra maneira, ou um ponto intermediário.",
)


FASTEST = Text(en="Along the path in the least time", pt_BR="Na trajetória no menor tempo")
NO_WAY = Text(
    en="The arm cannot follow this path from end to end within its limits. Play follows it as far as it goes.",
    pt_BR="O braço não consegue seguir esta trajetória de ponta a ponta dentro dos limites. Iniciar vai até onde dá.",
)


def through(state: State) -> Update:
    """The wish to go through the waypoints from where the arm is, or to say why that is not possible."""
    robot = state.robot
    if not state.waypoints:
        return gate.say(NONE)
    try:
        ways = list(legs(state.taught, state.q, partial(joints_along, robot), state.leg_shape, _acceleration(robot)))
    except HelicoideError as refusal:
        return gate.say(refusal.text)
    blocked = next((leg.waypoint for leg in ways if leg.blocked), None)
    if blocked is not None:
        return gate.say(BLOCKED.format(name=blocked.name, way=WAYS[blocked.way]))
    path = whole(ways)
    return gate.say(NONE) if path is None else gate.replay(path, TITLE)


def along_fastest(state: State) -> Update:
    """The wish to follow the path of the course in the least time, or to say why that is not possible."""
    robot, path = state.robot, gate.path_of(state.robot, replace(state.course, shape="constant speed"))
    start = brought(robot, state.q, path.pose(0.0))
    rows = None if start is None else joints_along(robot, path, start)
    if rows is None:
        return gate.say(NO_WAY)
    along = Spline(np.linspace(0.0, path.duration, len(rows)), rows)
    try:
        return gate.replay(fastest(along, state.course.shape, robot.speed, _acceleration(robot)), FASTEST)
    except HelicoideError as refusal:
        return gate.say(refusal.text)


def _acceleration(robot: Robot) -> Array:
    return np.where(np.isfinite(robot.acceleration), robot.acceleration, GENTLE * robot.speed)
