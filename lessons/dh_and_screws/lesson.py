"""Denavit-Hartenberg rows and successive screws: what each needs, one pose by both, and what a moved frame changes."""

from __future__ import annotations

from dataclasses import replace
from math import cos, radians, sin, tan

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady
from helicoide.kinematics.dh import DhRow, dh_from_screws
from helicoide.kinematics.forward import screw_displacements, tool_by_dh, tool_by_screws
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step, StepGoal, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import Text

TITLE = Text(en="DH rows and screws", pt_BR="Linhas de DH e helicoides")
ABOUT = Text(
    en="Two descriptions of one arm: frames from joint to joint, or lines in the base frame. One pose, other numbers.",
    pt_BR="Duas descrições de um braço: referenciais de junta em junta, ou retas no referencial da base. A mesma pose, "
    "outros números.",
)
ROBOT = "movemaster"
NEEDS = ("frames", "screws")
SOURCES = (
    "Cerbaro 2022: tabs. 6, 8, eqs. 4–8, 57, 59, 61, 62 (d1 and signs corrected), App. D",
    "Campos 1998: s. 40 (rows by Craig's convention)",
)
OWN_ARM = True

SHOULDER, ELBOW, WRIST_PITCH, ROLL = 1, 2, 3, 4
MOVED, NEAR = radians(15.0), radians(2.0)
QUARTER = radians(90.0)
PRINTED_PLACE = np.array([0.470429, 0.271602, 0.300000])  # eq. 5
PRINTED_SHIFT = np.array([-0.084641, 0.413012, 1.010140])  # of H in eq. 8
PRINTED_D1 = 0.0
SLID, LONGER = 0.050, 0.030
TILT = radians(1.0)


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes, with a held orientation."""
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def only_moved(joint: int) -> StepGoal:
    """Whether the arm rests with one joint moved from `ready`, and no other."""

    def is_moved(state: State, seat: Seat) -> bool:
        away = np.abs(state.arm.q - state.robot.poses["ready"])
        return bool(away[joint] >= MOVED and np.delete(away, joint).max() <= NEAR) and rests(state)

    return is_moved


def wrist_pitch_at(angle: float) -> StepGoal:
    """Whether the arm rests with the wrist pitch at an angle, rad."""
    return lambda state, seat: abs(float(state.arm.q[WRIST_PITCH]) - angle) <= NEAR and rests(state)


def rests_near(q: Array, state: State) -> bool:
    """Whether the arm rests near joint values (n,), rad."""
    return bool(np.abs(state.arm.q - q).max() <= NEAR) and rests(state)


def stretched(state: State, seat: Seat) -> bool:
    """All joints are at zero."""
    return rests_near(np.zeros_like(state.arm.q), state)


def level_only(state: State, seat: Seat) -> bool:
    """The gripper is level, but the arm is bent."""
    level = abs(float(state.arm.q[SHOULDER : WRIST_PITCH + 1].sum())) <= NEAR
    return level and not stretched(state, seat) and rests(state)


def example(state: State) -> Array:
    """The joint values of Cerbaro's example, (n,), rad."""
    return np.array(state.robot.poses["example"])


def at_example(state: State, seat: Seat) -> bool:
    """The arm is in the posture of the example."""
    return rests_near(example(state), state)


def roll_missing(state: State, seat: Seat) -> bool:
    """All joints are as in the example but the roll, which does not move the place of the tool."""
    away = np.abs(state.arm.q - example(state))
    return bool(away[:ROLL].max() <= NEAR < away[ROLL]) and rests(state)


def by_dh(state: State) -> Array:
    """The pose of the tool from the DH rows, (4, 4), m."""
    return tool_by_dh(state.robot, state.arm.q)


def by_screws(state: State) -> Array:
    """The pose of the tool from the screws, (4, 4), m."""
    return tool_by_screws(state.robot, state.arm.q)


def height_as_printed(state: State, seat: Seat) -> float:
    """The height of the tool in the example with the printed d₁, m."""
    wrong = state.robot.dh.rows[0].d - PRINTED_D1
    return float(tool_by_dh(state.robot, example(state))[2, 3] - wrong)


def tilted_row(state: State) -> DhRow:
    """The DH row of the shoulder, if the axis of the elbow is tilted in the plane of both axes."""
    joints = list(state.robot.joints)
    joints[ELBOW] = replace(joints[ELBOW], direction=np.array([sin(TILT), -cos(TILT), 0.0]))
    return dh_from_screws(joints, state.robot.T_world_tool_0).rows[SHOULDER]


def upper_arm(state: State) -> float:
    """The distance between the axes of shoulder and elbow, m."""
    return float(state.robot.dh.rows[SHOULDER].a)


VALUES = {
    "moved": fixed(MOVED, "°"),
    "elbow": Value(lambda state, _: state.arm.q[ELBOW], "°"),
    "theta_4": Value(lambda state, _: state.robot.dh.rows[WRIST_PITCH].theta + state.arm.q[WRIST_PITCH], "°"),
    "wrist_pitch": Value(lambda state, _: state.arm.q[WRIST_PITCH], "°"),
    "offset": Value(lambda state, _: state.robot.dh.rows[WRIST_PITCH].theta, "°"),
    "within": fixed(NEAR, "°"),
    "slid": fixed(SLID, "mm"),
    "shoulder_axis": Value(lambda state, _: state.robot.joints[SHOULDER].direction, "", 0),
    "shoulder_point": Value(lambda state, _: state.robot.joints[SHOULDER].point, "mm"),
    "elbow_at_zero": Value(lambda state, _: state.robot.joints[ELBOW].point, "mm"),
    "elbow_now": Value(lambda state, _: state.arm.poses[ELBOW + 1, :3, 3], "mm"),
    "tool_at_zero": Value(lambda state, _: state.robot.T_world_tool_0[:3, 3], "mm"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "example": Value(lambda state, _: example(state), "°"),
    "printed_place": fixed(PRINTED_PLACE, "mm", 3),
    "printed_shift": fixed(PRINTED_SHIFT, "mm", 3),
    "printed_d1": fixed(PRINTED_D1, "mm"),
    "motion": Value(lambda state, _: screw_displacements(state.robot, example(state))[-1], "", 3),
    "waist_point": Value(lambda state, _: state.robot.joints[0].point, "mm"),
    "wrist_point": Value(lambda state, _: state.robot.joints[WRIST_PITCH].point, "mm"),
    "roll_point": Value(lambda state, _: state.robot.joints[ROLL].point, "mm"),
    "d1": Value(lambda state, _: state.robot.dh.rows[0].d, "mm"),
    "height_as_printed": Value(height_as_printed, "mm"),
    "dh_place": Value(lambda state, _: by_dh(state)[:3, 3], "mm", 1),
    "screw_place": Value(lambda state, _: by_screws(state)[:3, 3], "mm", 1),
    "screw_shift": Value(lambda state, _: screw_displacements(state.robot, state.arm.q)[-1][:3, 3], "mm"),
    "longer": fixed(LONGER, "mm"),
    "upper_arm": Value(lambda state, _: upper_arm(state), "mm"),
    "longer_arm": Value(lambda state, _: upper_arm(state) + LONGER, "mm"),
    "tilt": fixed(TILT, "°"),
    "meeting": Value(lambda state, _: upper_arm(state) / tan(TILT), "m", 1),
    "tilted_d": Value(lambda state, _: abs(tilted_row(state).d), "m", 1),
    "tilted_a": Value(lambda state, _: abs(tilted_row(state).a), "mm"),
    "tilted_axis": fixed(np.array([sin(TILT), -cos(TILT), 0.0]), "", 3),
}

ONE_ROW = LineExercise(
    "chain",
    (
        GivenName("theta", "angle", Text(en="the angle about z", pt_BR="o ângulo em torno de z")),
        GivenName("d", "length", Text(en="the shift along z", pt_BR="o deslocamento ao longo de z")),
        GivenName("a", "length", Text(en="the shift along the new x", pt_BR="o deslocamento ao longo do novo x")),
        GivenName("alpha", "angle", Text(en="the angle about the new x", pt_BR="o ângulo em torno do novo x")),
    ),
    "B*translator(a, 0, 0)*rotor(1, 0, 0, alpha)",
    steps=(("B", "rotor(0, 0, 1, theta)*translator(0, 0, d)"),),
    sign_counts=False,
    title=Text(en="one row of the DH table", pt_BR="uma linha da tabela de DH"),
)
TWO_SCREWS = LineExercise(
    "chain",
    (
        GivenName("K1", "line", Text(en="the axis of joint 1 at zero", pt_BR="o eixo da junta 1 no zero")),
        GivenName("q1", "angle", Text(en="the angle of joint 1", pt_BR="o ângulo da junta 1")),
        GivenName("K2", "line", Text(en="the axis of joint 2 at zero", pt_BR="o eixo da junta 2 no zero")),
        GivenName("q2", "angle", Text(en="the angle of joint 2", pt_BR="o ângulo da junta 2")),
        GivenName("M0", "motor", Text(en="the end effector at zero", pt_BR="o efetuador no zero")),
    ),
    "screw(K1, q1)*screw(K2, q2)*M0",
    sign_counts=False,
    title=Text(
        en="the end effector after the turns of two joints", pt_BR="o efetuador depois dos giros de duas juntas"
    ),
)
ALL_JOINTS = tuple(range(5))

STEPS = (
    Step(
        "which_frame",
        start,
        only_moved(ELBOW),
        ((gate.set_joint(ELBOW, radians(-40.0)), 3.0),),
        joints=(SHOULDER, ELBOW, WRIST_PITCH),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("shoulder", only_moved(SHOULDER), ((gate.set_joint(SHOULDER, radians(50.0)), 3.0),)),
            Diagnosis("wrist", only_moved(WRIST_PITCH), ((gate.set_joint(WRIST_PITCH, radians(20.0)), 3.0),)),
        ),
        shown=Shown(layers=("dh",), camera="side"),
    ),
    Step(
        "four_numbers",
        start,
        wrist_pitch_at(-QUARTER),
        ((gate.set_joint(WRIST_PITCH, -QUARTER), 3.0),),
        joints=(WRIST_PITCH,),
        prediction=Choice(right=2),
        diagnoses=(
            Diagnosis("joint_zero", wrist_pitch_at(0.0), ((gate.set_joint(WRIST_PITCH, 0.0), 3.0),)),
            Diagnosis("other_sign", wrist_pitch_at(QUARTER), ((gate.set_joint(WRIST_PITCH, QUARTER), 3.0),)),
        ),
        shown=Shown(layers=("dh",), camera="side"),
    ),
    Step("write_row", start, line=ONE_ROW),
    Step(
        "lines_at_zero",
        start,
        stretched,
        ((gate.go_to("zero"), 4.0),),
        joints=ALL_JOINTS,
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("level", level_only, ((gate.set_joint(WRIST_PITCH, radians(45.0)), 3.0),)),),
        shown=Shown(layers=("axes",), camera="side"),
    ),
    Step("write_chain", start, line=TWO_SCREWS),
    Step(
        "one_pose",
        start,
        at_example,
        ((gate.go_to("example"), 5.0),),
        joints=ALL_JOINTS,
        prediction=Estimate(height_as_printed, "mm", within=20.0),
        diagnoses=(
            Diagnosis(
                "without_roll", roll_missing, ((gate.set_joints(np.radians([30.0, 60.0, -90.0, -30.0, 0.0])), 4.0),)
            ),
        ),
        shown=Shown(layers=("dh",), camera="first"),
    ),
    Step("longer", start, prediction=Choice(right=0), shown=Shown(layers=("dh",), camera="side")),
    Step(
        "almost_parallel",
        start,
        prediction=Estimate(lambda state, seat: upper_arm(state) / tan(TILT), "m", within=2.0),
        shown=Shown(layers=("axes",), camera="first"),
    ),
    Step("explore", start, joints=ALL_JOINTS, shown=Shown(layers=("axes",), camera="first"), is_open=True),
)
