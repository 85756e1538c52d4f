"""What the steps ask for, when they are done, and which mistakes are recognised."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import MoveToJoints, MoveToPose
from helicoide.geometry import rotation
from helicoide.ik.postures.branch import between, wrap
from helicoide.seat import Seat
from helicoide.state import State, Update

from .values import (
    AT_PLACE,
    BEND,
    ENOUGH,
    FIRST,
    LEAST_TURN,
    MOST_AT_READY,
    ROLL,
    TIP_AT,
    TOOL_LENGTH,
    WAIST,
    count_within,
    hand_pose,
    ready,
    ready_pose,
    tip,
)

ALIGNED = radians(4.0)
MOVED, FAR_TURN = radians(5.0), radians(90.0)


def start(state: State) -> State:
    """Ask for the arm at `ready`, with a held orientation, without obstacles and planes."""
    for _ in state.problem.obstacles.radii:
        state = gate.remove_obstacle(0)(state)
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def joints_at(*degrees: float) -> Update:
    """Ask for six joint values, °."""
    return gate.set_joints(np.radians(degrees))


def hand_at(hand: Array) -> Update:
    """Ask for the arm as at `ready` and a hand, (3,), rad."""
    return lambda state: gate.set_joints([*ready(state)[:ROLL], *hand])(state)


def wrist_at_tip_place(steps: float) -> Update:
    """Ask for the wrist centre at the place of the tip, shifted along the tool by a number of tool lengths."""

    def change(state: State) -> State:
        T = ready_pose(state)
        return gate.set_target(TIP_AT + steps * TOOL_LENGTH * T[:3, 2], rotation.from_matrix(T[:3, :3]))(state)

    return change


def hand_level(x: float, y: float, z: float) -> Update:
    """Ask for the wrist centre at a place, m, and a tool that points along x."""
    return gate.set_target([x, y, z], rotation.from_axis_angle(np.array([0.0, 1.0, 0.0]), radians(90.0)))


def rests(state: State) -> bool:
    """Whether the arm rests after a request of the reader."""
    return not state.arm.moving and isinstance(state.request.command, MoveToJoints | MoveToPose)


def turned(state: State) -> Array:
    """How far each joint is from where it is at `ready`, (6,), rad."""
    return np.abs(wrap(state.arm.q - ready(state)))


def is_at(state: State, T_world_goal: Array) -> bool:
    """Whether the end effector rests at a pose (4, 4), m."""
    missed, turn = between(state.T_world_tool, T_world_goal)
    return rests(state) and missed <= AT_PLACE and turn <= ALIGNED


def wrist_is_at(state: State, place: Array) -> bool:
    """Whether the wrist centre rests at a place (3,), m."""
    return rests(state) and bool(np.linalg.norm(state.T_world_tool[:3, 3] - place) <= AT_PLACE)


def hand_is(state: State, degrees: tuple[float, float, float]) -> bool:
    """Whether the last three joints rest at these angles, °."""
    return rests(state) and bool(np.abs(wrap(state.arm.q[ROLL:] - np.radians(degrees))).max() <= ALIGNED)


# Goals and mistakes.


def hand_turned(state: State, seat: Seat) -> bool:
    """The last three joints have turned, and the others not."""
    change = turned(state)
    return rests(state) and bool(change[ROLL:].min() >= LEAST_TURN - 1e-3 and change[:ROLL].max() < MOVED)


def arm_turned(state: State, seat: Seat) -> bool:
    """One of the first three joints was turned."""
    return rests(state) and bool(turned(state)[:ROLL].max() >= MOVED)


def tip_placed(state: State, seat: Seat) -> bool:
    """The tip is at the place, with the hand as at `ready`."""
    _, turn = between(state.T_world_tool, ready_pose(state))
    return rests(state) and bool(np.linalg.norm(tip(state) - TIP_AT) <= AT_PLACE) and turn <= ALIGNED


def wrist_placed(state: State, seat: Seat) -> bool:
    """The wrist centre is at the place that was asked for the tip."""
    return wrist_is_at(state, TIP_AT)


def tip_beyond(state: State, seat: Seat) -> bool:
    """The length of the tool was added, not subtracted."""
    return wrist_is_at(state, TIP_AT + TOOL_LENGTH * ready_pose(state)[:3, 2])


def hand_let_go(state: State, seat: Seat) -> bool:
    """Only the place of the target counts."""
    return not state.request.with_orientation


def other_shoulder(state: State, seat: Seat) -> bool:
    """The end effector is as at `ready`, with the shoulder on the other side."""
    return is_at(state, ready_pose(state)) and bool(turned(state)[WAIST] > FAR_TURN)


def waist_alone(state: State, seat: Seat) -> bool:
    """Only the waist was turned."""
    change = turned(state)
    return rests(state) and bool(change[WAIST] > LEAST_TURN and change[1:].max() < MOVED)


def hand_missing(state: State, seat: Seat) -> bool:
    """The wrist centre is as at `ready`, with the other shoulder, and the hand points elsewhere."""
    _, turn = between(state.T_world_tool, ready_pose(state))
    is_there = wrist_is_at(state, ready_pose(state)[:3, 3]) and bool(turned(state)[WAIST] > FAR_TURN)
    return is_there and turn > ALIGNED


def wrist_flipped(state: State, seat: Seat) -> bool:
    """The hand is as asked, with a negative bend."""
    return is_at(state, hand_pose(state)) and bool(state.arm.q[BEND] < 0)


def hand_first(state: State, seat: Seat) -> bool:
    """The hand is as asked, in the posture of the text."""
    return is_at(state, hand_pose(state)) and bool(state.arm.q[BEND] > 0)


def bend_negated(state: State, seat: Seat) -> bool:
    """Only the sign of the bend was changed."""
    roll, bend, flange = np.degrees(FIRST)
    return hand_is(state, (roll, -bend, flange))


def bend_kept(state: State, seat: Seat) -> bool:
    """Roll and flange were turned by half a turn, and the bend has its sign."""
    roll, bend, flange = np.degrees(FIRST)
    return hand_is(state, (roll + 180.0, bend, flange + 180.0))


def enough_within(state: State, seat: Seat) -> bool:
    """Enough postures of the pose are within the limits."""
    return rests(state) and count_within(state) >= ENOUGH


def no_more_within(state: State, seat: Seat) -> bool:
    """The arm has moved, and no more postures are within the limits than at `ready`."""
    return rests(state) and bool(turned(state).max() > MOVED) and count_within(state) <= MOST_AT_READY
