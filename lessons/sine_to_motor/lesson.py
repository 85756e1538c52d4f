"""From sine to motor: an angle, a rotor, three axes, a shift, and both in one product. For someone who knows sines."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians, sin

import numpy as np

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

from .values import (
    ABOUT_X,
    ABOUT_Y,
    ABOUT_Z,
    ALONG_X,
    ALONG_Y,
    ALONG_Z,
    FIRST_TURN,
    HALF,
    NEAR,
    QUARTER,
    SHIFT,
    TILT,
    TRIED,
    Y_AXIS,
    facing,
    motor,
    wanted,
)
from .values import VALUES as VALUES

TITLE = Text(en="From sine to motor", pt_BR="Do seno ao motor")
ABOUT = Text(
    en="Turn and shift a free body, and read both from one product: from the sine to the rotor, and on to the motor.",
    pt_BR="Gire e desloque um corpo livre e leia as duas coisas em um só produto: do seno ao rotor, e daí ao motor.",
)
ROBOT = "free_body"
SOURCES = (
    "Cerbaro 2022: eqs. 76–78, 88, 89 (quaternions), 96–99 (motors)",
    "Cerbaro 2022: eq. 95, corrected: a sandwich moves points, lines and planes, a product from the left moves poses",
)
NEAR_ANGLE, NEAR_LENGTH = radians(2.0), 0.005
UNTOUCHED = radians(5.0)


def start(state: State) -> State:
    """Ask for the body where it begins, free to turn."""
    for change in (gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def moved(x: float = 0.0, y: float = 0.0, about_x: float = 0.0, about_y: float = 0.0, about_z: float = 0.0) -> Update:
    """Ask for shifts, m, and turns, rad, by the joints of the body."""
    return gate.set_joints([0.0, y, x, about_z, about_y, about_x])


def at_rest(state: State, *places: tuple[int, float]) -> bool:
    """Whether the body rests with some of its joints, by number, near these values, rad or m."""
    if state.arm.moving:
        return False
    near = [NEAR_LENGTH] * 3 + [NEAR_ANGLE] * 3
    return all(abs(state.arm.q[joint] - value) <= near[joint] for joint, value in places)


def only(state: State, joint: int, value: float) -> bool:
    """Whether the body rests with one joint near a value, rad or m, and all others near zero."""
    return at_rest(state, *((other, value if other == joint else 0.0) for other in range(6)))


def is_only(joint: int, value: float) -> Callable[[State, Seat], bool]:
    """`only`, as a goal or a diagnosis."""
    return lambda state, seat: only(state, joint, value)


def flat(state: State) -> bool:
    """The body rests, turned about the vertical axis alone."""
    return at_rest(state, (ABOUT_X, 0.0), (ABOUT_Y, 0.0))


def sine_is_half(state: State, seat: Seat) -> bool:
    """The first face points to where y is one half."""
    return flat(state) and bool(abs(facing(state)[1] - HALF) <= NEAR)


def cosine_is_half(state: State, seat: Seat) -> bool:
    """It is x that is one half."""
    return flat(state) and bool(abs(facing(state)[0] - HALF) <= NEAR)


def angle_is_half(state: State, seat: Seat) -> bool:
    """The angle is half of a right one, not the sine half of its largest value."""
    return only(state, ABOUT_Z, QUARTER / 2)


def sine_is_minus_half(state: State, seat: Seat) -> bool:
    """The body was turned to the other side."""
    return flat(state) and bool(abs(facing(state)[1] + HALF) <= NEAR)


def points_to(state: State, angle: float) -> bool:
    """Whether the first face points in the direction of an angle, rad, about the vertical axis."""
    return flat(state) and bool(np.linalg.norm(facing(state)[:2] - [cos(angle), sin(angle)]) <= 2 * NEAR)


def turned_twice(state: State, seat: Seat) -> bool:
    """The body is where two equal turns bring it."""
    return points_to(state, 2 * FIRST_TURN)


def sign_of_cosine_lost(state: State, seat: Seat) -> bool:
    """The sine is right, and the cosine has the wrong sign."""
    return points_to(state, np.pi - 2 * FIRST_TURN)


def turned_back(state: State, seat: Seat) -> bool:
    """The cosine is right, and the sine has the wrong sign."""
    return points_to(state, -2 * FIRST_TURN)


def another_axis(joint: int) -> Callable[[State, Seat], bool]:
    """A diagnosis: the body was turned about another axis than that of a joint."""
    others = {ABOUT_X, ABOUT_Y, ABOUT_Z} - {joint}
    return lambda state, seat: not state.arm.moving and any(abs(state.arm.q[k]) > UNTOUCHED for k in others)


def second_face_up(state: State, seat: Seat) -> bool:
    """The face with two dots looks up, that with one dot looks along y."""
    return stands(state, up=1, along_y=0)


def stands(state: State, up: int, along_y: int, sign: float = 1.0) -> bool:
    """Whether an axis of the body points up (sign 1) or down (−1), and another one along y."""
    if state.arm.moving:
        return False
    is_up = sign * facing(state, up)[2] >= cos(NEAR_ANGLE)
    return bool(is_up and facing(state, along_y)[1] >= cos(NEAR_ANGLE))


def second_face_down(state: State, seat: Seat) -> bool:
    """The face with two dots looks down: the turn about x has the other sign."""
    return stands(state, up=1, along_y=0, sign=-1.0)


def first_face_up(state: State, seat: Seat) -> bool:
    """The face with one dot looks up, as in the product of the other order."""
    return not state.arm.moving and bool(facing(state)[2] >= cos(NEAR_ANGLE))


def about_y_used(state: State, seat: Seat) -> bool:
    """The middle turn was used, which this step does not need."""
    return not state.arm.moving and bool(abs(state.arm.q[ABOUT_Y]) > UNTOUCHED)


def shifted_along_another(state: State, seat: Seat) -> bool:
    """The body was shifted along x or z."""
    return not state.arm.moving and any(abs(state.arm.q[k]) > 2 * NEAR_LENGTH for k in (ALONG_X, ALONG_Z))


def is_at(x: float, y: float, about_z: float) -> Callable[[State, Seat], bool]:
    """A goal or a diagnosis: the body rests at a place, m, turned by an angle, rad, about the vertical axis."""

    def rests(state: State, seat: Seat) -> bool:
        places = (ALONG_X, x), (ALONG_Y, y), (ALONG_Z, 0.0), (ABOUT_X, 0.0), (ABOUT_Y, 0.0), (ABOUT_Z, about_z)
        return at_rest(state, *places)

    return rests


def motor_is_wanted(state: State, seat: Seat) -> bool:
    """The motor of the body is the wanted one, or its negative."""
    now = motor(state, seat).values
    away = min(np.linalg.norm(now - sign * wanted().values) for sign in (1.0, -1.0))
    return not state.arm.moving and bool(away <= NEAR)


def read_as(height: float, about_x: float) -> Callable[[State, Seat], bool]:
    """A diagnosis: the motor was read as this height, m, with this turn about x, rad."""
    return lambda state, seat: at_rest(
        state, (ALONG_X, 0.0), (ALONG_Y, 0.0), (ALONG_Z, height), (ABOUT_X, about_x), (ABOUT_Y, 0.0), (ABOUT_Z, 0.0)
    )


def raised(height: float, about_x: float) -> Update:
    """Ask for a height, m, and a turn about x, rad."""
    return gate.set_joints([height, 0.0, 0.0, 0.0, 0.0, about_x])


TURNED_AND_SHIFTED = LineExercise(
    "motor",
    (
        GivenName(
            "theta", "angle", Text(en="the angle of the turn, in radians", pt_BR="o ângulo do giro, em radianos")
        ),
        GivenName("d", "length", Text(en="how far the body is shifted", pt_BR="quanto o corpo se desloca")),
    ),
    "(1 + d/2*e1e)*(cos(theta/2) + sin(theta/2)*e1e2)",
    sign_counts=False,
    without=("rotor", "translator", "motor", "screw", "exp"),
    title=Text(en="the motor of a turn and then a shift", pt_BR="o motor de um giro e, depois, um deslocamento"),
)

STEPS = (
    Step(
        "circle",
        start,
        sine_is_half,
        ((gate.set_joint(ABOUT_Z, radians(30.0)), 2.0),),
        joints=(ABOUT_Z,),
        prediction=Choice(right=0),
        diagnoses=(
            Diagnosis("cosine", cosine_is_half, ((gate.set_joint(ABOUT_Z, radians(60.0)), 2.0),)),
            Diagnosis("half_way", angle_is_half, ((gate.set_joint(ABOUT_Z, QUARTER / 2), 2.0),)),
            Diagnosis("other_side", sine_is_minus_half, ((gate.set_joint(ABOUT_Z, radians(-30.0)), 2.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "turns_add",
        start,
        turned_twice,
        ((gate.set_joint(ABOUT_Z, 2 * FIRST_TURN), 2.0),),
        joints=(ABOUT_Z,),
        prediction=Choice(right=2),
        diagnoses=(
            Diagnosis("sign_lost", sign_of_cosine_lost, ((gate.set_joint(ABOUT_Z, np.pi - 2 * FIRST_TURN), 2.0),)),
            Diagnosis("other_side", turned_back, ((gate.set_joint(ABOUT_Z, -2 * FIRST_TURN), 2.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "half_angle",
        start,
        is_only(ABOUT_Z, QUARTER),
        ((gate.set_joint(ABOUT_Z, QUARTER), 2.0),),
        joints=(ABOUT_Z,),
        prediction=Estimate(lambda state, _: cos(TRIED / 2), "", within=0.05),
        diagnoses=(
            Diagnosis("whole_angle", is_only(ABOUT_Z, QUARTER / 2), ((gate.set_joint(ABOUT_Z, QUARTER / 2), 2.0),)),
            Diagnosis("other_side", is_only(ABOUT_Z, -QUARTER), ((gate.set_joint(ABOUT_Z, -QUARTER), 2.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "axes",
        start,
        is_only(ABOUT_Y, TILT),
        ((gate.set_joint(ABOUT_Y, TILT), 2.0),),
        joints=(ABOUT_X, ABOUT_Y, ABOUT_Z),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("another_axis", another_axis(ABOUT_Y), ((gate.set_joint(ABOUT_X, TILT), 2.0),)),
            Diagnosis("other_order", is_only(ABOUT_Y, -TILT), ((gate.set_joint(ABOUT_Y, -TILT), 2.0),)),
            Diagnosis("whole_angle", is_only(ABOUT_Y, TILT / 2), ((gate.set_joint(ABOUT_Y, TILT / 2), 2.0),)),
        ),
        shown=Shown(camera="side"),
    ),
    Step(
        "order",
        start,
        second_face_up,
        ((gate.set_joint(ABOUT_X, QUARTER), 2.0), (gate.set_joint(ABOUT_Z, QUARTER), 2.0)),
        joints=(ABOUT_X, ABOUT_Y, ABOUT_Z),
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(
            Diagnosis("other_product", first_face_up, ((moved(about_y=-QUARTER), 2.0),)),
            Diagnosis("minus", second_face_down, ((moved(about_x=-QUARTER, about_z=QUARTER), 2.0),)),
            Diagnosis("middle", about_y_used, ((gate.set_joint(ABOUT_Y, QUARTER), 2.0),)),
        ),
        shown=Shown(camera="first"),
    ),
    Step(
        "shift",
        start,
        is_only(ALONG_Y, SHIFT),
        ((gate.set_joint(ALONG_Y, SHIFT), 2.0),),
        joints=(ALONG_X, ALONG_Y, ALONG_Z),
        prediction=Estimate(lambda state, _: SHIFT / 2, "", within=0.01),
        diagnoses=(
            Diagnosis("not_doubled", is_only(ALONG_Y, SHIFT / 2), ((gate.set_joint(ALONG_Y, SHIFT / 2), 2.0),)),
            Diagnosis("other_side", is_only(ALONG_Y, -SHIFT), ((gate.set_joint(ALONG_Y, -SHIFT), 2.0),)),
            Diagnosis("another_axis", shifted_along_another, ((gate.set_joint(ALONG_X, SHIFT), 2.0),)),
        ),
        shown=Shown(camera="first"),
    ),
    Step(
        "motor",
        start,
        is_at(0.0, SHIFT, QUARTER),
        ((gate.set_joint(ALONG_Y, SHIFT), 2.0), (gate.set_joint(ABOUT_Z, QUARTER), 2.0)),
        joints=(ALONG_X, ALONG_Y, ABOUT_Z),
        prediction=Mark(lambda state, _: SHIFT * Y_AXIS, within=0.04),
        diagnoses=(
            Diagnosis("other_product", is_at(SHIFT, 0.0, QUARTER), ((moved(x=SHIFT, about_z=QUARTER), 2.0),)),
            Diagnosis("other_side", is_at(0.0, -SHIFT, QUARTER), ((moved(y=-SHIFT, about_z=QUARTER), 2.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step("write", start, line=TURNED_AND_SHIFTED),
    Step(
        "read",
        start,
        motor_is_wanted,
        ((gate.set_joint(ALONG_Z, SHIFT), 2.0), (gate.set_joint(ABOUT_X, TILT), 2.0)),
        joints=tuple(range(6)),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("halves", read_as(SHIFT / 2, TILT / 2), ((raised(SHIFT / 2, TILT / 2), 2.0),)),
            Diagnosis("other_side", read_as(SHIFT, -TILT), ((raised(SHIFT, -TILT), 2.0),)),
            Diagnosis("no_turn", read_as(SHIFT, 0.0), ((raised(SHIFT, 0.0), 2.0),)),
        ),
        shown=Shown(camera="first"),
    ),
    Step("explore", start, is_open=True, joints=tuple(range(6)), shown=Shown(camera="first")),
)
