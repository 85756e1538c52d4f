"""The postures of a goal: shown as they were found, put in order by what each joint's motion costs, gone to."""

from __future__ import annotations

from dataclasses import replace

from helicoide.arrays import Array, frozen
from helicoide.command import MoveToJoints
from helicoide.gate.check import checked, driven, finite
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.choice import OUT_OF_LIMITS, alike, barrier
from helicoide.ik.postures.solve import chosen
from helicoide.state import PostureList, State, Update, with_command
from helicoide.text import HelicoideError, Text

HEAVIEST_JOINT = 10.0
NO_POSTURE = Text(en="There is no such posture: list them anew.", pt_BR="Não há essa postura: liste-as de novo.")
WEIGHTS = Text(
    en="A joint's motion costs 0 to {most:g} times that of another.",
    pt_BR="O movimento de uma junta custa de 0 a {most:g} vezes o de outra.",
)
BEYOND = Text(
    en="The posture “{name}” is outside the joint limits.",
    pt_BR="A postura “{name}” está fora dos limites das juntas.",
)


def show_postures(T_world_goal: Array, with_orientation: bool, q: Array, answer: Answer) -> Update:
    """The postures that were found for a goal (4, 4), m, from where the arm was then, q (n,), rad or m."""
    return lambda state: _ordered(state, PostureList(T_world_goal, with_orientation, q, answer, ()))


def weigh_joint(index: int, weight: float) -> Update:
    """What the motion of a joint costs beside the others, 1 where all count alike; the list is put in that order."""

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
    """To the posture in that place of the list."""

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
    """The list in the order of the weighted motion; postures in which something is too near come last."""
    problem, weights = state.problem, state.postures.weights * alike(state.robot)
    rows = chosen(state.robot, listed.answer, listed.q, weights, problem.obstacles, listed.with_orientation)
    clear = sorted(rows, key=lambda row: row.dropped is not None or barrier(problem, row.q) is not None)
    return replace(state, postures=replace(state.postures, listing=replace(listed, rows=tuple(clear))))
