"""A lab on a free port, and what tests ask of it."""

from __future__ import annotations

import faulthandler
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace

import pytest
from tests.pages import Hand

from helicoide.kinematics.library import load_robot
from helicoide.session.lab import Lab
from helicoide.state import State
from helicoide.store.database import Store
from helicoide.view import link

SLOW = 60.0  # s


def eventually(condition: Callable[[], bool], seconds: float = 60.0) -> bool:
    """Whether a condition comes true, generously; if not, what every thread does is printed."""
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    if condition():
        return True
    faulthandler.dump_traceback(sys.__stderr__)
    return False


@contextmanager
def running(robot: str = "movemaster", store: Store | None = None) -> Iterator[Lab]:
    """A lab whose arms live. It takes actions up to `SLOW` seconds old, since a slow machine needs more than one."""
    lab = Lab(load_robot(robot), None, None, store=store)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(link, "FRESH", SLOW)
        lab.open("127.0.0.1", 0)
        try:
            assert eventually(lambda: lab.ready, 300)
            yield lab
        finally:
            lab.close()


def window(lab: Lab, **options: object) -> Hand:
    """A window that may drive."""
    hand = Hand(lab.server.get_port(), **options)
    assert eventually(lambda: hand.page.window.done() and hand.page.may_drive.is_set())
    key = hand.page.window.result()
    assert eventually(lambda: any(one.window.link.key == key for one in tuple(lab.visitors.values())))
    assert eventually(lambda: "Play" in hand.page.made or "Reproduzir" in hand.page.made or "Pause" in hand.page.made)
    return hand


def state(lab: Lab) -> State:
    """The shared arm."""
    return lab.shared.workcell.state


def after_ticks(lab: Lab, n: int = 40) -> State:
    """The shared arm n ticks later."""
    cell = lab.shared.workcell
    cell.tell(lambda state: replace(state, request=replace(state.request, unchanged=0.0)))
    now = cell.ticks
    assert eventually(lambda: cell.ticks >= now + n)
    return cell.state
