"""The predefined paths of an arm: three for any arm, which begin at its `ready` posture, and those of its source."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.command import PathChoice
from helicoide.ik.rcm.paths import PATHS as COUTINHO
from helicoide.kernels import python_function
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import plane_normal
from helicoide.text import HelicoideError, Text, untranslated
from helicoide.trajectory.cerbaro import EQ_33, EQ_34, EQ_35, MOVEMASTER_ELLIPSE, ORCA_CIRCLE
from helicoide.trajectory.loop import EllipsePath
from helicoide.trajectory.path import Path
from helicoide.trajectory.path_chain import PathChain
from helicoide.trajectory.pose_paths import LinePath
from helicoide.trajectory.time_optimal import TimingShape
from helicoide.trajectory.timing import ConstantSpeed, MinimumJerk, TimedPath, TimeScaling, TrapezoidalVelocity
from helicoide.trajectory.vargas import VARGAS

# LONG: half the line and longer semi-axis; SHORT: shorter semi-axis; both as fractions of the reach. TIME: duration, s.
LONG, SHORT, TIME = 0.1, 0.05, 20.0
SHORTEST, LONGEST = 2.0, 300.0
FIVE = 5  # joints, one less than an arbitrary pose needs
LAST_PLANAR = 5  # number of the last planar trajectory of Vargas
RAMP, ABOVE = 0.25, 1e-6
MEETS = Text(en="Cerbaro 2022, eq. {n} (meets the planes)", pt_BR="Cerbaro 2022, eq. {n} (encontra os planos)")
LAWS: Mapping[TimingShape, tuple[Text, TimeScaling]] = MappingProxyType(
    {
        "constant speed": (Text(en="constant speed", pt_BR="velocidade constante"), ConstantSpeed()),
        "trapezoid": (Text(en="trapezoidal velocity", pt_BR="perfil trapezoidal"), TrapezoidalVelocity(RAMP)),
        "minimum jerk": (Text(en="minimum jerk", pt_BR="jerk mínimo"), MinimumJerk()),
    }
)


@dataclass(frozen=True, eq=False)
class Preset:
    """A path with its name."""

    title: Text
    path: Path


@lru_cache(maxsize=16)
def presets(robot: Robot) -> Mapping[str, Preset]:
    """The paths of an arm by their keys; the first is the default."""
    return {key: Preset(title, path) for key, title, path in (*_of_any(robot), *_of_source(robot))}


def path_of(robot: Robot, course: PathChoice) -> Path:
    """The path of a choice with its time scaling. Raises HelicoideError for an unknown path or an invalid duration."""
    known = presets(robot)
    name = next(iter(known)) if course.name is None else course.name
    if name not in known or course.shape not in LAWS:
        raise HelicoideError(
            Text(
                en="There is no path {name!r} with the time scaling {shape!r}; paths: {paths}; time scalings: "
                "{shapes}.",
                pt_BR="Não há trajetória {name!r} com a lei de tempo {shape!r}; trajetórias: {paths}; leis de tempo: "
                "{shapes}.",
            ).format(name=name, shape=course.shape, paths=", ".join(known), shapes=", ".join(LAWS))
        )
    duration = known[name].path.duration if course.duration is None else course.duration
    if not SHORTEST <= duration <= LONGEST:
        raise HelicoideError(
            Text(
                en="The duration of a path must be {least:g} to {most:g} s, not {given:g}.",
                pt_BR="A duração de uma trajetória vai de {least:g} a {most:g} s, não {given:g}.",
            ).format(least=SHORTEST, most=LONGEST, given=duration)
        )
    return _in_time(robot, name, course.shape, duration)


def title_of(robot: Robot, course: PathChoice) -> Text:
    """The title of a path of the arm."""
    known = presets(robot)
    return known[course.name or next(iter(known))].title


@lru_cache(maxsize=16)
def _in_time(robot: Robot, name: str, shape: TimingShape, duration: float) -> Path:
    path = presets(robot)[name].path
    unchanged = shape == "constant speed" and duration == path.duration
    return path if unchanged else TimedPath(path, LAWS[shape][1], duration)


def _of_source(robot: Robot) -> Iterator[tuple[str, Text, Path]]:
    match robot.name:
        case "movemaster":
            for number, path in ((33, EQ_33), (34, EQ_34), (35, EQ_35)):
                yield f"eq{number}", MEETS.format(n=number), path
            yield "demonstration", untranslated("Cerbaro 2022, §4.4.4"), MOVEMASTER_ELLIPSE
        case "orca":
            yield "demonstration", untranslated("Cerbaro 2022, §4.4.3"), ORCA_CIRCLE
        case "planar3r" | "zebra_zero":
            title = Text(en="Vargas 2013, trajectory {n}", pt_BR="Vargas 2013, trajetória {n}")
            for number, trajectory in VARGAS.items():
                if (number <= LAST_PLANAR) == (robot.name == "planar3r"):
                    yield f"vargas{number}", title.format(n=number), trajectory
        case "dia10" | "dia10_rod":
            for name, way in COUTINHO.items():
                yield name, untranslated("Coutinho 2015, {name}").format(name=name), way.of(_ready(robot))


def _ready(robot: Robot) -> Array:
    """The tool pose at `ready`, T_world_tool (4, 4), m. Uses no compiled kernel."""
    return frozen(python_function(link_poses)(robot.chain, robot.poses["ready"])[-1] @ robot.T_link_tool)


def _of_any(robot: Robot) -> Iterator[tuple[str, Text, Path]]:
    """Ellipse, circle and line in a horizontal plane, or in that of a planar arm; the loops extend towards the base.

    With five joints the tool keeps its orientation only in the vertical plane through the first axis and the tool. The
    paths lie in that plane, the longer axis vertical.
    """
    T, normal = _ready(robot), plane_normal(robot)
    n = np.array([0.0, 0.0, 1.0]) if normal is None else normal
    outward = _outward(T[:3, 3] - robot.points[0], n)
    upright = normal is None and len(robot.variables) == FIVE
    if upright:
        n = np.cross(outward, n)
    sideways, long, short = np.cross(n, outward), LONG * robot.reach, SHORT * robot.reach
    there, back = (_moved(T, way * sideways) for way in (long, -long))
    ways = LinePath(T, there, TIME / 4), LinePath(there, back, TIME / 2), LinePath(back, T, TIME / 4)
    plane = np.eye(4)
    plane[:3] = np.column_stack([outward, sideways, n, T[:3, 3] - short * outward])
    round_ = EllipsePath(frozen(plane), (short, short), frozen(T[:3, :3]), TIME)
    flat = (short / 2, short) if upright else (short, long)
    plane[:3, 3] = T[:3, 3] - flat[0] * outward
    oval = EllipsePath(frozen(plane), flat, frozen(T[:3, :3]), TIME)
    yield "ellipse", Text(en="ellipse", pt_BR="elipse"), oval
    yield "circle", Text(en="circle", pt_BR="círculo"), round_
    yield "line", Text(en="straight line, back and forth", pt_BR="reta, ida e volta"), PathChain(ways)


def _moved(T: Array, way: Array) -> Array:
    moved = T.copy()
    moved[:3, 3] += way
    return frozen(moved)


def _outward(way: Array, normal: Array) -> Array:
    """The unit vector along a displacement without its part along a normal; any such vector if they are parallel."""
    level = way - (way @ normal) * normal
    if np.linalg.norm(level) < ABOVE:
        level = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    return np.asarray(level / np.linalg.norm(level))
