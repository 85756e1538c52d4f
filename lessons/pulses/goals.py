"""Counts and motors of the Movemaster in a state; what the steps request, their goals and their mistakes."""

from __future__ import annotations

from itertools import product
from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady, HoldPosition
from helicoide.kinematics.actuators import Actuators
from helicoide.kinematics.forward import tool_by_screws
from helicoide.seat import Seat
from helicoide.state import State

WAIST, SHOULDER, ELBOW, PITCH, ROLL = 0, 1, 2, 3, 4
AT_REST = radians(3.0)
READ_AT, WITHIN, ASKED_AT = radians(30.0), radians(1.0), radians(90.0)
STRETCHED, BENT = 0.80, radians(-85.0)
RAISED = radians(25.0)
LIMIT = radians(99.0)
OFF, OFF_WITHIN, TOO_FAR = radians(1.0), radians(0.15), radians(2.0)
MOTOR_RANGE, READING = radians(180.0), "reading_ceiling"
SAME_SENSE = radians(20.0)
COMPUTED, MEASURED = (0.470429, 0.271603, 0.300000), (0.477, 0.275, 0.293)  # eq. 6 and fig. 26, m


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes."""
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def actuators(state: State) -> Actuators:
    """The actuators of the arm: pulses per degree and the coupling of the wrist."""
    found = state.robot.actuators
    assert found is not None
    return found


def ready(state: State) -> Array:
    """The joint values at `ready`, (5,), rad."""
    return np.array(state.robot.poses["ready"])


def stretched(state: State) -> Array:
    """The joint values of the stretched arm, (5,), rad."""
    return np.array(state.robot.poses["zero"])


def counts(state: State) -> Array:
    """The pulses that the encoders count, (5,)."""
    return actuators(state).from_joints(state.arm.q)


def place(state: State, q: Array) -> Array:
    """Where the tool is at joint values (5,), rad: (3,), m."""
    return tool_by_screws(state.robot, q)[:3, 3]


def pulses_per_deg(state: State, motor: int) -> float:
    """The pulses per degree of a motor."""
    one_degree = actuators(state).inverse_coupling[:, motor] * radians(1.0)
    return float(actuators(state).from_joints(one_degree)[motor])


def one_pulse(state: State, q: Array, motor: int) -> Array:
    """How the tool moves if one motor makes one pulse, (3,), m."""
    return place(state, q + actuators(state).to_joints(np.eye(len(q))[motor])) - place(state, q)


def pulse_size(state: State, q: Array, motor: int) -> float:
    """How far the tool moves if one motor makes one pulse, m."""
    return float(np.linalg.norm(one_pulse(state, q, motor)))


def half_pulses(state: State, q: Array) -> Array:
    """How the tool moves for half a pulse of each motor, (5, 3), m."""
    return np.array([one_pulse(state, q, motor) for motor in range(len(q))]) / 2


def axis_distance(state: State, joint: int) -> float:
    """The distance of the tool of the stretched arm, whose joint values are zero, from the axis of a joint, m."""
    robot = state.robot
    return float(
        np.linalg.norm(np.cross(robot.directions[joint], place(state, stretched(state)) - robot.points[joint]))
    )


def worst_rounding(state: State) -> float:
    """The largest distance of the tool at `ready` from where it should be, with whole pulses, m."""
    halves = half_pulses(state, ready(state))
    signs = np.array(list(product((-1.0, 1.0), repeat=len(halves))))
    return float(np.linalg.norm(signs @ halves, axis=1).max())


def sum_of_halves(state: State, q: Array) -> float:
    """How far the tool would move at joint values (5,), rad, if the half pulses had one direction, m."""
    return float(np.linalg.norm(half_pulses(state, q), axis=1).sum())


def rounding(state: State) -> float:
    """The distance of the tool from where it is with whole pulses, m."""
    whole = actuators(state).to_joints(np.round(counts(state)))
    return float(np.linalg.norm(place(state, whole) - place(state, state.arm.q)))


def turned_by(state: State, joint: int) -> float:
    """How far a joint is from where it is at `ready`, rad."""
    return float(state.arm.q[joint] - ready(state)[joint])


def motor_angle(q: Array) -> float:
    """The angle of the fifth motor, θ₅ − θ₄, rad."""
    return float(q[ROLL] - q[PITCH])


def lever(state: State) -> float:
    """The distance of the tool at `ready` from the axis of the shoulder, m."""
    tool, axis = place(state, ready(state)), state.robot.points[SHOULDER]
    return float(np.hypot(np.hypot(*tool[:2]) - axis[0], tool[2] - axis[2]))


def tool_moved(state: State) -> float:
    """How far the tool is from where it is at `ready`, m."""
    return float(np.linalg.norm(place(state, state.arm.q) - place(state, ready(state))))


# Goals and mistakes.


def waist_read(state: State, seat: Seat) -> bool:
    """The waist rests where its count is to be read."""
    return abs(float(state.arm.q[WAIST]) - READ_AT) <= WITHIN and rests(state)


def waist_turned_back(state: State, seat: Seat) -> bool:
    """The waist was turned to the other side."""
    return bool(state.arm.q[WAIST] < -AT_REST) and rests(state)


def is_stretched(state: State, seat: Seat) -> bool:
    """The arm rests stretched."""
    return float(np.hypot(*state.T_world_tool[:2, 3])) >= STRETCHED and rests(state)


def is_bent(state: State, seat: Seat) -> bool:
    """The elbow was bent."""
    return bool(state.arm.q[ELBOW] < BENT) and rests(state)


def pitch_raised(state: State, seat: Seat) -> bool:
    """The wrist was pitched up, and its roll joint is where it was."""
    return turned_by(state, PITCH) >= RAISED and abs(turned_by(state, ROLL)) < AT_REST and rests(state)


def pitch_lowered(state: State, seat: Seat) -> bool:
    """The wrist was pitched down."""
    return turned_by(state, PITCH) < -AT_REST and rests(state)


def is_home(state: State, seat: Seat) -> bool:
    """The arm is at its switches and rests."""
    return state.arm.parked and not state.arm.moving and isinstance(state.request.command, HoldPosition)


def at_the_limit(state: State, seat: Seat) -> bool:
    """The shoulder is at the end of its slider, which is not at the switch."""
    return not state.arm.parked and bool(state.arm.q[SHOULDER] >= LIMIT) and rests(state)


def off_by_one(state: State, seat: Seat) -> bool:
    """The shoulder, and nothing else, rests one degree from where it is at `ready`."""
    others = max(abs(turned_by(state, joint)) for joint in (WAIST, ELBOW, PITCH, ROLL))
    return abs(abs(turned_by(state, SHOULDER)) - OFF) <= OFF_WITHIN and others < OFF_WITHIN and rests(state)


def off_by_more(state: State, seat: Seat) -> bool:
    """The shoulder was turned by more than was asked for."""
    return abs(turned_by(state, SHOULDER)) >= TOO_FAR and rests(state)


def motor_beyond(state: State, seat: Seat) -> bool:
    """The fifth motor is beyond half a turn, although each joint is within its limits."""
    return abs(motor_angle(state.arm.q)) > MOTOR_RANGE and rests(state)


def same_sense(state: State, seat: Seat) -> bool:
    """Pitch and roll were turned in the same sense, so that the motor turns less than the roll."""
    pitch, roll = float(state.arm.q[PITCH]), float(state.arm.q[ROLL])
    return min(abs(pitch), abs(roll)) > SAME_SENSE and pitch * roll > 0 and rests(state)
