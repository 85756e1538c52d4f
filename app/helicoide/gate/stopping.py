"""Stop: what comes before every other wish."""

from __future__ import annotations

from dataclasses import replace

from helicoide.command import Hold
from helicoide.state import State, Update, commanded


def stop() -> Update:
    """Nothing moves from this tick on, and what is held is let go."""

    def wish(state: State) -> State:
        state = commanded(state, Hold(stopped=True))
        return replace(state, request=replace(state.request, grasp=None, gripper=state.arm.gripper))

    return wish
