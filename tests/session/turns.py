"""How long the turns of an event loop take, in processor time of its thread, which no other program lengthens."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from time import thread_time
from unittest.mock import patch


@dataclass
class Turns:
    """What was counted: callbacks, and the longest of them, s of processor time, with what it was."""

    count: int = 0
    longest: float = 0.0
    what: str = ""


@contextmanager
def counted(loop: asyncio.AbstractEventLoop) -> Iterator[Turns]:
    """Count the turns of a loop, which runs in another thread."""
    turns, run = Turns(), asyncio.Handle._run

    def measured(handle: asyncio.Handle) -> None:
        if handle._loop is not loop:  # type: ignore[attr-defined]
            return run(handle)
        what, began = repr(getattr(handle._callback, "__self__", handle)), thread_time()  # type: ignore[attr-defined]
        run(handle)
        turns.count += 1
        if (took := thread_time() - began) > turns.longest:
            turns.longest, turns.what = took, what
        return None

    with patch.object(asyncio.Handle, "_run", measured):
        yield turns
