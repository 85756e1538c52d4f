"""Stop: what comes before every other wish."""

from __future__ import annotations

from dataclasses import replace

from helicoide.state import Hold, Update, commanded


def stop() -> Update:
    """Nothing moves from this tick on, and what is held is let go."""
    return lambda state: replace(commanded(state, Hold(stopped=True)), grasp=None, gripper_target=state.gripper)
