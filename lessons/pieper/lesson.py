"""Eight postures of the PUMA: wrist centre and tool point, Pieper's condition, what limits rule out; and the L-3."""

from __future__ import annotations

from math import radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    arm_turned,
    bend_kept,
    bend_negated,
    enough_within,
    hand_at,
    hand_first,
    hand_let_go,
    hand_level,
    hand_missing,
    hand_turned,
    joints_at,
    no_more_within,
    other_shoulder,
    start,
    tip_beyond,
    tip_placed,
    waist_alone,
    wrist_at_tip_place,
    wrist_flipped,
    wrist_placed,
)
from .values import BEND, FIRST, FLANGE, FLIPPED, ROLL, SHOULDER, WAIST, wrist_for_tip
from .values import VALUES as VALUES

TITLE = Text(en="Eight postures", pt_BR="Oito posturas")
ABOUT = Text(
    en="Why three axes through one point give a closed form, how eight postures arise, and which of them limits allow.",
    pt_BR="Por que três eixos por um ponto dão forma fechada, de onde vêm oito posturas, e quais cabem nos limites.",
)
ROBOT = "puma560"
NEEDS = ("closed_forms",)
SOURCES = (
    "Campos 1998: s.14, s.19–26, s.36, s.55",
    "Craig, Introduction to Robotics: chs. 3 and 4 (PUMA 560, Motoman L-3)",
)

ALL = tuple(range(6))
HAND = (ROLL, BEND, FLANGE)

WRIST_CENTRE = LineExercise(
    "error",
    (
        GivenName("p", "vector", Text(en="tip of the tool", pt_BR="ponta da ferramenta")),
        GivenName("z", "vector", Text(en="unit vector along the tool", pt_BR="vetor unitário ao longo da ferramenta")),
        GivenName("d", "length", Text(en="from the wrist centre to the tip", pt_BR="do centro do punho à ponta")),
    ),
    "p - d*z",
    title=Text(en="the wrist centre", pt_BR="o centro do punho"),
)
PROJECTION = LineExercise(
    "error",
    (
        GivenName("px", "number", Text(en="place of the wrist along x", pt_BR="x do punho")),
        GivenName("py", "number", Text(en="place of the wrist along y", pt_BR="y do punho")),
        GivenName("zx", "number", Text(en="x of the unit vector along the hand", pt_BR="x do vetor unitário da mão")),
        GivenName("zy", "number", Text(en="y of this vector", pt_BR="y desse vetor")),
    ),
    "(px*zy - py*zx)/rho",
    steps=(("rho", "sqrt(px**2 + py**2)"),),
    title=Text(en="the sine of the angle out of the plane", pt_BR="o seno do ângulo para fora do plano"),
)
SCREWS = LineExercise(
    "error",
    (
        GivenName("a", "length", Text(en="first fixed side of the triangle", pt_BR="primeiro lado fixo do triângulo")),
        GivenName("b", "length", Text(en="second fixed side", pt_BR="segundo lado fixo")),
        GivenName("psi", "angle", Text(en="angle between these sides", pt_BR="ângulo entre esses lados")),
    ),
    "sqrt(a**2 + b**2 - 2*a*b*cos(psi))",
    title=Text(en="the length of a ball screw", pt_BR="o comprimento de um fuso de esferas"),
)

STEPS = (
    Step(
        "still",
        start,
        hand_turned,
        ((hand_at(FIRST - [0.0, 0.5, 0.5]), 5.0),),
        joints=HAND,
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(Diagnosis("arm", arm_turned, ((gate.set_joint(SHOULDER, radians(-90.0)), 3.0),)),),
        shown=Shown(layers=("axes",), camera="side"),
    ),
    Step(
        "tip",
        start,
        tip_placed,
        ((wrist_at_tip_place(-1.0), 5.0),),
        prediction=Mark(lambda state, _: wrist_for_tip(state), within=0.04),
        diagnoses=(
            Diagnosis("wrist_there", wrist_placed, ((wrist_at_tip_place(0.0), 5.0),)),
            Diagnosis("beyond", tip_beyond, ((wrist_at_tip_place(1.0), 5.0),)),
            Diagnosis("let_go", hand_let_go, ((gate.keep_orientation(False), 1.0),)),
        ),
        shown=Shown(layers=("frames",), camera="side", tab="robot"),
    ),
    Step("write", start, prediction=Choice(right=1), line=WRIST_CENTRE, shown=Shown(layers=("axes",), camera="side")),
    Step(
        "arm",
        start,
        other_shoulder,
        ((joints_at(-155.8, -110.0, -154.6, 167.2, 68.1, 26.1), 8.0),),
        joints=ALL,
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("waist_alone", waist_alone, ((gate.set_joint(WAIST, radians(-155.8)), 5.0),)),
            Diagnosis("hand", hand_missing, ((joints_at(-155.8, -110.0, -154.6, 0.0, 60.0, 0.0), 8.0),)),
        ),
        shown=Shown(layers=("postures",), camera="first"),
    ),
    Step(
        "flip",
        start,
        wrist_flipped,
        ((hand_at(FLIPPED), 5.0),),
        joints=HAND,
        prediction=Estimate(lambda state, _: float(FLIPPED[0]), "°", within=2.0),
        diagnoses=(
            Diagnosis("first", hand_first, ((hand_at(FIRST), 5.0),)),
            Diagnosis("sign_alone", bend_negated, ((hand_at(FIRST * [1.0, -1.0, 1.0]), 5.0),)),
            Diagnosis("sign_kept", bend_kept, ((hand_at(FLIPPED * [1.0, -1.0, 1.0]), 5.0),)),
        ),
        shown=Shown(camera="side"),
    ),
    Step(
        "limits",
        start,
        enough_within,
        ((hand_level(0.40, 0.30, 0.20), 6.0),),
        joints=ALL,
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("as_few", no_more_within, ((gate.set_joint(WAIST, radians(40.0)), 3.0),)),),
        shown=Shown(layers=("postures",), camera="first"),
    ),
    Step("plane", start, line=PROJECTION, shown=Shown(camera="first")),
    Step("screws", start, line=SCREWS, shown=Shown(camera="first")),
    Step("explore", start, joints=ALL, shown=Shown(layers=("postures",), camera="first"), is_open=True),
)
