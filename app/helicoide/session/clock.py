"""The thread in which every arm lives: a hundred ticks a second, none of them late for anything but another arm."""

from __future__ import annotations

import gc
import sys
from collections.abc import Callable, Sequence
from threading import Condition, Thread
from time import monotonic

from helicoide.kernels import Kernel
from helicoide.session.workcell import TICK, Workcell

# s: for how long Python lets another thread run on, once this one is due
SWITCH = 0.0001
FORESIGHT = 0.3  # of a tick: what may be spent on where commands lead


class Clock(Thread):
    """Drains, ticks and foresees; sleeps while every arm rests.

    workcells: those there are; changed: told after each round, in this thread. gap: the longest time between two ticks
    that should have been one apart, s, since `forget_gap`. plain: whether kernels run as Python, in which there is no
    time to foresee anything; halted: no arm lives, whatever is asked.
    """

    def __init__(self, workcells: Callable[[], Sequence[Workcell]], changed: Callable[[], None]) -> None:
        super().__init__(name="helicoide clock", daemon=True)
        self.workcells, self.changed = workcells, changed
        self.gap = 0.0
        self.plain, self.halted = False, False
        self._condition = Condition()
        self._woken, self._ended = False, False
        self._turn = 0

    @property
    def rests(self) -> bool:
        """Whether no arm lives at the moment."""
        return not self._awake()

    def wake(self) -> None:
        """Something has been asked of an arm."""
        with self._condition:
            self._woken = True
            self._condition.notify()

    def end(self) -> None:
        """Let no more time pass."""
        self._ended = True
        self.wake()
        if self.is_alive():
            self.join()

    def run(self) -> None:
        """Until the end: no catching up after a delay."""
        sys.setswitchinterval(SWITCH)
        _take_out_garbage_by_hand()
        due, before = monotonic(), None
        while not self._ended:
            self._wait(due if self._awake() else None)
            Kernel.interpret(self.plain)
            for workcell in self.workcells():
                workcell.drain()
            if (now := monotonic()) >= due and (awake := self._awake()):
                self.gap = max(self.gap, 0.0 if before is None else now - before)
                for workcell in awake:
                    workcell.tick()
                due = max(due + TICK, now)
                before = now if self._awake() else None
                if not self.plain:
                    self._foresee(monotonic() + FORESIGHT * TICK)
            self.changed()
        Kernel.interpret(False)

    def live(self, plain: bool = False, halted: bool = False) -> None:
        """Let time pass from now on, from the next round on as is said here; the thread starts with the first call."""
        self.plain, self.halted = plain, halted
        if not (self._ended or self.is_alive()):
            self.start()
        self.wake()

    def _awake(self) -> list[Workcell]:
        if self.halted:
            return []
        return [workcell for workcell in self.workcells() if not (workcell.resting or workcell.paused)]

    def _wait(self, due: float | None) -> None:
        with self._condition:
            if not self._woken:
                self._condition.wait(None if due is None else max(0.0, due - monotonic()))
            self._woken = False

    def _foresee(self, until: float) -> None:
        """One workcell after the other, from where the last round ended, at least one."""
        workcells = self.workcells()
        for _ in workcells:
            self._turn = (self._turn + 1) % len(workcells)
            workcells[self._turn].foresee()
            if monotonic() > until:
                return


def _take_out_garbage_by_hand() -> None:
    """Let Python look for young garbage only: to look through everything stops every thread for a tenth of a second.

    Whoever sees that all arms rest calls `gc.collect`.
    """
    gc.freeze()
    young, middle, _ = gc.get_threshold()
    gc.set_threshold(young, middle, 1_000_000)
