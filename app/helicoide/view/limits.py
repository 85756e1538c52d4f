"""How fast a page is listened to: one that says more waits, and nobody else does."""

from __future__ import annotations

import asyncio
from time import monotonic

from websockets.asyncio.server import ServerConnection
from websockets.typing import Data

BURST = 1.0  # s of messages that are read at once after a silence


class Pace:
    """So many messages a second, rate, after a silence those of `BURST` seconds at once."""

    def __init__(self, rate: float) -> None:
        self.rate, self.left, self.seen = rate, BURST * rate, monotonic()

    def wait(self, now: float) -> float:
        """How long, s, the next message has to wait at that time, s."""
        self.left = min(BURST * self.rate, self.left + (now - self.seen) * self.rate) - 1.0
        self.seen = now
        return max(0.0, -self.left / self.rate)


def slowed(connection: ServerConnection, rate: float) -> None:
    """Read at most so many messages a second of a connection."""
    pace, receive = Pace(rate), connection.recv

    async def recv(*args: bool | None, **options: bool | None) -> Data:
        if wait := pace.wait(monotonic()):
            await asyncio.sleep(wait)
        return await receive(*args, **options)

    connection.recv = recv  # type: ignore[method-assign, assignment]
