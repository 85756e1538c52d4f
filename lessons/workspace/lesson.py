"""Where two links reach, their two postures by the law of cosines and atan2, the edge, and the families of methods."""

from __future__ import annotations

from math import pi, radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    all_negated,
    at_inner_edge,
    at_outer_edge,
    at_point_down,
    at_point_up,
    dragged_to,
    elbow_negated,
    inner_angle,
    is_folded,
    is_given_back,
    is_near,
    is_stretched,
    joints_at,
    led_down,
    led_up,
    nearly_stretched,
    off_the_point,
    other_elbow,
    same_elbow,
    shoulder_alone,
    start,
    target_at,
    target_reached,
)
from .values import (
    BENT,
    ELBOW,
    ELBOW_DOWN,
    ELBOW_UP,
    INNER,
    NEAR_ELBOW,
    OUTER,
    POINT,
    POINT_ELBOW,
    SHOULDER,
    distance_at,
)
from .values import VALUES as VALUES

TITLE = Text(en="Workspace", pt_BR="Espaço de trabalho")
ABOUT = Text(
    en="Where two links reach, with how many postures, how a closed form finds them, and what happens at the edge.",
    pt_BR="Até onde dois elos chegam, com quantas posturas, como uma forma fechada as encontra, e o que há na borda.",
)
ROBOT = "planar2r"
NEEDS = ("drive_the_arm",)
SOURCES = ("Campos 1998: s.6–12, s.15–26, s.37, s.44–48, s.52–54",)

LENGTHS = (
    GivenName("x", "number", Text(en="where the end effector is to be, along x", pt_BR="x do ponto desejado")),
    GivenName("y", "number", Text(en="where it is to be, along y", pt_BR="y do ponto desejado")),
    GivenName("l1", "length", Text(en="length of the first link", pt_BR="comprimento do primeiro elo")),
    GivenName("l2", "length", Text(en="length of the second link", pt_BR="comprimento do segundo elo")),
    GivenName("s2", "number", Text(en="sine of the elbow angle", pt_BR="seno do ângulo do cotovelo")),
)
CLOSED_FORM = LineExercise(
    "error",
    LENGTHS,
    "atan2(s2, c2)",
    steps=(
        ("c2", "(x**2 + y**2 - l1**2 - l2**2)/(2*l1*l2)"),
        ("theta1", "atan2(y, x) - atan2(l2*s2, l1 + l2*c2)"),
    ),
    without=("acos", "asin"),
    title=Text(en="the closed form of two links, in radians", pt_BR="a forma fechada de dois elos, em radianos"),
)

STEPS = (
    Step(
        "reach",
        start,
        at_inner_edge,
        ((target_at(0.0, 0.15), 5.0),),
        prediction=Estimate(lambda state, _: INNER, "mm", within=40.0, reveal="done"),
        diagnoses=(
            Diagnosis("outer", at_outer_edge, ((target_at(1.6, 1.2), 5.0),)),
            Diagnosis("let_go", is_given_back, ((dragged_to(0.0, 0.1), 6.0),)),
            Diagnosis("reached", target_reached, ((target_at(0.5, 0.5), 5.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "two",
        start,
        other_elbow,
        ((joints_at(70.91, -70.0), 4.0),),
        joints=(SHOULDER, ELBOW),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("elbow_sign", elbow_negated, ((joints_at(15.0, -70.0), 4.0),)),
            Diagnosis("both_signs", all_negated, ((joints_at(-15.0, -70.0), 4.0),)),
            Diagnosis("same_side", same_elbow, ((joints_at(-20.0, 90.0), 4.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "cosine",
        start,
        is_near,
        ((gate.set_joint(ELBOW, NEAR_ELBOW), 4.0),),
        joints=(SHOULDER, ELBOW),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("inner_angle", inner_angle, ((gate.set_joint(ELBOW, pi - NEAR_ELBOW), 4.0),)),
            Diagnosis("shoulder", shoulder_alone, ((gate.set_joint(SHOULDER, radians(-40.0)), 4.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "acos",
        start,
        at_point_up,
        ((gate.set_joints(ELBOW_UP), 4.0),),
        joints=(SHOULDER, ELBOW),
        prediction=Estimate(lambda state, _: -POINT_ELBOW, "°", within=1.5),
        diagnoses=(
            Diagnosis("acos", at_point_down, ((gate.set_joints(ELBOW_DOWN), 4.0),)),
            Diagnosis("shoulder_left", off_the_point, ((gate.set_joint(ELBOW, -POINT_ELBOW), 4.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step("write", start, line=CLOSED_FORM, shown=Shown(camera="top")),
    Step(
        "edge",
        start,
        is_stretched,
        ((gate.set_joint(ELBOW, 0.0), 3.0),),
        joints=(SHOULDER, ELBOW),
        prediction=Estimate(lambda state, _: OUTER - distance_at(BENT), "mm", within=10.0, reveal="done"),
        diagnoses=(
            Diagnosis("nearly", nearly_stretched, ((gate.set_joint(ELBOW, BENT), 3.0),)),
            Diagnosis("folded", is_folded, ((gate.set_joint(ELBOW, pi), 4.0),)),
        ),
        shown=Shown(layers=("singular",), camera="top"),
    ),
    Step("count", start, prediction=Choice(right=0), shown=Shown(camera="top")),
    Step(
        "families",
        start,
        led_up,
        ((gate.set_joint(ELBOW, radians(-70.0)), 4.0), (target_at(*POINT), 5.0)),
        joints=(SHOULDER, ELBOW),
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(Diagnosis("as_it_began", led_down, ((target_at(*POINT), 5.0),)),),
        shown=Shown(camera="top", tab="robot"),
    ),
    Step(
        "explore",
        start,
        joints=(SHOULDER, ELBOW),
        shown=Shown(layers=("postures",), camera="top"),
        is_open=True,
    ),
)
