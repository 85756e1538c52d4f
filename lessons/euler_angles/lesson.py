"""Euler angles: three angles for an orientation, fixed and moving axes, two triples for one, and gimbal lock."""

from __future__ import annotations

from math import cos, radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady
from helicoide.geometry import rotation
from helicoide.geometry.euler import ROLL_PITCH_YAW, euler_angles, euler_matrix
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step, StepGoal, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat, Selection
from helicoide.state import State, Update
from helicoide.text import Text

TITLE = Text(en="Roll, pitch, yaw", pt_BR="Rolagem, arfagem, guinada")
ABOUT = Text(
    en="Three angles for an orientation: about which axes, in which order, twice the same, and where they fail.",
    pt_BR="Três ângulos para uma orientação: em torno de que eixos, em que ordem, duas vezes a mesma, e onde falham.",
)
ROBOT = "movemaster"
NEEDS = ("frames", "quaternions")
SOURCES = (
    "Cerbaro 2022: eqs. 53–55 (which name them differently)",
    "Vargas 2013: eqs. 2.26, 2.27 (representation singularities)",
)
OWN_ARM = True

WAIST, SHOULDER, ELBOW, WRIST_PITCH, ROLL = range(5)
BY_HAND = (WAIST, WRIST_PITCH, ROLL)
FIRST = tuple(map(radians, (30.0, 30.0, 45.0)))  # yaw, pitch, roll
NEAR, AT_REST = radians(2.0), radians(3.0)
RAISED = radians(10.0)
QUARTER, HALF_TURN = radians(90.0), radians(180.0)
ROLLED = radians(60.0)
QUESTION, SAME = tuple(map(radians, (20.0, 60.0, 10.0))), tuple(map(radians, (200.0, 120.0, 190.0)))
ASKED, REACHABLE = tuple(map(radians, (180.0, 120.0, -150.0))), tuple(map(radians, (0.0, 60.0, 30.0)))
DOWN = radians(90.0)
BOTH, LEAST_WAIST, DOWN_WITHIN = radians(40.0), radians(30.0), radians(1.0)
STEEP, SIDEWAYS = radians(85.0), radians(10.0)  # rad; rad/s
LEAST_FACTOR, MOST_FACTOR, HUGE = 10.0, 20.0, 50.0
LIFTED = radians(55.0)


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes, with a held orientation."""
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def angles(state: State, seat: Seat) -> Array:
    """Yaw, pitch and roll of the tool about moving axes z, y, x, (3,), rad."""
    return euler_angles(state.T_world_tool[:3, :3], ROLL_PITCH_YAW).values


def by_joints(state: State) -> Array:
    """Yaw, pitch and roll as the joints of this arm make them, without an end at ±90° or ±180°, (3,), rad."""
    q = state.arm.q
    return np.array([q[WAIST], -(q[SHOULDER] + q[ELBOW] + q[WRIST_PITCH]), q[ROLL]])


def joints_at(triple: tuple[float, ...]) -> Update:
    """Ask for yaw, pitch and roll, rad, by waist, wrist pitch and roll; shoulder and elbow as in `ready`."""

    def change(state: State) -> State:
        q = np.array(state.robot.poses["ready"])
        yaw, pitch, roll = triple
        q[WAIST], q[WRIST_PITCH], q[ROLL] = yaw, -pitch - q[SHOULDER] - q[ELBOW], roll
        return gate.set_joints(q)(state)

    return change


def rests_at(triple: tuple[float, ...]) -> StepGoal:
    """Whether the joints rest at yaw, pitch and roll, rad."""
    return lambda state, seat: bool(np.abs(by_joints(state) - triple).max() <= NEAR) and rests(state)


def turn_from(triple: tuple[float, ...], state: State) -> float:
    """The angle between the orientation of the tool and that of yaw, pitch, roll, rad."""
    R = euler_matrix(triple, ROLL_PITCH_YAW)
    return float(np.linalg.norm(rotation.logarithm(R.T @ state.T_world_tool[:3, :3])))


def is_oriented(triple: tuple[float, ...]) -> StepGoal:
    """Whether the tool rests in the orientation of yaw, pitch, roll, rad, whichever joint values make it."""
    return lambda state, seat: turn_from(triple, state) <= NEAR and rests(state)


def pitch_axis_along_x(state: State, seat: Seat) -> bool:
    """The axis of the wrist pitch is parallel to the x axis of the room."""
    return bool(abs(abs(state.arm.q[WAIST]) - QUARTER) <= NEAR) and rests(state)


def only_rolled(state: State, seat: Seat) -> bool:
    """The roll has turned, the waist has not."""
    return bool(abs(state.arm.q[ROLL]) >= ROLLED and abs(state.arm.q[WAIST]) <= AT_REST) and rests(state)


def points_down(state: State) -> bool:
    """Whether the gripper points straight down."""
    return bool(abs(by_joints(state)[1] - DOWN) <= DOWN_WITHIN)


def waist_swung(state: State) -> bool:
    """Whether the waist has turned far enough, and the arm rests."""
    return bool(abs(state.arm.q[WAIST]) >= LEAST_WAIST) and rests(state)


def turned_when_down(state: State, seat: Seat) -> float:
    """How far the gripper is turned from where it points down with waist and roll at zero, rad."""
    return turn_from((0.0, DOWN, 0.0), state)


def unturned(state: State, seat: Seat) -> bool:
    """The gripper points down, the waist has turned, and yet the orientation is that of waist and roll at zero."""
    return points_down(state) and turned_when_down(state, seat) <= NEAR and waist_swung(state)


def waist_alone(state: State, seat: Seat) -> bool:
    """The gripper points down, and the waist has turned without the roll."""
    return points_down(state) and bool(abs(state.arm.q[ROLL]) <= AT_REST) and waist_swung(state)


def turns_added(state: State, seat: Seat) -> bool:
    """The gripper points down, and waist and roll have turned in opposite senses."""
    return points_down(state) and bool(state.arm.q[WAIST] * state.arm.q[ROLL] < -(AT_REST**2)) and waist_swung(state)


def not_down(state: State, seat: Seat) -> bool:
    """Waist and roll have turned alike, but the gripper does not point down."""
    q = state.arm.q
    return not points_down(state) and bool(abs(q[WAIST] - q[ROLL]) <= NEAR) and waist_swung(state)


def factor(state: State, seat: Seat) -> float:
    """How many times faster than the gripper tips sideways the roll has to turn, at most 999."""
    return min(1 / max(abs(cos(by_joints(state)[1])), 1e-9), 999.0)


def steep_enough(state: State, seat: Seat) -> bool:
    """The factor is large, but the gripper is not straight down."""
    return LEAST_FACTOR <= factor(state, seat) <= MOST_FACTOR and rests(state)


def locked(state: State, seat: Seat) -> bool:
    """The gripper is practically straight down or up."""
    return factor(state, seat) >= HUGE and rests(state)


def lifted(state: State, seat: Seat) -> bool:
    """The gripper was lifted away from straight down."""
    return bool(by_joints(state)[1] <= LIFTED) and rests(state)


def margin(state: State, seat: Seat) -> float:
    """The distance of the orientation from the singularity of the chosen convention, rad."""
    return float(euler_angles(state.T_world_tool[:3, :3], seat.notation.euler).singularity_margin)


def triple(values: tuple[float, ...]) -> Value:
    """Three angles that do not change."""
    return fixed(np.array(values), "°")


VALUES = {
    "angles": Value(angles, "°"),
    "first": triple(FIRST),
    "within": fixed(NEAR, "°"),
    "raised": fixed(RAISED, "°"),
    "quarter": fixed(QUARTER, "°"),
    "waist": Value(lambda state, _: state.arm.q[WAIST], "°"),
    "question_yaw": fixed(QUESTION[0], "°"),
    "question_pitch": fixed(QUESTION[1], "°"),
    "question_roll": fixed(QUESTION[2], "°"),
    "same_yaw": fixed(SAME[0], "°"),
    "same_pitch": fixed(SAME[1], "°"),
    "same_roll": fixed(SAME[2], "°"),
    "asked": triple(ASKED),
    "half_turn": fixed(HALF_TURN, "°"),
    "asked_turn": Value(lambda state, seat: turn_from(ASKED, state), "°"),
    "down": fixed(DOWN, "°"),
    "down_within": fixed(DOWN_WITHIN, "°"),
    "both": fixed(BOTH, "°"),
    "twice": fixed(2 * BOTH, "°"),
    "least_waist": fixed(LEAST_WAIST, "°"),
    "pitch": Value(lambda state, _: by_joints(state)[1], "°", 1),
    "turned": Value(turned_when_down, "°"),
    "steep": fixed(STEEP, "°"),
    "sideways": fixed(SIDEWAYS, "°/s"),
    "roll_rate": fixed(SIDEWAYS / cos(STEEP), "°/s"),
    "fastest": Value(lambda state, _: state.problem.limits.speed[ROLL], "°/s"),
    "factor": Value(factor, "", 1),
    "least_factor": fixed(LEAST_FACTOR, "", 0),
    "most_factor": fixed(MOST_FACTOR, "", 0),
    "huge": fixed(HUGE, "", 0),
    "margin": Value(margin, "°"),
}

THREE_TURNS = LineExercise(
    "quaternion product",
    (
        GivenName("qz", "rotation", Text(en="the turn about the z axis", pt_BR="o giro em torno do eixo z")),
        GivenName("qy", "rotation", Text(en="the turn about the y axis", pt_BR="o giro em torno do eixo y")),
        GivenName("qx", "rotation", Text(en="the turn about the x axis", pt_BR="o giro em torno do eixo x")),
    ),
    "qx*qy*qz",
    steps=(("m", "qz*qy*qx"),),
)

STEPS = (
    Step(
        "three_angles",
        start,
        rests_at(FIRST),
        ((joints_at(FIRST), 4.0),),
        joints=BY_HAND,
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis(
                "upward",
                rests_at((FIRST[0], -FIRST[1], FIRST[2])),
                ((joints_at((FIRST[0], -FIRST[1], FIRST[2])), 4.0),),
            ),
            Diagnosis("roll_sense", rests_at((*FIRST[:2], -FIRST[2])), ((joints_at((*FIRST[:2], -FIRST[2])), 4.0),)),
        ),
        shown=Shown(layers=("frames",), camera="first"),
    ),
    Step(
        "which_axis",
        start,
        pitch_axis_along_x,
        ((gate.set_joint(WAIST, QUARTER), 4.0),),
        joints=BY_HAND,
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("rolled", only_rolled, ((gate.set_joint(ROLL, QUARTER), 4.0),)),),
        shown=Shown(layers=("axes",), camera="first"),
    ),
    Step("write", start, line=THREE_TURNS),
    Step(
        "two_triples",
        start,
        is_oriented(ASKED),
        ((joints_at(REACHABLE), 4.0),),
        joints=BY_HAND,
        prediction=Estimate(lambda state, seat: SAME[1], "°", within=5.0),
        diagnoses=(
            Diagnosis("pitch_copied", rests_at((0.0, ASKED[1], 0.0)), ((joints_at((0.0, ASKED[1], 0.0)), 4.0),)),
            Diagnosis(
                "roll_copied", rests_at((*REACHABLE[:2], ASKED[2])), ((joints_at((*REACHABLE[:2], ASKED[2])), 4.0),)
            ),
        ),
        shown=Shown(layers=("frames",), camera="first"),
    ),
    Step(
        "lock",
        start,
        unturned,
        ((joints_at((0.0, DOWN, 0.0)), 3.0), (joints_at((BOTH, DOWN, BOTH)), 4.0)),
        joints=BY_HAND,
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("waist_alone", waist_alone, ((joints_at((BOTH, DOWN, 0.0)), 4.0),)),
            Diagnosis("added", turns_added, ((joints_at((BOTH, DOWN, -BOTH)), 4.0),)),
            Diagnosis("not_down", not_down, ((gate.set_joint(WAIST, BOTH), 3.0), (gate.set_joint(ROLL, BOTH), 3.0))),
        ),
        shown=Shown(layers=("axes",), camera="first"),
    ),
    Step(
        "near",
        start,
        steep_enough,
        ((joints_at((0.0, radians(85.5), 0.0)), 3.0),),
        joints=(WRIST_PITCH,),
        prediction=Estimate(lambda state, seat: SIDEWAYS / cos(STEEP), "°/s", within=15.0),
        diagnoses=(
            Diagnosis("locked", locked, ((joints_at((0.0, DOWN, 0.0)), 3.0),)),
            Diagnosis("lifted", lifted, ((joints_at((0.0, radians(40.0), 0.0)), 3.0),)),
        ),
        shown=Shown(layers=("axes",), camera="side"),
    ),
    Step(
        "explore",
        start,
        joints=tuple(range(5)),
        shown=Shown(layers=("axes", "frames"), camera="first", selection=Selection("tool")),
        is_open=True,
    ),
)
