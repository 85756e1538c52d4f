"""Maps of the workspace: choose, compute, show and remove them. Results for another robot are ignored."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from helicoide.gate.check import finite
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MAP_KINDS, MapKind, WorkspaceMap
from helicoide.seat import Seat, SeatUpdate
from helicoide.state import MapProgress, State, Update
from helicoide.text import HelicoideError, Text


def choose_map(kind: str) -> SeatUpdate:
    """Choose the kind of map of a seat. An unknown kind is ignored."""
    return lambda seat: replace(seat, map_kind=next((one for one in MAP_KINDS if one == kind), seat.map_kind))


def start_map(robot: Robot, kind: MapKind) -> Update:
    """Start the computation of a map of this robot."""
    return _of(robot, lambda state: _with(state, progress=MapProgress(kind)))


def tell_map(robot: Robot, share: float) -> Update:
    """Set the progress of the computation, 0 to 1."""
    return _while_counted(robot, lambda state, counting: _with(state, progress=replace(counting, share=share)))


def show_map(robot: Robot, found: WorkspaceMap) -> Update:
    """Finish the computation and show its map in place of the previous one."""
    return _while_counted(robot, lambda state, _: _with(state, progress=None, map=found))


def fail_map(robot: Robot, why: Text) -> Update:
    """End the computation without a map, with the reason as a notice."""
    return _while_counted(robot, lambda state, _: replace(_with(state, progress=None), notice=why))


def end_map() -> Update:
    """Cancel the computation."""
    return lambda state: _with(state, progress=None)


def clear_map() -> Update:
    """Remove the map."""
    return lambda state: _with(state, map=None)


def cut_map(share: float) -> SeatUpdate:
    """Set where a seat cuts the map, −1 to 1 in units of the reach, clipped. A value that is no number is ignored."""

    def change(seat: Seat) -> Seat:
        try:
            return replace(seat, cut=float(np.clip(finite(share, ()), -1.0, 1.0)))
        except HelicoideError:
            return seat

    return change


def _with(state: State, **changes: Any) -> State:
    return replace(state, workspace=replace(state.workspace, **changes))


def _of(robot: Robot, change: Update) -> Update:
    return lambda state: change(state) if state.robot is robot else state


def _while_counted(robot: Robot, change: Callable[[State, MapProgress], State]) -> Update:
    def update(state: State) -> State:
        counting = state.workspace.progress
        return state if counting is None else change(state, counting)

    return _of(robot, update)
