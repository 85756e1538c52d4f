"""The values of the pages, and what they are read from."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from math import asin, pi, radians

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import motor, rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.kinematics.forward import joint_motor, tool_by_screws, tool_motor
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Value, fixed
from helicoide.seat import Seat
from helicoide.state import State

WAIST, SHOULDER, ROLL = 0, 1, 4
WANTED = 0.5
WITHIN, AT_REST = radians(2.0), radians(3.0)
LEAST_WAIST, NO_SLIDE, MUCH_SLIDE = radians(20.0), 0.005, 0.060
SIDE = radians(60.0)
BELOW, FAR_ROLL, LITTLE_WAIST = -0.05, radians(150.0), radians(20.0)
APART, NEAR, NEAR_TURN, MARKED = radians(60.0), 0.015, radians(4.0), 0.040
SAME_PLACE, SAME_TURN = 0.020, radians(4.0)


def coefficient(M: Array, blade: str) -> float:
    """The coefficient of a blade of `CL031`."""
    place, sign = CL031.parse_blade(blade)
    return float(sign * M[place])


def waist_motor(state: State) -> Array:
    """The motor of the waist, (16,)."""
    return joint_motor(state.robot.joints[WAIST], float(state.arm.q[WAIST]))


def link_motor(state: State) -> Array:
    """The motor of the frame of the first link, (16,)."""
    return rigid.motor_from_pose(state.arm.poses[WAIST + 1])


def shoulder_line(state: State) -> Array:
    """The axis of the shoulder while the arm is at zero, (16,)."""
    return rigid.line(state.robot.directions[SHOULDER], state.robot.points[SHOULDER])


def shown_motor(state: State) -> Array:
    """The motor of the tool as the program shows it, with a positive scalar, (16,)."""
    return rigid.motor_from_pose(state.T_world_tool)


def product_motor(state: State) -> Array:
    """The product of the joints' motors and the zero pose, with the sign as it comes, (16,)."""
    return tool_motor(state.robot, state.arm.q)


def ends(robot: Robot) -> tuple[Array, Array]:
    """The two poses between which the tool moves, T_world_tool (4, 4), m: `ready`, and with the waist turned."""
    q = np.array(robot.poses["ready"])
    turned = q.copy()
    turned[WAIST] += APART
    return tool_by_screws(robot, q), tool_by_screws(robot, turned)


def halfway(robot: Robot) -> Array:
    """The pose halfway on the screw motion between the two, (4, 4), m."""
    first, last = map(rigid.motor_from_pose, ends(robot))
    return rigid.pose_from_motor(motor.sclerp(first, last, 0.5))


def straight_halfway(robot: Robot) -> Array:
    """The point halfway on the straight line between the two, (3,), m."""
    first, last = ends(robot)
    return np.asarray((first[:3, 3] + last[:3, 3]) / 2)


def multivector(read: Callable[[State], Array]) -> Callable[[State, Seat], Multivector]:
    """A value that is a multivector of the state, without what would be written as 0.000."""

    def rounded(state: State, seat: Seat) -> Multivector:
        return Multivector(np.round(read(state), 3), CL031)

    return rounded


def example_tip(state: State, reverse: bool) -> Array:
    """The place of the tool at the angles of the example, with the factors in order or reversed, (3,), m."""
    robot = state.robot
    factors = [joint_motor(joint, value) for joint, value in zip(robot.joints, robot.poses["example"], strict=True)]
    product = reduce(CL031.product, factors[::-1] if reverse else factors)
    zero = tool_by_screws(robot, np.zeros(len(factors)))[:3, 3]
    return rigid.coordinates(rigid.move(product, rigid.point(zero)))


def height(state: State, seat: Seat) -> float:
    """The height of the frame of the first link, m."""
    return float(state.robot.points[WAIST, 2])


VALUES = {
    "waist_motor": Value(multivector(waist_motor)),
    "waist": Value(lambda state, _: state.arm.q[WAIST], "°"),
    "roll": Value(lambda state, _: state.arm.q[ROLL], "°"),
    "wanted": fixed(WANTED, "", 1),
    "found_angle": fixed(2 * asin(WANTED), "°"),
    "full_angle": fixed(asin(WANTED), "°"),
    "within": fixed(WITHIN, "°"),
    "height": Value(height, "mm"),
    "lift": Value(lambda state, seat: height(state, seat) / 2, "", 1),
    "shoulder_place": Value(lambda state, _: state.robot.points[SHOULDER]),
    "shoulder_line": Value(multivector(shoulder_line)),
    "link_motor": Value(multivector(link_motor)),
    "least_waist": fixed(LEAST_WAIST, "°"),
    "no_slide": fixed(NO_SLIDE, "", 3),
    "volume": Value(lambda state, _: coefficient(shown_motor(state), "e1e2e3e"), "", 3),
    "tool_motor": Value(multivector(shown_motor)),
    "product": Value(multivector(product_motor)),
    "first_number": Value(lambda state, _: coefficient(product_motor(state), "1"), "", 3),
    "side": fixed(SIDE, "°"),
    "below": fixed(BELOW, "", 2),
    "example": Value(lambda state, _: state.robot.poses["example"], "°"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "tip": Value(lambda state, _: example_tip(state, False), "mm"),
    "reversed_tip": Value(lambda state, _: example_tip(state, True), "mm"),
    "same_place": fixed(SAME_PLACE, "mm"),
    "same_turn": fixed(SAME_TURN, "°"),
    "first_tip": Value(lambda state, _: ends(state.robot)[0][:3, 3], "mm"),
    "marked": fixed(MARKED, "mm"),
    "near": fixed(NEAR, "mm"),
    "near_turn": fixed(NEAR_TURN, "°"),
    "apart": fixed(APART, "°"),
    "half_way": fixed(APART / 2, "°"),
    "long_way": fixed(2 * pi - APART, "°"),
    "long_half": fixed(APART / 2 - pi, "°"),
    "cut": Value(
        lambda state, _: float(np.linalg.norm(halfway(state.robot)[:3, 3] - straight_halfway(state.robot))), "mm"
    ),
    "zero_tip": Value(lambda state, _: tool_by_screws(state.robot, np.zeros(len(state.arm.q)))[:3, 3], "mm"),
}
