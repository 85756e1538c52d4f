"""The values of the pages, and what they are read from."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, radians

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import incidence, rigid
from helicoide.geometry.clifford import CL031
from helicoide.geometry.multivector import Multivector
from helicoide.lesson import Value, fixed
from helicoide.readout import distance_product, plane_distances
from helicoide.state import State

WAIST, SHOULDER = 0, 1
SHOULDER_POINT, ELBOW_POINT, WRIST_POINT, TOOL_POINT = 1, 2, 3, 4
CEILING, BENCH = 0, 3
LIFTED = radians(8.0)
RAISED, ASIDE, MARKED, ALLOWED = 0.100, 0.030, 0.050, 0.005
SHIFTED, TILTED = 0.030, radians(0.5)
QUARTER = pi / 2
E1, E2, E3, E, E3E1 = (Multivector(CL031.blade(name), CL031) for name in ("e1", "e2", "e3", "e", "e3e1"))


def rotor(blade: Multivector, angle: float) -> Multivector:
    """cos(θ/2) + B sin(θ/2)."""
    return blade * float(np.sin(angle / 2)) + float(np.cos(angle / 2))


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


def shoulder_line(state: State) -> Array:
    """The axis of the shoulder."""
    return rigid.line(state.axes[SHOULDER], state.arm.poses[SHOULDER + 1, :3, 3])


def ceiling_shift(state: State) -> float:
    """How much the offset of the ceiling has changed, m."""
    return abs(float(state.problem.planes.offsets[CEILING] - state.robot.panes[CEILING].offset))


def ceiling_tilt(state: State) -> float:
    """The angle by which the ceiling is tilted from where it was, rad."""
    normal, before = state.problem.planes.normals[CEILING], state.robot.panes[CEILING].normal
    return float(np.arctan2(np.linalg.norm(np.cross(normal, before)), normal @ before))


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
    "shoulder_place": Value(lambda state, _: state.robot.points[SHOULDER]),
    "shoulder_direction": Value(lambda state, _: state.robot.directions[SHOULDER], decimals=0),
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
    "allowed": fixed(ALLOWED, "mm"),
    "bench": element(lambda state: plane(state, BENCH)),
    "elbow_place": Value(lambda state, _: state.monitored_points[ELBOW_POINT], "mm"),
    "marked": fixed(MARKED, "mm"),
    "arm_plane": element(arm_plane),
    "arm_plane_back": element(lambda state: -arm_plane(state)),
    "forearm": element(forearm),
    "foot": Value(lambda state, _: rigid.coordinates(forearm_on_bench(state)), "mm"),
}
