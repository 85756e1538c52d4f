"""Clifford algebra: products of four letters, then points, lines and planes of the arm, their joins and distances."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import pi, radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.console import Value as ConsoleValue
from helicoide.console import example_sheets, sheet_results
from helicoide.geometry import incidence, rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lesson import AtSeat, Choice, Diagnosis, Estimate, Mark, Shown, Solution, Step, StepGoal, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.readout import distance_product, plane_distances
from helicoide.seat import Seat, Selection
from helicoide.state import State, Update, with_joints
from helicoide.text import Text

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

WAIST, SHOULDER = 0, 1
SHOULDER_POINT, ELBOW_POINT, WRIST_POINT, TOOL_POINT = 1, 2, 3, 4
CEILING, BENCH = 0, 3
LIFTED = radians(8.0)
RAISED, ASIDE = 0.100, 0.030
SHIFTED, TILTED = 0.030, radians(0.5)
QUARTER = pi / 2
TOLERANCE = 1e-6
MOTION, STARS, DISTANCE, THROUGH = "rigid_motion", "hodge_star", "plane_distance", "plane_through_points"

E1, E2, E3, E, E3E1 = (Multivector(CL031.blade(name), CL031) for name in ("e1", "e2", "e3", "e", "e3e1"))
VOLUME = Multivector(CL031.blade("e1e2e3e"), CL031)


def start(state: State) -> State:
    """Ask for the arm at `ready` among the measured planes, with a held orientation."""
    for change in (gate.restore_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return state


def target_moved(dx: float, dy: float, dz: float) -> Update:
    """Ask for the tool as it now is, but for a displacement, m."""

    def change(state: State) -> State:
        T = state.T_world_tool
        return gate.set_target(T[:3, 3] + [dx, dy, dz], rotation.from_matrix(T[:3, :3]))(state)

    return change


def ceiling_moved(up: float, tilt: float = 0.0) -> Update:
    """Move the ceiling up, m, and tilt it about the y axis, rad."""

    def change(state: State) -> State:
        normal, offset = state.robot.panes[CEILING].normal, state.robot.panes[CEILING].offset
        turned = rotation.rotate(rotation.from_axis_angle([0.0, 1.0, 0.0], tilt), normal)
        return gate.set_plane(CEILING, turned, offset - up)(state)

    return change


# What is typed into the console.


def typed(text: str) -> Solution:
    """A line entered into the console."""

    def entered(seat: Seat) -> Seat:
        line = replace(seat.sheet.lines[0], text=text)
        return replace(seat, sheet=replace(seat.sheet, lines=(*seat.sheet.lines, line)))

    return ((AtSeat(entered), 0.0),)


def typed_values(state: State, seat: Seat, sheet: str) -> Iterator[tuple[ConsoleValue, ConsoleValue]]:
    """The value of each line that the example sheet does not have, as the arm is and with its waist turned."""
    given = {line.text for line in example_sheets()[sheet].sheet.lines}
    new = [n for n, line in enumerate(seat.sheet.lines) if line.text not in given]
    if not new:
        return
    now, later = sheet_results(seat.sheet, state), sheet_results(seat.sheet, elsewhere(state))
    for n in new:
        here, there = now[n].value, later[n].value
        if here is not None and there is not None:
            yield here, there


def elsewhere(state: State) -> State:
    """The state with the arm at another posture, at which a formula holds too, but a number that was read off fails."""
    q = np.array(state.robot.poses["ready"])
    q[WAIST] += radians(20.0)
    q[SHOULDER] -= radians(15.0)
    return with_joints(state, q)


def has_line(sheet: str, expected: Callable[[State], Array | float], factor: float = 1.0) -> StepGoal:
    """Whether a typed line is a number, or a multivector (16,), times a factor, at both postures."""

    def is_met(state: State, seat: Seat) -> bool:
        wanted = [factor * np.asarray(expected(each)) for each in (state, elsewhere(state))]
        return any(
            all(is_same(value, right) for value, right in zip(pair, wanted, strict=True))
            for pair in typed_values(state, seat, sheet)
        )

    return is_met


def is_same(value: ConsoleValue, right: Array) -> bool:
    """Whether a value of the console is this number, or has these coefficients."""
    if isinstance(value, Multivector) and value.algebra is not CL031:
        return False
    one = CL031.blade("1")
    given = value.values if isinstance(value, Multivector) else value * one
    return bool(np.abs(given - (right if right.ndim else right * one)).max() < TOLERANCE)


def any_of(*goals: StepGoal) -> StepGoal:
    """Whether one of the goals is met."""
    return lambda state, seat: any(goal(state, seat) for goal in goals)


def rotor_turning(target: Multivector) -> StepGoal:
    """Whether a typed line is a rotor of unit size that carries e3 there."""

    def is_met(state: State, seat: Seat) -> bool:
        return any(carries_e3_to(value, target) for value, _ in typed_values(state, seat, MOTION))

    return is_met


def carries_e3_to(value: ConsoleValue, target: Multivector) -> bool:
    """Whether a value is a rotor that carries e3 to a vector."""
    if not isinstance(value, Multivector) or value.algebra is not CL031:
        return False
    is_even = not value.values[CL031.grades % 2 == 1].any()
    return is_even and is_same(value * value.conjugate(), CL031.blade("1")) and is_same(value >> E3, target.values)


def rotor(blade: Multivector, angle: float) -> Multivector:
    """cos(θ/2) + B sin(θ/2)."""
    return blade * float(np.sin(angle / 2)) + float(np.cos(angle / 2))


# Points, lines and planes of the scene, (16,).


def point(state: State, index: int) -> Array:
    """A monitored point of the arm."""
    return rigid.point(state.monitored_points[index])


def plane(state: State, index: int) -> Array:
    """A plane of the scene."""
    return rigid.plane(state.problem.planes.normals[index], state.problem.planes.offsets[index])


def to_ceiling(state: State) -> float:
    """The distance of the elbow from the ceiling, m."""
    return float(plane_distances(state)[ELBOW_POINT, CEILING])


def ceiling_product(state: State) -> Array:
    """πp − pπ of the ceiling and the elbow."""
    return distance_product(state, ELBOW_POINT, CEILING)


def arm_plane(state: State) -> Array:
    """The plane through shoulder, elbow and wrist, its normal to the arm's left."""
    return -rigid.plane_through(*(point(state, k) for k in (SHOULDER_POINT, ELBOW_POINT, WRIST_POINT)))


def forearm(state: State) -> Array:
    """The line from the elbow to the wrist."""
    return incidence.join(point(state, ELBOW_POINT), point(state, WRIST_POINT))


def forearm_on_bench(state: State) -> Array:
    """Where the line of the forearm meets the bench."""
    return incidence.meet(forearm(state), plane(state, BENCH))


def hand_on_bench(state: State) -> Array:
    """Where the line from the wrist to the end effector meets the bench."""
    return incidence.meet(incidence.join(point(state, WRIST_POINT), point(state, TOOL_POINT)), plane(state, BENCH))


def shoulder_line(state: State) -> Array:
    """The axis of the shoulder."""
    return rigid.line(state.axes[SHOULDER], state.arm.poses[SHOULDER + 1, :3, 3])


# Goals and mistakes on the arm.


def lift(state: State) -> float:
    """How far the shoulder has turned from `ready`, rad."""
    return float(state.arm.q[SHOULDER] - state.robot.poses["ready"][SHOULDER])


def shoulder_lifted(state: State, seat: Seat) -> bool:
    """The shoulder rests, lifted, and not at `home`, from where the arm may still come."""
    return LIFTED <= lift(state) <= 2 * LIFTED and not state.arm.moving


def shoulder_lowered(state: State, seat: Seat) -> bool:
    """The shoulder was lowered."""
    return lift(state) <= -LIFTED / 2


def moved(state: State) -> Array:
    """How far the tool is from where it is at `ready`, (3,), m."""
    ready = with_joints(state, np.array(state.robot.poses["ready"]))
    return state.T_world_tool[:3, 3] - ready.T_world_tool[:3, 3]


def tool_raised(state: State, seat: Seat) -> bool:
    """The tool rests, raised straight up."""
    x, y, z = moved(state)
    return bool(z >= RAISED and np.hypot(x, y) <= ASIDE) and not state.arm.moving


def tool_aside(state: State, seat: Seat) -> bool:
    """The tool was moved to the side or forward."""
    return bool(np.hypot(*moved(state)[:2]) > ASIDE)


def ceiling_shift(state: State) -> float:
    """How much the offset of the ceiling has changed, m."""
    return abs(float(state.problem.planes.offsets[CEILING] - state.robot.panes[CEILING].offset))


def ceiling_tilt(state: State) -> float:
    """The angle by which the ceiling is tilted from where it was, rad."""
    normal, before = state.problem.planes.normals[CEILING], state.robot.panes[CEILING].normal
    return float(np.arctan2(np.linalg.norm(np.cross(normal, before)), normal @ before))


def ceiling_shifted(state: State, seat: Seat) -> bool:
    """The ceiling was moved along its normal."""
    return ceiling_shift(state) >= SHIFTED and ceiling_tilt(state) < TILTED


def ceiling_tilted(state: State, seat: Seat) -> bool:
    """The ceiling was tilted."""
    return ceiling_tilt(state) >= TILTED


def element(read: Callable[[State], Array]) -> Value:
    """A multivector of the scene."""
    return Value(lambda state, seat: Multivector(read(state), CL031))


VALUES = {
    "one": fixed(lambda: E1 * E1, decimals=0),
    "nothing": fixed(lambda: E * E, decimals=0),
    "swapped": fixed(lambda: E2 * E1, decimals=0),
    "e1e2_squared": fixed(lambda: E1 * E2 * E1 * E2, decimals=0),
    "e1e2e1": fixed(lambda: E1 * E2 * E1, decimals=0),
    "letters": fixed(len(CL031.squares), decimals=0),
    "blades": fixed(CL031.count, decimals=0),
    "by_grade": Value(lambda state, seat: np.bincount(CL031.grades).astype(float), decimals=0),
    "lifted": fixed(LIFTED, "°"),
    "shoulder_ready": Value(lambda state, _: state.robot.poses["ready"][SHOULDER], "°"),
    "shoulder": Value(lambda state, _: state.arm.q[SHOULDER], "°"),
    "shoulder_axis": element(shoulder_line),
    "quarter": fixed(QUARTER, "°"),
    "half": fixed(QUARTER / 2, "°"),
    "e3_turned": fixed(lambda: rotor(E3E1, QUARTER) >> E3, decimals=0),
    "e3_other": fixed(lambda: rotor(-E3E1, QUARTER) >> E3, decimals=0),
    "e3_whole": fixed(lambda: rotor(E3E1, 2 * QUARTER) >> E3, decimals=0),
    "star_e1": fixed(lambda: E1.dual(), decimals=0),
    "star_e2": fixed(lambda: E2.dual(), decimals=0),
    "e2_star": fixed(lambda: E2 * E2.dual(), decimals=0),
    "e2_other": fixed(lambda: E2 * -E2.dual(), decimals=0),
    "tool": element(lambda state: point(state, TOOL_POINT)),
    "raised": fixed(RAISED, "mm"),
    "height": Value(lambda state, _: state.T_world_tool[2, 3], "mm"),
    "shifted": fixed(SHIFTED, "mm"),
    "shift": Value(lambda state, _: ceiling_shift(state), "mm"),
    "tilt": Value(lambda state, _: ceiling_tilt(state), "°", 1),
    "ceiling": element(lambda state: plane(state, CEILING)),
    "elbow": element(lambda state: point(state, ELBOW_POINT)),
    "product": element(ceiling_product),
    "to_ceiling": Value(lambda state, _: to_ceiling(state), "mm", 1),
    "arm_plane": element(arm_plane),
    "arm_plane_back": element(lambda state: -arm_plane(state)),
    "forearm": element(forearm),
    "foot": Value(lambda state, _: rigid.coordinates(forearm_on_bench(state)), "mm"),
}

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
        prediction=Estimate(lambda state, _: to_ceiling(state), "mm", within=5.0),
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
        prediction=Mark(lambda state, _: rigid.coordinates(forearm_on_bench(state)), within=0.05),
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
