"""Planes that people give, find or take away, and the zones in front of them.

A plane that would come too near to the arm stops at the critical distance from it, as one that is dragged does.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import frozen
from helicoide.confinement import (
    Plane,
    Planes,
    box_planes,
    from_coefficients,
    limited_plane_centre,
    pane_on_plane,
    through_points,
)
from helicoide.confinement.plane_file import decode_planes
from helicoide.gate.check import driven, finite
from helicoide.kinematics.robot_parts import PlanePane
from helicoide.state import FittedCloud, State, Update, with_drag, with_problem
from helicoide.text import HelicoideError, Text, untranslated

MOST = 12
AHEAD = 0.45  # of the reach: how far in front of the base a pane is shown
GIVEN = Text(en="plane {name}", pt_BR="plano {name}")
BOX_TITLES = {
    "+z": Text(en="ceiling", pt_BR="teto"),
    "+y": Text(en="left wall", pt_BR="parede esquerda"),
    "-y": Text(en="right wall", pt_BR="parede direita"),
    "-z": Text(en="bench", pt_BR="bancada"),
}


def add_plane(coefficients: ArrayLike) -> Update:
    """One more plane a x + b y + c z = d, d in m where (a, b, c) has length one; the arm's tool is inside."""
    return _adding(lambda state: from_coefficients(finite(coefficients, (4,)), state.T_world_tool[:3, 3]))


def add_plane_through(points: ArrayLike) -> Update:
    """One more plane through three points (3, 3), m; the arm's tool is inside. Source: Cerbaro 2022, eqs. 25–26."""
    return _adding(lambda state: through_points(finite(points, (3, 3)), state.T_world_tool[:3, 3]))


def set_box(lower: ArrayLike, upper: ArrayLike) -> Update:
    """Ceiling, walls and bench of a box between two corners (3,), m, in place of the planes that may be moved."""

    def change(state: State) -> State:
        inside = box_planes(finite(lower, (3,)), finite(upper, (3,)))
        spans = np.asarray(upper) - np.asarray(lower)
        sizes = [(spans[1], spans[0]), (spans[0], spans[2]), (spans[0], spans[2]), (spans[1], spans[0])]
        panes = [
            PlanePane(name, title, inside.normals[k], float(inside.offsets[k]), inside.centres[k], sizes[k], True)
            for k, (name, title) in enumerate(BOX_TITLES.items())
        ]
        return confined(_without_movable(state), panes)

    return driven(change)


def take_planes(names: Sequence[str], planes: Planes) -> Update:
    """The planes of a file in place of those that may be moved."""

    def change(state: State) -> State:
        panes = [
            pane_on_plane(Plane(normal, float(offset)), name, GIVEN.format(name=name), centre)
            for name, normal, offset, centre in zip(names, planes.normals, planes.offsets, planes.centres, strict=True)
        ]
        return confined(_without_movable(state), panes)

    return driven(change)


def clear_clouds() -> Update:
    """Take away the clouds that were read; the planes that were found in them stay."""
    return lambda state: replace(state, clouds=MappingProxyType({}))


def show_cloud(name: str, seen: FittedCloud, pane: PlanePane | None) -> Update:
    """A cloud that was read for a plane of that name, and the plane, which confines the arm at once."""

    def change(state: State) -> State:
        state = replace(state, clouds=MappingProxyType({**state.clouds, name: seen}), notice=None)
        return replace(state, notice=seen.words) if pane is None else confined(state, [pane])

    return driven(change)


def clear_planes() -> Update:
    """Take away all planes that may be moved, and what was read of others."""
    return driven(lambda state: replace(_without_movable(state), clouds=MappingProxyType({})))


def take_planes_of(content: bytes, name: str) -> Update:
    """The planes of a file of that name; what is wrong with it is said."""

    def change(state: State) -> State:
        return take_planes(*decode_planes(content, name))(state)

    return driven(change)


def say(words: Text) -> Update:
    """A sentence in the status line."""
    return lambda state: replace(state, notice=words)


def remove_plane(index: int) -> Update:
    """Take away a plane that may be moved."""

    def change(state: State) -> State:
        panes = state.problem.planes.panes
        if index not in range(len(panes)) or not panes[index].movable:
            raise HelicoideError(
                Text(
                    en="That plane stays; to be taken away: {names}.", pt_BR="Esse plano fica; podem sair: {names}."
                ).format(names=", ".join(pane.name for pane in panes if pane.movable) or "–")
            )
        return _with(with_drag(state, None), state.problem.planes.without(index))

    return driven(change)


def set_zones(critical: float, warning: float) -> Update:
    """The critical and the warning distance, m, within their safe bounds."""

    def change(state: State) -> State:
        near, far = finite([critical, warning], (2,))
        problem = replace(state.problem, zones=state.problem.zones.adjusted(float(near), float(far)))
        return with_problem(state, problem)

    return driven(change)


def confined(state: State, panes: Sequence[PlanePane]) -> State:
    """The state with more planes, each as near as the arm lets it come; the notice says which were stopped."""
    planes, stopped = state.problem.planes, []
    for pane in panes:
        if any(one.name == pane.name and not one.movable for one in planes.panes):
            continue  # what is fixed stays as it is
        if len(planes.panes) >= MOST and pane.name not in planes.names:
            raise HelicoideError(
                Text(en="There are {most} planes at most.", pt_BR="Há no máximo {most} planos.").format(most=MOST)
            )
        centre = limited_plane_centre(pane.normal, pane.centre, state.guarded_points, state.problem.zones.critical)
        if not np.array_equal(centre, pane.centre):
            stopped.append(pane.name)
            pane = replace(pane, centre=frozen(centre), offset=float(pane.normal @ centre))
        planes = planes.with_pane(pane)
    notice = None if not stopped else STOPPED.format(names=", ".join(stopped), mm=1000 * state.problem.zones.critical)
    return replace(_with(state, planes), notice=notice)


STOPPED = Text(
    en="Moved back to {mm:.0f} mm from the arm: {names}.", pt_BR="Recuados até {mm:.0f} mm do braço: {names}."
)


def _adding(plane_of: Callable[[State], Plane]) -> Update:
    def change(state: State) -> State:
        plane = plane_of(state)
        name = next(name for k in range(1, MOST + 2) if (name := f"p{k}") not in state.problem.planes.names)
        reach = state.robot.reach
        ahead = state.robot.points[0] + np.array([AHEAD * reach, 0.0, 0.3 * reach])
        return confined(state, [pane_on_plane(plane, name, untranslated(name), ahead, (0.7 * reach, 0.7 * reach))])

    return driven(change)


def _without_movable(state: State) -> State:
    planes = state.problem.planes
    for index in reversed(range(len(planes.panes))):
        if planes.panes[index].movable:
            planes = planes.without(index)
    return _with(with_drag(state, None), planes)


def _with(state: State, planes: Planes) -> State:
    return with_problem(state, replace(state.problem, planes=planes))
