"""Maps of the workspace: chosen, counted, shown and taken away; what belongs to another arm is not taken."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from helicoide.gate.check import checked, finite
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import KINDS, Kind, Map
from helicoide.state import Seat, SeatUpdate, State, Update
from helicoide.text import HelicoideError, Text


def choose_map(kind: str) -> Update:
    """Another kind of map; what is counted is ended, the map that is shown stays."""

    def wish(state: State) -> State:
        chosen: Kind | None = next((one for one in KINDS if one == kind), None)
        if chosen is None:
            raise HelicoideError(
                Text(
                    en="There is no map of kind {kind!r}; there is: {known}.",
                    pt_BR="Não há mapa do tipo {kind!r}; há: {known}.",
                ).format(kind=kind, known=", ".join(KINDS))
            )
        return _with(state, kind=chosen, progress=None)

    return checked(wish)


def start_map(robot: Robot) -> Update:
    """The map of this arm begins to be counted."""
    return _of(robot, lambda state: _with(state, progress=0.0))


def tell_map(robot: Robot, share: float) -> Update:
    """What is counted tells how far it is, 0 to 1."""
    return _while_counted(robot, lambda state: _with(state, progress=share))


def show_map(robot: Robot, found: Map) -> Update:
    """The map of this arm is there, in place of the one before."""
    return _while_counted(robot, lambda state: _with(state, progress=None, map=found))


def fail_map(robot: Robot, why: Text) -> Update:
    """What was counted has ended without a map."""
    return _while_counted(robot, lambda state: replace(_with(state, progress=None), notice=why))


def end_map() -> Update:
    """End what is counted."""
    return lambda state: _with(state, progress=None)


def clear_map() -> Update:
    """Take the map away."""
    return lambda state: _with(state, map=None)


def cut_map(share: float) -> SeatUpdate:
    """Where a person has the map cut, −1 to 1 of the reach; anything else leaves it where it is."""

    def wish(seat: Seat) -> Seat:
        try:
            return replace(seat, cut=float(np.clip(finite(share, ()), -1.0, 1.0)))
        except HelicoideError:
            return seat

    return wish


def _with(state: State, **changes: Any) -> State:
    return replace(state, workspace=replace(state.workspace, **changes))


def _of(robot: Robot, wish: Update) -> Update:
    return lambda state: wish(state) if state.robot is robot else state


def _while_counted(robot: Robot, wish: Update) -> Update:
    return _of(robot, lambda state: state if state.workspace.progress is None else wish(state))
