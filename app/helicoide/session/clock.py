"""The thread that advances every arm: a hundred ticks a second, which only other arms can delay."""

from __future__ import annotations

import gc
import sys
from collections.abc import Callable, Sequence
from threading import Condition, Thread
from time import monotonic

from helicoide.kernels import Kernel
from helicoide.session.workcell import TICK, Workcell

# s that Python lets another thread run on when this one is due
SWITCH = 0.0001
FORESIGHT = 0.3  # share of a tick for computing where commands lead


class Clock(Thread):
    """Applies updates, advances the arms, and computes where commands lead; sleeps while every arm is at rest.

    workcells: returns all workcells; changed: called after each round, in this thread; gap: longest time between two
    consecutive ticks, s; plain: whether kernels run as Python, which is too slow to compute goals too; halted: whether
    no arm is advanced.
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
    def idle(self) -> bool:
        """Whether no arm is advanced at the moment."""
        return not self._awake()

    def wake(self) -> None:
        """Wake the thread, since an arm has a new update."""
        with self._condition:
            self._woken = True
            self._condition.notify()

    def end(self) -> None:
        """End the thread and wait for it."""
        self._ended = True
        self.wake()
        if self.is_alive():
            self.join()

    def run(self) -> None:
        """Run until `end`. Ticks that were missed are not made up for."""
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

    def start_ticking(self, plain: bool = False, halted: bool = False) -> None:
        """Set `plain` and `halted` from the next round on. The first call starts the thread."""
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
        """Compute goals, workcell by workcell, from where the last round ended until the time `until`; at least one."""
        workcells = self.workcells()
        for _ in workcells:
            self._turn = (self._turn + 1) % len(workcells)
            workcells[self._turn].foresee()
            if monotonic() > until:
                return


def _take_out_garbage_by_hand() -> None:
    """Turn off garbage collections of the oldest generation: each one stops every thread for a tenth of a second.

    `Lab` calls `gc.collect` instead, preferably while all arms are at rest.
    """
    gc.freeze()
    young, middle, _ = gc.get_threshold()
    gc.set_threshold(young, middle, 1_000_000)
