"""The measuring tour: it goes from reading to reading, and a stop in the meantime, also during a reading, ends it."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest
from tests.driving import with_joints

from helicoide import gate
from helicoide.command import HoldPosition, MoveToJoints
from helicoide.perception import realsense
from helicoide.perception.camera import SimulatedCamera
from helicoide.perception.units import Unit
from helicoide.session.surveying import LOOK, Surveying
from helicoide.state import State, Update
from helicoide.text import HelicoideError, untranslated


class _Arm:
    """An arm that is at once where it is sent."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.sent: list[MoveToJoints] = []

    def post(self, update: Update) -> None:
        before, self.state = self.state, update(self.state)
        command = self.state.request.command
        if isinstance(command, MoveToJoints) and command is not before.request.command:
            self.sent.append(command)
            self.state = with_joints(self.state, command.q)


def toured(state: State, stop_after: int | None, real: bool = False) -> _Arm:
    """What became of a tour; the arm is stopped when so many planes have been read."""
    arm = _Arm(state)

    def post(update: Update) -> None:
        arm.post(update)
        if (
            stop_after is not None
            and len(arm.state.clouds) == stop_after
            and arm.state.request.command != HoldPosition(stopped=True)
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
    assert set(arm.state.clouds) == {"+z", "+y", "-y"}
    assert set(arm.state.problem.planes.names) == {"+z", "+y", "-y", "-z"}
    assert len(arm.sent) == 3


def test_a_tour_waits_for_an_arm_whose_thread_is_late(state: State) -> None:
    arm, late = _Arm(state), 4 * LOOK

    async def run() -> None:
        loop = asyncio.get_running_loop()
        survey = Surveying(lambda: arm.state, lambda update: loop.call_later(late, arm.post, update) and None)
        survey.tour()
        assert survey._task is not None
        await survey._task
        await asyncio.sleep(2 * late)

    asyncio.run(run())
    assert set(arm.state.clouds) == {"+z", "+y", "-y"}


@pytest.mark.parametrize("count", [1, 2, 3])
def test_nothing_moves_after_a_stop_while_a_plane_is_read(state: State, count: int) -> None:
    arm = toured(state, count)
    assert arm.state.request.command == HoldPosition(stopped=True)
    assert len(arm.sent) == count


@pytest.fixture
def camera(monkeypatch: pytest.MonkeyPatch) -> dict[str, bool]:
    """A RealSense that sees what the simulated camera sees, or is not there; whether it is open, and was let go."""
    is_ = {"there": True, "open": False, "let go": False}

    @contextmanager
    def connected() -> Iterator[SimulatedCamera]:
        if not is_["there"]:
            raise HelicoideError(untranslated("No camera answers."))
        is_["open"] = True
        try:
            yield SimulatedCamera()
        finally:
            is_["open"], is_["let go"] = False, True

    monkeypatch.setattr(realsense, "connected", connected)
    return is_


def test_a_real_camera_reads_every_plane_and_is_let_go(state: State, camera: dict[str, bool]) -> None:
    arm = toured(state, None, real=True)
    assert set(arm.state.clouds) == {"+z", "+y", "-y"}
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
    assert set(arm.state.clouds) == {"+z", "+y", "-y"}


def test_without_a_camera_it_is_said_and_the_planes_stay(state: State, camera: dict[str, bool]) -> None:
    camera["there"] = False
    arm = toured(state, None, real=True)
    assert arm.state.notice == untranslated("No camera answers.")
    assert arm.state.problem.planes is state.problem.planes
    assert not arm.sent


def read(state: State, content: bytes, unit: Unit | None = None) -> State:
    """What became of a file in which the ceiling is looked for."""
    arm = _Arm(state)

    async def run() -> None:
        survey = Surveying(lambda: arm.state, arm.post)
        survey.read("room.xyz", content, "+z", unit)
        assert survey._task is not None
        await survey._task

    asyncio.run(run())
    return arm.state


def room(scale: float) -> bytes:
    rng = np.random.default_rng(0)
    ceiling = np.column_stack([rng.uniform(0.2, 0.9, (400, 2)), rng.normal(0.9, 1e-3, 400)])
    return "\n".join(" ".join(f"{value:.5f}" for value in row) for row in scale * ceiling).encode()


@pytest.mark.parametrize(("scale", "unit"), [(1.0, None), (1000.0, None), (100.0, "cm"), (1 / 0.0254, "inch")])
def test_a_plane_of_a_file_is_put_up_and_the_unit_is_said(state: State, scale: float, unit: Unit | None) -> None:
    after = read(state, room(scale), unit)
    planes = after.problem.planes
    assert planes.offsets[planes.names.index("+z")] == pytest.approx(-0.9, abs=0.002)
    assert ("as chosen" if unit else "guessed") in after.clouds["+z"].words.en


def test_a_file_whose_unit_nobody_can_tell_changes_nothing_but_words(state: State) -> None:
    after = read(state, room(100.0))
    assert after.problem.planes is state.problem.planes
    assert after.notice is not None
    assert "choose the unit" in after.notice.en
    assert "escolha a unidade" in after.notice.pt_BR
