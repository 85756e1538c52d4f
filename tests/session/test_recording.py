"""Recorders and recordings in the lab, without a page."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest
from tests.recorder.recordings import moved, recorded

from helicoide import content
from helicoide.kinematics.library import load_robot
from helicoide.recorder import panel_state
from helicoide.recorder.folder import list_recordings, new_path
from helicoide.seat import Seat
from helicoide.session import recorders
from helicoide.session.recorders import BUSY, MOST_AT_ONCE, Recorders
from helicoide.session.recordings import IN_USE, Recordings
from helicoide.session.seats import Place
from helicoide.session.workcell import Workcell
from helicoide.state import State, initial_state
from helicoide.text import Text

PATIENCE = 120.0


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(content, "user_folder", lambda: tmp_path)
    monkeypatch.setattr(recorders, "WATCHED", 0.01)
    return tmp_path / "recordings"


def workcell(state: State) -> Workcell:
    return Workcell(state, lambda: None, ThreadPoolExecutor(1))


async def until(condition: Callable[[], bool]) -> None:
    async with asyncio.timeout(PATIENCE):
        while not condition():
            await asyncio.sleep(0.01)


def test_only_so_many_arms_are_recorded_at_once(state: State) -> None:
    cells, said = [workcell(state) for _ in range(MOST_AT_ONCE + 1)], list[Text]()

    async def run() -> None:
        lab = Recorders(lambda: cells, lambda: None, lambda: None)
        for cell in cells:
            lab.record(cell, True, said.append)
        assert said == [BUSY]
        assert cells[-1].recorder is None
        lab.record(cells[0], True, said.append)  # it is recorded already
        lab.record(cells[0], False, said.append)
        await until(lambda: len(lab._recorded) == MOST_AT_ONCE - 1)
        lab.record(cells[-1], True, said.append)
        assert cells[-1].recorder is not None
        lab.close()
        await until(lambda: not lab._recorded)

    asyncio.run(run())
    assert said == [BUSY]
    assert len(list_recordings()) == MOST_AT_ONCE + 1


def test_the_recording_of_an_arm_that_is_paused_or_gone_ends(state: State) -> None:
    cells = [workcell(state), workcell(state)]

    async def run() -> None:
        known = list(cells)
        lab = Recorders(lambda: known, lambda: None, lambda: None)
        for cell in cells:
            lab.record(cell, True, print)
        cells[0].pause(True)
        known.remove(cells[1])
        await until(lambda: not lab._recorded)

    asyncio.run(run())
    assert not any(thread.name == "helicoide recorder" for thread in threading.enumerate())


class OneUser:
    """A place whose arm has a state, and the recordings of the lab."""

    def __init__(self, state: State) -> None:
        self.state, self.place, self.said = state, Place(Seat("a", "en")), list[Text]()
        self.recorded: set[str] = set()
        self.recordings = Recordings(
            lambda: [self.place], lambda _: self.state, lambda _: None, lambda name: name in self.recorded
        )

    async def opened(self, name: str, data: bytes | None = None) -> None:
        self.recordings.open(self.place, name, data)
        await until(lambda: not self.place.recordings.reading)


def test_a_recording_is_opened_refused_and_deleted(folder: Path) -> None:
    states = moved("planar3r", 0.5)
    path = folder / "turn.mcap"
    folder.mkdir()
    recorded(states, path)
    user = OneUser(states[0])

    async def run() -> None:
        await user.opened("turn.mcap")
        assert user.place.recordings.shown is not None
        user.state = initial_state(load_robot("puma560"))
        user.recordings.meet(user.place)
        await until(lambda: user.place.recordings.refusal is not None)
        assert user.place.recordings.shown is None
        user.state = states[0]
        user.recordings.meet(user.place)
        await until(lambda: user.place.recordings.shown is not None)
        user.recorded.add("turn.mcap")
        user.recordings.delete("turn.mcap", user.said.append)
        await until(lambda: user.said == [IN_USE.format(name="turn.mcap")])
        user.recorded.clear()
        user.recordings.delete("turn.mcap", user.said.append)
        await until(lambda: not path.exists() and user.place.recordings.chosen == "")

    asyncio.run(run())


@pytest.mark.parametrize("name", ["none.mcap", "../../secret.mcap", "/etc/passwd"])
def test_only_files_of_the_folder_are_opened_or_deleted(name: str, state: State) -> None:
    user = OneUser(state)

    async def run() -> None:
        await user.opened(name)
        assert user.place.recordings.refusal is not None
        assert user.place.recordings.refusal.en.startswith("There is no recording")
        user.recordings.delete(name, user.said.append)
        await until(lambda: bool(user.said))

    asyncio.run(run())


def test_a_file_of_another_program_is_refused(state: State) -> None:
    user = OneUser(state)

    async def run() -> None:
        await user.opened("photo.bag", b"\xff\xd8\xff")
        assert user.place.recordings.refusal is not None
        assert user.place.recordings.refusal.en.startswith("photo.bag cannot be read: it is damaged, or no .bag")

    asyncio.run(run())


def test_the_time_runs_to_the_end_and_stays_within_the_recording(folder: Path) -> None:
    states = moved("planar3r", 0.3)
    folder.mkdir()
    recorded(states, folder / "turn.mcap")
    user = OneUser(states[0])

    async def run() -> None:
        await user.opened("turn.mcap")
        panel = user.place.recordings
        assert panel.recording is not None
        for wrong in (-1.0, 1e300, float("nan"), float("inf")):
            assert 0 <= panel_state.with_instant(wrong)(panel).instant <= panel.recording.duration
        user.recordings.change(user.place, panel_state.with_play)
        await until(lambda: not user.place.recordings.plays)
        assert user.place.recordings.instant == panel.recording.duration

    asyncio.run(run())


def test_names_of_files_are_new_and_plain(state: State, folder: Path) -> None:
    now, odd = datetime(2026, 1, 2, 3, 4, 5), replace(state.robot, name="../a b/ü")
    first = new_path(odd, now)
    assert first.parent == folder
    assert first.name == "2026-01-02_03-04-05__a_b_ü.mcap"
    folder.mkdir()
    first.touch()
    assert new_path(odd, now).name == "2026-01-02_03-04-05__a_b_ü_2.mcap"
