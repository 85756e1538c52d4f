"""Quaternions: four numbers, the sandwich, the double cover, slerp and the error of an orientation."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians, sin

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.geometry.clifford import QUATERNIONS
from helicoide.geometry.multivector import Multivector
from helicoide.geometry.quaternion_paths import lerp, slerp
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

TITLE = Text(en="Quaternions", pt_BR="Quatérnios")
ABOUT = Text(
    en="Four numbers for a rotation: why two of them mean the same, the way between two, and how far it is still.",
    pt_BR="Quatro números para uma rotação: por que dois deles valem o mesmo, o caminho entre dois e o que falta.",
)
ROBOT = "free_body"
NEEDS = ("sine_to_motor",)
SOURCES = (
    "Cerbaro 2022: eqs. 76–78, 85, 88, 89, 91, 92",
    "Vargas 2013: eqs. 2.41–2.46 (quaternion error)",
    "Shoemake 1985, Animating rotation with quaternion curves (slerp)",
)

ABOUT_Z, ABOUT_Y, ABOUT_X = 3, 4, 5
Z_AXIS = np.array([0.0, 0.0, 1.0])
NEAR, NEAR_ANGLE = 0.02, radians(2.0)
QUARTER, HALF_TURN, TURN = radians(90.0), radians(180.0), radians(360.0)
WAY, PART = radians(160.0), 0.25
FAR = radians(300.0)
MISSING = radians(60.0)
BEYOND = radians(240.0)


def about_z(angle: float) -> Array:
    """The quaternion of a turn about z by an angle, rad."""
    return rotation.from_axis_angle(Z_AXIS, angle)


ONE, ALONG_I, _, ALONG_K = np.eye(4)
WAY_END, FAR_END, WANTED = about_z(WAY), about_z(FAR), about_z(QUARTER)


def asked() -> Array:
    """The quaternion that a reader turns the body by: a quarter turn about x backwards, then one about z."""
    return rotation.multiply(WANTED, rotation.from_axis_angle([1.0, 0.0, 0.0], -QUARTER))


def start(state: State) -> State:
    """Ask for the body where it begins, free to turn."""
    for change in (gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def turned(z: float = 0.0, y: float = 0.0, x: float = 0.0) -> Update:
    """Ask for turns about the three axes, rad."""
    return gate.set_joints([0.0, 0.0, 0.0, z, y, x])


def quaternion(state: State, seat: Seat) -> Array:
    """The quaternion of the body, wxyz, with the sign that the turns of its joints give it."""
    z, y, x = state.arm.q[ABOUT_Z:]
    factors = about_z(z), rotation.from_axis_angle([0.0, 1.0, 0.0], y), rotation.from_axis_angle([1.0, 0.0, 0.0], x)
    return rotation.multiply(rotation.multiply(factors[0], factors[1]), factors[2])


def rests_at(angle: float, near: float = NEAR_ANGLE) -> Callable[[State, Seat], bool]:
    """A goal or a diagnosis: the body rests, turned by an angle about z alone; rad."""

    def rests(state: State, seat: Seat) -> bool:
        away = state.arm.q[ABOUT_Z:] - [angle, 0.0, 0.0]
        return not state.arm.moving and bool(np.abs(away).max() <= near)

    return rests


def has_no_scalar(state: State, seat: Seat) -> bool:
    """The first number of the quaternion is zero."""
    return not state.arm.moving and bool(abs(quaternion(state, seat)[0]) <= NEAR)


def is_turned_as(wanted: Callable[[], Array]) -> Callable[[State, Seat], bool]:
    """A goal or a diagnosis: the body rests with the rotation of a quaternion; its sign does not count."""
    return lambda state, seat: not state.arm.moving and bool(abs(quaternion(state, seat) @ wanted()) >= cos(NEAR_ANGLE))


def is_itself_again(state: State, seat: Seat) -> bool:
    """The quaternion is 1 again, after turns."""
    away = np.linalg.norm(quaternion(state, seat) - ONE)
    return not state.arm.moving and bool(away <= NEAR and np.abs(state.arm.q[ABOUT_Z:]).max() > HALF_TURN)


def is_opposite(state: State, seat: Seat) -> bool:
    """The quaternion is −1."""
    return not state.arm.moving and bool(np.linalg.norm(quaternion(state, seat) + ONE) <= NEAR)


def on_the_shorter_way(state: State, seat: Seat) -> bool:
    """The body is in the middle of the shorter way to the far end, turned about z by −30° or 330°."""
    return any(rests_at(angle)(state, seat) for angle in ((FAR - TURN) / 2, (FAR + TURN) / 2))


def difference(state: State, seat: Seat) -> Array:
    """Δq = q_d q*, wxyz, with the sign that the product gives it."""
    return rotation.multiply(WANTED, rotation.conjugate(quaternion(state, seat)))


def error(state: State, seat: Seat) -> Array:
    """The error of the orientation, (3,): the vector part of Δq, or of −Δq if its scalar part is negative."""
    return rotation.quaternion_error(WANTED, quaternion(state, seat))


def error_is_half(state: State, seat: Seat) -> bool:
    """The error is half a unit along z."""
    return not state.arm.moving and bool(np.linalg.norm(error(state, seat) - sin(MISSING / 2) * Z_AXIS) <= NEAR)


def error_points_back(state: State, seat: Seat) -> bool:
    """More than half a turn is missing, so that the error points back."""
    return not state.arm.moving and bool(difference(state, seat)[0] < -NEAR and error(state, seat)[2] < -NEAR)


def beyond_wanted(state: State, seat: Seat) -> bool:
    """The error points back because the body has turned too far."""
    return not state.arm.moving and bool(difference(state, seat)[0] > 0 and error(state, seat)[2] < -NEAR)


def away_from_wanted(state: State, seat: Seat) -> bool:
    """The body has turned away, but less than half a turn is missing."""
    return not state.arm.moving and bool(state.arm.q[ABOUT_Z] < -NEAR_ANGLE and difference(state, seat)[0] > 0)


def typeset(read: Callable[[State, Seat], Array]) -> Callable[[State, Seat], Multivector]:
    """A quaternion, wxyz, as a sum."""
    return lambda state, seat: Multivector(read(state, seat), QUATERNIONS)


def as_sum(q: Callable[[], Array], decimals: int = 2) -> Value:
    """A quaternion that does not change, as a sum."""
    return fixed(lambda: Multivector(q(), QUATERNIONS), decimals=decimals)


def lerp_angle() -> float:
    """The angle of the stretched chord after a part of the way, rad."""
    return float(rotation.axis_angle(lerp(ONE, WAY_END, PART) / np.linalg.norm(lerp(ONE, WAY_END, PART)))[1])


def slerp_angle() -> float:
    """The angle on the great circle after a part of the way, rad."""
    return float(rotation.axis_angle(slerp(ONE, WAY_END, PART))[1])


VALUES = {
    "q": Value(typeset(quaternion), decimals=2),
    "w": Value(lambda state, seat: quaternion(state, seat)[0]),
    "angle_z": Value(lambda state, _: state.arm.q[ABOUT_Z], "°"),
    "quarter": fixed(QUARTER, "°"),
    "quarter_q": as_sum(lambda: WANTED),
    "eighth": fixed(QUARTER / 2, "°"),
    "left_i": as_sum(lambda: rotation.multiply(WANTED, ALONG_I)),
    "left_k": as_sum(lambda: rotation.multiply(WANTED, ALONG_K)),
    "asked": as_sum(asked),
    "turn": fixed(TURN, "°"),
    "two_turns": fixed(2 * TURN, "°"),
    "half_turn": fixed(HALF_TURN, "°"),
    "way": fixed(WAY, "°"),
    "way_q": as_sum(lambda: WAY_END),
    "part": fixed(PART),
    "slerp_angle": fixed(slerp_angle(), "°"),
    "lerp_angle": fixed(lerp_angle(), "°"),
    "eighth_way": fixed(PART * WAY / 2, "°"),
    "lerp_length": fixed(float(np.linalg.norm(lerp(ONE, WAY_END, 0.5)))),
    "far": fixed(FAR, "°"),
    "short": fixed(TURN - FAR, "°"),
    "far_q": as_sum(lambda: FAR_END),
    "minus_far_q": as_sum(lambda: -FAR_END),
    "far_dot": fixed(float(ONE @ FAR_END)),
    "long_middle": fixed(FAR / 2, "°"),
    "short_middle": fixed((FAR - TURN) / 2, "°"),
    "missing": fixed(MISSING, "°"),
    "half_missing": fixed(MISSING / 2, "°"),
    "half_sine": fixed(sin(MISSING / 2), decimals=1),
    "difference": Value(typeset(difference), decimals=2),
    "error": Value(error),
    "still": Value(lambda state, seat: QUARTER - state.arm.q[ABOUT_Z], "°"),
    "beyond": fixed(BEYOND, "°"),
    "beyond_at": fixed(QUARTER - BEYOND, "°"),
    "back": fixed(TURN - BEYOND, "°"),
}


TWICE = LineExercise(
    "quaternion product",
    (
        GivenName("p", "rotation", Text(en="the first rotation", pt_BR="a primeira rotação")),
        GivenName("q", "rotation", Text(en="the second rotation", pt_BR="a segunda rotação")),
        GivenName("v", "vector", Text(en="the vector that is turned", pt_BR="o vetor que é girado")),
    ),
    "r*v*conj(r)",
    steps=(("r", "q*p"),),
    title=Text(
        en="the rotation r, and then the vector turned by it", pt_BR="a rotação r e, depois, o vetor girado por ela"
    ),
)
WHAT_IS_MISSING = LineExercise(
    "error",
    (
        GivenName("qd", "rotation", Text(en="the rotation to be reached", pt_BR="a rotação a alcançar")),
        GivenName("q", "rotation", Text(en="the rotation of the body", pt_BR="a rotação do corpo")),
    ),
    "conj(q)*qd",
    title=Text(
        en="the turn that is missing, about axes of the body", pt_BR="o giro que falta, em torno de eixos do corpo"
    ),
)


def z_to(angle: float) -> tuple[tuple[Update, float], ...]:
    """A way that turns the body about z to an angle, rad."""
    return ((gate.set_joint(ABOUT_Z, angle), 5.0),)


STEPS = (
    Step(
        "four_numbers",
        start,
        has_no_scalar,
        z_to(HALF_TURN),
        joints=(ABOUT_Z, ABOUT_Y, ABOUT_X),
        prediction=Choice(right=0),
        diagnoses=(
            Diagnosis("full_turn", is_opposite, z_to(TURN)),
            Diagnosis("quarter", rests_at(QUARTER), z_to(QUARTER)),
        ),
        shown=Shown(camera="first"),
    ),
    Step(
        "sandwich",
        start,
        is_turned_as(asked),
        ((gate.set_joint(ABOUT_Z, QUARTER), 2.0), (gate.set_joint(ABOUT_X, -QUARTER), 2.0)),
        joints=(ABOUT_Z, ABOUT_Y, ABOUT_X),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis(
                "inverse", is_turned_as(lambda: rotation.conjugate(asked())), ((turned(y=QUARTER, x=QUARTER), 3.0),)
            ),
            Diagnosis("one_turn", rests_at(QUARTER), z_to(QUARTER)),
        ),
        shown=Shown(camera="first"),
    ),
    Step("write_both", start, line=TWICE),
    Step(
        "double_cover",
        start,
        is_itself_again,
        z_to(2 * TURN),
        joints=(ABOUT_Z,),
        prediction=Choice(right=2),
        diagnoses=(
            Diagnosis("once", is_opposite, z_to(TURN)),
            Diagnosis("half_turn", rests_at(HALF_TURN), z_to(HALF_TURN)),
        ),
        shown=Shown(camera="first"),
    ),
    Step(
        "slerp",
        start,
        rests_at(PART * WAY),
        z_to(PART * WAY),
        joints=(ABOUT_Z,),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("chord", rests_at(lerp_angle()), z_to(lerp_angle())),
            Diagnosis("half_angle", rests_at(PART * WAY / 2), z_to(PART * WAY / 2)),
            Diagnosis("other_end", rests_at((1 - PART) * WAY), z_to((1 - PART) * WAY)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "long_way",
        start,
        on_the_shorter_way,
        z_to((FAR - TURN) / 2),
        joints=(ABOUT_Z,),
        prediction=Estimate(lambda state, _: FAR / 2, "°", within=5.0),
        diagnoses=(
            Diagnosis("longer", rests_at(FAR / 2), z_to(FAR / 2)),
            Diagnosis("other_side", rests_at((TURN - FAR) / 2), z_to((TURN - FAR) / 2)),
            Diagnosis("the_end", rests_at(FAR - TURN), z_to(FAR - TURN)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "error",
        start,
        error_is_half,
        z_to(QUARTER - MISSING),
        joints=(ABOUT_Z,),
        prediction=Estimate(lambda state, _: sin(MISSING / 2), "", within=0.05),
        diagnoses=(
            Diagnosis("beyond", rests_at(QUARTER + MISSING), z_to(QUARTER + MISSING)),
            Diagnosis("whole_angle", rests_at(QUARTER - MISSING / 2), z_to(QUARTER - MISSING / 2)),
        ),
        shown=Shown(camera="top"),
    ),
    Step("write_error", start, line=WHAT_IS_MISSING),
    Step(
        "shorter_side",
        start,
        error_points_back,
        z_to(QUARTER - BEYOND),
        joints=(ABOUT_Z,),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("too_far", beyond_wanted, z_to(HALF_TURN)),
            Diagnosis("not_yet", away_from_wanted, z_to(-MISSING)),
        ),
        shown=Shown(camera="top"),
    ),
    Step("playground", start, playground=True, is_open=True, shown=Shown(layers=("playground",), camera="first")),
)
