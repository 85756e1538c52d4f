"""While kernels are compiled the arms live by Python: they move within their limits, and nothing is compiled here."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import numpy as np
import pytest
from numba.core import event
from tests.session.labs import after_ticks, eventually, state, window

from helicoide import gate, kernels
from helicoide.kernels import Kernel
from helicoide.kinematics.library import load_robot
from helicoide.session import lab as labs
from helicoide.session import preparing
from helicoide.session.lab import Lab


class Compiling(event.Listener):
    """The kernels that were compiled, whether or not they could be loaded."""

    def __init__(self) -> None:
        self.met: list[str] = []

    def on_start(self, event: event.Event) -> None:
        if isinstance(kernel := event.data["dispatcher"], Kernel):
            self.met.append(kernel.py_func.__qualname__)

    def on_end(self, event: event.Event) -> None:
        pass


class Slow:
    """A compilation that goes on until it is let go."""

    stopped = False

    def __init__(self, *_: object) -> None:
        self.may_end = threading.Event()

    def reports(self) -> Iterator[int]:
        yield 1
        self.may_end.wait(120)

    def stop(self) -> None:
        self.stopped = True
        self.may_end.set()


@pytest.fixture
def preparing_lab(monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[Lab, Slow]]:
    """A lab that finds nothing on disk at its start, and what it waits for."""
    asked, exercise_all = list[str](), preparing.exercise

    def exercise() -> None:
        asked.append("load")
        if len(asked) == 1:
            raise kernels.NotCached
        exercise_all()

    monkeypatch.setattr(preparing, "exercise", exercise)
    monkeypatch.setattr(labs, "ProcessJob", Slow)
    lab = Lab(load_robot("movemaster"), None, None)
    lab.open("127.0.0.1", 0)
    try:
        yield lab, lab._compilation
    finally:
        lab.close()


def test_the_arm_moves_before_its_kernels_are_there(preparing_lab: tuple[Lab, Slow]) -> None:
    lab, compilation = preparing_lab
    assert eventually(Kernel.interpreted)
    listening = Compiling()
    with event.install_listener("numba:compile", listening):
        hand = window(lab)
        hand.do(hand.page.give("1 waist", 3.0))
        assert eventually(lambda: abs(state(lab).arm.q[0] - np.radians(3.0)) < 1e-3)
        assert not lab.ready
        assert "1" in hand.page.notice["status"], "how far the preparation is"
        lab.shared.workcell.tell(gate.add_obstacle())
        lab.shared.workcell.tell(gate.drag_target("", "start", state(lab).T_world_tool[:3, 3], [1.0, 0, 0, 0]))
        moved = after_ticks(lab)
        limits = moved.problem.limits
        assert (limits.lower <= moved.arm.q).all()
        assert (moved.arm.q <= limits.upper).all()
        assert moved.request.goal is None, "nothing is foreseen"
        assert listening.met == []
    hand.do(hand.page.stop())
    compilation.may_end.set()
    assert eventually(lambda: lab.ready and not Kernel.interpreted(), 300)
    hand.do(hand.page.give("1 waist", 5.0))
    assert eventually(lambda: abs(state(lab).arm.q[0] - np.radians(5.0)) < 1e-3)
    assert eventually(lambda: state(lab).request.goal is not None)
    hand.close()


def test_no_arm_moves_while_kernels_are_compiled_in_the_same_process(preparing_lab: tuple[Lab, Slow]) -> None:
    lab, _ = preparing_lab
    assert eventually(Kernel.interpreted)
    lab.loop.call_soon_threadsafe(lab._meanwhile, False)
    assert eventually(lambda: lab.clock.halted)
    lab.shared.workcell.tell(gate.set_joint(0, 0.2))
    assert eventually(lambda: state(lab).request.command is not None and not lab.shared.workcell.resting)
    ticks, q = lab.shared.workcell.ticks, state(lab).arm.q
    assert not eventually(lambda: lab.shared.workcell.ticks > ticks, 0.5)
    assert state(lab).arm.q is q
    lab.loop.call_soon_threadsafe(lab._meanwhile, True)
    assert eventually(lambda: abs(state(lab).arm.q[0] - 0.2) < 1e-3)
