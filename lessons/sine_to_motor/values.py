"""The values of the pages, and what they are read from."""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.kinematics.forward import tool_motor
from helicoide.lesson import Value, fixed
from helicoide.seat import Seat
from helicoide.state import State

ALONG_Z, ALONG_Y, ALONG_X, ABOUT_Z, ABOUT_Y, ABOUT_X = range(6)
HALF, NEAR = 0.5, 0.02
ALSO_HALF = radians(150.0)
FIRST_TURN = radians(50.0)
QUARTER = radians(90.0)
TRIED = radians(120.0)
TILT = radians(60.0)
SHIFT = 0.200
X_AXIS, Y_AXIS, Z_AXIS = np.eye(3)


def facing(state: State, axis: int = 0) -> Array:
    """Where an axis of the body points, (3,)."""
    return np.asarray(state.T_world_tool[:3, axis])


def product(*motors: Array) -> Multivector:
    """The product of motors, from the left to the right."""
    whole = CL031.blade("1")
    for one in motors:
        whole = CL031.product(whole, one)
    return Multivector(whole, CL031)


TURN_Z, TURN_X = rigid.rotor(Z_AXIS, QUARTER), rigid.rotor(X_AXIS, QUARTER)
SHIFT_X = rigid.translator(SHIFT * X_AXIS)


def wanted() -> Multivector:
    """The motor that a reader brings the body to: a turn about x, then a shift along z."""
    return product(rigid.translator(SHIFT * Z_AXIS), rigid.rotor(X_AXIS, TILT))


def motor(state: State, seat: Seat) -> Multivector:
    """The motor of the body: the product of those of its joints, with its sign."""
    return Multivector(tool_motor(state.robot, state.arm.q), CL031)


VALUES = {
    "angle_z": Value(lambda state, _: state.arm.q[ABOUT_Z], "°"),
    "facing": Value(lambda state, _: facing(state)[:2]),
    "x": Value(lambda state, _: facing(state)[0]),
    "y": Value(lambda state, _: facing(state)[1]),
    "half": fixed(HALF, decimals=1),
    "near": fixed(NEAR),
    "also_half": fixed(ALSO_HALF, "°"),
    "first_turn": fixed(FIRST_TURN, "°"),
    "twice": fixed(2 * FIRST_TURN, "°"),
    "mirrored": fixed(np.pi - 2 * FIRST_TURN, "°"),
    "cos_first": fixed(cos(FIRST_TURN), decimals=4),
    "sin_first": fixed(sin(FIRST_TURN), decimals=4),
    "twice_sine": fixed(2 * sin(FIRST_TURN), decimals=3),
    "squared": fixed(np.array([cos(FIRST_TURN) ** 2 - sin(FIRST_TURN) ** 2, 2 * cos(FIRST_TURN) * sin(FIRST_TURN)])),
    "motor": Value(motor, decimals=2),
    "scalar": Value(lambda state, seat: motor(state, seat)["1"]),
    "quarter": fixed(QUARTER, "°"),
    "eighth": fixed(QUARTER / 2, "°"),
    "quarter_rotor": fixed(lambda: product(TURN_Z), decimals=2),
    "tried": fixed(TRIED, "°"),
    "half_tried": fixed(TRIED / 2, "°"),
    "tried_scalar": fixed(cos(TRIED / 2), decimals=1),
    "tilt": fixed(TILT, "°"),
    "half_tilt": fixed(TILT / 2, "°"),
    "tilt_rotor": fixed(lambda: product(rigid.rotor(Y_AXIS, TILT)), decimals=2),
    "z_then_x": fixed(lambda: product(TURN_Z, TURN_X), decimals=2),
    "x_then_z": fixed(lambda: product(TURN_X, TURN_Z), decimals=2),
    "shift": fixed(SHIFT, "mm"),
    "half_shift": fixed(SHIFT / 2, "mm"),
    "shift_m": fixed(SHIFT, "m", 1),
    "half_shift_m": fixed(SHIFT / 2, decimals=1),
    "shift_y": fixed(lambda: product(rigid.translator(SHIFT * Y_AXIS)), decimals=2),
    "shift_turned": fixed(lambda: product(SHIFT_X, TURN_Z), decimals=2),
    "turn_shifted": fixed(lambda: product(TURN_Z, SHIFT_X), decimals=2),
    "wanted": fixed(wanted),
    "half_length": Value(lambda state, _: float(np.linalg.norm(rigid.null_part(wanted().values))), decimals=1),
    "now": Value(motor),
}
