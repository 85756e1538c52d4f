"""Maps of the workspace: chosen, counted, shown and taken away; what belongs to another arm is not taken."""

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
    """Another kind of map for a person; anything else leaves the one that is chosen."""
    return lambda seat: replace(seat, map_kind=next((one for one in MAP_KINDS if one == kind), seat.map_kind))


def start_map(robot: Robot, kind: MapKind) -> Update:
    """A map of this arm begins to be counted."""
    return _of(robot, lambda state: _with(state, progress=MapProgress(kind)))


def tell_map(robot: Robot, share: float) -> Update:
    """What is counted tells how far it is, 0 to 1."""
    return _while_counted(robot, lambda state, counting: _with(state, progress=replace(counting, share=share)))


def show_map(robot: Robot, found: WorkspaceMap) -> Update:
    """The map of this arm is there, in place of the one before."""
    return _while_counted(robot, lambda state, _: _with(state, progress=None, map=found))


def fail_map(robot: Robot, why: Text) -> Update:
    """What was counted has ended without a map."""
    return _while_counted(robot, lambda state, _: replace(_with(state, progress=None), notice=why))


def end_map() -> Update:
    """End what is counted."""
    return lambda state: _with(state, progress=None)


def clear_map() -> Update:
    """Take the map away."""
    return lambda state: _with(state, map=None)


def cut_map(share: float) -> SeatUpdate:
    """Where a person has the map cut, −1 to 1 of the reach; anything else leaves it where it is."""

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
