"""Motions that are worked out, or whose arm is fetched, before they begin: a stop in the meantime ends them."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

from helicoide import gate
from helicoide.command import HoldPosition, Replay
from helicoide.kinematics.robot import Robot
from helicoide.session import arms
from helicoide.session.arms import Arms
from helicoide.session.replaying import along_fastest
from helicoide.session.workcell import Workcell
from helicoide.state import State, Update, initial_state
from helicoide.studies.study import Motion
from helicoide.text import Text

Meanwhile = Callable[[Workcell], object] | None


@pytest.fixture
def workcell(robot: Robot) -> Workcell:
    return Workcell(initial_state(robot), lambda: None, ThreadPoolExecutor(1))


def stop_in_time(workcell: Workcell) -> None:
    workcell.stop()
    workcell.drain()


def stop_before_it_is_done(workcell: Workcell) -> None:
    workcell.stop()


def worked_out(workcell: Workcell, meanwhile: Meanwhile) -> State:
    """What became of a motion that took its time to be worked out."""
    answer = threading.Event()

    def slowly(state: State) -> Update:
        assert answer.wait(60)
        return along_fastest(gate.choose_path("circle")(state))

    async def run() -> None:
        working = Arms(workcell)
        working.work_out(slowly)
        await asyncio.sleep(0.02)
        if meanwhile is not None:
            meanwhile(workcell)
        answer.set()
        await asyncio.gather(*working._tasks)
        workcell.drain()

    asyncio.run(run())
    return workcell.state


def test_a_motion_begins_when_it_is_worked_out(workcell: Workcell) -> None:
    assert isinstance(worked_out(workcell, None).request.command, Replay)


@pytest.mark.parametrize("meanwhile", [stop_in_time, stop_before_it_is_done])
def test_a_stop_ends_a_motion_that_is_worked_out(workcell: Workcell, meanwhile: Meanwhile) -> None:
    assert worked_out(workcell, meanwhile).request.command == HoldPosition(stopped=True)


def test_the_status_says_that_a_motion_is_worked_out(workcell: Workcell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(arms, "SOON", 0.0)
    said = []

    def look(workcell: Workcell) -> None:
        workcell.drain()
        said.append(workcell.state.notice)

    assert worked_out(workcell, look).notice is None
    assert said == [arms.COMPUTING]


def test_a_refusal_is_what_the_status_says_in_the_end(workcell: Workcell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(arms, "SOON", 0.0)
    why = Text(en="no", pt_BR="não")

    async def run() -> None:
        working = Arms(workcell)
        working.find(lambda state: gate.say(why))
        await asyncio.gather(*working._tasks)
        workcell.drain()

    asyncio.run(run())
    assert workcell.state.notice == why


@pytest.fixture
def play_on_another_arm(monkeypatch: pytest.MonkeyPatch, workcell: Workcell) -> Callable[[Meanwhile], State]:
    """Play a motion of the PUMA while another arm stands there; what happens while the PUMA is fetched."""
    fetched, load = threading.Event(), arms.load_robot

    def slowly(*arguments: Any) -> Robot:
        assert fetched.wait(60)
        return load(*arguments)

    monkeypatch.setattr(arms, "load_robot", slowly)
    motion = Motion("puma560", np.array([0.0, 1.0]), np.zeros((2, 6)))

    def play(meanwhile: Meanwhile) -> State:
        async def run() -> None:
            bringing = Arms(workcell)
            bringing.play(motion)
            await asyncio.sleep(0.02)
            if meanwhile is not None:
                meanwhile(workcell)
            fetched.set()
            await asyncio.gather(*bringing._tasks)
            workcell.drain()

        asyncio.run(run())
        return workcell.state

    return play


def test_a_motion_of_another_arm_brings_that_arm(play_on_another_arm: Callable[[Meanwhile], State]) -> None:
    state = play_on_another_arm(None)
    assert state.robot.name == "puma560"
    assert isinstance(state.request.command, Replay)


@pytest.mark.parametrize("meanwhile", [stop_in_time, stop_before_it_is_done])
def test_a_stop_while_the_arm_is_fetched_ends_its_motion(
    play_on_another_arm: Callable[[Meanwhile], State], meanwhile: Meanwhile
) -> None:
    state = play_on_another_arm(meanwhile)
    assert state.robot.name == "puma560"
    assert state.request.command == HoldPosition()
