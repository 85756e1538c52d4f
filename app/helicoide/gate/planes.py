"""The planes that confine the arm: drag them, set one, or restore those of the robot's file."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.confinement import Plane, limited_plane_centre, planes_of
from helicoide.gate.check import FARTHEST, driven, finite, pose
from helicoide.gate.target import Phase
from helicoide.state import Drag, State, Update, with_drag, with_problem
from helicoide.text import HelicoideError, Text


def drag_plane(seat: str, phase: Phase, index: int, position: ArrayLike, wxyz: ArrayLike) -> Update:
    """Drag a plane by its gizmo, z along the inward normal. The plane stops at the critical distance from the arm."""

    def change(state: State) -> State:
        T = pose(state, position, wxyz)
        check_movable(state, index)
        handle = f"plane {index}"
        if phase == "start":
            state = with_drag(state, Drag(seat, handle))
        if state.request.drag != Drag(seat, handle):
            return state
        held = with_drag(state, None) if phase == "end" else state
        return _plane_moved(held, index, T[:3, 2], T[:3, 3])

    return driven(change)


def set_plane(index: int, normal: ArrayLike, offset: float) -> Update:
    """Set a plane n·r = d: n (3,), any length but 0; d, m, for n/‖n‖. It stops at the critical distance from the arm.

    The centre of its pane moves to the foot of the perpendicular.
    """

    def change(state: State) -> State:
        check_movable(state, index)
        *direction, d = finite([*finite(normal, (3,)), offset], (4,))
        far = FARTHEST * state.robot.maximum_reach
        if np.linalg.norm(direction) < 1e-6 or abs(d) > far:
            raise HelicoideError(
                Text(
                    en="A plane needs a normal that is not zero and a distance of at most {far:.1f} m.",
                    pt_BR="Um plano precisa de uma normal não nula e de uma distância de no máximo {far:.1f} m.",
                ).format(far=far)
            )
        plane = Plane(np.asarray(direction) / np.linalg.norm(direction), float(d))
        return _plane_moved(state, index, plane.normal, plane.foot(state.problem.planes.centres[index]))

    return driven(change)


def check_movable(state: State, index: int) -> None:
    """Raise HelicoideError unless there is a movable plane with this number."""
    panes = state.problem.planes.panes
    if index not in range(len(panes)) or not panes[index].movable:
        raise HelicoideError(Text(en="That plane is fixed.", pt_BR="Esse plano é fixo."))


def _plane_moved(state: State, index: int, normal: Array, moved: Array) -> State:
    """The state with the plane as asked, or at the critical distance from the arm with a notice."""
    problem, critical = state.problem, state.problem.zones.critical
    points = state.monitored_points
    centre = limited_plane_centre(normal, moved, points, critical)
    stopped = None if np.array_equal(centre, moved) else _stopped_plane(state, index, (points - centre) @ normal)
    problem = replace(problem, planes=problem.planes.with_plane(index, normal, centre))
    return with_problem(state, problem, stopped)


def _stopped_plane(state: State, index: int, distances: Array) -> Text:
    pane, point = state.problem.planes.panes[index], state.robot.monitored[int(distances.argmin())]
    return Text(
        en="Plane {name} ({pane}) stops at {mm:.0f} mm from the arm: {point}.",
        pt_BR="O plano {name} ({pane}) para a {mm:.0f} mm do braço: {point}.",
    ).format(name=pane.name, pane=pane.title, mm=1000 * distances.min(), point=point.title)


def restore_planes() -> Update:
    """Replace all planes by those of the robot's file, each as near to its place as the arm allows."""

    def change(state: State) -> State:
        state = replace(state, notice=None)
        before = replace(state.problem, planes=planes_of(state.robot.panes))
        state = replace(state, problem=before)
        for index, pane in enumerate(state.robot.panes):
            moved = _plane_moved(state, index, pane.normal, pane.centre)
            state = replace(moved, notice=moved.notice or state.notice)
        return state

    return driven(change)
