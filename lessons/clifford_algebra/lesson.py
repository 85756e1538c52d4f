"""Clifford algebra: products of four letters, then points, lines and planes of the arm, their joins and distances."""

from __future__ import annotations

from math import radians

from helicoide import gate
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Selection
from helicoide.text import Text

from .goals import (
    DISTANCE,
    MOTION,
    STARS,
    THROUGH,
    any_of,
    ceiling_moved,
    ceiling_shifted,
    ceiling_tilted,
    hand_on_bench,
    has_line,
    rotor_turning,
    shoulder_lifted,
    shoulder_lowered,
    start,
    target_moved,
    tool_aside,
    tool_raised,
    typed,
)
from .values import (
    ALLOWED,
    CEILING,
    E1,
    E2,
    E3,
    MARKED,
    SHOULDER,
    TOOL_POINT,
    WAIST,
    arm_plane,
    ceiling_product,
    forearm,
    forearm_on_bench,
    to_ceiling,
)
from .values import VALUES as VALUES

TITLE = Text(en="Clifford algebra", pt_BR="Álgebra de Clifford")
ABOUT = Text(
    en="Four letters and three rules; then the points, lines and planes of the arm, their products and distances.",
    pt_BR="Quatro letras e três regras; depois os pontos, retas e planos do braço, seus produtos e distâncias.",
)
ROBOT = "movemaster"
NEEDS = ("drive_the_arm", "sine_to_motor")
SOURCES = (
    "Cerbaro 2022: App. F, eqs. 73–75, 98; §5.2, eqs. 16–30 and the Hodge star of §5.2.4",
    "Selig 2005, ch. 10",
)
VOLUME = Multivector(CL031.blade("e1e2e3e"), CL031)

EDGE = LineExercise(
    "incidence",
    (
        GivenName("A", "plane", Text(en="a plane", pt_BR="um plano")),
        GivenName("B", "plane", Text(en="another plane", pt_BR="outro plano")),
        GivenName("p", "point", Text(en="a point", pt_BR="um ponto")),
    ),
    "join(K, p)",
    steps=(("K", "meet(A, B)"),),
    sign_counts=False,
    title=Text(
        en="the edge of two planes, then a plane through it", pt_BR="a aresta de dois planos, depois um plano por ela"
    ),
)

STEPS = (
    Step("generators", start, prediction=Choice(right=1)),
    Step("blades", start, prediction=Estimate(lambda state, _: CL031.count, "", within=0.0)),
    Step(
        "axis",
        start,
        shoulder_lifted,
        ((gate.set_joint(SHOULDER, radians(40.0)), 2.0),),
        joints=(SHOULDER,),
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("lowered", shoulder_lowered, ((gate.set_joint(SHOULDER, radians(20.0)), 2.0),)),),
        shown=Shown(camera="side"),
    ),
    Step(
        "sense",
        start,
        rotor_turning(E1),
        typed("R = cos(pi/4) + sin(pi/4)*e3*e1"),
        prediction=Choice(right=2),
        diagnoses=(
            Diagnosis("alphabet", rotor_turning(-E1), typed("R = cos(pi/4) + sin(pi/4)*e1*e3")),
            Diagnosis("whole_angle", rotor_turning(-E3), typed("R = cos(pi/2) + sin(pi/2)*e3*e1")),
        ),
        shown=Shown(sheet=MOTION, hidden=("console",)),
        console=True,
    ),
    Step(
        "star",
        start,
        has_line(STARS, lambda state: E2.dual().values),
        typed("B = e3*e1*e"),
        prediction=Choice(right=0),
        diagnoses=(
            Diagnosis("alphabet", has_line(STARS, lambda state: -E2.dual().values), typed("B = e1*e3*e")),
            Diagnosis("product", has_line(STARS, lambda state: VOLUME.values), typed("e2*e3*e1*e")),
        ),
        shown=Shown(sheet=STARS),
        console=True,
    ),
    Step(
        "plane",
        start,
        ceiling_shifted,
        ((ceiling_moved(0.06), 0.5),),
        prediction=Choice(right=0, reveal="done"),
        diagnoses=(Diagnosis("tilted", ceiling_tilted, ((ceiling_moved(0.06, radians(5.0)), 0.5),)),),
        shown=Shown(selection=Selection("plane", CEILING), coefficient="e", tab="algebra"),
    ),
    Step(
        "point",
        start,
        tool_raised,
        ((target_moved(0.0, 0.0, 0.12), 3.0),),
        prediction=Choice(right=2),
        diagnoses=(Diagnosis("aside", tool_aside, ((target_moved(0.0, 0.1, 0.0), 3.0),)),),
        shown=Shown(selection=Selection("point", TOOL_POINT), coefficient="e1e2e", camera="first"),
    ),
    Step(
        "distance",
        start,
        has_line(DISTANCE, to_ceiling),
        typed("l_elbow = 0.5*dual(ceiling*elbow - elbow*ceiling)"),
        prediction=Estimate(lambda state, _: to_ceiling(state), "mm", within=1e3 * ALLOWED),
        diagnoses=(
            Diagnosis(
                "twice", has_line(DISTANCE, to_ceiling, factor=2.0), typed("dual(ceiling*elbow - elbow*ceiling)")
            ),
            Diagnosis(
                "reversed",
                has_line(DISTANCE, to_ceiling, factor=-1.0),
                typed("0.5*dual(elbow*ceiling - ceiling*elbow)"),
            ),
            Diagnosis(
                "no_star",
                any_of(has_line(DISTANCE, ceiling_product), has_line(DISTANCE, ceiling_product, factor=0.5)),
                typed("ceiling*elbow - elbow*ceiling"),
            ),
        ),
        shown=Shown(sheet=DISTANCE, camera="side"),
        console=True,
    ),
    Step(
        "three_points",
        start,
        has_line(THROUGH, arm_plane),
        typed("plane_through(elbow, shoulder, wrist)"),
        prediction=Choice(right=1),
        diagnoses=(
            Diagnosis(
                "other_face",
                has_line(THROUGH, arm_plane, factor=-1.0),
                typed("plane_through(shoulder, elbow, wrist)"),
            ),
        ),
        shown=Shown(sheet=THROUGH, hidden=("console",), camera="first"),
        console=True,
    ),
    Step(
        "join_and_meet",
        start,
        has_line(DISTANCE, forearm_on_bench),
        typed("meet(join(elbow, wrist), bench)"),
        prediction=Mark(lambda state, _: rigid.coordinates(forearm_on_bench(state)), within=MARKED),
        diagnoses=(
            Diagnosis(
                "line_only",
                any_of(has_line(DISTANCE, forearm), has_line(DISTANCE, forearm, factor=-1.0)),
                typed("join(elbow, wrist)"),
            ),
            Diagnosis("hand", has_line(DISTANCE, hand_on_bench), typed("meet(join(wrist, tool), bench)")),
        ),
        shown=Shown(sheet=DISTANCE, camera="first"),
        console=True,
    ),
    Step("edge", start, line=EDGE),
    Step("explore", start, is_open=True, console=True, joints=(WAIST, SHOULDER, 2, 3, 4)),
)
