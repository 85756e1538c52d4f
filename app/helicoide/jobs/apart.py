"""One piece of long work in a process of its own, which tells how far it is and can be ended at any time."""

from __future__ import annotations

import multiprocessing
import traceback
from collections.abc import Callable, Iterator
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from helicoide.jobs.thinned import thinned

Report = Callable[[Any], None]
Work = Callable[..., object]


class Failed(Exception):
    """The work ended with an exception; its traceback as text."""


class Apart:
    """A call `work(report, *arguments)`; both are sent to the process, so that work is a function of a module."""

    def __init__(self, work: Work, *arguments: object) -> None:
        self._receiver, self._sender = multiprocessing.Pipe(duplex=False)
        spawn = multiprocessing.get_context("spawn")
        self._child = spawn.Process(target=_call, args=(self._sender, work, arguments), daemon=True)
        self._stopped = False
        self.result: Any = None

    def progress(self) -> Iterator[Any]:
        """Start, and yield what the work reports until it is done or stopped; `result` then holds what it returned.

        Raises Failed, with the traceback, when the work raised.
        """
        self._child.start()
        self._sender.close()
        if self._stopped:
            self._child.terminate()
        with suppress(EOFError):
            while True:
                kind, what = self._receiver.recv()
                if kind == "failed":
                    raise Failed(what)
                if kind == "result":
                    self.result = what
                else:
                    yield what
        self._child.join()

    def stop(self) -> None:
        """End the work where it is; a later start ends at once."""
        self._stopped = True
        if self._child.pid is not None:
            self._child.terminate()


def _call(sender: Connection, work: Work, arguments: tuple[object, ...]) -> None:
    try:
        result = work(thinned(lambda what: sender.send(("report", what))), *arguments)
        sender.send(("result", result))
    except Exception:
        sender.send(("failed", traceback.format_exc()))
