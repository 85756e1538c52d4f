"""Stop: what comes before every other wish."""

from __future__ import annotations

from dataclasses import replace

from helicoide.command import Along, GetReady, Hold, Park, Replay
from helicoide.state import State, Update, commanded


def stop(closing: bool = False) -> Update:
    """Nothing moves from this tick on, and what is held is let go.

    closing: whether the same key closes something on the page; then no stop is said to have been where nothing moved.
    """

    def wish(state: State) -> State:
        said = not closing or _moves(state) or state.request.command == Hold(stopped=True)
        state = commanded(state, Hold(stopped=said))
        return replace(state, request=replace(state.request, grasp=None, gripper=state.arm.gripper))

    return wish


def _moves(state: State) -> bool:
    command = state.request.command
    follows = isinstance(command, Replay | Park | GetReady) or (isinstance(command, Along) and command.playing)
    return follows or state.arm.moving or state.arm.gripper != state.request.gripper
