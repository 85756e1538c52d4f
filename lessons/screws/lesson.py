"""Screws: axes, the turn by Rodrigues, Chasles' theorem, pitch, and what two hinges can do together."""

from __future__ import annotations

from dataclasses import replace
from math import pi, radians, sin

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady, PathChoice
from helicoide.geometry import motor, rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.motor import ScrewDisplacement
from helicoide.kinematics.forward import tool_by_screws
from helicoide.lesson import Choice, Diagnosis, Estimate, Order, Shown, Step, StepGoal, Value, fixed
from helicoide.seat import Seat, Selection
from helicoide.state import State
from helicoide.text import Text

TITLE = Text(en="Screws: turn and slide", pt_BR="Helicoides: girar e deslizar")
ABOUT = Text(
    en="Every motion of a rigid body is a turn about one line and a slide along it. Axis, angle, slide and pitch.",
    pt_BR="Todo movimento de um corpo rígido é um giro em torno de uma reta e um avanço ao longo dela: eixo, ângulo, "
    "avanço e passo.",
)
ROBOT = "movemaster"
NEEDS = ("drive_the_arm", "sine_to_motor")
SOURCES = (
    "Cerbaro 2022: tab. 8, eqs. 61, 62 (signs corrected)",
    "Coutinho 2015: eq. 2.7",
    "Selig 2005: ch. 2 (Chasles)",
)
OWN_ARM = True

WAIST, SHOULDER, ELBOW, WRIST, ROLL = range(5)
MOVED, AT_REST = radians(15.0), radians(3.0)
TURNED, WITHIN = radians(60.0), radians(2.0)
LONG = 0.200
LEAST_PITCH, MOST_PITCH = 0.150, 0.190
BOTH, NO_TURN, LEVEL = radians(20.0), radians(1.5), radians(5.0)
FEW, SLID = 0.005, 0.040
HALF_TURN, OVER = radians(170.0), radians(200.0)


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes, with a held orientation and the path at its beginning."""
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, path_choice=PathChoice(), path_s=0.0))


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def ready_pose(state: State) -> Array:
    """The pose of the tool at `ready`, T_world_tool (4, 4), m."""
    return tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))


def turned_by(state: State, joint: int) -> float:
    """How far a joint is from where it is in `ready`, rad."""
    return float(state.arm.q[joint] - state.robot.poses["ready"][joint])


def only_moved(state: State, joint: int) -> bool:
    """Whether this joint was turned, and no other, and all rest."""
    others = (k for k in range(len(state.arm.q)) if k != joint)
    return (
        abs(turned_by(state, joint)) >= MOVED
        and all(abs(turned_by(state, k)) <= AT_REST for k in others)
        and rests(state)
    )


def rests_after(joint: int) -> StepGoal:
    """Whether the arm rests with one joint turned, and no other."""
    return lambda state, seat: only_moved(state, joint)


def screw_from_base(state: State) -> ScrewDisplacement:
    """The screw that carries the base frame onto the frame of the tool."""
    return motor.screw_from_motor(rigid.motor_from_pose(state.T_world_tool))


def screw_from_ready(state: State) -> ScrewDisplacement:
    """The screw that carries the tool from its place in `ready` to where it is."""
    before = rigid.motor_from_pose(ready_pose(state))
    now = rigid.motor_from_pose(state.T_world_tool)
    return motor.screw_from_motor(CL031.product(now, CL031.conjugate(before)))


def waist_turned(state: State, seat: Seat) -> bool:
    """The waist rests where it was asked to."""
    return abs(turned_by(state, WAIST) - TURNED) <= WITHIN and rests(state)


def waist_turned_back(state: State, seat: Seat) -> bool:
    """The waist was turned against the right-hand rule."""
    return turned_by(state, WAIST) < -AT_REST and rests(state)


def radius(state: State) -> float:
    """The distance of the tool at `ready` from the axis of the waist, m."""
    return float(np.hypot(*ready_pose(state)[:2, 3]))


def chord(state: State, seat: Seat) -> float:
    """The straight way between the ends of the turn, m."""
    return 2 * radius(state) * sin(TURNED / 2)


def slides_far(state: State, seat: Seat) -> bool:
    """The screw from the base has a long slide, and the arm rests."""
    return abs(float(screw_from_base(state).displacement)) >= LONG and rests(state)


def stays_upright(state: State, seat: Seat) -> bool:
    """The arm was moved within its upright plane, and the slide is still zero."""
    was_moved = any(abs(turned_by(state, k)) > MOVED for k in range(len(state.arm.q)))
    return was_moved and abs(float(screw_from_base(state).displacement)) < FEW and rests(state)


def pitch_met(state: State, seat: Seat) -> bool:
    """The screw from the base is right-handed, with the pitch that was asked for."""
    return LEAST_PITCH <= float(screw_from_base(state).pitch) <= MOST_PITCH and rests(state)


def left_handed(state: State, seat: Seat) -> bool:
    """The screw from the base is left-handed."""
    return float(screw_from_base(state).pitch) < -LEAST_PITCH / 2 and rests(state)


def too_steep(state: State, seat: Seat) -> bool:
    """The pitch is larger than what was asked for."""
    return float(screw_from_base(state).pitch) > MOST_PITCH and rests(state)


def shifted(state: State, seat: Seat) -> bool:
    """Shoulder and elbow have turned, and yet the tool is only shifted."""
    both = min(abs(turned_by(state, SHOULDER)), abs(turned_by(state, ELBOW))) >= BOTH
    return bool(both and screw_from_ready(state).angle <= NO_TURN) and rests(state)


def same_sense(state: State, seat: Seat) -> bool:
    """Shoulder and elbow have turned in the same sense, so that the turns add up."""
    shoulder, elbow = turned_by(state, SHOULDER), turned_by(state, ELBOW)
    return shoulder * elbow > 0 and min(abs(shoulder), abs(elbow)) > LEVEL and rests(state)


def one_alone(state: State, seat: Seat) -> bool:
    """Of shoulder and elbow only one has turned."""
    far, near = sorted((abs(turned_by(state, SHOULDER)), abs(turned_by(state, ELBOW))), reverse=True)
    return far >= BOTH and near < LEVEL and rests(state)


def slid_by_hinges(state: State, seat: Seat) -> bool:
    """Waist and shoulder have turned, and the tool has slid along the axis of the whole motion."""
    both = min(abs(turned_by(state, WAIST)), abs(turned_by(state, SHOULDER))) >= BOTH
    return bool(both and abs(screw_from_ready(state).displacement) >= SLID) and rests(state)


def axes_meet(state: State, seat: Seat) -> bool:
    """Waist and roll have turned: their axes meet, so that nothing slides."""
    both = min(abs(turned_by(state, WAIST)), abs(turned_by(state, ROLL))) >= BOTH
    return bool(both and abs(screw_from_ready(state).displacement) < FEW) and rests(state)


def one_hinge(state: State, seat: Seat) -> bool:
    """Only one of the joints has turned."""
    return any(abs(turned_by(state, k)) >= BOTH and only_moved(state, k) for k in (WAIST, SHOULDER, ROLL))


def half_turned(state: State, seat: Seat) -> bool:
    """The screw from the base is nearly a half turn."""
    return bool(screw_from_base(state).angle >= HALF_TURN) and rests(state)


VALUES = {
    "moved": fixed(MOVED, "°"),
    "turned": fixed(TURNED, "°"),
    "within": fixed(WITHIN, "°"),
    "waist": Value(lambda state, _: state.arm.q[WAIST], "°"),
    "radius": Value(lambda state, _: radius(state), "mm"),
    "chord": Value(chord, "mm"),
    "arc": Value(lambda state, _: radius(state) * TURNED, "mm"),
    "way": Value(lambda state, _: float(np.linalg.norm(state.T_world_tool[:3, 3] - ready_pose(state)[:3, 3])), "mm"),
    "axis": Value(lambda state, _: screw_from_base(state).direction, "", 2),
    "angle": Value(lambda state, _: float(screw_from_base(state).angle), "°"),
    "slide": Value(lambda state, _: float(screw_from_base(state).displacement), "mm"),
    "pitch": Value(lambda state, _: 1e3 * float(screw_from_base(state).pitch), "mm/rad", 0),
    "fine_pitch": Value(lambda state, _: 1e3 * float(screw_from_base(state).pitch), "mm/rad", 1),
    "lead": Value(lambda state, _: 2 * pi * float(screw_from_base(state).pitch), "mm"),
    "long": fixed(LONG, "mm"),
    "least_pitch": fixed(1e3 * LEAST_PITCH, "mm/rad", 0),
    "most_pitch": fixed(1e3 * MOST_PITCH, "mm/rad", 0),
    "both": fixed(BOTH, "°"),
    "slid": fixed(SLID, "mm"),
    "level": fixed(NO_TURN, "°", 1),
    "shoulder_turn": Value(lambda state, _: turned_by(state, SHOULDER), "°"),
    "elbow_turn": Value(lambda state, _: turned_by(state, ELBOW), "°"),
    "waist_turn": Value(lambda state, _: turned_by(state, WAIST), "°"),
    "whole_turn": Value(lambda state, _: float(screw_from_ready(state).angle), "°"),
    "whole_slide": Value(lambda state, _: float(screw_from_ready(state).displacement), "mm"),
    "apart": Value(lambda state, _: state.robot.points[SHOULDER, 0] - state.robot.points[WAIST, 0], "mm"),
    "half_apart": Value(lambda state, _: (state.robot.points[SHOULDER, 0] - state.robot.points[WAIST, 0]) / 2, "mm"),
    "shoulder": Value(lambda state, _: state.robot.poses["ready"][SHOULDER], "°"),
    "elbow": Value(lambda state, _: state.robot.poses["ready"][ELBOW], "°"),
    "wrist": Value(lambda state, _: state.robot.poses["ready"][WRIST], "°"),
    "down": Value(lambda state, _: -sum(state.robot.poses["ready"][SHOULDER : WRIST + 1]), "°"),
    "half_turn": fixed(HALF_TURN, "°"),
    "over": fixed(OVER, "°"),
    "under": fixed(2 * pi - OVER, "°"),
}

STEPS = (
    Step(
        "axes",
        start,
        rests_after(SHOULDER),
        ((gate.set_joint(SHOULDER, radians(55.0)), 3.0),),
        joints=(WAIST, SHOULDER, ELBOW),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("four", rests_after(WAIST), ((gate.set_joint(WAIST, radians(40.0)), 3.0),)),
            Diagnosis("two", rests_after(ELBOW), ((gate.set_joint(ELBOW, radians(-40.0)), 3.0),)),
        ),
        shown=Shown(layers=("axes",), camera="side"),
    ),
    Step(
        "rodrigues",
        start,
        waist_turned,
        ((gate.set_joint(WAIST, TURNED), 3.0),),
        joints=(WAIST,),
        prediction=Estimate(chord, "mm", within=40.0),
        diagnoses=(Diagnosis("other_side", waist_turned_back, ((gate.set_joint(WAIST, -TURNED), 3.0),)),),
        shown=Shown(layers=("trail",), camera="top", selection=Selection("joint", WAIST)),
    ),
    Step(
        "chasles",
        start,
        slides_far,
        ((gate.set_joint(WAIST, radians(45.0)), 3.0),),
        joints=(WAIST, SHOULDER, ELBOW),
        prediction=Choice(right=2),
        diagnoses=(Diagnosis("upright", stays_upright, ((gate.set_joint(SHOULDER, radians(60.0)), 3.0),)),),
        shown=Shown(layers=("screw",), camera="first", selection=Selection("tool")),
    ),
    Step(
        "pitch",
        start,
        pitch_met,
        ((gate.set_joint(WAIST, radians(28.0)), 3.0),),
        joints=(WAIST, ROLL),
        prediction=Order(right=(2, 0, 3, 1)),
        diagnoses=(
            Diagnosis("left_handed", left_handed, ((gate.set_joint(WAIST, radians(-28.0)), 3.0),)),
            Diagnosis("too_steep", too_steep, ((gate.set_joint(WAIST, radians(70.0)), 3.0),)),
        ),
        shown=Shown(layers=("screw",), camera="first", selection=Selection("tool")),
    ),
    Step(
        "opposite",
        start,
        shifted,
        ((gate.set_joint(SHOULDER, radians(60.0)), 3.0), (gate.set_joint(ELBOW, radians(-105.0)), 3.0)),
        joints=(SHOULDER, ELBOW),
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(
            Diagnosis(
                "same_sense",
                same_sense,
                ((gate.set_joint(SHOULDER, radians(60.0)), 3.0), (gate.set_joint(ELBOW, radians(-45.0)), 3.0)),
            ),
            Diagnosis("one_alone", one_alone, ((gate.set_joint(SHOULDER, radians(60.0)), 3.0),)),
        ),
        shown=Shown(layers=("axes", "trail"), camera="side"),
    ),
    Step(
        "hinges",
        start,
        slid_by_hinges,
        ((gate.set_joint(WAIST, radians(45.0)), 3.0), (gate.set_joint(SHOULDER, radians(75.0)), 3.0)),
        joints=(WAIST, SHOULDER, ROLL),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis(
                "axes_meet",
                axes_meet,
                ((gate.set_joint(WAIST, radians(45.0)), 3.0), (gate.set_joint(ROLL, radians(45.0)), 3.0)),
            ),
            Diagnosis("one_hinge", one_hinge, ((gate.set_joint(WAIST, radians(60.0)), 3.0),)),
        ),
        shown=Shown(layers=("axes", "twist"), camera="first"),
    ),
    Step(
        "half_turn",
        start,
        half_turned,
        ((gate.set_joint(ROLL, radians(175.0)), 4.0),),
        joints=tuple(range(5)),
        prediction=Choice(right=1),
        shown=Shown(layers=("screw",), camera="first", selection=Selection("tool")),
        is_open=True,
    ),
    Step(
        "explore",
        start,
        joints=tuple(range(5)),
        shown=Shown(layers=("axes", "screw", "twist"), camera="first", selection=Selection("tool")),
        is_open=True,
    ),
)
