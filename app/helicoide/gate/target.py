"""The target of the tool: drag it, or set its pose."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.command import MoveToPose
from helicoide.gate.check import driven, pose
from helicoide.ik.controller import GUARDED
from helicoide.state import Drag, State, Update, with_command, with_drag

Phase = Literal["start", "update", "end"]


def drag_target(seat: str, phase: Phase, position: ArrayLike, wxyz: ArrayLike) -> Update:
    """Drag the target to a position (3,), m, world frame, and a quaternion (4,), wxyz. seat: who drags.

    Under the guarded step, the end of a drag starts a search for a better posture. If it finds none, the target moves
    to the accepted goal.
    """

    def change(state: State) -> State:
        T = pose(state, position, wxyz)
        if phase == "start":
            state = with_drag(state, Drag(seat, "target"))
        if state.request.drag != Drag(seat, "target"):
            return state
        state = with_command(state, MoveToPose(T))
        return _released(state, T) if phase == "end" else state

    return driven(change)


def _released(state: State, T_world_target: Array) -> State:
    """The state after the end of a drag, with the target at T_world_target (4, 4), m.

    Under the guarded step a search for a better posture follows. If it finds none, the target moves to the accepted
    goal. With other methods the target stays where it is.
    """
    settles = state.request.controller.method == GUARDED
    request = replace(state.request, drag=None, command=MoveToPose(T_world_target, settles), searched=False)
    return replace(state, request=request)


def let_go(drag: Drag) -> Update:
    """End this drag where it is now. If another drag has begun since then, that one continues."""

    def update(state: State) -> State:
        if state.request.drag is not drag:
            return state
        if drag.handle == "target" and isinstance(state.request.command, MoveToPose):
            return _released(state, state.request.command.T_world_target)
        return with_drag(state, None)

    return update


def set_target(position: ArrayLike, wxyz: ArrayLike) -> Update:
    """Set the target to a position (3,), m, and a quaternion (4,), wxyz. It stays there even if it is out of reach."""
    return driven(lambda state: with_command(state, MoveToPose(pose(state, position, wxyz))))


def keep_orientation(on: bool) -> Update:
    """Set whether the tool follows the position and the orientation of the target (on), or only its position."""
    return lambda state: replace(state, request=replace(state.request.renewed(), with_orientation=bool(on)))
