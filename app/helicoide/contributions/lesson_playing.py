"""Play a lesson without a lab: the state and the seat after setups, solutions and wrong paths."""

from __future__ import annotations

from helicoide.command import HoldPosition
from helicoide.foresight import advance_with_search
from helicoide.lesson import AtSeat
from helicoide.seat import Seat
from helicoide.state import State, Update

TICK = 0.01
LONGEST = 30.0  # s, for a setup to come to rest


def played(state: State, seconds: float) -> State:
    """The state after a number of seconds without requests."""
    for _ in range(round(seconds / TICK)):
        state = advance_with_search(state, TICK)
    return state


def settled(state: State) -> State | None:
    """The state once the arm is at rest without a command; None if that takes longer than `LONGEST`."""
    for _ in range(round(LONGEST)):
        state = played(state, 1.0)
        if isinstance(state.request.command, HoldPosition) and not state.arm.moving:
            return state
    return None


def done(state: State, seat: Seat, part: tuple[Update | AtSeat, float]) -> tuple[State, Seat]:
    """The state and the seat after one part of a solution."""
    act, seconds = part
    if isinstance(act, AtSeat):
        return played(state, seconds), act.update(seat)
    return played(act(state), seconds), seat
