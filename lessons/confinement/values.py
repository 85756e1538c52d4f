"""The values of the pages, and what they are read from."""

from __future__ import annotations

from math import radians, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.confinement.zones import SHELL_THICKNESS
from helicoide.geometry import incidence, rigid
from helicoide.lesson import Value, fixed
from helicoide.perception.enclosure_reading import NOISE, OUTLIERS
from helicoide.readout import plane_distances
from helicoide.readout.distances import distances_of
from helicoide.state import State, with_joints

WAIST, SHOULDER, ELBOW = 0, 1, 2
ELBOW_POINT, TOOL_POINT = 2, 4
CEILING, LEFT, RIGHT, BENCH = 0, 1, 2, 3
ASKED = radians(60.0)
CRITICAL, WARNING, WIDER, AS_ASKED = 0.080, 0.110, 0.120, 1.5e-3
BACK = 0.40, 0.0, 0.35
ZONES_WITHIN, LEAN_WITHIN = radians(4.0), radians(1.0)
CORNER_WITHIN, CORRIDOR_WITHIN = 0.012, 0.015


def elbow_to_ceiling(state: State) -> float:
    """The distance of the elbow to the ceiling, m."""
    return float(plane_distances(state)[ELBOW_POINT, CEILING])


def missing(state: State) -> float:
    """The distance of the tool from its target, m; 0 without a target."""
    command = state.request.command
    if not isinstance(command, MoveToPose):
        return 0.0
    return float(np.linalg.norm(command.T_world_target[:3, 3] - state.T_world_tool[:3, 3]))


def at_ready(state: State) -> State:
    """The state with the arm at `ready`."""
    return with_joints(state, np.array(state.robot.poses["ready"]))


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


def parked_elbow(state: State) -> tuple[float, float, float]:
    """Of the elbow when the arm is parked: how far ahead of the base, how high, and from the measured ceiling, m."""
    elbow = with_joints(state, np.array(state.robot.poses["home"])).monitored_points[ELBOW_POINT]
    pane = state.robot.panes[CEILING]
    return float(elbow[0]), float(elbow[2]), float(pane.normal @ elbow - pane.offset)


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


def lean(normal: Array) -> float:
    """How much a wall leans towards its inner side, rad; 0 if it is upright."""
    return float(np.arcsin(-normal[2]))


def left_wall_lean(state: State) -> float:
    """How much the left wall leans inwards, rad; 0 without that wall."""
    planes = state.problem.planes
    return lean(planes.normals[planes.names.index("+y")]) if "+y" in planes.names else 0.0


def corner_edge(state: State) -> float:
    """How far from the edge a point is that is at the safety distance to the left wall and the bench, m."""
    return float(CRITICAL / np.sin((np.pi / 2 - lean(state.robot.panes[LEFT].normal)) / 2))


def level_stop(state: State) -> float:
    """The angle at which the shoulder would stop under a level ceiling, rad."""
    first = at_ready(state)
    shoulder, elbow = first.monitored_points[[SHOULDER, ELBOW_POINT]]
    rise = elbow[2] + elbow_to_ceiling(first) - CRITICAL - shoulder[2]
    return float(np.arcsin(rise / np.linalg.norm(elbow - shoulder)))


def ceiling_drop(state: State) -> float:
    """How far the ceiling was moved down along its normal, m."""
    return float(state.problem.planes.offsets[CEILING] - state.robot.panes[CEILING].offset)


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
    "square": fixed(CRITICAL * sqrt(2), "mm"),
    "level_stop": Value(lambda state, _: level_stop(state), "°"),
    "zones_within": fixed(ZONES_WITHIN, "°"),
    "corner_within": fixed(CORNER_WITHIN, "mm"),
    "corridor_within": fixed(CORRIDOR_WITHIN, "mm"),
    "drop": Value(lambda state, _: ceiling_drop(state), "mm"),
    "wider": fixed(WIDER, "mm"),
    "walls": Value(lambda state, _: between_walls(state), "mm"),
    "corridor": Value(lambda state, _: corridor(state), "mm"),
    "elbow_x": Value(lambda state, _: parked_elbow(state)[0], "mm"),
    "elbow_parked": Value(lambda state, _: parked_elbow(state)[2], "mm"),
    "elbow_z": Value(lambda state, _: parked_elbow(state)[1], "mm"),
    "ceiling_height": Value(lambda state, _: state.robot.panes[CEILING].centre[2], "mm"),
    "pane_edge": Value(lambda state, _: pane_edge(state), "mm"),
    "tilt_left": Value(lambda state, _: left_wall_lean(state), "°", 1),
    "corner_edge": Value(lambda state, _: corner_edge(state), "mm", 1),
    "lean_within": fixed(LEAN_WITHIN, "°"),
    "noise": fixed(NOISE, "mm"),
    "outliers": fixed(OUTLIERS, "%"),
    "points": Value(lambda state, _: float(sum(len(cloud.points) for cloud in state.clouds.values())), decimals=0),
}
