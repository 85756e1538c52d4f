"""Whether what comes from a page counts: only while its Stop can be heard, only what was made after the last stop by
someone who could know of it, and only what is fresh.

The page tells the last two along viser's own socket, where nothing overtakes anything: `HelicoideFence` after all that
was made before a stop, `HelicoideMadeAt` before each message that a hand makes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic

import viser
from viser._messages import Message

FRESH = 1.0


@dataclass
class HelicoideFence(Message, include_in_scene_serialization=False):
    """The page has let go of everything since the stop of that number; all that it sent before was sent before."""

    number: int


@dataclass
class HelicoideMadeAt(Message, include_in_scene_serialization=False):
    """The message that follows was made when this server's clock showed `at`, ms, or later."""

    at: float


@dataclass
class Link:
    """What is known of the page of one window, by its key.

    channels: how many control channels the page has open; fence: the number of the last stop; passed: that of the last
    one which the page has passed; made_at: when what comes now was made at the earliest, s of `monotonic`.
    """

    key: str
    channels: int = 0
    fence: int = 1
    passed: int = 0
    made_at: float = field(default=float("-inf"))

    @property
    def drives(self) -> bool:
        """Whether what comes now counts."""
        return self._may_drive and self._fresh

    @property
    def late(self) -> bool:
        """Whether what comes now would have counted, had it not been on its way for so long."""
        return self._may_drive and not self._fresh

    @property
    def _may_drive(self) -> bool:
        return self.channels > 0 and self.passed == self.fence

    @property
    def _fresh(self) -> bool:
        return monotonic() - self.made_at <= FRESH  # false for NaN

    def close(self) -> int:
        """Nothing counts until the page has passed the fence of this number."""
        self.fence += 1
        return self.fence

    def hear(self, message: HelicoideFence | HelicoideMadeAt) -> bool:
        """Take what the page says of what it sends; returns whether it passed the fence with it."""
        if isinstance(message, HelicoideMadeAt):
            self.made_at = message.at / 1000 if isinstance(message.at, int | float) else float("-inf")
            return False
        if message.number == self.fence != self.passed:
            self.passed = self.fence
            return True
        return False


def heard_from(server: viser.ViserServer, hear: Callable[[int, HelicoideFence | HelicoideMadeAt], None]) -> None:
    """Call `hear` with the number of the client and each of these messages, in the order of all that it sends."""

    def heard(client_id: int, message: Message) -> None:
        assert isinstance(message, HelicoideFence | HelicoideMadeAt)
        hear(client_id, message)

    for kind in (HelicoideFence, HelicoideMadeAt):
        server._websock_server.register_handler(kind, heard)
