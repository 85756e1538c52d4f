"""The recorder of an arm: the clock appends states to a queue, and a thread writes them to a file."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from threading import Event, Thread
from time import time_ns
from typing import BinaryIO

from helicoide.files.os_errors import os_error_reason
from helicoide.recorder.mcap_file import StateFile
from helicoide.state import State
from helicoide.text import Text

# s of the arm's own time between two samples, and the longest recording; the largest file, bytes
SAMPLED, LONGEST, LARGEST = 0.02, 3600.0, 250_000_000
# s between two looks into the queue; the most states that wait in it, 40 s of an arm that moves
EVERY, WAITING = 0.25, 4000
log = logging.getLogger("helicoide")

BOUNDS = Text(
    en="A recording ends by itself after {min:.0f} minutes of motion or {mb:.0f} MB.",
    pt_BR="Uma gravação termina sozinha após {min:.0f} minutos de movimento ou {mb:.0f} MB.",
).format(min=LONGEST / 60, mb=LARGEST / 1e6)
LONG = Text(
    en="The recording has ended: it is {min:.0f} minutes long.", pt_BR="A gravação terminou: ela tem {min:.0f} minutos."
).format(min=LONGEST / 60)
LARGE = Text(
    en="The recording has ended: its file has {mb:.0f} MB.", pt_BR="A gravação terminou: o arquivo tem {mb:.0f} MB."
).format(mb=LARGEST / 1e6)
ANOTHER_ARM = Text(
    en="The recording has ended: another arm was loaded.", pt_BR="A gravação terminou: outro braço foi carregado."
)
SLOW = Text(en="The recording has ended: the disk is too slow.", pt_BR="A gravação terminou: o disco é lento demais.")
CANNOT = Text(en="The recording has ended: {reason}.", pt_BR="A gravação terminou: {reason}.")
BUG = Text(
    en="The recording has ended: internal error; see the terminal.",
    pt_BR="A gravação terminou: erro interno; veja o terminal.",
)


@dataclass(frozen=True)
class RecorderStatus:
    """What a recorder does: whether it still writes, how much it has written, and why it ended by itself, if it did.

    seconds of the arm's own time and megabytes are rounded, so that equal ones need not be shown again.
    """

    running: bool
    seconds: int
    megabytes: float
    reason: Text | None


class Recorder:
    """Records an arm from a state on, until `end` or until a limit, a fault of the disk or another arm ends it.

    take: queues a state; it only appends to a deque, so that the clock can call it in every tick. path: the file;
    opened: opens it. seconds, size: how much has been written, s of the arm's own time and bytes; reason: why the
    recording ended by itself, else None.
    """

    def __init__(self, path: Path, first: State, opened: Callable[[Path], BinaryIO] | None = None) -> None:
        self.path, self.first = path, first
        self.seconds, self.size = 0.0, 0
        self.reason: Text | None = None
        self._queue: deque[State] = deque([first], WAITING)
        self.take: Callable[[State], None] = self._queue.append
        self._opened = opened or new_file
        self._asked_to_end = Event()
        self._last_t: float | None = None
        self._thread = Thread(target=self._run, name="helicoide recorder", daemon=True)
        self._thread.start()

    @property
    def running(self) -> bool:
        """Whether states are still written."""
        return self._thread.is_alive()

    @property
    def status(self) -> RecorderStatus:
        """What it does now."""
        return RecorderStatus(self.running, int(self.seconds), round(self.size / 1e6, 1), self.reason)

    def end(self, wait: float | None = None) -> None:
        """Write what is queued and end the recording. wait: longest time to wait for this, s; None: do not wait."""
        self._asked_to_end.set()
        if wait is not None:
            self._thread.join(wait)

    def _run(self) -> None:
        try:
            with self._opened(self.path) as file:
                self._record(file)
        except OSError as error:
            self.reason = CANNOT.format(reason=os_error_reason(error))
        except Exception:
            log.exception("a recording failed")
            self.reason = BUG
        self.take = _ignore
        self._queue.clear()

    def _record(self, file: BinaryIO) -> None:
        states = StateFile(file, self.first, time_ns())
        while self.reason is None:
            asked = self._asked_to_end.wait(EVERY)
            if len(self._queue) == WAITING:
                self.reason = SLOW
            while self._queue and self.reason is None:
                self._sample(states, self._queue.popleft())
            file.flush()
            self.size = file.tell()
            if self.size > LARGEST:
                self.reason = LARGE
            elif not self.path.exists():
                raise FileNotFoundError(2, "")
            if asked:
                break
        states.finish()

    def _sample(self, states: StateFile, state: State) -> None:
        """Write a state, unless one was written less than `SAMPLED` before it."""
        if state.robot is not self.first.robot:
            self.reason = ANOTHER_ARM
            return
        since = state.t - self.first.t
        if self._last_t is not None and since - self._last_t < SAMPLED - 1e-6:
            return
        states.add(state)
        self.seconds = self._last_t = since
        if since > LONGEST:
            self.reason = LONG


def _ignore(state: State) -> None:
    """Take a state after the end."""


def new_file(path: Path) -> BinaryIO:
    """A new file; an existing one is never overwritten."""
    path.parent.mkdir(parents=True, exist_ok=True)
    return path.open("xb")
