"""Maps of the workspace: counted in a process of their own that ends as soon as nobody waits for it, and kept."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from pathlib import Path

import numpy as np
import pytest

from helicoide import gate
from helicoide.jobs import chunks
from helicoide.jobs.process import Report
from helicoide.kinematics import workspace
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.workspace import CHUNK, MAP_KINDS, MapKind, MapPlan, plane_normal
from helicoide.session import mapping
from helicoide.session.mapping import MapJob, plan_of
from helicoide.state import State, Update, WorkspaceMaps, initial_state
from helicoide.view.layers.workspace import MOST

TINY, ENDLESS = 2 * CHUNK, 10**6 * CHUNK
PATIENCE = 300.0


def share(workspace: WorkspaceMaps) -> float | None:
    """How much is counted of the map that is being counted."""
    return None if workspace.progress is None else workspace.progress.share


class _Arm:
    """An arm whose requests are granted at once; every workspace it ever had."""

    def __init__(self, state: State) -> None:
        self.state = state
        self.had: list[WorkspaceMaps] = []
        self.mapping = MapJob(lambda: self.state, self.post)

    def post(self, update: Update) -> None:
        self.state = update(self.state)
        self.had.append(self.state.workspace)

    async def until(self, condition: Callable[[], bool]) -> None:
        while not condition():
            await asyncio.sleep(0.01)

    async def over(self) -> None:
        """Wait until the counting has ended, in one way or another."""
        assert self.mapping._task is not None
        await asyncio.wait([self.mapping._task])

    @property
    def counts(self) -> bool:
        """Whether the process has told something."""
        return share(self.state.workspace) not in (None, 0.0)

    @property
    def process_ended(self) -> bool:
        job = self.mapping._job
        return job is not None and job._child.exitcode is not None


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Maps are kept in a folder of the test, by processes it starts too; the kernels stay where they are."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


@pytest.fixture
def arm(state: State) -> _Arm:
    return _Arm(state)


def live(arm: _Arm, run: Callable[[], Coroutine[object, object, None]]) -> None:
    """Let something run, generously: what is slow is not wrong, what never comes must end."""

    async def patient() -> None:
        try:
            await asyncio.wait_for(run(), PATIENCE)
        finally:
            arm.mapping.close()

    asyncio.run(patient())


def of_size(monkeypatch: pytest.MonkeyPatch, samples: int) -> None:
    monkeypatch.setattr(mapping, "SAMPLES", {kind: {2: samples, 3: samples} for kind in MAP_KINDS})


@pytest.mark.parametrize("kind", MAP_KINDS)
def test_the_map_is_the_one_that_the_postures_make(arm: _Arm, monkeypatch: pytest.MonkeyPatch, kind: MapKind) -> None:
    of_size(monkeypatch, TINY)

    async def run() -> None:
        arm.mapping.begin(kind)
        await arm.over()

    live(arm, run)
    plan = workspace.plan_map(arm.state.robot, kind, TINY)
    expected = workspace.collect_map(plan, workspace.count_chunks(plan), lambda share: None)
    found = arm.state.workspace.map
    assert found is not None
    np.testing.assert_array_equal(found.hits, expected.hits)
    np.testing.assert_array_equal(found.values, expected.values)
    assert not found.hits.flags.writeable
    assert not found.values.flags.writeable
    assert [share(had) for had in arm.had] == [0.0, 0.5, 1.0, None]
    assert chunks.cached_map(plan) is not None


def test_a_kept_map_appears_without_a_process(arm: _Arm, monkeypatch: pytest.MonkeyPatch) -> None:
    of_size(monkeypatch, TINY)
    kept = chunks.workspace_map(plan_of(arm.state.robot, "reachable"))
    monkeypatch.delattr(mapping, "ProcessJob")

    async def run() -> None:
        arm.mapping.begin("reachable")
        await arm.over()

    live(arm, run)
    found = arm.state.workspace.map
    assert found is not None
    np.testing.assert_array_equal(found.hits, kept.hits)
    assert [share(had) for had in arm.had] == [0.0, None]


def ended(arm: _Arm, by: Callable[[], object]) -> None:
    """Count a map that would take days, and end that."""

    async def run() -> None:
        arm.mapping.begin("reachable")
        await arm.until(lambda: arm.counts)
        by()
        await arm.over()

    live(arm, run)
    assert arm.process_ended
    assert arm.state.workspace.map is None
    assert arm.state.notice is None


def test_it_can_be_ended(arm: _Arm, monkeypatch: pytest.MonkeyPatch) -> None:
    of_size(monkeypatch, ENDLESS)
    ended(arm, lambda: arm.post(gate.end_map()))
    assert arm.state.workspace.progress is None


def test_another_arm_ends_it_and_gets_no_map(arm: _Arm, monkeypatch: pytest.MonkeyPatch) -> None:
    of_size(monkeypatch, ENDLESS)
    scara = load_robot("scara")
    other = gate.start_map(scara, "reachable")(initial_state(scara))
    ended(arm, lambda: setattr(arm, "state", other))
    assert arm.state is other


def test_closing_ends_the_process(arm: _Arm, monkeypatch: pytest.MonkeyPatch) -> None:
    of_size(monkeypatch, ENDLESS)

    async def run() -> None:
        arm.mapping.begin("reachable")
        await arm.until(lambda: arm.counts)
        arm.mapping.close()
        await arm.over()

    live(arm, run)
    assert arm.process_ended


def test_a_second_one_ends_the_first(arm: _Arm, monkeypatch: pytest.MonkeyPatch) -> None:
    of_size(monkeypatch, ENDLESS)

    async def run() -> None:
        arm.mapping.begin("reachable")
        await arm.until(lambda: arm.counts)
        first = arm.mapping._job
        assert first is not None
        of_size(monkeypatch, TINY)
        arm.mapping.begin("reachable")
        await arm.over()
        await arm.until(lambda: first._child.exitcode is not None)

    live(arm, run)
    assert arm.state.workspace.map is not None
    assert arm.state.workspace.map.samples == TINY


def breaks(report: Report, plan: MapPlan) -> None:
    raise ValueError("no such map")


def test_a_failure_is_said_in_words(
    arm: _Arm, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    of_size(monkeypatch, TINY)
    monkeypatch.setattr(mapping, "counted", breaks)

    async def run() -> None:
        arm.mapping.begin("reachable")
        await arm.over()

    live(arm, run)
    assert arm.state.notice == mapping.FAILED
    assert (arm.state.workspace.progress, arm.state.workspace.map) == (None, None)
    assert "no such map" in caplog.text


def test_a_killed_process_is_said_in_words(
    arm: _Arm, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    of_size(monkeypatch, ENDLESS)

    async def run() -> None:
        arm.mapping.begin("reachable")
        await arm.until(lambda: arm.counts)
        assert arm.mapping._job is not None
        arm.mapping._job._child.kill()
        await arm.over()

    live(arm, run)
    assert arm.state.notice == mapping.FAILED
    assert (arm.state.workspace.progress, arm.state.workspace.map) == (None, None)
    assert "ended from outside" in caplog.text


@pytest.mark.parametrize("name", ["movemaster", "scara", "planar3r", "polar_rp"])
@pytest.mark.parametrize("kind", MAP_KINDS)
def test_maps_are_fine_and_those_in_a_plane_can_be_sent_whole(name: str, kind: MapKind) -> None:
    robot = load_robot(name)
    plan = plan_of(robot, kind)
    across = plan.cells.shape[0]
    if plane_normal(robot) is None:
        assert across == {"reachable": 64, "dexterous": 22, "manipulability": 56}[kind]
    else:
        assert across >= 130
        assert np.pi / 4 * across**2 <= MOST
