"""How the steps begin, when each is done, and how its mistakes are recognised."""

from __future__ import annotations

from math import radians

import numpy as np

from helicoide import gate
from helicoide.arrays import Array
from helicoide.command import HoldPosition, MoveToJoints, MoveToPose
from helicoide.geometry import rotation
from helicoide.ik import Contact
from helicoide.lesson import Solution
from helicoide.perception.camera import SimulatedCamera
from helicoide.perception.enclosure_reading import NOISE, OUTLIERS, PLANE_READINGS, camera_cloud, plane_in_cloud
from helicoide.readout import nearest_point_and_plane, plane_distances
from helicoide.readout.distances import distances_of
from helicoide.seat import Seat
from helicoide.state import State, Update, with_joints

from .values import (
    AS_ASKED,
    ASKED,
    BENCH,
    CEILING,
    CRITICAL,
    ELBOW_POINT,
    LEFT,
    RIGHT,
    SHOULDER,
    TOOL_POINT,
    WARNING,
    WIDER,
    ceiling_drop,
    elbow_to_ceiling,
    missing,
    tilt,
)

LOWERED = radians(5.0)
TOUCH, SHORT, OFF = 1e-3, 0.020, 0.020
SLOW = 0.01  # rad/s; at a plane an arm may creep along it for seconds
BOX = (0.20, -0.32, 0.0), (0.90, 0.32, 0.64)
PHASES: tuple[gate.Phase, ...] = ("start", "end")
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


def target_distances(state: State) -> Array:
    """The distances of the target to the planes, (k,), m; nan without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return np.full(len(state.problem.planes.panes), np.nan)
    return np.asarray(distances_of(state, command.T_world_target[None, :3, 3])[0])


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
