"""A process of the lab that is killed from outside: the person is told, and the terminal says what happened."""

from __future__ import annotations

import asyncio

import pytest
from tests.jobs.works import dies

from helicoide.session import mapping
from helicoide.session.mapping import MapJob
from helicoide.state import State, Update

PATIENCE = 120.0


def test_a_map_that_is_killed_has_failed(
    state: State, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(mapping, "counted", dies)
    monkeypatch.setattr("helicoide.jobs.chunks.cached_map", lambda plan: None)

    def post(update: Update) -> None:
        nonlocal state
        state = update(state)

    maps = MapJob(lambda: state, post)

    async def run() -> None:
        maps.begin("reachable")
        assert maps._task is not None
        await asyncio.wait([maps._task], timeout=PATIENCE)

    asyncio.run(run())
    assert state.notice == mapping.FAILED
    assert state.workspace.progress is None
    assert "ended from outside" in caplog.text
