"""The named multivectors of a State, and distances as products of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from helicoide.geometry import rigid
from helicoide.geometry.clifford import CL031
from helicoide.kinematics.chain import Array
from helicoide.state import State
from helicoide.text import Text


@dataclass(frozen=True, eq=False)
class Reading:
    """A multivector of the scene: a key that names its object, a title, a symbol, and how it is worked out.

    symbol: in TeX; index: a name, which is not TeX, to stand below it.
    """

    key: str
    title: Text
    symbol: str
    work_out: Callable[[], Array]
    index: str = ""

    @cached_property
    def values(self) -> Array:
        """The sixteen coefficients (16,), m."""
        return self.work_out()


def readings(state: State) -> list[Reading]:
    """Tool motor, joint lines, planes and guarded points as multivectors of Cl(0,3,1)."""
    return [_tool(state), *_lines(state), *_planes(state), *_points(state)]


def chosen(state: State, key: str | None) -> Reading | None:
    """The reading of a key; None without one, and where its object has gone."""
    return None if key is None else next((reading for reading in readings(state) if reading.key == key), None)


def _tool(state: State) -> Reading:
    title = Text(en="tool motor", pt_BR="motor do efetuador")
    return Reading("tool", title, "M", lambda: rigid.canonical(rigid.motor_from_pose(state.T_world_tool)))


def _lines(state: State) -> list[Reading]:
    title = Text(en="axis of joint {n} ({joint})", pt_BR="eixo da junta {n} ({joint})")
    return [
        Reading(
            f"joint {i}",
            title.format(n=i + 1, joint=joint.title),
            rf"\ell_{i + 1}",
            partial(lambda i: rigid.line(state.axes[i], state.arm.poses[i + 1, :3, 3]), i),
        )
        for i, joint in enumerate(state.robot.joints)
    ]


def _planes(state: State) -> list[Reading]:
    planes, title = state.problem.planes, Text(en="plane {name} ({pane})", pt_BR="plano {name} ({pane})")
    return [
        Reading(
            f"plane {k}",
            title.format(name=pane.name, pane=pane.title),
            r"\pi",
            partial(lambda k: rigid.plane(planes.normals[k], planes.offsets[k]), k),
            pane.name,
        )
        for k, pane in enumerate(state.problem.planes.panes)
    ]


def _points(state: State) -> list[Reading]:
    title = Text(en="point: {point}", pt_BR="ponto: {point}")
    return [
        Reading(
            f"point {j}",
            title.format(point=point.title),
            rf"p_{j + 1}",
            partial(lambda j: rigid.point(state.guarded_points[j]), j),
        )
        for j, point in enumerate(state.robot.guarded)
    ]


def distance_product(state: State, point: int, plane: int) -> Array:
    """πp − pπ = 2 l e1e2e3e of a guarded point and a plane, (16,), m. Source: Cerbaro 2022, eq. 19."""
    pi = rigid.plane(state.problem.planes.normals[plane], state.problem.planes.offsets[plane])
    p = rigid.point(state.guarded_points[point])
    return np.subtract(CL031.product(pi, p), CL031.product(p, pi))
