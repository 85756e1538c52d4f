"""The closed form of three links, what the state says, and the values of the pages."""

from __future__ import annotations

from math import acos, atan2, cos, hypot, pi, radians, sin

import numpy as np

from helicoide.arrays import Array
from helicoide.command import MoveToJoints, MoveToPose
from helicoide.ik.postures.branch import wrap
from helicoide.kinematics.forward import tool_by_screws
from helicoide.lesson import Value, fixed
from helicoide.state import State

SHOULDER, ELBOW, WRIST = 0, 1, 2
L1, L2, L3 = 2.0, 1.0, 1.0  # m, of the robot's file
PLACE, DIRECTION = (1.5, 1.5), 0.0  # of the hand in the step about the wrist, m and rad
FAR_WRIST, FAR_DIRECTION = (-1.2, 1.6), radians(-90.0)
CHOICE, CHOICE_DIRECTION = (0.6, -2.9), radians(-60.0)
WEIGHTS = 3.0, 1.0, 1.0
LEAST_TURN = radians(30.0)
AT_PLACE = 0.030  # m
LIFT = 0.400
POLAR = 0.300, 0.400


def wrapped(angle: float) -> float:
    """The same angle in (−π, π], rad."""
    return float(wrap(angle))


def wrist_of(x: float, y: float, phi: float) -> tuple[float, float]:
    """Where the third axis is for a place, m, and a direction of the hand, rad."""
    return x - L3 * cos(phi), y - L3 * sin(phi)


def posture(x: float, y: float, phi: float, sign: int) -> Array:
    """θ₁, θ₂, θ₃, rad, for the third axis at (x, y), m, and a hand at φ, rad; sign: of θ₂.

    c₂ = (r² − l₁² − l₂²) / 2l₁l₂, θ₁ = β ∓ ψ, θ₃ = φ − θ₁ − θ₂. Source: Campos 1998, s.44–54.
    """
    r = hypot(x, y)
    theta2 = sign * acos((r**2 - L1**2 - L2**2) / (2 * L1 * L2))
    theta1 = wrapped(atan2(y, x) - sign * angle_at_shoulder(r))
    return np.array([theta1, theta2, wrapped(phi - theta1 - theta2)])


def angle_at_shoulder(r: float) -> float:
    """ψ, rad, from the line to the third axis to the first link. Source: Campos 1998, s.54."""
    return acos((r**2 + L1**2 - L2**2) / (2 * L1 * r))


FAR = hypot(*FAR_WRIST)
BETA, PSI = atan2(FAR_WRIST[1], FAR_WRIST[0]), angle_at_shoulder(FAR)
FAR_UP, FAR_DOWN = (posture(*FAR_WRIST, FAR_DIRECTION, sign) for sign in (-1, 1))
FAR_PLACE = FAR_WRIST[0] + L3 * cos(FAR_DIRECTION), FAR_WRIST[1] + L3 * sin(FAR_DIRECTION)
# Rounded to whole degrees, so that whoever adds up the angles shown gets the sums shown.
CHOICE_DOWN, CHOICE_UP = (
    np.radians(np.round(np.degrees(posture(*wrist_of(*CHOICE, CHOICE_DIRECTION), CHOICE_DIRECTION, sign))))
    for sign in (1, -1)
)


def rests(state: State) -> bool:
    """Whether the arm rests after a request of the reader."""
    return not state.arm.moving and isinstance(state.request.command, MoveToJoints | MoveToPose)


def heading(T_world_tool: Array) -> float:
    """The direction of a hand in the plane of the arm, rad."""
    return float(np.arctan2(T_world_tool[1, 0], T_world_tool[0, 0]))


def ready_pose(state: State) -> Array:
    """The pose of the tool at `ready`, (4, 4), m."""
    return tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))


def ready_wrist(state: State) -> tuple[float, float]:
    """Where the third axis is at `ready`, m."""
    T = ready_pose(state)
    return wrist_of(float(T[0, 3]), float(T[1, 3]), heading(T))


def wrist_place(state: State) -> Array:
    """Where the third axis is, (2,), m."""
    x, y, _ = state.T_world_tool[:3, 3]
    return np.array(wrist_of(float(x), float(y), heading(state.T_world_tool)))


def missing(state: State) -> float:
    """The distance of the tool from its target, m; 0 without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return 0.0
    return float(np.linalg.norm(command.T_world_target[:3, 3] - state.T_world_tool[:3, 3]))


def change_to(q: Array, state: State) -> Array:
    """How far each joint turns from `ready` to a posture (3,), rad, the shorter way round."""
    return np.abs(wrap(q - np.array(state.robot.poses["ready"])))


def cost(q: Array, state: State, weights: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> float:
    """The weighted sum of the changes, rad. Source: Campos 1998, s.17."""
    return float(np.dot(weights, change_to(q, state)))


VALUES = {
    "tool": Value(lambda state, _: state.T_world_tool[:2, 3], "mm"),
    "phi": Value(lambda state, _: heading(state.T_world_tool), "°"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "elbow": Value(lambda state, _: state.arm.q[ELBOW], "°"),
    "wrist": Value(lambda state, _: wrist_place(state), "mm"),
    "ready_tool": Value(lambda state, _: ready_pose(state)[:2, 3], "mm"),
    "ready_phi": Value(lambda state, _: heading(ready_pose(state)), "°"),
    "ready_joints": Value(lambda state, _: np.array(state.robot.poses["ready"]), "°"),
    "least_turn": fixed(LEAST_TURN, "°"),
    "upper": fixed(L1, "mm"),
    "fore": fixed(L2, "mm"),
    "hand": fixed(L3, "mm"),
    "place": fixed(np.array(PLACE), "mm"),
    "direction": fixed(DIRECTION, "°"),
    "wrist_asked": fixed(np.array(wrist_of(*PLACE, DIRECTION)), "mm"),
    "far_place": fixed(np.array(FAR_PLACE), "mm"),
    "far_phi": fixed(FAR_DIRECTION, "°"),
    "far_wrist": fixed(np.array(FAR_WRIST), "mm"),
    "beta": fixed(BETA, "°", 1),
    "beta_lost": fixed(BETA - pi, "°", 1),
    "psi": fixed(PSI, "°", 1),
    "bend": fixed(float(FAR_DOWN[ELBOW]), "°", 1),
    "choice_place": fixed(np.array(CHOICE), "mm"),
    "choice_phi": fixed(CHOICE_DIRECTION, "°"),
    "choice_down": fixed(CHOICE_DOWN, "°"),
    "choice_up": fixed(CHOICE_UP, "°"),
    "change_down": Value(lambda state, _: change_to(CHOICE_DOWN, state), "°"),
    "change_up": Value(lambda state, _: change_to(CHOICE_UP, state), "°"),
    "cost_down": Value(lambda state, _: cost(CHOICE_DOWN, state), "°"),
    "cost_up": Value(lambda state, _: cost(CHOICE_UP, state), "°"),
    "weighted_down": Value(lambda state, _: cost(CHOICE_DOWN, state, WEIGHTS), "°"),
    "weighted_up": Value(lambda state, _: cost(CHOICE_UP, state, WEIGHTS), "°"),
    "lift": fixed(LIFT, "mm"),
    "weight": fixed(WEIGHTS[0], decimals=0),
    "at_place": fixed(AT_PLACE, "mm"),
    "missing": Value(lambda state, _: missing(state), "mm"),
    "polar": fixed(np.array(POLAR), "mm"),
    "polar_angle": fixed(atan2(-POLAR[0], POLAR[1]), "°", 1),
    "polar_slide": fixed(hypot(*POLAR), "mm"),
}
