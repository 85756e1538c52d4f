"""Stop: what comes before every other wish."""

from __future__ import annotations

from dataclasses import replace

from helicoide.gate.check import LATCH
from helicoide.state import Hold, Update, commanded


def stop() -> Update:
    """Nothing moves from this tick on; what is held is let go, and sliders stay deaf until the hand has let go."""
    return lambda state: replace(
        commanded(state, Hold(stopped=True)),
        grasp=None,
        gripper_target=state.gripper,
        latched=state.t + LATCH,
    )
