"""Stop, which takes precedence over every other request."""

from __future__ import annotations

from dataclasses import replace

from helicoide.command import FollowPath, GetReady, HoldPosition, Park, Replay
from helicoide.state import State, Update, with_command


def stop(closing: bool = False) -> Update:
    """Stop the arm and its gripper from this tick on, and end the drag.

    closing: whether the same key closes something on the page. Then a stop is shown only if something moved or the arm
    was stopped already.
    """

    def change(state: State) -> State:
        said = not closing or _moves(state) or state.request.command == HoldPosition(stopped=True)
        state = with_command(state, HoldPosition(stopped=said))
        return replace(state, request=replace(state.request, drag=None, gripper=state.arm.gripper))

    return change


def _moves(state: State) -> bool:
    command = state.request.command
    follows = isinstance(command, Replay | Park | GetReady) or (isinstance(command, FollowPath) and command.playing)
    return follows or state.arm.moving or state.arm.gripper != state.request.gripper
