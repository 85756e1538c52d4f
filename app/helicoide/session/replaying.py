"""The way through taught waypoints, worked out before it is gone."""

from __future__ import annotations

from functools import partial

import numpy as np

from helicoide import gate
from helicoide.ik.joints_along import joints_along
from helicoide.kinematics.chain import Array
from helicoide.state import Update
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.program import legs, whole
from helicoide.trajectory.waypoints import WAYS, Taught

# Of an arm whose file gives no acceleration: full speed in a quarter of a second.
GENTLE = 4.0
TITLE = Text(en="Going through the waypoints", pt_BR="Percorrendo os pontos ensinados")
NONE = Text(en="There are no waypoints to go through yet.", pt_BR="Ainda não há pontos a percorrer.")
BLOCKED = Text(
    en="The arm cannot come to waypoint {name} by: {way}. Choose another way, or a point between.",
    pt_BR="O braço não chega ao ponto {name} por: {way}. Escolha outra maneira, ou um ponto intermediário.",
)


def through(taught: Taught, q: Array) -> Update:
    """The wish to go through the waypoints from a posture q (n,), or to say why that is not possible."""
    robot = taught.robot
    if not taught.waypoints:
        return gate.say(NONE)
    acceleration = np.where(np.isfinite(robot.acceleration), robot.acceleration, GENTLE * robot.speed)
    try:
        ways = list(legs(taught, q, partial(joints_along, robot), "trapezoid", acceleration))
    except HelicoideError as refusal:
        return gate.say(refusal.text)
    blocked = next((leg.waypoint for leg in ways if leg.blocked), None)
    if blocked is not None:
        return gate.say(BLOCKED.format(name=blocked.name, way=WAYS[blocked.way]))
    path = whole(ways)
    return gate.say(NONE) if path is None else gate.replay(path, TITLE)
