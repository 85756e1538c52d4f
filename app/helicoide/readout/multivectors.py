"""The named multivectors of a State, and the distance from a point to a plane as a product."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.state import State
from helicoide.text import Text


@dataclass(frozen=True, eq=False)
class Reading:
    """A named multivector of the scene.

    key: names its object; symbol: in TeX; at: from a state to the coefficients (16,), m; index: a subscript of the
    symbol in plain text.
    """

    key: str
    title: Text
    symbol: str
    at: Callable[[State], Array]
    index: str = ""


def readings(state: State) -> tuple[Reading, ...]:
    """Tool motor, joint lines, planes and monitored points as multivectors of Cl(0,3,1)."""
    return _readings(state.robot, state.problem.planes.panes)


def chosen_reading(state: State, key: str | None) -> Reading | None:
    """The reading with this key; None if key is None or its object no longer exists."""
    return None if key is None else next((reading for reading in readings(state) if reading.key == key), None)


@lru_cache(maxsize=128)  # enough for a class of thirty, each with its own arm and planes
def _readings(robot: Robot, panes: tuple[PlanePane, ...]) -> tuple[Reading, ...]:
    return _tool(), *_lines(robot), *_planes(panes), *_points(robot)


def _tool() -> Reading:
    title = Text(en="end-effector motor", pt_BR="motor do efetuador")
    return Reading("tool", title, "M", lambda state: rigid.canonical(rigid.motor_from_pose(state.T_world_tool)))


def _lines(robot: Robot) -> Iterator[Reading]:
    title = Text(en="axis of joint {n} ({joint})", pt_BR="eixo da junta {n} ({joint})")

    def line(i: int, state: State) -> Array:
        return rigid.line(state.axes[i], state.arm.poses[i + 1, :3, 3])

    for i, joint in enumerate(robot.joints):
        said = title.format(n=i + 1, joint=joint.title)
        yield Reading(f"joint {i}", said, rf"\ell_{i + 1}", partial(line, i))


def _planes(panes: tuple[PlanePane, ...]) -> Iterator[Reading]:
    title = Text(en="plane {name} ({pane})", pt_BR="plano {name} ({pane})")

    def plane(k: int, state: State) -> Array:
        planes = state.problem.planes
        return rigid.plane(planes.normals[k], planes.offsets[k])

    for k, pane in enumerate(panes):
        yield Reading(f"plane {k}", title.format(name=pane.name, pane=pane.title), r"\pi", partial(plane, k), pane.name)


def _points(robot: Robot) -> Iterator[Reading]:
    title = Text(en="point: {point}", pt_BR="ponto: {point}")

    def point(j: int, state: State) -> Array:
        return rigid.point(state.monitored_points[j])

    for j, guarded in enumerate(robot.monitored):
        yield Reading(f"point {j}", title.format(point=guarded.title), rf"p_{j + 1}", partial(point, j))


def distance_product(state: State, point: int, plane: int) -> Array:
    """πp − pπ = 2 l e1e2e3e of a monitored point and a plane, (16,), m. Source: Cerbaro 2022, eq. 19."""
    pi = rigid.plane(state.problem.planes.normals[plane], state.problem.planes.offsets[plane])
    p = rigid.point(state.monitored_points[point])
    return np.subtract(CL031.product(pi, p), CL031.product(p, pi))
