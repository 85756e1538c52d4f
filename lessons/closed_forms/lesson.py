"""Three links step by step, why a wrong branch is chosen, and what a target can ask of fewer than six joints."""

from __future__ import annotations

from math import pi, radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.text import Text

from .goals import (
    chosen_down,
    chosen_up,
    elbow_alone,
    far_hand_left,
    far_placed,
    hand_as_before,
    hand_left,
    hand_opposite,
    hand_placed,
    hand_tilted,
    hand_turned,
    marked_wrist,
    orientation_let_go,
    other_elbow,
    place_lost,
    quadrant_lost,
    signs_mixed,
    start,
    target_at,
    target_followed,
    target_tilted,
    to_elbow_up,
    turned_in_place,
    under_the_target,
    wrist_alone,
)
from .values import (
    BETA,
    CHOICE_DOWN,
    CHOICE_UP,
    DIRECTION,
    FAR_DIRECTION,
    FAR_DOWN,
    FAR_UP,
    LIFT,
    PLACE,
    PSI,
    SHOULDER,
    WRIST,
    cost,
)
from .values import VALUES as VALUES

TITLE = Text(en="Closed forms", pt_BR="Formas fechadas")
ABOUT = Text(
    en="Three links step by step, which branch to choose, and what a target can ask of fewer than six joints.",
    pt_BR="Três elos passo a passo, que ramo escolher, e o que um alvo pode pedir a menos de seis juntas.",
)
ROBOT = "planar3r"
NEEDS = ("workspace",)
SOURCES = (
    "Campos 1998: s.13–18, s.27–36, s.38–54",
    "Vargas 2013: figs. 2.6 and 2.9 (the arm)",
)

ALL = (0, 1, 2)
SAME_TURN = radians(-40.0)

GIVEN = (
    GivenName("x", "number", Text(en="place of the end effector along x", pt_BR="x do efetuador")),
    GivenName("y", "number", Text(en="place of the end effector along y", pt_BR="y do efetuador")),
    GivenName("phi", "angle", Text(en="direction of the hand", pt_BR="direção da mão")),
    GivenName("l3", "length", Text(en="length of the hand", pt_BR="comprimento da mão")),
    GivenName("theta1", "angle", Text(en="angle of joint 1", pt_BR="ângulo da junta 1")),
    GivenName("theta2", "angle", Text(en="angle of joint 2", pt_BR="ângulo da junta 2")),
)
BEFORE_AND_AFTER = LineExercise(
    "error",
    GIVEN,
    "phi - theta1 - theta2",
    steps=(("wx", "x - l3*cos(phi)"), ("wy", "y - l3*sin(phi)")),
    title=Text(en="the wrist, and the angle of joint 3", pt_BR="o punho e o ângulo da junta 3"),
)
POLAR_ARM = LineExercise(
    "error",
    (
        GivenName("x", "number", Text(en="place of the end effector along x", pt_BR="x do efetuador")),
        GivenName("y", "number", Text(en="place of the end effector along y", pt_BR="y do efetuador")),
    ),
    "atan2(-x, y)",
    steps=(("rho", "sqrt(x**2 + y**2)"),),
    title=Text(en="the closed form of the polar arm, in radians", pt_BR="a forma fechada do braço polar, em radianos"),
)

STEPS = (
    Step(
        "turn",
        start,
        turned_in_place,
        ((hand_turned(SAME_TURN), 5.0),),
        joints=ALL,
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("wrist_alone", wrist_alone, ((gate.set_joint(WRIST, 0.0), 4.0),)),
            Diagnosis("let_go", orientation_let_go, ((gate.keep_orientation(False), 1.0),)),
            Diagnosis("place_lost", place_lost, ((gate.set_joint(SHOULDER, radians(20.0)), 4.0),)),
        ),
        shown=Shown(camera="top", tab="robot"),
    ),
    Step(
        "wrist",
        start,
        hand_placed,
        ((target_at(*PLACE, DIRECTION), 6.0),),
        prediction=Mark(marked_wrist, within=0.15),
        diagnoses=(
            Diagnosis("opposite", hand_opposite, ((target_at(*PLACE, DIRECTION + pi), 6.0),)),
            Diagnosis("not_turned", hand_as_before, ((target_at(*PLACE, radians(85.0)), 6.0),)),
        ),
        shown=Shown(camera="top", tab="robot"),
    ),
    Step(
        "two",
        start,
        other_elbow,
        ((to_elbow_up(), 5.0),),
        joints=ALL,
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis("elbow_alone", elbow_alone, ((gate.set_joint(1, radians(-70.0)), 4.0),)),
            Diagnosis("hand", hand_left, ((to_elbow_up(with_wrist=False), 5.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step("write", start, line=BEFORE_AND_AFTER, shown=Shown(camera="top")),
    Step(
        "signs",
        start,
        far_placed,
        ((gate.set_joints(FAR_UP), 6.0),),
        joints=ALL,
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(
            Diagnosis(
                "mixed", signs_mixed, ((gate.set_joints([BETA + PSI, FAR_DOWN[1], FAR_DIRECTION - BETA - PSI]), 6.0),)
            ),
            Diagnosis("quadrant", quadrant_lost, ((gate.set_joints([BETA - pi - PSI, *FAR_DOWN[1:]]), 6.0),)),
            Diagnosis("hand", far_hand_left, ((gate.set_joints([*FAR_UP[:2], 0.0]), 6.0),)),
        ),
        shown=Shown(camera="top"),
    ),
    Step(
        "nearest",
        start,
        chosen_up,
        ((gate.set_joints(CHOICE_UP), 6.0),),
        joints=ALL,
        prediction=Estimate(lambda state, _: cost(CHOICE_UP, state), "°", within=15.0, reveal="done"),
        diagnoses=(Diagnosis("equal_weights", chosen_down, ((gate.set_joints(CHOICE_DOWN), 6.0),)),),
        shown=Shown(camera="top"),
    ),
    Step(
        "subspace",
        start,
        under_the_target,
        ((target_at(2.0, 1.5, radians(85.0), LIFT), 6.0),),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("in_the_plane", target_followed, ((target_at(2.0, 1.5, radians(85.0)), 6.0),)),
            Diagnosis("tilted", target_tilted, ((hand_tilted(radians(40.0)), 6.0),)),
        ),
        shown=Shown(camera="first", tab="robot"),
    ),
    Step("polar", start, prediction=Choice(right=0), line=POLAR_ARM, shown=Shown(camera="top")),
    Step("explore", start, joints=ALL, shown=Shown(layers=("postures",), camera="top"), is_open=True),
)
