"""Pulses: from joint angles to encoder counts, what one pulse moves, the coupled wrist, the zero, and a retrofit."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Order, Shown, Step, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    ASKED_AT,
    COMPUTED,
    ELBOW,
    MEASURED,
    MOTOR_RANGE,
    OFF,
    PITCH,
    RAISED,
    READ_AT,
    READING,
    ROLL,
    SHOULDER,
    STRETCHED,
    WAIST,
    WITHIN,
    at_the_limit,
    axis_distance,
    counts,
    is_bent,
    is_home,
    is_stretched,
    lever,
    motor_angle,
    motor_beyond,
    off_by_more,
    off_by_one,
    pitch_lowered,
    pitch_raised,
    pulse_size,
    pulses_per_deg,
    ready,
    rounding,
    same_sense,
    start,
    stretched,
    sum_of_halves,
    tool_moved,
    waist_read,
    waist_turned_back,
    worst_rounding,
)

TITLE = Text(en="From angles to pulses", pt_BR="De ângulos a pulsos")
ABOUT = Text(
    en="What the encoders of a rebuilt arm count: resolution, rounding, a coupled wrist, the zero, and why fine is not "
    "exact.",
    pt_BR="O que contam os encoders de um braço reconstruído: resolução, arredondamento, punho acoplado, o zero, e por "
    "que fino não é exato.",
)
ROBOT = "movemaster"
NEEDS = ("drive_the_arm", "screws")
SOURCES = ("Cerbaro 2022: §3.2, tabs. 2–4, fig. 20 (coupling), quadros 3–5; eq. 6 and fig. 26 (measured)",)

# A degree of each motor in pulses, and back (tab. 4, fig. 20): what the fifth joint angle is, from two counts.
READ_BACK = LineExercise(
    "chain",
    (
        GivenName("n4", "number", Text(en="count of motor 4", pt_BR="contagem do motor 4")),
        GivenName("n5", "number", Text(en="count of motor 5", pt_BR="contagem do motor 5")),
        GivenName("p4", "number", Text(en="pulses per degree of motor 4", pt_BR="pulsos por grau do motor 4")),
        GivenName("p5", "number", Text(en="pulses per degree of motor 5", pt_BR="pulsos por grau do motor 5")),
    ),
    "n5/p5 + b",
    steps=(("b", "n4/p4"),),
    title=Text(en="from pulses to the angles of joints, in degrees", pt_BR="de pulsos a ângulos de junta, em graus"),
)
VALUES = {
    "read_at": fixed(READ_AT, "°"),
    "within": fixed(WITHIN, "°"),
    "asked_at": fixed(ASKED_AT, "°"),
    "count_waist": Value(lambda state, _: counts(state)[WAIST], "", 0),
    "count_5": Value(lambda state, _: counts(state)[ROLL], "", 0),
    "counts": Value(lambda state, _: counts(state), "", 0),
    "per_deg": Value(lambda state, _: pulses_per_deg(state, WAIST), "", 0),
    "per_deg_2": Value(lambda state, _: pulses_per_deg(state, SHOULDER), "", 0),
    "per_deg_3": Value(lambda state, _: pulses_per_deg(state, ELBOW), "", 0),
    "per_deg_4": Value(lambda state, _: pulses_per_deg(state, PITCH), "", 0),
    "per_deg_5": Value(lambda state, _: pulses_per_deg(state, ROLL), "", 0),
    "at_asked": Value(lambda state, _: pulses_per_deg(state, WAIST) * np.degrees(ASKED_AT), "", 0),
    "one_pulse": Value(lambda state, _: radians(1.0) / pulses_per_deg(state, WAIST), "°", 4),
    "long": fixed(STRETCHED, "mm"),
    "waist_axis": Value(lambda state, _: axis_distance(state, WAIST), "mm"),
    "shoulder_axis": Value(lambda state, _: axis_distance(state, SHOULDER), "mm"),
    "pitch_axis": Value(lambda state, _: axis_distance(state, PITCH), "mm"),
    "waist_far": Value(lambda state, _: pulse_size(state, stretched(state), WAIST), "mm", 3),
    "shoulder_far": Value(lambda state, _: pulse_size(state, stretched(state), SHOULDER), "mm", 3),
    "pitch_far": Value(lambda state, _: pulse_size(state, stretched(state), PITCH), "mm", 3),
    "roll_far": Value(lambda state, _: pulse_size(state, stretched(state), ROLL), "mm", 3),
    "waist_near": Value(lambda state, _: pulse_size(state, ready(state), WAIST), "mm", 3),
    "shoulder_near": Value(lambda state, _: pulse_size(state, ready(state), SHOULDER), "mm", 3),
    "elbow_near": Value(lambda state, _: pulse_size(state, ready(state), ELBOW), "mm", 3),
    "pitch_near": Value(lambda state, _: pulse_size(state, ready(state), PITCH), "mm", 3),
    "worst": Value(lambda state, _: worst_rounding(state), "mm", 3),
    "halves": Value(lambda state, _: sum_of_halves(state, ready(state)), "mm", 3),
    "halves_far": Value(lambda state, _: sum_of_halves(state, stretched(state)), "mm", 3),
    "rounding": Value(lambda state, _: rounding(state), "mm", 4),
    "raised": fixed(RAISED, "°"),
    "pitch": Value(lambda state, _: state.arm.q[PITCH], "°", 2),
    "roll": Value(lambda state, _: state.arm.q[ROLL], "°", 2),
    "count_home": Value(
        lambda state, _: np.degrees(state.robot.poses["home"][SHOULDER]) * pulses_per_deg(state, SHOULDER), "", 0
    ),
    "home_shoulder": Value(lambda state, _: state.robot.poses["home"][SHOULDER], "°"),
    "shoulder_upper": Value(lambda state, _: state.robot.upper[SHOULDER], "°"),
    "off": fixed(OFF, "°"),
    "lever": Value(lambda state, _: lever(state), "mm"),
    "astray": Value(lambda state, _: OFF * lever(state), "mm", 1),
    "tool_moved": Value(lambda state, _: tool_moved(state), "mm", 1),
    "pulses_off": Value(lambda state, _: np.degrees(OFF) * pulses_per_deg(state, SHOULDER), "", 0),
    "computed": fixed(np.array(COMPUTED), "mm", 1),
    "measured": fixed(np.array(MEASURED), "mm"),
    "differ": fixed(float(np.linalg.norm(np.subtract(COMPUTED, MEASURED))), "mm", 1),
    "reading_pitch": Value(lambda state, _: state.robot.poses[READING][PITCH], "°"),
    "reading_roll": Value(lambda state, _: state.robot.poses[READING][ROLL], "°"),
    "reading_motor": Value(lambda state, _: motor_angle(state.robot.poses[READING]), "°"),
    "motor": Value(lambda state, _: motor_angle(state.arm.q), "°"),
    "motor_range": fixed(MOTOR_RANGE, "°"),
}

STEPS = (
    Step(
        "count",
        start,
        waist_read,
        ((gate.set_joint(WAIST, READ_AT), 3.0),),
        joints=(WAIST,),
        prediction=Estimate(lambda state, _: pulses_per_deg(state, WAIST) * np.degrees(ASKED_AT), "", within=300.0),
        diagnoses=(Diagnosis("other_side", waist_turned_back, ((gate.set_joint(WAIST, -READ_AT), 3.0),)),),
        shown=Shown(camera="top"),
    ),
    Step(
        "resolution",
        start,
        is_stretched,
        ((gate.go_to("zero"), 4.0),),
        prediction=Order(right=(3, 1, 2, 0), reveal="done"),
        diagnoses=(Diagnosis("bent", is_bent, ((gate.set_joint(ELBOW, radians(-110.0)), 3.0),)),),
        joints=(SHOULDER, ELBOW, PITCH),
        shown=Shown(layers=("axes",), camera="side", tab="robot"),
    ),
    Step(
        "rounding",
        start,
        prediction=Estimate(lambda state, _: sum_of_halves(state, ready(state)), "mm", within=0.01),
        shown=Shown(layers=("axes",), camera="first"),
    ),
    Step(
        "coupling",
        start,
        pitch_raised,
        ((gate.set_joint(PITCH, radians(15.0)), 3.0),),
        joints=(PITCH, ROLL),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(Diagnosis("lowered", pitch_lowered, ((gate.set_joint(PITCH, radians(-60.0)), 3.0),)),),
        shown=Shown(layers=("axes",), camera="side"),
    ),
    Step("read_back", start, line=READ_BACK, joints=(PITCH, ROLL)),
    Step(
        "motor_range",
        start,
        motor_beyond,
        ((gate.set_joint(PITCH, radians(80.0)), 2.5), (gate.set_joint(ROLL, radians(-140.0)), 3.0)),
        joints=(PITCH, ROLL),
        prediction=Estimate(lambda state, _: motor_angle(state.robot.poses[READING]), "°", within=1.0),
        diagnoses=(
            Diagnosis(
                "same_sense",
                same_sense,
                ((gate.set_joint(PITCH, radians(60.0)), 2.5), (gate.set_joint(ROLL, radians(100.0)), 3.0)),
            ),
        ),
        shown=Shown(layers=("axes",), camera="side"),
    ),
    Step(
        "homing",
        start,
        is_home,
        ((gate.park(), 6.0),),
        joints=(SHOULDER,),
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("at_limit", at_the_limit, ((gate.set_joint(SHOULDER, radians(100.0)), 4.0),)),),
        shown=Shown(camera="side", tab="robot"),
    ),
    Step(
        "accuracy",
        start,
        off_by_one,
        ((gate.set_joint(SHOULDER, radians(31.0)), 2.0),),
        joints=(SHOULDER,),
        prediction=Estimate(lambda state, _: OFF * lever(state), "mm", within=2.5),
        diagnoses=(Diagnosis("too_far", off_by_more, ((gate.set_joint(SHOULDER, radians(40.0)), 2.5),)),),
        shown=Shown(camera="side"),
    ),
    Step("explore", start, is_open=True, joints=(WAIST, SHOULDER, ELBOW, PITCH, ROLL), shown=Shown(camera="first")),
)
