"""Planes that people enter, fit to a point cloud or remove, and the distances of their zones.

A plane that would come too near to the arm stops at the critical distance from it, as a dragged plane does.
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
AHEAD = 0.45  # distance from the base at which a new pane is shown, as a fraction of the reach
GIVEN = Text(en="plane {name}", pt_BR="plano {name}")
BOX_TITLES = {
    "+z": Text(en="ceiling", pt_BR="teto"),
    "+y": Text(en="left wall", pt_BR="parede esquerda"),
    "-y": Text(en="right wall", pt_BR="parede direita"),
    "-z": Text(en="bench", pt_BR="bancada"),
}


def add_plane(coefficients: ArrayLike) -> Update:
    """Add the plane a x + b y + c z = d, with the tool on its inner side. d is in m if (a, b, c) is a unit vector."""
    return _adding(lambda state: from_coefficients(finite(coefficients, (4,)), state.T_world_tool[:3, 3]))


def add_plane_through(points: ArrayLike) -> Update:
    """Add a plane through three points (3, 3), m, with the tool on its inner side. Source: Cerbaro 2022, eqs. 25–26."""
    return _adding(lambda state: through_points(finite(points, (3, 3)), state.T_world_tool[:3, 3]))


def set_box(lower: ArrayLike, upper: ArrayLike) -> Update:
    """Replace the movable planes by ceiling, walls and bench of a box between two corners (3,), m."""

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
    """Replace the movable planes by named planes, as read from a file."""

    def change(state: State) -> State:
        panes = [
            pane_on_plane(Plane(normal, float(offset)), name, GIVEN.format(name=name), centre)
            for name, normal, offset, centre in zip(names, planes.normals, planes.offsets, planes.centres, strict=True)
        ]
        return confined(_without_movable(state), panes)

    return driven(change)


def clear_clouds() -> Update:
    """Remove the point clouds; the planes that were fitted to them stay."""
    return lambda state: replace(state, clouds=MappingProxyType({}))


def show_cloud(name: str, seen: FittedCloud, pane: PlanePane | None) -> Update:
    """Show a cloud that was read for the plane of this name, and add the plane that was fitted to it, if any."""

    def change(state: State) -> State:
        state = replace(state, clouds=MappingProxyType({**state.clouds, name: seen}), notice=None)
        return replace(state, notice=seen.words) if pane is None else confined(state, [pane])

    return driven(change)


def clear_planes() -> Update:
    """Remove all movable planes and all point clouds."""
    return driven(lambda state: replace(_without_movable(state), clouds=MappingProxyType({})))


def take_planes_of(content: bytes, name: str) -> Update:
    """`take_planes` from the content of a file with this name. An invalid file is refused with the reason."""

    def change(state: State) -> State:
        return take_planes(*decode_planes(content, name))(state)

    return driven(change)


def say(words: Text) -> Update:
    """Show a sentence in the status line."""
    return lambda state: replace(state, notice=words)


def unsay(words: Text) -> Update:
    """Take a sentence out of the status line, if it is still there."""
    return lambda state: replace(state, notice=None) if state.notice is words else state


def remove_plane(index: int) -> Update:
    """Remove a movable plane."""

    def change(state: State) -> State:
        panes = state.problem.planes.panes
        if index not in range(len(panes)) or not panes[index].movable:
            raise HelicoideError(
                Text(
                    en="That plane cannot be removed; removable planes: {names}.",
                    pt_BR="Esse plano não pode ser removido; removíveis: {names}.",
                ).format(names=", ".join(pane.name for pane in panes if pane.movable) or "–")
            )
        return _with(with_drag(state, None), state.problem.planes.without(index))

    return driven(change)


def set_zones(critical: float, warning: float) -> Update:
    """Set the critical and the warning distance, m, within their safe bounds."""

    def change(state: State) -> State:
        near, far = finite([critical, warning], (2,))
        problem = replace(state.problem, zones=state.problem.zones.adjusted(float(near), float(far)))
        return with_problem(state, problem)

    return driven(change)


def confined(state: State, panes: Sequence[PlanePane]) -> State:
    """The state with the panes added, those too near to the arm moved back to the critical distance, with a notice.

    A pane replaces a movable plane of its name and is skipped if a fixed plane has it. Raises HelicoideError for more
    than `MOST` planes.
    """
    planes, stopped = state.problem.planes, []
    for pane in panes:
        if any(one.name == pane.name and not one.movable for one in planes.panes):
            continue  # fixed planes are not replaced
        if len(planes.panes) >= MOST and pane.name not in planes.names:
            raise HelicoideError(
                Text(en="There are {most} planes at most.", pt_BR="Há no máximo {most} planos.").format(most=MOST)
            )
        centre = limited_plane_centre(pane.normal, pane.centre, state.monitored_points, state.problem.zones.critical)
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
