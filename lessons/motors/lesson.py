"""Motors: screws as eight numbers, their order in a chain, M and −M, and the way between two poses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import reduce
from math import asin, pi, radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import GetReady, PathChoice
from helicoide.console import example_sheets, kind_of, sheet_results
from helicoide.geometry import motor, rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.kinematics.forward import joint_motor, tool_by_screws, tool_motor
from helicoide.kinematics.robot import Robot
from helicoide.lesson import AtSeat, Choice, Diagnosis, Estimate, Mark, Order, Shown, Step, Value, fixed
from helicoide.lines import GivenName, LineExercise
from helicoide.seat import Seat, Selection
from helicoide.state import State
from helicoide.text import Text

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

WAIST, ROLL = 0, 4
SHEET = "movemaster_forward"
WANTED = 0.5
WITHIN, AT_REST = radians(2.0), radians(3.0)
LEAST_WAIST, NO_SLIDE, MUCH_SLIDE = radians(20.0), 0.005, 0.060
SAME_PLACE, SAME_TURN, STILL = 0.020, radians(4.0), 0.005
SIDE = radians(60.0)
BELOW, FAR_ROLL, LITTLE_WAIST = -0.05, radians(150.0), radians(20.0)
APART, NEAR, NEAR_TURN = radians(60.0), 0.015, radians(4.0)
TINY = 1e-6


def start(state: State) -> State:
    """Ask for the arm at `ready`, without planes, with a held orientation and the path at its beginning."""
    for change in (gate.clear_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, path_choice=PathChoice(), path_s=0.0))


def rests(state: State) -> bool:
    """Whether the arm rests, and is not asked for `ready`."""
    return not state.arm.moving and not isinstance(state.request.command, GetReady)


def coefficient(M: Array, blade: str) -> float:
    """The coefficient of a blade of `CL031`."""
    place, sign = CL031.parse_blade(blade)
    return float(sign * M[place])


def waist_motor(state: State) -> Array:
    """The motor of the waist, (16,)."""
    return joint_motor(state.robot.joints[WAIST], float(state.arm.q[WAIST]))


def link_motor(state: State) -> Array:
    """The motor of the frame of the first link, (16,)."""
    return rigid.motor_from_pose(state.arm.poses[WAIST + 1])


def shown_motor(state: State) -> Array:
    """The motor of the tool as the program shows it, with a positive scalar, (16,)."""
    return rigid.motor_from_pose(state.T_world_tool)


def product_motor(state: State) -> Array:
    """The product of the joints' motors and the zero pose, with the sign as it comes, (16,)."""
    return tool_motor(state.robot, state.arm.q)


def waist_at(state: State, angle: float) -> bool:
    """Whether the arm rests with the waist at an angle, rad."""
    return abs(float(state.arm.q[WAIST]) - angle) <= WITHIN and rests(state)


def half_angle_found(state: State, seat: Seat) -> bool:
    """The coefficient of e1e2 in the waist's motor is as large as it was asked for."""
    return waist_at(state, 2 * asin(WANTED))


def full_angle_taken(state: State, seat: Seat) -> bool:
    """The sine of the whole angle is as large as it was asked for."""
    return waist_at(state, asin(WANTED))


def waist_turned_back(state: State, seat: Seat) -> bool:
    """The waist was turned to the other side."""
    return bool(state.arm.q[WAIST] < -AT_REST) and rests(state)


def both_numbers(state: State) -> tuple[bool, float]:
    """Whether the waist is turned enough, and the coefficient that is zero without a slide along the axis."""
    return bool(abs(state.arm.q[WAIST]) >= LEAST_WAIST), abs(coefficient(shown_motor(state), "e1e2e3e"))


def slide_undone(state: State, seat: Seat) -> bool:
    """The waist is turned, and yet the screw from the base is a pure turn."""
    turned, slide = both_numbers(state)
    return turned and slide <= NO_SLIDE and rests(state)


def rolled_along(state: State, seat: Seat) -> bool:
    """The roll was turned in the same sense as the waist, which makes the slide longer."""
    turned, slide = both_numbers(state)
    return turned and bool(state.arm.q[WAIST] * state.arm.q[ROLL] > AT_REST**2) and slide >= MUCH_SLIDE and rests(state)


def waist_only(state: State, seat: Seat) -> bool:
    """The waist was turned, the roll not yet."""
    turned, slide = both_numbers(state)
    return turned and bool(abs(state.arm.q[ROLL]) < AT_REST) and slide > NO_SLIDE and rests(state)


def of_sheet(seat: Seat, name: str) -> Array | None:
    """A multivector of the sheet by its name, (16,); None without one."""
    found = {result.name: result.value for result in sheet_results(seat.sheet, None)}.get(name)
    return found.values if isinstance(found, Multivector) and found.algebra is CL031 else None


def from_sheet(state: State, seat: Seat) -> tuple[float, float] | None:
    """How far the tool is from the pose of the sheet, m and rad; None without that pose."""
    if (pose := of_sheet(seat, "pose")) is None or not motor.is_motor(pose, TINY):
        return None
    T = rigid.pose_from_motor(pose)
    turn = rotation.logarithm(T[:3, :3].T @ state.T_world_tool[:3, :3])
    return float(np.linalg.norm(T[:3, 3] - state.T_world_tool[:3, 3])), float(np.linalg.norm(turn))


def sheet_met(state: State, seat: Seat) -> bool:
    """The arm rests in the pose of the sheet."""
    apart = from_sheet(state, seat)
    return apart is not None and apart[0] <= SAME_PLACE and apart[1] <= SAME_TURN and rests(state)


def roll_missing(state: State, seat: Seat) -> bool:
    """The tool is where the sheet says, but turned otherwise."""
    apart = from_sheet(state, seat)
    return apart is not None and apart[0] <= SAME_PLACE and apart[1] > SAME_TURN and rests(state)


def typed(state: State | None, seat: Seat) -> list[Multivector]:
    """The multivectors of the lines that are not in the example sheet, in their order."""
    given = {line.text for line in example_sheets()[SHEET].sheet.lines}
    results = zip(seat.sheet.lines, sheet_results(seat.sheet, state), strict=True)
    values = [result.value for line, result in results if line.text not in given]
    return [value for value in values if isinstance(value, Multivector) and value.algebra is CL031]


def tip_in_order(seat: Seat, names: tuple[str, ...]) -> Array | None:
    """Where the tool at zero is moved by the product of these motors of the sheet, (16,)."""
    found = (of_sheet(seat, name) for name in names)
    factors = [one for one in found if one is not None and motor.is_motor(one, TINY)]
    zero = rigid.point([0.82, 0.0, 0.4])
    return rigid.move(reduce(CL031.product, factors), zero) if len(factors) == len(names) else None


def is_last(seat: Seat, names: tuple[str, ...]) -> bool:
    """Whether the last typed line gives that point."""
    lines, tip = typed(None, seat), tip_in_order(seat, names)
    return bool(lines) and tip is not None and bool(np.allclose(lines[-1].values, tip, atol=TINY))


RIGHT_ORDER = ("h1", "h2", "h3", "h4", "h5")
REVERSED = RIGHT_ORDER[::-1]


def reversed_typed(state: State, seat: Seat) -> bool:
    """The last typed line moves the tool by the factors in the reverse order."""
    return is_last(seat, REVERSED)


def right_typed(state: State, seat: Seat) -> bool:
    """The last typed line moves the tool by the factors in the right order."""
    return is_last(seat, RIGHT_ORDER)


def no_point_typed(state: State, seat: Seat) -> bool:
    """The last typed line is a motor: it moves nothing yet."""
    lines = typed(None, seat)
    return bool(lines) and kind_of(lines[-1]).name == "motor"


def entered_line(text: str) -> AtSeat:
    """Add a line to those of the console."""

    def added(seat: Seat) -> Seat:
        lines = seat.sheet.lines
        return replace(seat, sheet=replace(seat.sheet, lines=(*lines, replace(lines[-1], text=text))))

    return AtSeat(added)


def sign_changed(state: State, seat: Seat) -> bool:
    """The product of the joints' motors has a negative scalar part."""
    return coefficient(product_motor(state), "1") <= BELOW and rests(state)


def turned_alike(state: State, seat: Seat) -> bool:
    """Waist and roll have turned in the same sense."""
    waist, roll = state.arm.q[WAIST], state.arm.q[ROLL]
    return bool(waist * roll > 0 and abs(waist) >= LEAST_WAIST and abs(roll) >= LEAST_WAIST) and rests(state)


def roll_alone(state: State, seat: Seat) -> bool:
    """The roll has turned nearly as far as it can, the waist hardly."""
    return bool(abs(state.arm.q[ROLL]) >= FAR_ROLL and abs(state.arm.q[WAIST]) < LITTLE_WAIST) and rests(state)


def ends(robot: Robot) -> tuple[Array, Array]:
    """The two poses between which the tool moves, T_world_tool (4, 4), m: `ready`, and with the waist turned."""
    q = np.array(robot.poses["ready"])
    turned = q.copy()
    turned[WAIST] += APART
    return tool_by_screws(robot, q), tool_by_screws(robot, turned)


def halfway(robot: Robot) -> Array:
    """The pose halfway on the screw motion between the two, (4, 4), m."""
    first, last = map(rigid.motor_from_pose, ends(robot))
    return rigid.pose_from_motor(motor.sclerp(first, last, 0.5))


def straight_halfway(robot: Robot) -> Array:
    """The point halfway on the straight line between the two, (3,), m."""
    first, last = ends(robot)
    return np.asarray((first[:3, 3] + last[:3, 3]) / 2)


def at_halfway(state: State, seat: Seat) -> bool:
    """The tool rests halfway on the screw motion."""
    T = halfway(state.robot)
    turn = rotation.logarithm(T[:3, :3].T @ state.T_world_tool[:3, :3])
    near = np.linalg.norm(T[:3, 3] - state.T_world_tool[:3, 3]) <= NEAR
    return bool(near and np.linalg.norm(turn) <= NEAR_TURN) and rests(state)


def cut_short(state: State, seat: Seat) -> bool:
    """The tool rests near the middle of the straight line."""
    return bool(np.linalg.norm(straight_halfway(state.robot) - state.T_world_tool[:3, 3]) <= 2 * NEAR) and rests(state)


def at_the_end(state: State, seat: Seat) -> bool:
    """The arm is at the end of the motion."""
    return waist_at(state, APART)


def cut_the_corner(state: State) -> State:
    """Ask for the middle of the straight line, with the tool turned as it is."""
    as_it_is = rotation.from_matrix(state.T_world_tool[:3, :3])
    return gate.set_target(straight_halfway(state.robot), as_it_is)(state)


def moved_points(state: State, seat: Seat) -> tuple[float, float] | None:
    """How far the last typed motor moves the elbow and the wrist, m; None without a motor."""
    lines = typed(state, seat)
    if not lines or kind_of(lines[-1]).name != "motor":
        return None
    names = [point.name for point in state.robot.monitored]
    points = state.monitored_points[[names.index("elbow"), names.index("wrist")]]
    moved = rigid.coordinates(rigid.move(lines[-1].values, rigid.point(points)))
    elbow, wrist = np.linalg.norm(moved - points, axis=1)
    return float(elbow), float(wrist)


def only_wrist_moves(state: State, seat: Seat) -> bool:
    """The last typed motor moves the wrist and leaves the elbow in place."""
    moved = moved_points(state, seat)
    return moved is not None and moved[0] <= TINY and moved[1] > STILL


def elbow_moves(state: State, seat: Seat) -> bool:
    """The last typed motor moves the elbow."""
    moved = moved_points(state, seat)
    return moved is not None and moved[0] > TINY


def neither_moves(state: State, seat: Seat) -> bool:
    """The last typed motor leaves both in place."""
    moved = moved_points(state, seat)
    return moved is not None and moved[0] <= TINY and moved[1] <= STILL


def multivector(read: Callable[[State], Array]) -> Callable[[State, Seat], Multivector]:
    """A value that is a multivector of the state, without what would be written as 0.000."""

    def rounded(state: State, seat: Seat) -> Multivector:
        return Multivector(np.round(read(state), 3), CL031)

    return rounded


def example_tip(state: State, reverse: bool) -> Array:
    """The place of the tool at the angles of the example, with the factors in order or reversed, (3,), m."""
    robot = state.robot
    factors = [joint_motor(joint, value) for joint, value in zip(robot.joints, robot.poses["example"], strict=True)]
    product = reduce(CL031.product, factors[::-1] if reverse else factors)
    zero = tool_by_screws(robot, np.zeros(len(factors)))[:3, 3]
    return rigid.coordinates(rigid.move(product, rigid.point(zero)))


def height(state: State, seat: Seat) -> float:
    """The height of the frame of the first link, m."""
    return float(state.robot.points[WAIST, 2])


TURN = LineExercise(
    "motor",
    (
        GivenName("L", "line", Text(en="the axis, a line", pt_BR="o eixo, uma reta")),
        GivenName("alpha", "angle", Text(en="the angle", pt_BR="o ângulo")),
    ),
    "cos(alpha/2) + sin(alpha/2)*L",
    sign_counts=False,
    without=("screw", "exp", "rotor"),
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
)
VALUES = {
    "waist_motor": Value(multivector(waist_motor)),
    "waist": Value(lambda state, _: state.arm.q[WAIST], "°"),
    "roll": Value(lambda state, _: state.arm.q[ROLL], "°"),
    "wanted": fixed(WANTED, "", 1),
    "found_angle": fixed(2 * asin(WANTED), "°"),
    "full_angle": fixed(asin(WANTED), "°"),
    "within": fixed(WITHIN, "°"),
    "height": Value(height, "mm"),
    "lift": Value(lambda state, seat: height(state, seat) / 2, "", 1),
    "link_motor": Value(multivector(link_motor)),
    "least_waist": fixed(LEAST_WAIST, "°"),
    "no_slide": fixed(NO_SLIDE, "", 3),
    "volume": Value(lambda state, _: coefficient(shown_motor(state), "e1e2e3e"), "", 3),
    "tool_motor": Value(multivector(shown_motor)),
    "product": Value(multivector(product_motor)),
    "first_number": Value(lambda state, _: coefficient(product_motor(state), "1"), "", 3),
    "side": fixed(SIDE, "°"),
    "below": fixed(BELOW, "", 2),
    "example": Value(lambda state, _: state.robot.poses["example"], "°"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "tip": Value(lambda state, _: example_tip(state, False), "mm"),
    "reversed_tip": Value(lambda state, _: example_tip(state, True), "mm"),
    "apart": fixed(APART, "°"),
    "half_way": fixed(APART / 2, "°"),
    "long_way": fixed(2 * pi - APART, "°"),
    "long_half": fixed(APART / 2 - pi, "°"),
    "cut": Value(
        lambda state, _: float(np.linalg.norm(halfway(state.robot)[:3, 3] - straight_halfway(state.robot))), "mm"
    ),
    "zero_tip": Value(lambda state, _: tool_by_screws(state.robot, np.zeros(len(state.arm.q)))[:3, 3], "mm"),
}

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
        prediction=Mark(lambda state, _: halfway(state.robot)[:3, 3], within=0.04),
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
