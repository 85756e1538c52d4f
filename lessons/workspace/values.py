"""The closed form of two links, what the state says, and the values of the pages."""

from __future__ import annotations

from functools import lru_cache
from math import acos, atan2, cos, hypot, pi, radians, sin, sqrt

import numpy as np

from helicoide.command import MoveToJoints, MoveToPose
from helicoide.ik.postures.branch import wrap
from helicoide.ik.postures.solve import solve
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.library import load_robot
from helicoide.lesson import Value, fixed
from helicoide.state import State

SHOULDER, ELBOW = 0, 1
L1, L2 = 1.0, 0.7  # m, of the robot's file
INNER, OUTER = L1 - L2, L1 + L2
SLOW = 0.01  # rad/s; at an edge an arm creeps for seconds
AT_EDGE, AT_POINT, AT_TARGET = 0.005, 0.020, 0.003  # m
AS_GOOD, AS_ASKED, MOVED, NEARLY, STRETCHED, FOLDED = map(radians, (0.1, 4.0, 10.0, 15.0, 0.5, 175.0))
NEAR = 0.900
BENT = radians(10.0)
POINT = 0.700, 0.900


def elbow_cosine(r: float) -> float:
    """c₂ = (r² − l₁² − l₂²) / 2l₁l₂ for a distance r, m. Source: Campos 1998, s.44."""
    return (r**2 - L1**2 - L2**2) / (2 * L1 * L2)


def distance_at(theta2: float) -> float:
    """The distance of the tool from the first axis, m, for an elbow angle, rad."""
    return sqrt(L1**2 + L2**2 + 2 * L1 * L2 * cos(theta2))


def shoulder_angle(x: float, y: float, theta2: float) -> float:
    """θ₁ = Atan2(y, x) − Atan2(l₂s₂, l₁ + l₂c₂), rad. Source: Campos 1998, s.46–48."""
    return atan2(y, x) - atan2(L2 * sin(theta2), L1 + L2 * cos(theta2))


NEAR_ELBOW = acos(elbow_cosine(NEAR))
POINT_ELBOW = acos(elbow_cosine(hypot(*POINT)))
ELBOW_DOWN = shoulder_angle(*POINT, POINT_ELBOW), POINT_ELBOW
ELBOW_UP = shoulder_angle(*POINT, -POINT_ELBOW), -POINT_ELBOW


def rests(state: State) -> bool:
    """Whether the arm is as good as at rest after a request of the reader."""
    is_slow = bool(np.abs(state.arm.velocities).max() < SLOW)
    return is_slow and isinstance(state.request.command, MoveToJoints | MoveToPose)


def distance(state: State) -> float:
    """The distance of the tool from the first axis, m."""
    return float(np.hypot(*state.T_world_tool[:2, 3]))


def target_distance(state: State) -> float:
    """The distance of the target from the first axis, m; without a target that of the tool."""
    command = state.request.command
    return float(np.hypot(*command.T_world_target[:2, 3])) if isinstance(command, MoveToPose) else distance(state)


def missing(state: State) -> float:
    """The distance of the tool from its target, m; 0 without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return 0.0
    return float(np.linalg.norm(command.T_world_target[:3, 3] - state.T_world_tool[:3, 3]))


def ready_place(state: State) -> tuple[float, float]:
    """Where the tool is at `ready`, m."""
    x, y, _ = tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))[:3, 3]
    return float(x), float(y)


def shown_place(state: State) -> tuple[float, float]:
    """Where the tool is, m. An arm at rest is near enough to what was asked, and near `ready` it counts as there.

    So the pages name one place for one posture, also in a step that begins with an arm that came from another side.
    """
    off = wrap(state.arm.q - np.array(state.robot.poses["ready"]))
    x, y = ready_place(state) if np.abs(off).max() < AS_GOOD else state.T_world_tool[:2, 3]
    return float(x), float(y)


def is_at(state: State, place: tuple[float, float]) -> bool:
    """Whether the tool rests at a place, m."""
    return rests(state) and bool(np.linalg.norm(state.T_world_tool[:2, 3] - place) <= AT_POINT)


def has_joints(state: State, shoulder: float, elbow: float) -> bool:
    """Whether the arm rests with these joint values, rad."""
    return rests(state) and bool(np.abs(wrap(state.arm.q - [shoulder, elbow])).max() <= AS_ASKED)


def turned(state: State, joint: int) -> float:
    """How far a joint is from where it is in `ready`, rad."""
    return abs(float(state.arm.q[joint] - state.robot.poses["ready"][joint]))


@lru_cache(maxsize=8)
def postures_of(name: str) -> int:
    """How many postures the closed form finds for the pose of an arm at `ready`."""
    robot = load_robot(name)
    q = np.array(robot.poses["ready"])
    return len(solve(robot, tool_by_screws(robot, q), q, every=True).branches)


VALUES = {
    "long": fixed(L1, "mm"),
    "short": fixed(L2, "mm"),
    "long_m": fixed(L1, decimals=1),
    "short_m": fixed(L2, decimals=1),
    "inner": fixed(INNER, "mm"),
    "outer": fixed(OUTER, "mm"),
    "distance": Value(lambda state, _: hypot(*shown_place(state)), "mm"),
    "missing": Value(lambda state, _: missing(state), "mm"),
    "place_x": Value(lambda state, _: ready_place(state)[0], "mm"),
    "place_y": Value(lambda state, _: ready_place(state)[1], "mm"),
    "tool_x": Value(lambda state, _: shown_place(state)[0], "mm"),
    "tool_y": Value(lambda state, _: shown_place(state)[1], "mm"),
    "at_point": fixed(AT_POINT, "mm"),
    "at_edge": fixed(AT_EDGE, "mm"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "ready": Value(lambda state, _: np.array(state.robot.poses["ready"]), "°"),
    "shoulder": Value(lambda state, _: state.arm.q[SHOULDER], "°"),
    "elbow": Value(lambda state, _: state.arm.q[ELBOW], "°"),
    "elbow_cosine": Value(lambda state, _: elbow_cosine(distance(state)), decimals=2),
    "near": fixed(NEAR, "mm"),
    "near_cosine": fixed(elbow_cosine(NEAR), decimals=2),
    "near_elbow": fixed(NEAR_ELBOW, "°"),
    "near_inside": fixed(pi - NEAR_ELBOW, "°"),
    "point_x": fixed(POINT[0], "mm"),
    "point_y": fixed(POINT[1], "mm"),
    "point_cosine": fixed(elbow_cosine(hypot(*POINT)), decimals=3),
    "point_elbow": fixed(POINT_ELBOW, "°", 1),
    "other_elbow": fixed(-POINT_ELBOW, "°", 1),
    "down": fixed(np.array(ELBOW_DOWN), "°"),
    "up": fixed(np.array(ELBOW_UP), "°"),
    "bent": fixed(BENT, "°"),
    "lost": fixed(OUTER - distance_at(BENT), "mm", 1),
    "right_angle": fixed(pi / 2, "°"),
    "lost_bent": fixed(distance_at(pi / 2) - distance_at(pi / 2 + BENT), "mm"),
    "to_edge": Value(lambda state, _: OUTER - hypot(*shown_place(state)), "mm", 1),
    "just_to_edge": Value(lambda state, _: OUTER - distance(state), "mm", 2),
    "elbow_precisely": Value(lambda state, _: state.arm.q[ELBOW], "°", 1),
    "scara": fixed(lambda: postures_of("scara"), decimals=0),
    "polar": fixed(lambda: postures_of("polar_rp"), decimals=0),
    "puma": fixed(lambda: postures_of("puma560"), decimals=0),
    "motoman": fixed(lambda: postures_of("motoman_l3"), decimals=0),
}
