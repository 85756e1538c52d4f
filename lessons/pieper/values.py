"""Wrist centre and tip of the tool, the postures of a target, and the values of the pages."""

from __future__ import annotations

from functools import lru_cache
from math import asin, cos, hypot, pi, radians

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.branch import wrap
from helicoide.ik.postures.solve import solve
from helicoide.kinematics.forward import tool_by_screws
from helicoide.kinematics.robot import Robot
from helicoide.lesson import Value, fixed
from helicoide.state import State

WAIST, SHOULDER, ELBOW, ROLL, BEND, FLANGE = range(6)
TOOL_LENGTH = 0.170  # m, from the wrist centre to the tip of the drawn tool
TIP_AT = np.array([0.550, 0.100, 0.150])  # m
FIRST = np.radians([-60.0, 60.0, 0.0])  # roll, bend and flange of a hand, rad
FLIPPED = np.radians([120.0, -60.0, 180.0])
LEAST_TURN = radians(20.0)
AT_PLACE = 0.010  # m
MOST_AT_READY, ENOUGH = 3, 5
ASIDE = 0.020  # m, of axis 6 in the question about Pieper's condition
ON_LIMIT = 1e-6  # rad


def ready(state: State) -> Array:
    """The joint values of `ready`, (6,), rad."""
    return np.array(state.robot.poses["ready"])


def ready_pose(state: State) -> Array:
    """The pose of the end effector at `ready`, (4, 4), m."""
    return tool_by_screws(state.robot, ready(state))


def hand_pose(state: State) -> Array:
    """The pose with the arm as at `ready` and the hand of the step about the wrist, (4, 4), m."""
    return tool_by_screws(state.robot, np.array([*ready(state)[:ROLL], *FIRST]))


def tip(state: State) -> Array:
    """The tip of the tool, (3,), m."""
    T = state.T_world_tool
    return np.asarray(T[:3, 3] + TOOL_LENGTH * T[:3, 2])


def wrist_for_tip(state: State) -> Array:
    """Where the wrist centre must be for the tip at `TIP_AT` and a hand as at `ready`, (3,), m."""
    return np.asarray(TIP_AT - TOOL_LENGTH * ready_pose(state)[:3, 2])


def offset(state: State) -> float:
    """d₃: how far the plane of the arm is from the axis of the waist, m."""
    return float(state.robot.points[SHOULDER, 1])


def to_other_shoulder(state: State) -> float:
    """How far joint 1 turns between the two shoulders for the wrist centre of `ready`, rad.

    The difference of θ₁ = Atan2(p_y, p_x) − Atan2(d₃, ±√(p_x² + p_y² − d₃²)). Source: Campos 1998, s.55, after Craig.
    """
    x, y, _ = ready_pose(state)[:3, 3]
    return pi - 2 * asin(offset(state) / hypot(float(x), float(y)))


@lru_cache(maxsize=32)
def _postures(robot: Robot, values: tuple[float, ...]) -> Array:
    """All postures with the end effector where it is at six joint values, rad, (k, 6)."""
    q = np.array(values)
    return solve(robot, tool_by_screws(robot, q), q, every=True).q


def outside(state: State) -> Array:
    """Which joints of which postures of the present pose are outside their limits, (k, 6)."""
    q = _postures(state.robot, tuple(state.arm.q.tolist()))
    return np.asarray((q < state.robot.lower - ON_LIMIT) | (q > state.robot.upper + ON_LIMIT))


def count_within(state: State) -> int:
    """How many postures of the present pose are within the joint limits."""
    return int((~outside(state).any(axis=1)).sum())


def below(state: State) -> Array:
    """The posture of the pose of `ready` with the same shoulder and a bend > 0 whose elbow is down, (6,), rad."""
    q = _postures(state.robot, tuple(ready(state).tolist()))
    change = np.abs(wrap(q - ready(state)))
    return np.asarray(q[(change[:, WAIST] < ON_LIMIT) & (change[:, ELBOW] > ON_LIMIT) & (q[:, BEND] > 0)][0])


def rise(q: Array) -> float:
    """How steeply the forearm, along the axis of joint 4, rises from the elbow to the wrist, rad."""
    return asin(-cos(q[SHOULDER] + q[ELBOW]))


def count_at_ready(state: State) -> int:
    """How many postures the pose of `ready` has, whatever the limits."""
    return len(_postures(state.robot, tuple(ready(state).tolist())))


VALUES = {
    "least_turn": fixed(LEAST_TURN, "°"),
    "wrist": Value(lambda state, _: state.T_world_tool[:3, 3], "mm"),
    "last_joints": Value(lambda state, _: state.arm.q[ROLL:], "°"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "tool_length": fixed(TOOL_LENGTH, "mm"),
    "tip_at": fixed(TIP_AT, "mm"),
    "at_place": fixed(AT_PLACE, "mm"),
    "tip": Value(lambda state, _: tip(state), "mm"),
    "pointing": Value(lambda state, _: ready_pose(state)[:3, 2], decimals=2),
    "wrist_for_tip": Value(lambda state, _: wrist_for_tip(state), "mm"),
    "offset": Value(lambda state, _: offset(state), "mm"),
    "waist": Value(lambda state, _: state.arm.q[WAIST], "°"),
    "other_shoulder": Value(lambda state, _: to_other_shoulder(state), "°"),
    "longer_way": Value(lambda state, _: 2 * pi - to_other_shoulder(state), "°"),
    "ready_wrist": Value(lambda state, _: ready_pose(state)[:3, 3], "mm"),
    "first_hand": fixed(FIRST, "°"),
    "flipped": fixed(FLIPPED, "°"),
    "first_bend": fixed(float(FIRST[1]), "°"),
    "flipped_bend": fixed(-float(FIRST[1]), "°"),
    "roll_lower": Value(lambda state, _: state.robot.lower[ROLL], "°"),
    "roll_upper": Value(lambda state, _: state.robot.upper[ROLL], "°"),
    "all_postures": Value(lambda state, _: count_at_ready(state), decimals=0),
    "within": Value(lambda state, _: count_within(state), decimals=0),
    "ruled_out": Value(lambda state, _: outside(state).sum(axis=0).astype(float), decimals=0),
    "enough": fixed(ENOUGH, decimals=0),
    "ready_bend": Value(lambda state, _: ready(state)[BEND], "°"),
    "bend_lower": Value(lambda state, _: state.robot.lower[BEND], "°"),
    "bend_upper": Value(lambda state, _: state.robot.upper[BEND], "°"),
    "elbow_lower": Value(lambda state, _: state.robot.lower[ELBOW], "°"),
    "elbow_upper": Value(lambda state, _: state.robot.upper[ELBOW], "°"),
    "elbow_down": Value(lambda state, _: below(state)[ELBOW], "°"),
    "forearm_rise": Value(lambda state, _: rise(below(state)), "°"),
    "hand_drop": Value(lambda state, _: -asin(ready_pose(state)[2, 2]), "°"),
    "bend_needed": Value(lambda state, _: below(state)[BEND], "°"),
    "aside": fixed(ASIDE, "mm"),
}
