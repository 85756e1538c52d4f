"""The entry point of the instrument: held, dragged, let go (remote centre of motion)."""

from __future__ import annotations

from dataclasses import replace

from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.gate.check import FARTHEST, driven, finite
from helicoide.gate.method import of_both
from helicoide.gate.target import Phase
from helicoide.ik import entry_point
from helicoide.state import Grasp, State, Update, enclosed, grasped
from helicoide.text import HelicoideError, Text

ENTRY = "entry"
NONE_HELD = Text(en="No entry point is held.", pt_BR="Nenhum ponto de entrada está ativo.")


def hold_entry(on: bool) -> Update:
    """Keep the instrument in the entry point where it is now, or let it go."""

    def wish(state: State) -> State:
        state = of_both(state, lambda drive: drive.by(drive.method))
        if not on:
            return _with(grasped(state, None), None)
        here = entry_point(state.robot, [0.0, 0.0, 0.0])
        return _with(state, state.arm.poses[here.link, :3, :3] @ here.shaft[0] + state.arm.poses[here.link, :3, 3])

    return driven(wish)


def drag_entry(seat: str, phase: Phase, position: ArrayLike) -> Update:
    """The entry point under the hand; the instrument follows it as fast as the arm can."""

    def wish(state: State) -> State:
        asked, grasp = _place(state, position), Grasp(seat, ENTRY)
        if phase == "start":
            state = grasped(state, grasp)
        if state.request.grasp != grasp:
            return state
        return _with(grasped(state, None) if phase == "end" else state, asked)

    return driven(wish)


def set_entry(position: ArrayLike) -> Update:
    """The entry point by its numbers, m."""
    return driven(lambda state: _with(state, _place(state, position)))


def _place(state: State, position: ArrayLike) -> Array:
    if state.problem.entry is None:
        raise HelicoideError(NONE_HELD)
    asked, far = finite(position, (3,)), FARTHEST * state.robot.extended
    if abs(asked).max() > far:
        raise HelicoideError(
            Text(
                en="The entry point must lie within {far:.1f} m of the base.",
                pt_BR="O ponto de entrada deve ficar a até {far:.1f} m da base.",
            ).format(far=far)
        )
    return asked


def _with(state: State, point: Array | None) -> State:
    entry = None if point is None else entry_point(state.robot, point)
    return enclosed(state, replace(state.problem, entry=entry))
