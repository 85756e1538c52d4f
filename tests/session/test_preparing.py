"""What becomes of the preparation when its process is killed, when nothing can be kept, when somebody stops it."""

from __future__ import annotations

import asyncio
import errno
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.jobs.works import counts, fails, is_killed, waits

from helicoide import kernels
from helicoide.jobs.process import ProcessJob
from helicoide.kinematics.robot import Robot
from helicoide.session import preparing
from helicoide.session.preparing import AGAIN, HERE, NOT_KEPT, compiling, prepare
from helicoide.text import LANGUAGES, Text

Words = list[Text]


@pytest.fixture
def exercised(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """An `exercise` that finds nothing on disk the first time, and writes down what is asked of it."""
    asked: list[str] = []

    def exercise() -> None:
        asked.append("load" if not asked else "rest")
        if asked == ["load"]:
            raise kernels.NotCached

    monkeypatch.setattr(preparing, "exercise", exercise)
    monkeypatch.setattr(kernels, "KERNELS", {})
    monkeypatch.setattr(kernels, "CACHE_FOLDER", tmp_path)
    monkeypatch.setattr(kernels.KernelCache, "refusal", None)
    return asked


def said(
    robot: Robot,
    compilation: ProcessJob,
    hear: Callable[[Text], None] = lambda text: None,
    meanwhile: Callable[[bool], object] = lambda alive: None,
) -> Words:
    words: Words = []

    def say(text: Text) -> None:
        words.append(text)
        hear(text)

    asyncio.run(prepare(robot, compilation, say, meanwhile))
    return words


def test_what_is_on_disk_is_loaded_and_nothing_is_said(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    alive: list[bool] = []
    monkeypatch.setattr(preparing, "exercise", lambda: None)
    assert said(robot, ProcessJob(fails), meanwhile=alive.append) == []
    assert alive == [True], "by Python, as long as they are loaded"


def test_what_is_not_on_disk_is_compiled_apart(robot: Robot, exercised: list[str]) -> None:
    alive: list[bool] = []
    assert said(robot, ProcessJob(counts, 3), meanwhile=alive.append) == [compiling(0), compiling(1), compiling(2)]
    assert exercised == ["load", "rest"]
    assert alive == [True], "the arms live by Python meanwhile"


def test_a_preparation_that_is_killed_begins_again(robot: Robot, exercised: list[str], tmp_path: Path) -> None:
    words = said(robot, ProcessJob(is_killed, str(tmp_path / "lives"), 1))
    assert words == [compiling(1), compiling(0, AGAIN), compiling(1), compiling(2)]
    assert exercised == ["load", "rest"]


def test_one_that_is_killed_twice_goes_on_in_this_process(robot: Robot, exercised: list[str], tmp_path: Path) -> None:
    words = said(robot, ProcessJob(is_killed, str(tmp_path / "lives"), 2))
    assert words == [compiling(1), compiling(0, AGAIN), compiling(1), compiling(0, HERE)]
    assert exercised == ["load", "rest"]


def test_a_killed_preparation_is_noticed_at_once(robot: Robot, exercised: list[str], tmp_path: Path) -> None:
    heard = dict[Text, float]()
    said(
        robot, ProcessJob(is_killed, str(tmp_path / "lives"), 1), lambda text: heard.setdefault(text, time.monotonic())
    )
    took = heard[compiling(0, AGAIN)] - heard[compiling(1)]
    print(f"noticed after {took:.2f} s")
    assert took < 20


def test_one_that_fails_goes_on_in_this_process(robot: Robot, exercised: list[str]) -> None:
    assert said(robot, ProcessJob(fails)) == [compiling(0)]
    assert exercised == ["load", "rest"]


def test_one_that_is_stopped_leaves_it_at_that(robot: Robot, exercised: list[str]) -> None:
    compilation = ProcessJob(waits, "")
    assert said(robot, compilation, lambda text: compilation.stop()) == [compiling(0)]
    assert exercised == ["load"]


def test_what_is_compiled_here_is_counted_and_why_is_said(
    robot: Robot, exercised: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without room on the disk it happens at every start, and the page says so; then no arm moves."""
    beginning, alive = preparing.exercise, list[bool]()

    def exercise() -> None:
        beginning()
        monkeypatch.setattr(kernels.KernelCache, "refusal", OSError(errno.ENOSPC, "No space left on device"))
        kernels.Kernel(twice)(1.0)

    monkeypatch.setattr(preparing, "exercise", exercise)
    assert said(robot, ProcessJob(fails), meanwhile=alive.append) == [compiling(0), compiling(1, NOT_KEPT)]
    assert alive == [True, False]
    for language in LANGUAGES:
        assert str(kernels.CACHE_FOLDER) in compiling(1, NOT_KEPT)[language]


def twice(number: float) -> float:
    return 2.0 * number


def test_a_process_of_its_own_stops_compiling_when_nothing_can_be_kept(
    exercised: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    done = list[int]()

    def exercise() -> None:
        kernels.Kernel(twice)(1.0)
        monkeypatch.setattr(kernels.KernelCache, "refusal", OSError(errno.ENOSPC, "No space left on device"))
        kernels.Kernel(twice)(1)
        raise AssertionError("it was not stopped")

    monkeypatch.setattr(preparing, "exercise", exercise)
    preparing.compiled(done.append)
    assert done == [1, 2]
