"""What the lesson measures: the turn of the gripper, the null space, the objective; and the values of its pages."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.ik.limit_gains import GROWTH
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.library import load_robot
from helicoide.lesson import Value, fixed
from helicoide.readout import position_analysis, target_pose, world_jacobian
from helicoide.state import State

SHOULDER, ELBOW, WRIST = range(3)
TURNED, LITTLE = radians(25.0), radians(4.0)
SAME_POINT, MOVED_AWAY = 0.002, 0.010
JOINTS_OF_FIVE, ROWS_OF_POSITION = 5, 3
EXACT = 0.001
GOOD = 0.245
HEAVY = 20.0  # 1/s
LEVEL = radians(1.0)
FREE_OF_LIMIT = radians(2.0)
TARGET = 0.200, -0.200
AT_LIMIT = np.radians([-78.15, 137.90, -140.0])  # near the target, where joint 3 is at its limit
OVERGROWN, LOST = 100.0, 0.010


def ready_pose(state: State) -> Array:
    """The pose of the tool at `ready`, T_world_tool (4, 4), m."""
    return tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))


def turned(state: State) -> float:
    """How far the gripper has turned since `ready`, rad."""
    return float(state.arm.q.sum() - sum(state.robot.poses["ready"]))


def away(state: State) -> float:
    """How far the end effector is from its place at `ready`, m."""
    return float(np.linalg.norm(state.T_world_tool[:3, 3] - ready_pose(state)[:3, 3]))


def to_target(state: State) -> float:
    """The distance of the end effector from its target, m."""
    return float(np.linalg.norm(target_pose(state)[:3, 3] - state.T_world_tool[:3, 3]))


def has_target(state: State) -> bool:
    """Whether a target is asked for."""
    return isinstance(state.request.command, MoveToPose)


def null_velocities(state: State) -> Array:
    """Joint velocities that do not move the end effector: the cross product of both rows of J, (3,)."""
    x, y = world_jacobian(state)[:2]
    return np.cross(x, y)


def manipulability(state: State) -> float:
    """The product of both semi-axes of the velocity ellipse, with lengths divided by the reach."""
    return float(np.prod(position_analysis(state).sigma[:2] / state.problem.length))


def pulls() -> Array:
    """What each joint adds to the null-space motion at `AT_LIMIT`, (3,), rad/s; > 0: joint 3 leaves its limit.

    k₀ (−∂f/∂qᵢ) nᵢ, with f the distance to joint limits and n the unit vector of the null space with n₃ > 0.
    Source: Cerbaro 2022, eqs. 10 and 14.
    """
    robot = load_robot("orca")
    x, y = frame_jacobian(robot, AT_LIMIT)[:2]
    along = np.cross(x, y) / np.linalg.norm(np.cross(x, y))
    middle, span = (robot.upper + robot.lower) / 2, robot.upper - robot.lower
    return np.asarray(HEAVY * (middle - AT_LIMIT) / (len(span) * span**2) * along * np.sign(along[WRIST]))


def to_limit(state: State) -> float:
    """The distance of the joints from their limits: that of the nearest, rad."""
    limits = state.problem.limits
    return float(np.minimum(state.arm.q - limits.lower, limits.upper - state.arm.q).min())


def weights(state: State) -> Array:
    """The weight k₀ of each joint, (n,), 1/s; zeros without an objective."""
    second = state.request.controller.secondary
    if second is None:
        return np.zeros(len(state.arm.q))
    return np.full(len(state.arm.q), second.weight) if second.weights is None else np.asarray(second.weights)


VALUES = {
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "turned_by": Value(lambda state, _: turned(state), "°"),
    "away": Value(lambda state, _: away(state), "mm", 1),
    "turn": fixed(TURNED, "°"),
    "left_of_five": fixed(float(JOINTS_OF_FIVE - ROWS_OF_POSITION), "", 0),
    "row_x": Value(lambda state, _: world_jacobian(state)[0], "", 3),
    "row_y": Value(lambda state, _: world_jacobian(state)[1], "", 3),
    "null": Value(lambda state, _: null_velocities(state), "", 4),
    "manipulability": Value(lambda state, _: manipulability(state), "", 3),
    "good": fixed(GOOD, "", 3),
    "error": Value(lambda state, _: to_target(state), "mm", 1),
    "heavy": fixed(HEAVY, "1/s", 0),
    "weight": Value(lambda state, _: weights(state)[WRIST], "1/s", 1),
    "largest_weight": Value(lambda state, _: weights(state).max(), "1/s", 0),
    "growth": fixed(GROWTH - 1.0, "%"),
    "wrist": Value(lambda state, _: state.arm.q[WRIST], "°", 1),
    "wrist_limit": Value(lambda state, _: state.problem.limits.lower[WRIST], "°"),
    "free": fixed(FREE_OF_LIMIT, "°"),
    "pulls": fixed(pulls, "°/s"),
    "same": fixed(SAME_POINT, "mm"),
    "exact": fixed(EXACT, "mm"),
}
