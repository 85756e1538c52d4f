"""What the steps ask for, when they are done, and which mistakes are recognised."""

from __future__ import annotations

from math import pi, radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.geometry import rotation
from helicoide.ik.postures.branch import wrap
from helicoide.seat import Seat
from helicoide.state import State, Update

from .values import (
    AT_PLACE,
    BETA,
    CHOICE_DOWN,
    CHOICE_UP,
    DIRECTION,
    ELBOW,
    FAR_DIRECTION,
    FAR_PLACE,
    FAR_UP,
    FAR_WRIST,
    LEAST_TURN,
    LIFT,
    PLACE,
    PSI,
    WRIST,
    heading,
    missing,
    ready_pose,
    ready_wrist,
    rests,
    wrapped,
    wrist_of,
    wrist_place,
)

ALIGNED = radians(4.0)
MOVED = radians(10.0)
UP = np.array([0.0, 0.0, 1.0])


def start(state: State) -> State:
    """Ask for the arm at `ready`, for a place and a direction, without obstacles and planes."""
    for _ in state.problem.obstacles.radii:
        state = gate.remove_obstacle(0)(state)
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def target_at(x: float, y: float, phi: float, z: float = 0.0) -> Update:
    """Ask for a place, m, and a direction of the hand, rad."""
    return gate.set_target([x, y, z], rotation.from_axis_angle(UP, phi))


def hand_turned(by: float) -> Update:
    """Ask for the present place and a hand turned by an angle, rad."""

    def change(state: State) -> State:
        x, y, _ = state.T_world_tool[:3, 3]
        return target_at(float(x), float(y), heading(state.T_world_tool) + by)(state)

    return change


def hand_tilted(by: float) -> Update:
    """Ask for the present place and a hand tilted out of the plane, rad."""

    def change(state: State) -> State:
        quat = rotation.from_matrix(state.T_world_tool[:3, :3])
        tilt = rotation.from_axis_angle(np.array([1.0, 0.0, 0.0]), by)
        return gate.set_target(state.T_world_tool[:3, 3], rotation.multiply(tilt, quat))(state)

    return change


def elbow_up_of_ready(state: State) -> Array:
    """The posture with the tool as at `ready` and the elbow on the other side, (3,), rad."""
    x, y = ready_wrist(state)
    theta1, theta2, theta3 = state.robot.poses["ready"]
    first = wrapped(2 * float(np.arctan2(y, x)) - theta1)
    return np.array([first, -theta2, wrapped(theta1 + 2 * theta2 + theta3 - first)])


def to_elbow_up(*, with_wrist: bool = True) -> Update:
    """Ask for this posture; without the wrist the third joint stays as it is."""

    def change(state: State) -> State:
        q = elbow_up_of_ready(state)
        return gate.set_joints(q if with_wrist else [*q[:WRIST], state.arm.q[WRIST]])(state)

    return change


def is_at(state: State, place: tuple[float, float]) -> bool:
    """Whether the tool rests at a place of the plane, m."""
    return rests(state) and bool(np.linalg.norm(state.T_world_tool[:2, 3] - place) <= AT_PLACE)


def is_aligned(state: State, phi: float) -> bool:
    """Whether the hand has a direction, rad."""
    return abs(wrapped(heading(state.T_world_tool) - phi)) <= ALIGNED


def has_joints(state: State, q: Array) -> bool:
    """Whether the arm rests in a posture (3,), rad."""
    return rests(state) and bool(np.abs(wrap(state.arm.q - q)).max() <= ALIGNED)


def from_ready(state: State) -> float:
    """The distance of the tool from where it is at `ready`, m."""
    return float(np.linalg.norm(state.T_world_tool[:3, 3] - ready_pose(state)[:3, 3]))


# Goals and mistakes.


def turned_in_place(state: State, seat: Seat) -> bool:
    """The hand was turned, and its point is where it was."""
    turn = abs(wrapped(heading(state.T_world_tool) - heading(ready_pose(state))))
    return rests(state) and from_ready(state) <= AT_PLACE and turn >= LEAST_TURN - 1e-3


def wrist_alone(state: State, seat: Seat) -> bool:
    """Only the last joint was turned, and the point went away."""
    change = np.abs(state.arm.q - np.array(state.robot.poses["ready"]))
    return rests(state) and bool(change[WRIST] > MOVED and change[:WRIST].max() < ALIGNED)


def orientation_let_go(state: State, seat: Seat) -> bool:
    """Only the place of the target counts."""
    return not state.request.with_orientation


def place_lost(state: State, seat: Seat) -> bool:
    """The point of the hand has moved away."""
    return rests(state) and from_ready(state) > 2 * AT_PLACE and not wrist_alone(state, seat)


def hand_placed(state: State, seat: Seat) -> bool:
    """The hand is at the place, with the direction."""
    return is_at(state, PLACE) and is_aligned(state, DIRECTION)


def hand_opposite(state: State, seat: Seat) -> bool:
    """The hand is at the place and points the opposite way."""
    return is_at(state, PLACE) and is_aligned(state, DIRECTION + pi)


def hand_as_before(state: State, seat: Seat) -> bool:
    """The hand is at the place, with the direction of `ready`."""
    return is_at(state, PLACE) and is_aligned(state, heading(ready_pose(state)))


def other_elbow(state: State, seat: Seat) -> bool:
    """The tool is as at `ready`, with the elbow on the other side."""
    is_there = from_ready(state) <= AT_PLACE and is_aligned(state, heading(ready_pose(state)))
    return rests(state) and is_there and bool(state.arm.q[ELBOW] < 0)


def hand_left(state: State, seat: Seat) -> bool:
    """Shoulder and elbow are right, and the hand points elsewhere."""
    off = np.abs(wrap(state.arm.q - elbow_up_of_ready(state)))
    return rests(state) and bool(off[:WRIST].max() <= ALIGNED) and not other_elbow(state, seat)


def elbow_alone(state: State, seat: Seat) -> bool:
    """Only the sign of the elbow was changed."""
    theta1, theta2, theta3 = state.robot.poses["ready"]
    return has_joints(state, np.array([theta1, -theta2, theta3]))


def far_placed(state: State, seat: Seat) -> bool:
    """The hand is at the far place, with the direction."""
    return is_at(state, FAR_PLACE) and is_aligned(state, FAR_DIRECTION)


def signs_mixed(state: State, seat: Seat) -> bool:
    """θ₁ of one posture with θ₂ of the other."""
    theta2 = abs(float(FAR_UP[ELBOW]))
    pairs = ((BETA - PSI, -theta2), (BETA + PSI, theta2))
    return rests(state) and any(np.abs(wrap(state.arm.q[:WRIST] - pair)).max() <= ALIGNED for pair in pairs)


def quadrant_lost(state: State, seat: Seat) -> bool:
    """The wrist is at the opposite place: β is wrong by half a turn."""
    return rests(state) and bool(np.linalg.norm(wrist_place(state) + FAR_WRIST) <= 2 * AT_PLACE)


def far_hand_left(state: State, seat: Seat) -> bool:
    """The third axis is where it should be, and the hand points elsewhere."""
    is_there = bool(np.linalg.norm(wrist_place(state) - FAR_WRIST) <= AT_PLACE)
    return rests(state) and is_there and not is_aligned(state, FAR_DIRECTION)


def chosen_up(state: State, seat: Seat) -> bool:
    """The arm rests in the posture that costs less with the weights."""
    return has_joints(state, CHOICE_UP)


def chosen_down(state: State, seat: Seat) -> bool:
    """The arm rests in the posture that costs less with equal weights."""
    return has_joints(state, CHOICE_DOWN)


def target_tilt(state: State) -> float:
    """How far the z axis of the target is from the axes of the joints, rad; 0 without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return 0.0
    return float(np.arccos(np.clip(command.T_world_target[2, 2], -1.0, 1.0)))


def under_the_target(state: State, seat: Seat) -> bool:
    """The target is lifted out of the plane, and the tool rests under it."""
    command = state.request.command
    if not isinstance(command, MoveToPose) or state.arm.moving:
        return False
    off = command.T_world_target[:3, 3] - state.T_world_tool[:3, 3]
    return bool(abs(off[2]) >= LIFT - AT_PLACE and np.hypot(*off[:2]) <= AT_PLACE)


def target_followed(state: State, seat: Seat) -> bool:
    """The target was moved within the plane, and reached."""
    is_reached = isinstance(state.request.command, MoveToPose) and missing(state) < 1e-3
    return rests(state) and is_reached and from_ready(state) > AT_PLACE and target_tilt(state) < ALIGNED


def target_tilted(state: State, seat: Seat) -> bool:
    """The target was tilted, not lifted."""
    return rests(state) and target_tilt(state) > MOVED and missing(state) < AT_PLACE


def marked_wrist(state: State, seat: Seat) -> Array:
    """Where the third axis must be for the asked place and direction, (3,), m."""
    return np.array([*wrist_of(*PLACE, DIRECTION), 0.0])
