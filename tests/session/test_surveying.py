"""The measuring tour: it goes from reading to reading, and a stop in the meantime, also during a reading, ends it."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from tests.driving import at

from helicoide import gate
from helicoide.perception import realsense
from helicoide.perception.camera import SimulatedCamera
from helicoide.session.surveying import Surveying
from helicoide.state import Hold, State, ToJoints, Update
from helicoide.text import HelicoideError, same


class _Arm:
    """An arm that is at once where it is sent."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.sent: list[ToJoints] = []

    def post(self, update: Update) -> None:
        before, self.state = self.state, update(self.state)
        command = self.state.request.command
        if isinstance(command, ToJoints) and command is not before.request.command:
            self.sent.append(command)
            self.state = at(self.state, command.q)


def toured(state: State, stop_after: int | None, real: bool = False) -> _Arm:
    """What became of a tour; the arm is stopped when so many planes have been read."""
    arm = _Arm(state)

    def post(update: Update) -> None:
        arm.post(update)
        if (
            stop_after is not None
            and len(arm.state.seen) == stop_after
            and arm.state.request.command != Hold(stopped=True)
        ):
            arm.post(gate.stop())

    async def run() -> None:
        survey = Surveying(lambda: arm.state, post)
        survey.tour(real)
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
    assert arm.state.request.command == Hold(stopped=True)
    assert len(arm.sent) == count


@pytest.fixture
def camera(monkeypatch: pytest.MonkeyPatch) -> dict[str, bool]:
    """A RealSense that sees what the simulated camera sees, or is not there; whether it is open, and was let go."""
    is_ = {"there": True, "open": False, "let go": False}

    @contextmanager
    def connected() -> Iterator[SimulatedCamera]:
        if not is_["there"]:
            raise HelicoideError(same("No camera answers."))
        is_["open"] = True
        try:
            yield SimulatedCamera()
        finally:
            is_["open"], is_["let go"] = False, True

    monkeypatch.setattr(realsense, "connected", connected)
    return is_


def test_a_real_camera_reads_every_plane_and_is_let_go(state: State, camera: dict[str, bool]) -> None:
    arm = toured(state, None, real=True)
    assert set(arm.state.seen) == {"+z", "+y", "-y"}
    assert (camera["open"], camera["let go"]) == (False, True)


def test_a_real_camera_is_let_go_after_a_stop(state: State, camera: dict[str, bool]) -> None:
    toured(state, 1, real=True)
    assert (camera["open"], camera["let go"]) == (False, True)


def test_a_camera_that_is_still_being_opened_is_let_go(state: State, camera: dict[str, bool]) -> None:
    """Another tour begins before the first camera answers."""
    slow, arm = threading.Event(), _Arm(state)
    connected = realsense.connected

    @contextmanager
    def slowly() -> Iterator[SimulatedCamera]:
        slow.wait(30)
        with connected() as opened:  # type: ignore[attr-defined]
            yield opened

    async def run() -> None:
        survey = Surveying(lambda: arm.state, arm.post)
        survey._begin(lambda: survey._with(slowly()))  # type: ignore[arg-type]
        first = survey._task
        await asyncio.sleep(0.05)
        survey.tour()
        slow.set()
        assert survey._task is not None
        assert first is not None
        await asyncio.wait([first, survey._task])

    asyncio.run(run())
    assert (camera["open"], camera["let go"]) == (False, True)
    assert set(arm.state.seen) == {"+z", "+y", "-y"}


def test_without_a_camera_it_is_said_and_the_planes_stay(state: State, camera: dict[str, bool]) -> None:
    camera["there"] = False
    arm = toured(state, None, real=True)
    assert arm.state.notice == same("No camera answers.")
    assert arm.state.problem.planes is state.problem.planes
    assert not arm.sent
