"""One joint of an arm, moved to an angle."""

from __future__ import annotations

import numpy as np

from helicoide import gate
from helicoide.lesson import Step
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import Text

TITLE = Text(en="New lesson (new_name)", pt_BR="Lição nova (new_name)")
ROBOT = "planar3r"

ELBOW, ANGLE, WITHIN = 1, np.radians(60.0), np.radians(2.0)


def start(state: State) -> State:
    """Ask for the arm at `ready`. A setup asks by functions of gate; it moves nothing itself."""
    return gate.get_ready()(state)


def bent(state: State, seat: Seat) -> bool:
    """The elbow rests where it was asked to."""
    return bool(abs(state.arm.q[ELBOW] - ANGLE) <= WITHIN) and not state.arm.moving


STEPS = (Step("elbow", start, bent, ((gate.set_joint(ELBOW, ANGLE), 3.0),)),)
