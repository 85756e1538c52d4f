"""The measuring tour: it goes from reading to reading, and a stop in the meantime, also during a reading, ends it."""

from __future__ import annotations

import asyncio

import pytest
from tests.driving import at

from helicoide import gate
from helicoide.session.surveying import Surveying
from helicoide.state import Hold, State, ToJoints, Update


class _Arm:
    """An arm that is at once where it is sent."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.sent: list[ToJoints] = []

    def post(self, update: Update) -> None:
        before, self.state = self.state, update(self.state)
        command = self.state.command
        if isinstance(command, ToJoints) and command is not before.command:
            self.sent.append(command)
            self.state = at(self.state, command.q)


def toured(state: State, stop_after: int | None) -> _Arm:
    """What became of a tour; the arm is stopped when so many planes have been read."""
    arm = _Arm(state)

    def post(update: Update) -> None:
        arm.post(update)
        if stop_after is not None and len(arm.state.seen) == stop_after and arm.state.command != Hold(stopped=True):
            arm.post(gate.stop())

    async def run() -> None:
        survey = Surveying(lambda: arm.state, post)
        survey.tour()
        assert survey._task is not None
        await survey._task

    asyncio.run(run())
    return arm


def test_every_plane_is_read(state: State) -> None:
    arm = toured(state, None)
    assert set(arm.state.seen) == {"+z", "+y", "-y"}
    assert set(arm.state.problem.planes.names) == {"+z", "+y", "-y", "-z"}
    assert len(arm.sent) == 3


@pytest.mark.parametrize("count", [1, 2, 3])
def test_nothing_moves_after_a_stop_while_a_plane_is_read(state: State, count: int) -> None:
    arm = toured(state, count)
    assert arm.state.command == Hold(stopped=True)
    assert len(arm.sent) == count
