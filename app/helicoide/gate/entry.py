"""The entry point of the instrument (remote centre of motion): switch it on or off, drag it, set its position."""

from __future__ import annotations

from dataclasses import replace

from numpy.typing import ArrayLike

from helicoide.arrays import Array
from helicoide.gate.check import FARTHEST, driven, finite
from helicoide.gate.method import for_both_arms
from helicoide.gate.target import Phase
from helicoide.ik import entry_point
from helicoide.state import Drag, State, Update, with_drag, with_problem
from helicoide.text import HelicoideError, Text

ENTRY = "entry"
NONE_HELD = Text(en="No entry point is active.", pt_BR="Nenhum ponto de entrada está ativo.")


def enforce_entry(on: bool) -> Update:
    """Put an entry point on the shaft at its present position, or remove the entry point. Methods start anew."""

    def change(state: State) -> State:
        state = for_both_arms(state, lambda drive: drive.with_method(drive.method))
        if not on:
            return _with(with_drag(state, None), None)
        here = entry_point(state.robot, [0.0, 0.0, 0.0])
        return _with(state, state.arm.poses[here.link, :3, :3] @ here.shaft[0] + state.arm.poses[here.link, :3, 3])

    return driven(change)


def drag_entry(seat: str, phase: Phase, position: ArrayLike) -> Update:
    """Drag the entry point to a position (3,), m; the instrument follows as fast as the arm can."""

    def change(state: State) -> State:
        asked, grasp = _place(state, position), Drag(seat, ENTRY)
        if phase == "start":
            state = with_drag(state, grasp)
        if state.request.drag != grasp:
            return state
        return _with(with_drag(state, None) if phase == "end" else state, asked)

    return driven(change)


def set_entry(position: ArrayLike) -> Update:
    """Set the position of the entry point, (3,), m."""
    return driven(lambda state: _with(state, _place(state, position)))


def _place(state: State, position: ArrayLike) -> Array:
    if state.problem.entry is None:
        raise HelicoideError(NONE_HELD)
    asked, far = finite(position, (3,)), FARTHEST * state.robot.maximum_reach
    if abs(asked).max() > far:
        raise HelicoideError(
            Text(
                en="The entry point must be within {far:.1f} m of the base.",
                pt_BR="O ponto de entrada deve ficar a até {far:.1f} m da base.",
            ).format(far=far)
        )
    return asked


def _with(state: State, point: Array | None) -> State:
    entry = None if point is None else entry_point(state.robot, point)
    return with_problem(state, replace(state.problem, entry=entry))
