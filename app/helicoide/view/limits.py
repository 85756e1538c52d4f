"""Limit the rate at which messages of a page are read. Only the page that sends more has to wait."""

from __future__ import annotations

import asyncio
from time import monotonic

from websockets.asyncio.server import ServerConnection
from websockets.typing import Data

BURST = 1.0  # s of messages that are read at once after a pause


class Pace:
    """A limit of `rate` messages per second; after a pause, the messages of `BURST` seconds are read at once."""

    def __init__(self, rate: float) -> None:
        self.rate, self.left, self.seen = rate, BURST * rate, monotonic()

    def wait(self, now: float) -> float:
        """The time, s, that the next message has to wait. now: s of `monotonic`."""
        self.left = min(BURST * self.rate, self.left + (now - self.seen) * self.rate) - 1.0
        self.seen = now
        return max(0.0, -self.left / self.rate)


def slowed(connection: ServerConnection, rate: float) -> None:
    """Read at most `rate` messages per second of a connection."""
    pace, receive = Pace(rate), connection.recv

    async def recv(*args: bool | None, **options: bool | None) -> Data:
        if wait := pace.wait(monotonic()):
            await asyncio.sleep(wait)
        return await receive(*args, **options)

    connection.recv = recv  # type: ignore[method-assign, assignment]
