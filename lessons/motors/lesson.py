"""Motors: screws as eight numbers, their order in a chain, M and −M, and the way between two poses."""

from __future__ import annotations

from math import asin, radians

import numpy as np

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Order, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Selection
from helicoide.text import Text

from .goals import (
    SHEET,
    at_halfway,
    at_the_end,
    cut_short,
    cut_the_corner,
    elbow_moves,
    entered_line,
    full_angle_taken,
    half_angle_found,
    neither_moves,
    no_point_typed,
    only_wrist_moves,
    reversed_typed,
    right_typed,
    roll_alone,
    roll_missing,
    rolled_along,
    sheet_met,
    sign_changed,
    slide_undone,
    start,
    turned_alike,
    waist_only,
    waist_turned_back,
)
from .values import APART, MARKED, ROLL, SIDE, WAIST, WANTED, halfway, height
from .values import VALUES as VALUES

TITLE = Text(en="Motors: eight numbers", pt_BR="Motores: oito números")
ABOUT = Text(
    en="Dual quaternions: half angles, the order of the factors, M and −M, and the screw way between two poses.",
    pt_BR="Quatérnios duais: meios ângulos, a ordem dos fatores, M e −M, e o caminho helicoidal entre duas poses.",
)
ROBOT = "movemaster"
NEEDS = ("screws", "quaternions")
SOURCES = (
    "Cerbaro 2022: eqs. 15, 17, 96–99, 103 (order corrected), tab. 8, App. F",
    "Kavan et al. 2008 (ScLERP)",
)
OWN_ARM = True

TURN = LineExercise(
    "motor",
    (
        GivenName("L", "line", Text(en="the axis, a line", pt_BR="o eixo, uma reta")),
        GivenName("alpha", "angle", Text(en="the angle, in radians", pt_BR="o ângulo, em radianos")),
    ),
    "cos(alpha/2) + sin(alpha/2)*L",
    sign_counts=False,
    without=("screw", "exp", "rotor"),
    title=Text(en="the motor of a turn about a line", pt_BR="o motor de um giro em torno de uma reta"),
)

PEN = LineExercise(
    "chain",
    (
        GivenName("B", "motor", Text(en="from the room to the base", pt_BR="da sala à base")),
        GivenName("M", "motor", Text(en="from the base to the end effector", pt_BR="da base ao efetuador")),
        GivenName("P", "motor", Text(en="from the end effector to the pen", pt_BR="do efetuador à caneta")),
    ),
    "B*M*P",
    steps=(("N", "B*M"),),
    sign_counts=False,
    title=Text(
        en="the end effector, then the pen, as seen from the room",
        pt_BR="o efetuador e depois a caneta, vistos da sala",
    ),
)

STEPS = (
    Step(
        "half_angle",
        start,
        half_angle_found,
        ((gate.set_joint(WAIST, 2 * asin(WANTED)), 3.0),),
        joints=(WAIST,),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("full_angle", full_angle_taken, ((gate.set_joint(WAIST, asin(WANTED)), 3.0),)),
            Diagnosis("other_side", waist_turned_back, ((gate.set_joint(WAIST, -2 * asin(WANTED)), 3.0),)),
        ),
        shown=Shown(camera="top", selection=Selection("joint", WAIST)),
    ),
    Step(
        "eight",
        start,
        slide_undone,
        ((gate.set_joint(WAIST, radians(40.0)), 3.0), (gate.set_joint(ROLL, radians(-40.5)), 3.0)),
        joints=(WAIST, ROLL),
        prediction=Estimate(lambda state, seat: height(state, seat) / 2, "", within=0.02),
        diagnoses=(
            Diagnosis("waist_only", waist_only, ((gate.set_joint(WAIST, radians(40.0)), 3.0),)),
            Diagnosis(
                "rolled_along",
                rolled_along,
                ((gate.set_joint(WAIST, radians(40.0)), 3.0), (gate.set_joint(ROLL, radians(45.0)), 3.0)),
            ),
        ),
        shown=Shown(layers=("screw",), camera="first", selection=Selection("tool")),
    ),
    Step("write", start, prediction=Choice(right=2), line=TURN),
    Step(
        "chain",
        start,
        sheet_met,
        ((gate.set_joints(np.radians([30.0, 60.0, -90.0, -30.0, 90.0])), 5.0),),
        joints=tuple(range(5)),
        prediction=Order(right=(4, 1, 3, 0, 2)),
        diagnoses=(
            Diagnosis(
                "roll_missing",
                roll_missing,
                ((gate.set_joints(np.radians([30.0, 60.0, -90.0, -30.0, 0.0])), 5.0),),
            ),
        ),
        shown=Shown(layers=("products",), camera="first", hidden=("console",), sheet=SHEET),
        console=True,
    ),
    Step(
        "order",
        start,
        reversed_typed,
        ((entered_line("h5*h4*h3*h2*h1 >> point(0.82, 0, 0.4)"), 0.1),),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("right_order", right_typed, ((entered_line("h1*h2*h3*h4*h5 >> point(0.82, 0, 0.4)"), 0.1),)),
            Diagnosis("no_point", no_point_typed, ((entered_line("h5*h4*h3*h2*h1"), 0.1),)),
        ),
        shown=Shown(layers=("console",), camera="first", sheet=SHEET),
        console=True,
    ),
    Step("pen", start, line=PEN, shown=Shown(layers=("frames",), camera="first")),
    Step(
        "sign",
        start,
        sign_changed,
        ((gate.set_joint(WAIST, -SIDE), 3.0), (gate.set_joint(ROLL, radians(170.0)), 4.0)),
        joints=(WAIST, ROLL),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis(
                "turned_alike",
                turned_alike,
                ((gate.set_joint(WAIST, SIDE), 3.0), (gate.set_joint(ROLL, radians(170.0)), 4.0)),
            ),
            Diagnosis("roll_alone", roll_alone, ((gate.set_joint(ROLL, radians(170.0)), 4.0),)),
        ),
        shown=Shown(layers=("screw",), camera="first", selection=Selection("tool")),
    ),
    Step(
        "halfway",
        start,
        at_halfway,
        ((gate.set_joint(WAIST, APART / 2), 3.0),),
        joints=(WAIST,),
        prediction=Mark(lambda state, _: halfway(state.robot)[:3, 3], within=MARKED),
        diagnoses=(
            Diagnosis("cut_short", cut_short, ((cut_the_corner, 4.0),)),
            Diagnosis("at_the_end", at_the_end, ((gate.set_joint(WAIST, APART), 3.0),)),
        ),
        shown=Shown(layers=("trail",), camera="top"),
    ),
    Step(
        "invent",
        start,
        only_wrist_moves,
        ((entered_line("exp(0.3*L3)"), 0.1),),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("neither_moves", neither_moves, ((entered_line("screw(line(elbow, wrist), 1)"), 0.1),)),
            Diagnosis("elbow_moves", elbow_moves, ((entered_line("exp(0.3*L2)"), 0.1),)),
        ),
        shown=Shown(layers=("console", "axes"), camera="first", sheet=SHEET),
        console=True,
        is_open=True,
    ),
    Step(
        "explore",
        start,
        joints=tuple(range(5)),
        shown=Shown(layers=("screw", "products"), camera="first", selection=Selection("tool")),
        is_open=True,
    ),
)
