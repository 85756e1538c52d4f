"""Teach: record postures, run them, joint moves and straight lines, a way round a sphere, pick and place."""

from __future__ import annotations

from math import cos, radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Order, Shown, Step, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    CLEAR,
    DIFFERENT,
    ELBOW,
    FAR_SIDE,
    HIGH,
    SHOULDER,
    SIDE,
    WAIST,
    aside,
    at_last,
    bulge,
    carried,
    crossed,
    height_there,
    left_behind,
    line_refused,
    out_of_order,
    passing,
    pushed_aside,
    radius,
    ran_by_joints,
    ran_in_line,
    run,
    start,
    start_with_line,
    start_with_sphere,
    start_with_two,
    still_held,
    two_alike,
    two_different,
    way_clearance,
    went_round,
)

TITLE = Text(en="Teach and repeat", pt_BR="Ensinar e repetir")
ABOUT = Text(
    en="Record postures, run them, choose between joint moves and straight lines, and let the arm carry a ball.",
    pt_BR="Grave posturas, execute-as, escolha entre juntas e linhas retas, e faça o braço levar uma bola.",
)
ROBOT = "movemaster"
NEEDS = ("drive_the_arm",)
SOURCES = ("Cerbaro 2022: §3.2, fig. 21 (golf ball, known joint poses)",)

MIDDLES = LineExercise(
    "chain",
    (
        GivenName(
            "r", "length", Text(en="from the axis of the waist to the gripper", pt_BR="do eixo da cintura à garra")
        ),
        GivenName(
            "a",
            "angle",
            Text(en="the waist at the first point, in radians", pt_BR="a cintura no primeiro ponto, em radianos"),
        ),
        GivenName(
            "b",
            "angle",
            Text(en="the waist at the second point, in radians", pt_BR="a cintura no segundo ponto, em radianos"),
        ),
    ),
    "r*(cos(a) + cos(b))/2",
    steps=(("m", "r*cos((a + b)/2)"),),
    title=Text(
        en="x halfway, by a joint move and by a linear move", pt_BR="x na metade do caminho, por juntas e em linha reta"
    ),
)
VALUES = {
    "different": fixed(DIFFERENT, "°"),
    "count": Value(lambda state, _: len(state.taught.waypoints), "", 0),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "side": fixed(SIDE, "°"),
    "far_side": fixed(FAR_SIDE, "°"),
    "shoulder_high": fixed(radians(HIGH[0]), "°"),
    "height": Value(lambda state, _: state.T_world_tool[2, 3], "mm"),
    "height_there": Value(lambda state, _: height_there(state), "mm"),
    "passing": Value(lambda state, _: passing(state), "mm"),
    "middle": Value(lambda state, _: radius(state) * cos(SIDE), "mm", 1),
    "radius": Value(lambda state, _: radius(state), "mm", 1),
    "bulge": Value(lambda state, seat: bulge(state, seat), "mm", 1),
    "aside": Value(lambda state, _: aside(state), "mm"),
    "clear": fixed(CLEAR, "mm"),
    "way": Value(lambda state, _: max(0.0, way_clearance(state)), "mm"),
}

WAIST_LEFT, SHOULDER_UP = radians(40.0), radians(55.0)
STEPS = (
    Step(
        "record",
        start,
        two_different,
        ((gate.record(), 0.2), (gate.set_joint(WAIST, WAIST_LEFT), 3.0), (gate.record(), 0.2)),
        joints=(WAIST, SHOULDER, ELBOW),
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(Diagnosis("alike", two_alike, ((gate.record(), 0.2), (gate.record(), 0.2))),),
        shown=Shown(camera="first", tab="robot"),
    ),
    Step(
        "repeat",
        start_with_two,
        at_last,
        ((gate.set_joint(SHOULDER, SHOULDER_UP), 2.0), (run, 6.0)),
        joints=(WAIST, SHOULDER, ELBOW),
        prediction=Choice(right=1, reveal="done"),
        shown=Shown(layers=("trail",), camera="first", tab="robot"),
    ),
    Step(
        "joint_or_line",
        start_with_two,
        ran_in_line,
        ((gate.set_move_type("P2", "line"), 0.2), (run, 7.0)),
        prediction=Estimate(bulge, "mm", within=20.0),
        diagnoses=(Diagnosis("by_joints", ran_by_joints, ((run, 6.0),)),),
        shown=Shown(layers=("trail",), camera="top", tab="robot"),
    ),
    Step("middles", start_with_two, line=MIDDLES, shown=Shown(camera="top")),
    Step(
        "no_way",
        start_with_line,
        crossed,
        ((gate.set_move_type("P2", "joints"), 0.2), (run, 9.0)),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(Diagnosis("refused", line_refused, ((run, 1.0),)),),
        shown=Shown(layers=("trail",), camera="top", tab="robot"),
    ),
    Step(
        "around",
        start_with_sphere,
        went_round,
        ((gate.record(), 0.2), (gate.move_waypoint("P3", 1), 0.2), (run, 8.0)),
        joints=(WAIST, SHOULDER, ELBOW),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("out_of_order", out_of_order, ((gate.record(), 1.5),)),
            Diagnosis("through", pushed_aside, ((run, 8.0),)),
        ),
        shown=Shown(layers=("trail",), camera="first", tab="robot"),
    ),
    Step(
        "pick_and_place",
        start,
        carried,
        ((gate.pick_and_place(), 0.5), (run, 9.0)),
        prediction=Order(right=(4, 2, 0, 5, 1, 3), reveal="done"),
        diagnoses=(
            Diagnosis(
                "left_behind", left_behind, ((gate.pick_and_place(), 0.5), (gate.set_grip("A2", ""), 0.2), (run, 9.0))
            ),
            Diagnosis("held", still_held, ((gate.pick_and_place(), 0.5), (gate.set_grip("B2", ""), 0.2), (run, 9.0))),
        ),
        shown=Shown(camera="first", tab="robot"),
    ),
    Step(
        "explore",
        start,
        is_open=True,
        joints=(WAIST, SHOULDER, ELBOW, 3, 4),
        shown=Shown(layers=("trail",), camera="first", tab="robot"),
    ),
)
