"""The planes that confine the arm: dragged, and put back."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.confinement import planes_of, stopped_at_arm
from helicoide.gate.check import driven, pose
from helicoide.gate.target import Phase
from helicoide.state import Grasp, State, Update, enclosed, grasped
from helicoide.text import HelicoideError, Text


def drag_plane(seat: str, phase: Phase, index: int, position: ArrayLike, wxyz: ArrayLike) -> Update:
    """A plane's gizmo, z along the inward normal: the plane stops at the critical distance from the arm."""

    def wish(state: State) -> State:
        T = pose(state, position, wxyz)
        panes = state.problem.planes.panes
        if index not in range(len(panes)) or not panes[index].movable:
            raise HelicoideError(Text(en="That plane is fixed.", pt_BR="Esse plano é fixo."))
        handle = f"plane {index}"
        if phase == "start":
            state = grasped(state, Grasp(seat, handle))
        if state.request.grasp != Grasp(seat, handle):
            return state
        held = grasped(state, None) if phase == "end" else state
        return _plane_moved(held, index, T[:3, 2], T[:3, 3])

    return driven(wish)


def _plane_moved(state: State, index: int, normal: Array, asked: Array) -> State:
    """The plane where it was asked for, or at the critical distance from the arm, and then the words that say so."""
    problem, critical = state.problem, state.problem.zones.critical
    points = state.guarded_points
    centre = stopped_at_arm(normal, asked, points, critical)
    stopped = None if np.array_equal(centre, asked) else _stopped_plane(state, index, (points - centre) @ normal)
    problem = replace(problem, planes=problem.planes.moved(index, normal, centre))
    return enclosed(state, problem, stopped)


def _stopped_plane(state: State, index: int, distances: Array) -> Text:
    pane, point = state.problem.planes.panes[index], state.robot.guarded[int(distances.argmin())]
    return Text(
        en="Plane {name} ({pane}) stops at {mm:.0f} mm from the arm: {point}.",
        pt_BR="O plano {name} ({pane}) para a {mm:.0f} mm do braço: {point}.",
    ).format(name=pane.name, pane=pane.title, mm=1000 * distances.min(), point=point.title)


def restore_planes() -> Update:
    """The planes of the robot's file, each where it has it, or as near to that as the arm allows; no others."""

    def wish(state: State) -> State:
        state = replace(state, notice=None)
        before = replace(state.problem, planes=planes_of(state.robot.panes))
        state = replace(state, problem=before)
        for index, pane in enumerate(state.robot.panes):
            moved = _plane_moved(state, index, pane.normal, pane.centre)
            state = replace(moved, notice=moved.notice or state.notice)
        return state

    return driven(wish)
