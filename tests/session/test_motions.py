"""Motions that are worked out, or whose arm is fetched, before they begin: a stop in the meantime ends them."""

from __future__ import annotations

import asyncio
import threading
from collections import deque
from collections.abc import Callable
from contextlib import nullcontext
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from helicoide import gate
from helicoide.kinematics.robot import Robot
from helicoide.session import Session, changing
from helicoide.session.changing import Changing
from helicoide.session.replaying import along_fastest
from helicoide.state import Hold, Replay, State, Update, initial
from helicoide.studies.study import Motion

Meanwhile = Update | None


def worked_out(robot: Robot, meanwhile: Meanwhile) -> State:
    """What became of a motion that took its time to be worked out."""
    session, answer = Session(robot, "en", None), threading.Event()

    def slowly(state: State) -> Update:
        assert answer.wait(60)
        return along_fastest(gate.choose_path("circle")(state))

    async def run() -> None:
        work = asyncio.create_task(session._work_out(slowly))
        await asyncio.sleep(0.02)
        if meanwhile is not None:
            session.state = meanwhile(session.state)
        answer.set()
        await work
        session._apply()

    asyncio.run(run())
    return session.state


def test_a_motion_begins_when_it_is_worked_out(robot: Robot) -> None:
    assert isinstance(worked_out(robot, None).command, Replay)


def test_a_stop_ends_a_motion_that_is_worked_out(robot: Robot) -> None:
    assert worked_out(robot, gate.stop()).command == Hold(stopped=True)


class _Lab(SimpleNamespace):
    """What `Changing` needs of a session, without a server."""

    def __init__(self, robot: Robot) -> None:
        server = SimpleNamespace(atomic=nullcontext, flush=lambda: None)
        scene = SimpleNamespace(clear=lambda server: None)
        super().__init__(robot=robot, shapes=[], state=initial(robot), seats={}, windows={}, server=server, scene=scene)
        self.inbox: deque[Update] = deque()

    def post(self, update: Update) -> None:
        self.state = update(self.state)

    def draw(self) -> None:
        pass


@pytest.fixture
def play_on_another_arm(monkeypatch: pytest.MonkeyPatch, robot: Robot) -> Callable[[Meanwhile], Any]:
    """Play a motion of the PUMA while another arm stands there; what happens while the PUMA is fetched."""
    fetched, load = threading.Event(), changing.load

    def slowly(*arguments: Any) -> Robot:
        assert fetched.wait(60)
        return load(*arguments)

    monkeypatch.setattr(changing, "load", slowly)
    monkeypatch.setattr(changing, "Scene", lambda *arguments: SimpleNamespace(clear=lambda server: None))
    motion = Motion("puma560", np.array([0.0, 1.0]), np.zeros((2, 6)))

    def play(meanwhile: Meanwhile) -> Any:
        lab = _Lab(robot)

        async def run() -> None:
            bringing = Changing(lab)  # type: ignore[arg-type]
            bringing.play(motion)
            await asyncio.sleep(0.02)
            if meanwhile is not None:
                lab.post(meanwhile)
            fetched.set()
            await bringing._task

        asyncio.run(run())
        return lab

    return play


def test_a_motion_of_another_arm_brings_that_arm(play_on_another_arm: Callable[[Meanwhile], Any]) -> None:
    lab = play_on_another_arm(None)
    assert lab.state.robot.name == "puma560"
    assert isinstance(lab.state.command, Replay)


def test_a_stop_while_the_arm_is_fetched_ends_its_motion(play_on_another_arm: Callable[[Meanwhile], Any]) -> None:
    lab = play_on_another_arm(gate.stop())
    assert lab.state.robot.name == "puma560"
    assert lab.state.command == Hold()
