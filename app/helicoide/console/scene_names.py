"""The names of the scene: motors of the links, joint axes and values, monitored points, planes, and the target."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial

from helicoide.arrays import Array
from helicoide.console.names import OF_AN_ARM, is_reserved
from helicoide.console.values import Value, multivector_value, quaternion_value
from helicoide.geometry import rigid, rotation
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.readout import target_pose
from helicoide.state import State
from helicoide.text import Text


@dataclass(frozen=True, eq=False)
class SceneName:
    """A name of the scene. title: what it stands for; at: from a state to its value."""

    name: str
    title: Text
    at: Callable[[State], Value]


def scene_names(state: State) -> dict[str, SceneName]:
    """All names of the scene of a state."""
    return _names(state.robot, state.problem.planes.panes)


def plane_names(state: State) -> tuple[str, ...]:
    """The names of the planes of a state, in their order."""
    names = tuple(scene_names(state))
    return names[len(names) - len(state.problem.planes.panes) :]


@lru_cache(maxsize=128)  # as many as the readings of the Algebra tab
def _names(robot: Robot, panes: tuple[PlanePane, ...]) -> dict[str, SceneName]:
    found: dict[str, SceneName] = {}
    for one in (*_frames(robot), *_joints(robot), *_target()):
        found[one.name] = one
    for k, point in enumerate(robot.monitored):
        name = _identifier((point.name, point.title.en), "point", k, found)
        title = Text(en="point: {title}", pt_BR="ponto: {title}").format(title=point.title)
        found[name] = SceneName(name, title, partial(_point, k))
    for k, pane in enumerate(panes):
        name = _identifier((pane.name, pane.title.en), "plane", k, found)
        title = Text(en="plane {name} ({title})", pt_BR="plano {name} ({title})")
        found[name] = SceneName(name, title.format(name=pane.name, title=pane.title), partial(_plane, k))
    return found


def _frames(robot: Robot) -> Iterator[SceneName]:
    yield SceneName("M_tool", Text(en="motor of the end effector", pt_BR="motor do efetuador"), _tool)
    title = Text(en="quaternion of the end effector", pt_BR="quatérnio do efetuador")
    yield SceneName("q_tool", title, lambda state: _quaternion(state.T_world_tool))
    for i in range(len(robot.joints)):
        title = Text(en="motor of link {n}", pt_BR="motor do elo {n}").format(n=i + 1)
        yield SceneName(f"M_link{i + 1}", title, partial(_link, i))


def _joints(robot: Robot) -> Iterator[SceneName]:
    for i, joint in enumerate(robot.joints):
        title = Text(en="axis of joint {n} ({joint})", pt_BR="eixo da junta {n} ({joint})")
        yield SceneName(f"L{i + 1}", title.format(n=i + 1, joint=joint.title), partial(_axis, i))
    for i, variable in enumerate(robot.variables):
        unit = "m" if variable.is_prismatic else "rad"
        title = Text(en="value of {joint}, {unit}", pt_BR="valor de {joint}, {unit}")
        yield SceneName(f"theta{i + 1}", title.format(joint=variable.name, unit=unit), partial(_value, i))


def _target() -> Iterator[SceneName]:
    yield SceneName("target", Text(en="point: the target", pt_BR="ponto: o alvo"), _target_point)
    yield SceneName("M_target", Text(en="motor of the target", pt_BR="motor do alvo"), _target_motor)


def _motor(T: Array) -> Value:
    return multivector_value(rigid.canonical(rigid.motor_from_pose(T)))


def _quaternion(T: Array) -> Value:
    return quaternion_value(rotation.from_matrix(T[:3, :3]))


def _tool(state: State) -> Value:
    return _motor(state.T_world_tool)


def _link(i: int, state: State) -> Value:
    return _motor(state.arm.poses[i + 1])


def _axis(i: int, state: State) -> Value:
    return multivector_value(rigid.line(state.axes[i], state.arm.poses[i + 1, :3, 3]))


def _value(i: int, state: State) -> Value:
    return float(state.arm.q[i])


def _point(k: int, state: State) -> Value:
    return multivector_value(rigid.point(state.monitored_points[k]))


def _plane(k: int, state: State) -> Value:
    planes = state.problem.planes
    return multivector_value(rigid.plane(planes.normals[k], planes.offsets[k]))


def _target_point(state: State) -> Value:
    return multivector_value(rigid.point(target_pose(state)[:3, 3]))


def _target_motor(state: State) -> Value:
    return _motor(target_pose(state))


def _identifier(names: tuple[str, ...], what: str, number: int, taken: dict[str, SceneName]) -> str:
    """A name that the grammar reads: the first of the names that has letters, else such as plane_1; never one twice."""
    plain = next(filter(None, map(_plain, names)), f"{what}_{number + 1}")
    if is_reserved(plain) or OF_AN_ARM.fullmatch(plain):
        plain = f"{what}_{plain}"
    name, count = plain, 1
    while name in taken:
        count += 1
        name = f"{plain}_{count}"
    return name


def _plain(name: str) -> str:
    """A name in letters without accents, digits and _; empty if it has other signs than blanks and hyphens."""
    letters = "".join(c for c in unicodedata.normalize("NFKD", name) if not unicodedata.combining(c))
    plain = re.sub(r"[\s_-]+", "_", letters.strip())[:24].rstrip("_")
    return plain if re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", plain) else ""
