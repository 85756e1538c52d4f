"""One joint of an arm, moved to an angle: a prediction, a goal, a mistake, and a task without a single solution."""

from __future__ import annotations

from math import radians

from helicoide import gate
from helicoide.lesson import Choice, Diagnosis, Step, Value, fixed
from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import Text

TITLE = Text(en="New lesson (new_name)", pt_BR="Lição nova (new_name)")
ABOUT = Text(en="What one joint does to the rest of the arm.", pt_BR="O que uma junta faz com o resto do braço.")
ROBOT = "planar3r"

ELBOW, ANGLE, WITHIN = 1, radians(60.0), radians(2.0)


def start(state: State) -> State:
    """Ask for the arm at `ready`. A setup asks by functions of gate; it moves nothing itself."""
    return gate.get_ready()(state)


def bent(state: State, seat: Seat) -> bool:
    """The elbow rests where it was asked to."""
    return bool(abs(state.arm.q[ELBOW] - ANGLE) <= WITHIN) and not state.arm.moving


def bent_back(state: State, seat: Seat) -> bool:
    """The elbow was bent to the other side."""
    return bool(state.arm.q[ELBOW] < -WITHIN)


# What {angle} and {elbow} in the pages stand for. A number that the program knows is never typed into a page.
VALUES = {
    "angle": fixed(ANGLE, "°"),
    "elbow": Value(lambda state, seat: state.arm.q[ELBOW], "°"),
}

STEPS = (
    Step(
        "elbow",
        start,
        bent,
        ((gate.set_joint(ELBOW, ANGLE), 3.0),),
        joints=(ELBOW,),
        prediction=Choice(right=1),
        diagnoses=(Diagnosis("bent_back", bent_back, ((gate.set_joint(ELBOW, -ANGLE), 3.0),)),),
    ),
    Step("explore", start, is_open=True, joints=(0, 1, 2)),
)
