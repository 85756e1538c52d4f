"""The planes that confine the arm: drag them, or restore those of the robot's file."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.confinement import limited_plane_centre, planes_of
from helicoide.gate.check import driven, pose
from helicoide.gate.target import Phase
from helicoide.state import Drag, State, Update, with_drag, with_problem
from helicoide.text import HelicoideError, Text


def drag_plane(seat: str, phase: Phase, index: int, position: ArrayLike, wxyz: ArrayLike) -> Update:
    """Drag a plane by its gizmo, z along the inward normal. The plane stops at the critical distance from the arm."""

    def change(state: State) -> State:
        T = pose(state, position, wxyz)
        panes = state.problem.planes.panes
        if index not in range(len(panes)) or not panes[index].movable:
            raise HelicoideError(Text(en="That plane is fixed.", pt_BR="Esse plano é fixo."))
        handle = f"plane {index}"
        if phase == "start":
            state = with_drag(state, Drag(seat, handle))
        if state.request.drag != Drag(seat, handle):
            return state
        held = with_drag(state, None) if phase == "end" else state
        return _plane_moved(held, index, T[:3, 2], T[:3, 3])

    return driven(change)


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
