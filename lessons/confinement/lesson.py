"""Confinement: planes around an arm, the distances that it keeps, why it stopped, and how a camera measures a room."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToJoints, MoveToPose
from helicoide.confinement.zones import SHELL_THICKNESS
from helicoide.geometry import incidence, rigid, rotation
from helicoide.ik import Contact
from helicoide.lesson import Choice, Diagnosis, Estimate, Shown, Solution, Step, Value, fixed
from helicoide.perception.camera import SimulatedCamera
from helicoide.perception.enclosure_reading import NOISE, OUTLIERS, PLANE_READINGS, camera_cloud, plane_in_cloud
from helicoide.readout import nearest_point_and_plane, plane_distances
from helicoide.readout.distances import distances_of
from helicoide.seat import Seat
from helicoide.state import State, Update, with_joints
from helicoide.text import Text

TITLE = Text(en="Confinement", pt_BR="Confinamento")
ABOUT = Text(
    en="An arm among planes: which point is stopped, by what and how far away, and how a camera measures the room.",
    pt_BR="Um braço entre planos: que ponto é detido, por qual plano, a que distância, e como uma câmera mede a sala.",
)
ROBOT = "movemaster"
NEEDS = ("drive_the_arm",)
SOURCES = ("Cerbaro 2022: §5.2, eqs. 18, 20, 25–26; §6.1–6.2, eqs. 36–37 and fig. 43",)

WAIST, SHOULDER, ELBOW = 0, 1, 2
ELBOW_POINT, TOOL_POINT = 2, 4
CEILING, LEFT, RIGHT, BENCH = 0, 1, 2, 3
ASKED = radians(60.0)
LOWERED = radians(5.0)
TOUCH, SHORT, OFF = 1e-3, 0.020, 0.020
SLOW = 0.01  # rad/s; at a plane an arm may creep along it for seconds
CRITICAL, WARNING, WIDER, AS_ASKED = 0.080, 0.110, 0.120, 1.5e-3
BOX = (0.20, -0.32, 0.0), (0.90, 0.32, 0.64)
PHASES: tuple[gate.Phase, ...] = ("start", "end")
BACK = 0.40, 0.0, 0.35
AS_MEASURED = radians(2.0)


def start(state: State) -> State:
    """Ask for the arm at `ready` among the planes of its file, with the usual distances and no clouds."""
    for change in (
        gate.clear_clouds(),
        gate.set_zones(CRITICAL, WARNING),
        gate.restore_planes(),
        gate.keep_orientation(True),
        gate.get_ready(),
    ):
        state = change(state)
    return state


def start_in_a_box(state: State) -> State:
    """The same with an upright box, as somebody might draw it, in place of the measured planes."""
    return gate.get_ready()(gate.set_box(*BOX)(start(state)))


def target_at(x: float, y: float, z: float) -> Update:
    """Ask for a place, m, with the orientation that the tool has."""
    return lambda state: gate.set_target([x, y, z], rotation.from_matrix(state.T_world_tool[:3, :3]))(state)


def dragged_to(x: float, y: float, z: float) -> Update:
    """Drag the target to a place, m, and let go."""

    def change(state: State) -> State:
        quat = rotation.from_matrix(state.T_world_tool[:3, :3])
        for phase in PHASES:
            state = gate.drag_target("", phase, [x, y, z], quat)(state)
        return state

    return change


def ceiling_lowered(by: float) -> Update:
    """Move the ceiling down, m."""

    def change(state: State) -> State:
        planes = state.problem.planes
        return gate.set_plane(CEILING, planes.normals[CEILING], planes.offsets[CEILING] + by)(state)

    return change


def measured(number: int) -> Update:
    """What the camera sees from where the arm is, and the plane that is found in it."""

    def change(state: State) -> State:
        reading = PLANE_READINGS[number]
        camera = SimulatedCamera(noise=NOISE, outliers=OUTLIERS, resolution=(160, 90))
        seen, pane = plane_in_cloud(camera_cloud(camera, state), reading, state.T_world_tool[:3, 3], number)
        return gate.show_cloud(reading.name, seen, pane)(state)

    return change


def measuring(count: int) -> Solution:
    """The first readings of the camera, as the button makes them."""
    parts: list[tuple[Update, float]] = [(gate.clear_planes(), 0.1)]
    for number in range(count):
        parts += [(gate.go_to(PLANE_READINGS[number].pose), 4.0), (measured(number), 0.1)]
    return tuple(parts)


# Distances.


def at_rest(state: State) -> bool:
    """Whether the arm is as good as at rest, with its planes on, after a request of the reader."""
    is_slow = bool(np.abs(state.arm.velocities).max() < SLOW)
    return is_slow and not state.arm.parked and isinstance(state.request.command, MoveToPose | MoveToJoints)


def least(state: State, plane: int) -> float:
    """The distance of the nearest monitored point to a plane, m."""
    return float(plane_distances(state)[:, plane].min())


def touches(state: State, plane: int, point: int) -> bool:
    """Whether a monitored point is as near to a plane as any may come, and no other is nearer."""
    distance = float(plane_distances(state)[point, plane])
    return abs(distance - state.problem.zones.critical) <= TOUCH and distance <= least(state, plane) + TOUCH


def elbow_to_ceiling(state: State) -> float:
    """The distance of the elbow to the ceiling, m."""
    return float(plane_distances(state)[ELBOW_POINT, CEILING])


def target_distances(state: State) -> Array:
    """The distances of the target to the planes, (k,), m; nan without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return np.full(len(state.problem.planes.panes), np.nan)
    return np.asarray(distances_of(state, command.T_world_target[None, :3, 3])[0])


def missing(state: State) -> float:
    """The distance of the tool from its target, m; 0 without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return 0.0
    return float(np.linalg.norm(command.T_world_target[:3, 3] - state.T_world_tool[:3, 3]))


def at_ready(state: State) -> State:
    """The state with the arm at `ready`."""
    return with_joints(state, np.array(state.robot.poses["ready"]))


def shoulder_at_stop(state: State) -> float:
    """The shoulder angle, from `ready` upwards, at which the elbow is at the safety distance to the ceiling, rad."""
    low, high = float(state.robot.poses["ready"][SHOULDER]), ASKED
    for _ in range(30):
        middle = (low + high) / 2
        q = np.array(state.robot.poses["ready"])
        q[SHOULDER] = middle
        is_clear = elbow_to_ceiling(with_joints(state, q)) > state.problem.zones.critical
        low, high = (middle, high) if is_clear else (low, middle)
    return low


def to_the_edge(state: State) -> float:
    """The distance of the tool to the line in which the left wall meets the bench, m."""
    planes = state.problem.planes
    wall, bench = (rigid.plane(planes.normals[k], planes.offsets[k]) for k in (LEFT, BENCH))
    return float(incidence.point_line_distance(incidence.meet(wall, bench), rigid.point(state.T_world_tool[:3, 3])))


def between_walls(state: State) -> float:
    """How far the walls are from each other where the tool is at `ready`, along y, m."""
    ready = at_ready(state).T_world_tool[:3, 3]
    normals, offsets = state.problem.planes.normals, state.problem.planes.offsets
    left, right = (float((offsets[k] - normals[k] @ ready) / normals[k][1]) for k in (LEFT, RIGHT))
    return left - right


def corridor(state: State) -> float:
    """What is left between the walls for the tool at the wider safety distance, along y, m."""
    normals = state.problem.planes.normals
    return between_walls(state) - WIDER / abs(float(normals[LEFT][1])) - WIDER / abs(float(normals[RIGHT][1]))


def parked_elbow(state: State) -> tuple[float, float]:
    """Of the elbow when the arm is parked: how far it is ahead of the base, and from the measured ceiling, m."""
    elbow = with_joints(state, np.array(state.robot.poses["home"])).monitored_points[ELBOW_POINT]
    pane = state.robot.panes[CEILING]
    return float(elbow[0]), float(pane.normal @ elbow - pane.offset)


def pane_edge(state: State) -> float:
    """Where the drawn part of the ceiling begins, ahead of the base, m."""
    pane = state.robot.panes[CEILING]
    return float(pane.centre[0] - pane.size[0] / 2)


def tilt(state: State, name: str, upright: Array) -> float:
    """The angle of the normal of a named plane with a direction, rad; 0 if there is no such plane."""
    planes = state.problem.planes
    if name not in planes.names:
        return 0.0
    normal = planes.normals[planes.names.index(name)]
    return float(np.arctan2(np.linalg.norm(np.cross(normal, upright)), normal @ upright))


def left_wall_tilt(state: State) -> float:
    """How much the normal of the left wall is tilted from the y axis, rad."""
    return tilt(state, "+y", np.array([0.0, -1.0, 0.0]))


# Goals and mistakes.


def tool_nearest(state: State, seat: Seat) -> bool:
    """The end effector and the bench are the nearest pair."""
    return at_rest(state) and nearest_point_and_plane(state) == Contact(BENCH, TOOL_POINT)


def tool_raised(state: State, seat: Seat) -> bool:
    """The target went up, and something else is still nearer."""
    return at_rest(state) and float(target_distances(state)[BENCH]) > 0.2


def elbow_stopped(state: State, seat: Seat) -> bool:
    """The elbow rests at the safety distance to the ceiling."""
    return at_rest(state) and touches(state, CEILING, ELBOW_POINT)


def elbow_warned(state: State, seat: Seat) -> bool:
    """The elbow rests within the warning distance."""
    zones = state.problem.zones
    return at_rest(state) and zones.critical + TOUCH < elbow_to_ceiling(state) < zones.warning


def shoulder_lowered(state: State, seat: Seat) -> bool:
    """The shoulder was lowered."""
    return at_rest(state) and bool(state.arm.q[SHOULDER] < state.robot.poses["ready"][SHOULDER] - LOWERED)


def stopped_by_elbow(state: State, seat: Seat) -> bool:
    """The target is far from every plane, and the arm does not reach it, as its elbow is at the ceiling."""
    is_free = bool(np.all(target_distances(state) > state.problem.zones.warning))
    return elbow_stopped(state, seat) and is_free and missing(state) > SHORT


def target_beyond(state: State, seat: Seat) -> bool:
    """The target itself is too near to a plane, or beyond it."""
    return at_rest(state) and bool(np.any(target_distances(state) <= state.problem.zones.warning))


def target_reached(state: State, seat: Seat) -> bool:
    """The target was reached."""
    is_asked = isinstance(state.request.command, MoveToPose)
    return at_rest(state) and is_asked and missing(state) < TOUCH and not target_let_go(state, seat)


def target_let_go(state: State, seat: Seat) -> bool:
    """The elbow is at the ceiling, but the target is at the arm: released, it has come back, or it was not far off."""
    return elbow_stopped(state, seat) and isinstance(state.request.command, MoveToPose) and missing(state) <= SHORT


def in_the_corner(state: State, seat: Seat) -> bool:
    """The tool rests at the left wall and at the bench at once."""
    return at_rest(state) and touches(state, LEFT, TOOL_POINT) and touches(state, BENCH, TOOL_POINT)


def at_one_plane(state: State, seat: Seat) -> bool:
    """The tool rests at one of the two planes alone."""
    return at_rest(state) and touches(state, LEFT, TOOL_POINT) != touches(state, BENCH, TOOL_POINT)


def at_right_wall(state: State, seat: Seat) -> bool:
    """The tool rests at the right wall."""
    return at_rest(state) and touches(state, RIGHT, TOOL_POINT)


def ceiling_drop(state: State) -> float:
    """How far the ceiling was moved down along its normal, m."""
    return float(state.problem.planes.offsets[CEILING] - state.robot.panes[CEILING].offset)


def ceiling_stopped(state: State, seat: Seat) -> bool:
    """The ceiling was pulled down as far as it goes, and the arm is where it was."""
    moved = float(np.abs(state.arm.q - state.robot.poses["ready"]).max())
    return abs(least(state, CEILING) - state.problem.zones.critical) <= TOUCH and ceiling_drop(state) > OFF > moved


def ceiling_on_its_way(state: State, seat: Seat) -> bool:
    """The ceiling was pulled down, but could go further."""
    return ceiling_drop(state) > TOUCH and least(state, CEILING) > state.problem.zones.critical + TOUCH


def ceiling_raised(state: State, seat: Seat) -> bool:
    """The ceiling was pushed up."""
    return ceiling_drop(state) < -TOUCH


def is_wider(state: State) -> bool:
    """Whether the safety distance is as wide as was asked for."""
    return abs(state.problem.zones.critical - WIDER) < AS_ASKED


def at_wider_wall(state: State, seat: Seat) -> bool:
    """The tool rests at the left wall, at the wider safety distance."""
    return is_wider(state) and at_rest(state) and touches(state, LEFT, TOOL_POINT)


def at_wall_as_before(state: State, seat: Seat) -> bool:
    """The tool rests at the left wall, but the safety distance has not been changed."""
    return not is_wider(state) and at_rest(state) and touches(state, LEFT, TOOL_POINT)


def another_distance(state: State, seat: Seat) -> bool:
    """The safety distance was changed to something else."""
    return not is_wider(state) and abs(state.problem.zones.critical - CRITICAL) > AS_ASKED


def is_parked(state: State, seat: Seat) -> bool:
    """The arm is parked and rests, without a command to come back."""
    return state.arm.parked and not state.arm.moving and isinstance(state.request.command, HoldPosition)


def room_measured(state: State, seat: Seat) -> bool:
    """All three planes were found in clouds, near to where the simulated room has them."""
    found = [reading.name for reading in PLANE_READINGS if reading.name in state.clouds]
    if len(found) < len(PLANE_READINGS):
        return False
    return all(tilt(state, pane.name, pane.normal) < AS_MEASURED for pane in state.robot.panes if pane.name in found)


def has_plane(state: State, name: str) -> bool:
    """Whether there is a plane of this name."""
    return name in state.problem.planes.names


def read_from_the_file(state: State, seat: Seat) -> bool:
    """The planes are those of the robot's file again; nothing was measured."""
    ceiling = state.robot.panes[CEILING]
    return not state.clouds and has_plane(state, ceiling.name) and tilt(state, ceiling.name, ceiling.normal) < 1e-6


def measured_in_part(state: State, seat: Seat) -> bool:
    """The measurement has ended before all planes were found."""
    return 0 < len(state.clouds) < len(PLANE_READINGS) and not state.arm.moving


def shields(state: State) -> list[int]:
    """The planes that somebody added and that a stretched arm would pierce."""
    tool = with_joints(state, np.array(state.robot.poses["zero"])).T_world_tool[:3, 3]
    far = distances_of(state, tool[None])[0]
    return [k for k in added(state) if far[k] < 0]


def added(state: State) -> list[int]:
    """The planes that are not in the robot's file."""
    known = {pane.name for pane in state.robot.panes}
    return [k for k, name in enumerate(state.problem.planes.names) if name not in known]


def shield_holds(state: State, seat: Seat) -> bool:
    """The arm rests at the plane that was added."""
    critical = state.problem.zones.critical
    return at_rest(state) and any(abs(least(state, k) - critical) <= TOUCH for k in shields(state))


def no_shield(state: State, seat: Seat) -> bool:
    """A plane was added, but a stretched arm would not reach it."""
    return bool(added(state)) and not shields(state)


VALUES = {
    "elbow_at_first": Value(lambda state, _: elbow_to_ceiling(at_ready(state)), "mm"),
    "tool_at_first": Value(lambda state, _: plane_distances(at_ready(state))[TOOL_POINT, BENCH], "mm"),
    "height_at_first": Value(lambda state, _: at_ready(state).monitored_points[ELBOW_POINT][2], "mm"),
    "shoulder_at_first": Value(lambda state, _: state.robot.poses["ready"][SHOULDER], "°"),
    "nearest": Value(lambda state, _: plane_distances(state).min(), "mm"),
    "elbow_ceiling": Value(lambda state, _: elbow_to_ceiling(state), "mm"),
    "safe": Value(lambda state, _: state.problem.zones.critical, "mm"),
    "warning": Value(lambda state, _: state.problem.zones.warning, "mm"),
    "shell": fixed(SHELL_THICKNESS, "mm"),
    "reserve": fixed(CRITICAL - SHELL_THICKNESS, "mm"),
    "asked": fixed(ASKED, "°"),
    "shoulder": Value(lambda state, _: state.arm.q[SHOULDER], "°"),
    "shoulder_height": Value(lambda state, _: state.monitored_points[1][2], "mm"),
    "upper_arm": Value(
        lambda state, _: float(np.linalg.norm(state.monitored_points[ELBOW_POINT] - state.monitored_points[1])), "mm"
    ),
    "missing": Value(lambda state, _: missing(state), "mm"),
    "back": Value(lambda state, _: np.array(BACK), "mm"),
    "back_free": Value(lambda state, _: distances_of(state, np.array([BACK])).min(), "mm"),
    "far_left": fixed(0.500, "mm"),
    "far_down": fixed(-0.200, "mm"),
    "in_front": fixed(0.700, "mm"),
    "edge": Value(lambda state, _: to_the_edge(state), "mm"),
    "drop": Value(lambda state, _: ceiling_drop(state), "mm"),
    "wider": fixed(WIDER, "mm"),
    "walls": Value(lambda state, _: between_walls(state), "mm"),
    "corridor": Value(lambda state, _: corridor(state), "mm"),
    "elbow_x": Value(lambda state, _: parked_elbow(state)[0], "mm"),
    "elbow_parked": Value(lambda state, _: parked_elbow(state)[1], "mm"),
    "pane_edge": Value(lambda state, _: pane_edge(state), "mm"),
    "tilt_left": Value(lambda state, _: left_wall_tilt(state), "°", 1),
    "noise": fixed(NOISE, "mm"),
    "outliers": fixed(OUTLIERS, "%"),
    "points": Value(lambda state, _: float(sum(len(cloud.points) for cloud in state.clouds.values())), decimals=0),
}

STEPS = (
    Step(
        "nearest",
        start,
        tool_nearest,
        ((target_at(0.60, 0.0, 0.11), 3.0),),
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("raised", tool_raised, ((target_at(0.60, 0.0, 0.25), 3.0),)),),
        shown=Shown(hidden=("distances",), camera="first"),
    ),
    Step(
        "zones",
        start,
        elbow_stopped,
        ((gate.set_joint(SHOULDER, ASKED), 3.0),),
        joints=(SHOULDER,),
        prediction=Estimate(lambda state, _: shoulder_at_stop(state), "°", within=4.0, reveal="done"),
        diagnoses=(
            Diagnosis("warned", elbow_warned, ((gate.set_joint(SHOULDER, radians(37.0)), 3.0),)),
            Diagnosis("lowered", shoulder_lowered, ((gate.set_joint(SHOULDER, radians(10.0)), 3.0),)),
        ),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "elbow",
        start,
        stopped_by_elbow,
        ((target_at(*BACK), 4.0),),
        held_for=0.5,
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(
            Diagnosis("beyond", target_beyond, ((target_at(0.60, 0.0, 0.70), 5.0),)),
            Diagnosis("let_go", target_let_go, ((dragged_to(*BACK), 6.0),)),
            Diagnosis("reached", target_reached, ((target_at(0.60, 0.0, 0.13), 4.0),)),
        ),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "corner",
        start,
        in_the_corner,
        ((target_at(0.60, 0.50, -0.20), 6.0),),
        prediction=Estimate(lambda state, _: to_the_edge(state), "mm", within=12.0, reveal="done"),
        diagnoses=(
            Diagnosis("right", at_right_wall, ((target_at(0.60, -0.50, 0.15), 5.0),)),
            Diagnosis("one", at_one_plane, ((target_at(0.60, 0.50, 0.20), 5.0),)),
        ),
        shown=Shown(layers=("distances",), camera="first"),
    ),
    Step(
        "moving_plane",
        start,
        ceiling_stopped,
        ((ceiling_lowered(0.10), 1.0),),
        prediction=Choice(right=2, reveal="done"),
        diagnoses=(
            Diagnosis("further", ceiling_on_its_way, ((ceiling_lowered(0.02), 1.0),)),
            Diagnosis("raised", ceiling_raised, ((ceiling_lowered(-0.05), 1.0),)),
        ),
        shown=Shown(layers=("distances",), camera="side"),
    ),
    Step(
        "corridor",
        start,
        at_wider_wall,
        ((gate.set_zones(WIDER, WIDER + 0.03), 0.5), (target_at(0.60, 0.50, 0.17), 5.0)),
        prediction=Estimate(lambda state, _: corridor(state), "mm", within=15.0),
        diagnoses=(
            Diagnosis("as_before", at_wall_as_before, ((target_at(0.60, 0.50, 0.17), 5.0),)),
            Diagnosis("another", another_distance, ((gate.set_zones(0.10, 0.13), 0.5),)),
        ),
        shown=Shown(layers=("distances",), camera="top", tab="robot"),
    ),
    Step(
        "measuring",
        start_in_a_box,
        room_measured,
        measuring(len(PLANE_READINGS)),
        prediction=Estimate(lambda state, _: left_wall_tilt(state), "°", within=2.0, reveal="done"),
        diagnoses=(
            Diagnosis("from_file", read_from_the_file, ((gate.restore_planes(), 0.5),)),
            Diagnosis("in_part", measured_in_part, measuring(1)),
        ),
        shown=Shown(camera="first", tab="robot"),
    ),
    Step(
        "parked",
        start,
        is_parked,
        ((gate.park(), 8.0),),
        prediction=Choice(right=1, reveal="done"),
        diagnoses=(Diagnosis("held", elbow_stopped, ((gate.set_joint(SHOULDER, radians(100.0)), 4.0),)),),
        shown=Shown(camera="side", tab="robot"),
    ),
    Step(
        "shield",
        start,
        shield_holds,
        ((gate.add_plane([-1.0, 0.0, 0.0, -0.70]), 0.5), (gate.go_to("zero"), 5.0)),
        diagnoses=(Diagnosis("elsewhere", no_shield, ((gate.add_plane([0.0, 1.0, 0.0, -0.20]), 0.5),)),),
        shown=Shown(layers=("distances",), camera="first", tab="robot"),
        is_open=True,
    ),
    Step(
        "explore",
        start,
        is_open=True,
        joints=(WAIST, SHOULDER, ELBOW, 3, 4),
        charts=("planes",),
        shown=Shown(layers=("distances",)),
    ),
)
