"""Plans a motion: the guarded arm makes it in a simulation, and only the result is shown."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide import gate
from helicoide.arrays import Array, frozen
from helicoide.foresight import advance_with_search, at_rest
from helicoide.session.workcell import TICK
from helicoide.state import Plan, State, Update
from helicoide.text import Text

# s: the longest motion that is planned; of a plan between two joint values that are kept.
LONGEST_PLAN, KNOT = 60.0, 0.05
MOVING = Text(
    en="The arm moves: a motion is planned while it stands still.",
    pt_BR="O braço está em movimento: um plano começa com ele parado.",
)
TOO_LONG = Text(
    en="The motion takes longer than {seconds:.0f} s, which is too long for a plan.",
    pt_BR="O movimento leva mais de {seconds:.0f} s, o que é longo demais para um plano.",
)
NO_MOTION = Text(
    en="The arm is there already, or cannot move there.", pt_BR="O braço já está lá ou não pode ir até lá."
)


def plan_motion(state: State, request: Update, title: Text) -> Update:
    """The update that shows where a request would move the arm, or says why there is no such plan."""
    if state.arm.parked:
        return gate.say(gate.PARKED)
    if state.arm.moving:
        return gate.say(MOVING)
    begun = request(replace(state, compared=None, plan=None, notice=None))
    if begun.notice is not None:
        return gate.say(begun.notice)
    rows = _simulated(begun)
    if rows is None:
        return gate.say(TOO_LONG.format(seconds=LONGEST_PLAN))
    if len(rows) < 2:
        return gate.say(NO_MOTION)
    return gate.plan_found(Plan(title, frozen(KNOT * np.arange(len(rows))), rows, state.problem))


def _simulated(state: State) -> Array | None:
    """The joint values (k, n) at every knot until the arm stands still; None if that takes too long."""
    rows, every = [state.arm.q], round(KNOT / TICK)
    for tick in range(1, round(LONGEST_PLAN / TICK) + 1):
        before, state = state, advance_with_search(state, TICK)
        if tick % every == 0:
            rows.append(state.arm.q)
        if at_rest(before, state):
            moved = [k for k in range(1, len(rows)) if not np.array_equal(rows[k], rows[k - 1])]
            return frozen(rows[: moved[-1] + 1 if moved else 1])
    return None
