"""The postures of a goal: list them, order them by the weighted motion of the joints, go to one."""

from __future__ import annotations

from dataclasses import replace

from helicoide.arrays import Array, frozen
from helicoide.command import MoveToJoints
from helicoide.gate.check import checked, driven, finite
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.choice import OUT_OF_LIMITS, barrier, equal_weights
from helicoide.ik.postures.solve import ranked_postures
from helicoide.state import PostureList, State, Update, with_command
from helicoide.text import HelicoideError, Text

HEAVIEST_JOINT = 10.0
NO_POSTURE = Text(
    en="There is no such posture: list the postures again.", pt_BR="Não há essa postura: liste as posturas de novo."
)
WEIGHTS = Text(
    en="The weight of a joint must be 0 to {most:g}.",
    pt_BR="O peso de uma junta vai de 0 a {most:g}.",
)
BEYOND = Text(
    en="The posture “{name}” is outside the joint limits.",
    pt_BR="A postura “{name}” está fora dos limites das juntas.",
)


def show_postures(T_world_goal: Array, with_orientation: bool, q: Array, answer: Answer) -> Update:
    """List the postures found for a goal (4, 4), m. q (n,), rad or m: the posture of the arm at that time."""
    return lambda state: _ordered(state, PostureList(T_world_goal, with_orientation, q, answer, ()))


def weigh_joint(index: int, weight: float) -> Update:
    """Set the cost of a joint's motion relative to the others, 1 for equal cost, and order the list by it."""

    def change(state: State) -> State:
        (value,) = finite([weight], (1,))
        if index not in range(len(state.arm.q)) or not 0.0 <= value <= HEAVIEST_JOINT:
            raise HelicoideError(WEIGHTS.format(most=HEAVIEST_JOINT))
        weights = state.postures.weights.copy()
        weights[index] = value
        state = replace(state, postures=replace(state.postures, weights=frozen(weights)))
        return state if state.postures.listing is None else _ordered(state, state.postures.listing)

    return checked(change)


def go_to_posture(place: int) -> Update:
    """Go to a posture of the list, by its index."""

    def change(state: State) -> State:
        listed = state.postures.listing
        if listed is None or place not in range(len(listed.rows)):
            raise HelicoideError(NO_POSTURE)
        row = listed.rows[place]
        if row.dropped is OUT_OF_LIMITS:
            raise HelicoideError(BEYOND.format(name=row.branch.name))
        return with_command(state, MoveToJoints(row.q))

    return driven(change)


def _ordered(state: State, listed: PostureList) -> State:
    """The state with the list ordered by weighted motion; postures that are dropped or too near to something last."""
    problem, weights = state.problem, state.postures.weights * equal_weights(state.robot)
    rows = ranked_postures(state.robot, listed.answer, listed.q, weights, problem.obstacles, listed.with_orientation)
    clear = sorted(rows, key=lambda row: row.dropped is not None or barrier(problem, row.q) is not None)
    return replace(state, postures=replace(state.postures, listing=replace(listed, rows=tuple(clear))))
