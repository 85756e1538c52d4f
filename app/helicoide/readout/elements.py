"""The objects of a State that people inspect, each with its multivector and, where it is a frame, its pose."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Literal

import numpy as np

from helicoide.arrays import Array
from helicoide.command import FollowPath, MoveToPose
from helicoide.geometry import rigid
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.seat import Selection
from helicoide.state import State
from helicoide.text import Text

Nature = Literal["motor", "line", "plane", "point"]
"""What a multivector represents."""
SYMBOLS: dict[Nature, str] = {"motor": "M", "line": r"\ell", "plane": r"\pi", "point": "p"}
"""The letter of a multivector, in TeX."""


@dataclass(frozen=True, eq=False)
class Element:
    """An object of the scene and its multivector.

    symbol: in TeX; values: from a state to the coefficients (16,) of `CL031`, m; pose: from a state to T_world_frame
    (4, 4), m, None for an object without a frame; index: a subscript of the symbol in plain text.
    """

    selection: Selection
    nature: Nature
    title: Text
    symbol: str
    values: Callable[[State], Array]
    pose: Callable[[State], Array] | None = None
    index: str = ""


def elements(state: State) -> tuple[Element, ...]:
    """All objects that can be inspected: frames, joint axes, planes and points, as multivectors of Cl(0,3,1)."""
    following = isinstance(state.request.command, FollowPath)
    return _elements(state.robot, state.problem.planes.panes, state.problem.entry is not None, following)


def element_of(state: State, selection: Selection | None) -> Element | None:
    """The object of a selection; None if nothing is selected or the object no longer exists."""
    return next((element for element in elements(state) if element.selection == selection), None)


@lru_cache(maxsize=128)  # enough for a class of thirty, each with its own arm and planes
def _elements(robot: Robot, panes: tuple[PlanePane, ...], with_entry: bool, with_path: bool) -> tuple[Element, ...]:
    return (
        *_frames(robot, with_path),
        *_lines(robot),
        *_planes(panes),
        *_points(robot),
        *([ENTRY] if with_entry else []),
    )


def _moving(selection: Selection, title: Text, symbol: str, pose: Callable[[State], Array], index: str = "") -> Element:
    """A frame, with its pose as a motor of canonical sign."""

    def values(state: State) -> Array:
        return rigid.motor_from_pose(pose(state))

    return Element(selection, "motor", title, symbol, values, pose, index)


def _frames(robot: Robot, with_path: bool) -> Iterator[Element]:
    yield _moving(Selection("tool"), TOOL, "M", lambda state: state.T_world_tool)
    yield _moving(Selection("target"), TARGET, "M_d", _target_pose)
    if with_path:
        yield _moving(Selection("path"), PATH, "M_s", _path_pose)
    for i, joint in enumerate(robot.joints):
        title = LINK.format(n=i + 1, joint=joint.title)
        yield _moving(Selection("link", i), title, f"M_{i + 1}", partial(_link_pose, i))
    for i, frame in enumerate(robot.frames.values()):
        title = FRAME.format(name=frame.title)
        yield _moving(Selection("frame", i), title, "M", partial(_frame_pose, frame.name), frame.name)


def _target_pose(state: State) -> Array:
    """T_world_target (4, 4), m: where the gizmo of the target is, which follows the tool while nothing is asked."""
    command = state.request.command
    return command.T_world_target if isinstance(command, MoveToPose) else state.T_world_tool


def _path_pose(state: State) -> Array:
    command = state.request.command
    return command.path.pose(command.s) if isinstance(command, FollowPath) else state.T_world_tool


def _link_pose(i: int, state: State) -> Array:
    return np.asarray(state.arm.poses[i + 1])


def _frame_pose(name: str, state: State) -> Array:
    frame = state.robot.frames[name]
    return np.asarray(state.arm.poses[frame.link] @ frame.T_link_frame)


def _lines(robot: Robot) -> Iterator[Element]:
    def line(i: int, state: State) -> Array:
        return rigid.line(state.axes[i], state.arm.poses[i + 1, :3, 3])

    for i, joint in enumerate(robot.joints):
        title = AXIS.format(n=i + 1, joint=joint.title)
        yield Element(Selection("joint", i), "line", title, rf"\ell_{i + 1}", partial(line, i))


def _planes(panes: tuple[PlanePane, ...]) -> Iterator[Element]:
    def plane(k: int, state: State) -> Array:
        planes = state.problem.planes
        return rigid.plane(planes.normals[k], planes.offsets[k])

    for k, pane in enumerate(panes):
        title = PLANE.format(name=pane.name, pane=pane.title)
        yield Element(Selection("plane", k), "plane", title, r"\pi", partial(plane, k), index=pane.name)


def _points(robot: Robot) -> Iterator[Element]:
    def point(j: int, state: State) -> Array:
        return rigid.point(state.monitored_points[j])

    for j, monitored in enumerate(robot.monitored):
        title = POINT.format(point=monitored.title)
        yield Element(Selection("point", j), "point", title, f"p_{j + 1}", partial(point, j))


def _entry_values(state: State) -> Array:
    entry = state.problem.entry
    return rigid.point(state.T_world_tool[:3, 3] if entry is None else entry.point)


TOOL = Text(en="end-effector motor", pt_BR="motor do efetuador")
TARGET = Text(en="target motor", pt_BR="motor do alvo")
PATH = Text(en="motor of the current path point", pt_BR="motor do ponto atual da trajetória")
LINK = Text(en="motor of link {n} ({joint})", pt_BR="motor do elo {n} ({joint})")
FRAME = Text(en="motor of the frame: {name}", pt_BR="motor do referencial: {name}")
AXIS = Text(en="axis of joint {n} ({joint})", pt_BR="eixo da junta {n} ({joint})")
PLANE = Text(en="plane {name} ({pane})", pt_BR="plano {name} ({pane})")
POINT = Text(en="point: {point}", pt_BR="ponto: {point}")
ENTRY = Element(
    Selection("entry"), "point", Text(en="entry point (RCM)", pt_BR="ponto de entrada (RCM)"), "p_E", _entry_values
)
