"""Drive the arm: joints, a place, an orientation, a plane, a stop. For someone who meets a robot arm here first."""

from __future__ import annotations

from dataclasses import replace
from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToPose, PathChoice
from helicoide.geometry import rotation
from helicoide.kinematics.forward import tool_by_screws
from helicoide.lesson import Choice, Diagnosis, Estimate, Mark, Shown, Step, Value, fixed
from helicoide.readout import plane_distances
from helicoide.seat import Seat
from helicoide.state import State, Update
from helicoide.text import Text

TITLE = Text(en="Drive the arm", pt_BR="Conduza o braço")
ABOUT = Text(
    en="Joints, a target, what five joints cannot do, planes that stop the arm, and how you stop it.",
    pt_BR="Juntas, um alvo, o que cinco juntas não conseguem, planos que detêm o braço, e como você o para.",
)
ROBOT = "movemaster"
SOURCES = ("Cerbaro 2022: tab. 3, eqs. 36, 37",)

WAIST, ELBOW, CEILING = 0, 2, 0
BENT, WITHIN = radians(-100.0), radians(2.0)
TURNED = radians(20.0)
ELSEWHERE = radians(5.0)
LEFT, LOW, RIGHT = 0.120, 0.130, -0.050
SWUNG = radians(20.0)
RAISED = 0.100
ASKED_TURN, ASKED_YAW = radians(30.0), radians(60.0)
HELD_WITHIN = 1e-3
FOLLOWED, NEAR_PATH = 2.0, 0.1
STOPPED_AFTER = 5.0


def start(state: State) -> State:
    """Ask for the arm at `ready`, the measured planes, a held orientation and the path at its beginning."""
    for change in (gate.restore_planes(), gate.keep_orientation(True), gate.get_ready()):
        state = change(state)
    return replace(state, request=replace(state.request, path_choice=PathChoice(), path_s=0.0))


def target_at(x: float, y: float, z: float, about_y_deg: float = 0.0, about_z_deg: float = 0.0) -> Update:
    """Ask for a place, m, with the tool as it now is but for turns about the world's y and z axes."""

    def change(state: State) -> State:
        quat = rotation.from_matrix(state.T_world_tool[:3, :3])
        for axis, degrees in (([0.0, 1.0, 0.0], about_y_deg), ([0.0, 0.0, 1.0], about_z_deg)):
            quat = rotation.multiply(rotation.from_axis_angle(axis, radians(degrees)), quat)
        return gate.set_target([x, y, z], quat)(state)

    return change


def joint_moved(state: State, index: int) -> float:
    """How far a joint is from where it is in `ready`, rad."""
    return float(state.arm.q[index] - state.robot.poses["ready"][index])


def elbow_bent(state: State, seat: Seat) -> bool:
    """The elbow rests where it was asked to."""
    return bool(abs(state.arm.q[ELBOW] - BENT) <= WITHIN) and not state.arm.moving


def another_joint(state: State, seat: Seat) -> bool:
    """Another joint than the elbow was moved."""
    return any(abs(joint_moved(state, index)) > ELSEWHERE for index in range(len(state.arm.q)) if index != ELBOW)


def elbow_stretched(state: State, seat: Seat) -> bool:
    """The elbow was stretched, not bent."""
    return joint_moved(state, ELBOW) > ELSEWHERE


def waist_turned(state: State, seat: Seat) -> bool:
    """The waist rests where it was asked to."""
    return abs(joint_moved(state, WAIST) - TURNED) <= WITHIN and not state.arm.moving


def waist_turned_back(state: State, seat: Seat) -> bool:
    """The waist was turned to the other side."""
    return joint_moved(state, WAIST) < -ELSEWHERE


def after_turn(state: State, seat: Seat) -> Array:
    """Where the tool is once the waist alone has turned, (3,) m."""
    q = np.array(state.robot.poses["ready"])
    q[WAIST] += TURNED
    return tool_by_screws(state.robot, q)[:3, 3]


def at_target(state: State) -> bool:
    """The arm rests after a target was asked for."""
    return isinstance(state.request.command, MoveToPose) and not state.arm.moving


def low_on_the_left(state: State, seat: Seat) -> bool:
    """The target brought the tool to the left and down, and the tool rests there."""
    _, y, z = state.T_world_tool[:3, 3]
    return at_target(state) and bool(y >= LEFT and z <= LOW)


def high_on_the_left(state: State, seat: Seat) -> bool:
    """The target is far enough to the left, and still too high."""
    _, y, z = state.T_world_tool[:3, 3]
    return at_target(state) and bool(y >= LEFT and z > LOW)


def on_the_right(state: State, seat: Seat) -> bool:
    """The target went to the other side."""
    return at_target(state) and bool(state.T_world_tool[1, 3] <= RIGHT)


def out_of_plane(T_world_tool: Array) -> float:
    """The angle of a tool's x axis with the vertical plane through the waist axis and the tool, rad.

    No joint but the waist, which moves the tool away, leads out of that plane.
    """
    x, y, _ = T_world_tool[:3, 3]
    sideways = np.array([-y, x, 0.0]) / np.hypot(x, y)
    return float(np.arcsin(np.clip(sideways @ T_world_tool[:3, 0], -1.0, 1.0)))


def missing_length(state: State) -> float:
    """The distance of the tool from its target, m; 0 without a target."""
    if not isinstance(state.request.command, MoveToPose):
        return 0.0
    return float(np.linalg.norm(state.request.command.T_world_target[:3, 3] - state.T_world_tool[:3, 3]))


def turn_refused(state: State, seat: Seat) -> bool:
    """The target asks for a turn that five joints do not have; the tool keeps its place and rests."""
    command = state.request.command
    if not isinstance(command, MoveToPose) or not state.request.with_orientation or state.arm.moving:
        return False
    return missing_length(state) < HELD_WITHIN and abs(out_of_plane(command.T_world_target)) >= SWUNG


def turn_followed(state: State, seat: Seat) -> bool:
    """The target asks for a turn that the arm can make."""
    ready = tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))
    turned = np.linalg.norm(rotation.logarithm(ready[:3, :3].T @ state.T_world_tool[:3, :3]))
    return at_target(state) and bool(turned >= SWUNG)


def orientation_let_go(state: State, seat: Seat) -> bool:
    """The orientation does not count at the moment."""
    return not state.request.with_orientation


def target_beyond(state: State) -> float:
    """How far the target is beyond the ceiling, m; negative below it, and without a target."""
    if not isinstance(state.request.command, MoveToPose):
        return -np.inf
    planes = state.problem.planes
    return float(planes.offsets[CEILING] - planes.normals[CEILING] @ state.request.command.T_world_target[:3, 3])


def ceiling_above(state: State) -> float:
    """The height of the ceiling straight above the tool at `ready`, m."""
    normal, offset = state.problem.planes.normals[CEILING], state.problem.planes.offsets[CEILING]
    x, y, _ = tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))[:3, 3]
    return float((offset - normal[:2] @ [x, y]) / normal[2])


def rise(state: State, seat: Seat) -> float:
    """How far the tool can rise from `ready`, m."""
    height = tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))[2, 3]
    return float(ceiling_above(state) - state.problem.zones.critical - height)


def lap(state: State) -> float:
    """The time for once around the path, s."""
    return gate.path_of(state.robot, state.request.path_choice).duration


def to_the_ceiling(state: State) -> float:
    """The distance of the nearest monitored point to the ceiling, m."""
    return float(plane_distances(state)[:, CEILING].min())


def held_by_the_ceiling(state: State, seat: Seat) -> bool:
    """The target is beyond the ceiling, and a monitored point of the arm is as near to it as any may come."""
    is_near = abs(to_the_ceiling(state) - state.problem.zones.critical) <= HELD_WITHIN
    return target_beyond(state) > 0 and is_near


def below_the_ceiling(state: State, seat: Seat) -> bool:
    """The target was raised, but not through the ceiling."""
    is_raised = (
        state.T_world_tool[2, 3] >= tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))[2, 3] + RAISED
    )
    return bool(is_raised) and at_target(state) and target_beyond(state) <= 0


def stopped_on_the_path(state: State, seat: Seat) -> bool:
    """Stopped after following the path for a while; walls may hold the tool some way off the curve."""
    on_path = gate.path_of(state.robot, state.request.path_choice).pose(state.request.path_s)
    away = np.linalg.norm(on_path[:3, 3] - state.T_world_tool[:3, 3])
    is_stopped = state.request.command == HoldPosition(stopped=True)
    return is_stopped and state.request.path_s >= FOLLOWED and bool(away < NEAR_PATH)


def stopped_too_soon(state: State, seat: Seat) -> bool:
    """Stopped on the path, before it was followed for long enough."""
    return state.request.command == HoldPosition(stopped=True) and 0 < state.request.path_s < FOLLOWED


def only_paused(state: State, seat: Seat) -> bool:
    """The path is paused, not stopped."""
    command = state.request.command
    return state.request.path_s >= FOLLOWED and getattr(command, "playing", True) is False


VALUES = {
    "bent": fixed(BENT, "°"),
    "within": fixed(WITHIN, "°"),
    "elbow_ready": Value(lambda state, _: state.robot.poses["ready"][ELBOW], "°"),
    "elbow_lower": Value(lambda state, _: state.robot.lower[ELBOW], "°"),
    "elbow_upper": Value(lambda state, _: state.robot.upper[ELBOW], "°"),
    "elbow": Value(lambda state, _: state.arm.q[ELBOW], "°"),
    "waist": Value(lambda state, _: state.arm.q[WAIST], "°"),
    "turned": fixed(TURNED, "°"),
    "turned_to": Value(after_turn, "mm"),
    "joints": Value(lambda state, _: state.arm.q, "°"),
    "reach": Value(lambda state, _: float(np.hypot(*state.T_world_tool[:2, 3])), "mm"),
    "height": Value(lambda state, _: state.T_world_tool[2, 3], "mm"),
    "left": fixed(LEFT, "mm"),
    "low": fixed(LOW, "mm"),
    "y": Value(lambda state, _: state.T_world_tool[1, 3], "mm"),
    "swung": fixed(SWUNG, "°"),
    "asked_turn": fixed(ASKED_TURN, "°"),
    "asked_yaw": fixed(ASKED_YAW, "°"),
    "safe": Value(lambda state, _: state.problem.zones.critical, "mm"),
    "ceiling": Value(lambda state, _: ceiling_above(state), "mm"),
    "start_height": Value(
        lambda state, _: tool_by_screws(state.robot, np.array(state.robot.poses["ready"]))[2, 3], "mm"
    ),
    "rise": Value(rise, "mm"),
    "nearest": Value(lambda state, _: to_the_ceiling(state), "mm"),
    "missing": Value(lambda state, _: missing_length(state), "mm"),
    "lap": Value(lambda state, _: lap(state), "s", 0),
    "stopped_after": fixed(STOPPED_AFTER, "s", 0),
    "rest": Value(lambda state, _: lap(state) - STOPPED_AFTER, "s", 0),
    "followed": fixed(FOLLOWED, "s", 0),
    "path_s": Value(lambda state, _: state.request.path_s, "s", 1),
}

STEPS = (
    Step(
        "joint",
        start,
        elbow_bent,
        ((gate.set_joint(ELBOW, BENT), 2.0),),
        joints=(ELBOW,),
        prediction=Choice(right=2),
        diagnoses=(
            Diagnosis("another_joint", another_joint, ((gate.set_joint(WAIST, TURNED), 2.0),)),
            Diagnosis("stretched", elbow_stretched, ((gate.set_joint(ELBOW, radians(-60.0)), 2.0),)),
        ),
        shown=Shown(camera="side"),
    ),
    Step(
        "circle",
        start,
        waist_turned,
        ((gate.set_joint(WAIST, TURNED), 3.0),),
        joints=(WAIST,),
        prediction=Mark(after_turn, within=0.04),
        diagnoses=(Diagnosis("other_side", waist_turned_back, ((gate.set_joint(WAIST, -TURNED), 3.0),)),),
        shown=Shown(layers=("trail",), camera="top"),
    ),
    Step(
        "target",
        start,
        low_on_the_left,
        ((target_at(0.60, 0.16, 0.11), 3.0),),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("too_high", high_on_the_left, ((target_at(0.60, 0.16, 0.167), 3.0),)),
            Diagnosis("other_side", on_the_right, ((target_at(0.60, -0.16, 0.11), 3.0),)),
        ),
        shown=Shown(camera="first"),
    ),
    Step(
        "orientation",
        start,
        turn_refused,
        ((target_at(0.6029, 0.0, 0.1671, about_z_deg=60.0), 3.0),),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("let_go", orientation_let_go, ((gate.keep_orientation(False), 1.0),)),
            Diagnosis("followed", turn_followed, ((target_at(0.6029, 0.0, 0.1671, about_y_deg=30.0), 3.0),)),
        ),
    ),
    Step(
        "plane",
        start,
        held_by_the_ceiling,
        ((target_at(0.60, 0.0, 0.70), 4.0),),
        held_for=0.5,
        prediction=Estimate(rise, "mm", within=20.0, reveal="done"),
        diagnoses=(Diagnosis("below", below_the_ceiling, ((target_at(0.60, 0.0, 0.45), 4.0),)),),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "stop",
        start,
        stopped_on_the_path,
        ((gate.play(), 5.0), (gate.stop(), 0.5)),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("too_soon", stopped_too_soon, ((gate.play(), 1.0), (gate.stop(), 0.5))),
            Diagnosis("paused", only_paused, ((gate.play(), 5.0), (gate.pause(), 0.5))),
        ),
        shown=Shown(layers=("path",), tab="robot"),
    ),
    Step("explore", start, is_open=True, joints=tuple(range(5)), shown=Shown(layers=("trail",))),
)
