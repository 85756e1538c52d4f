"""Which messages from a page are accepted.

A message is accepted only while a control channel is open, so that Stop works; only if it was made after the page knew
of the last stop; and only if it is at most `FRESH` seconds old. For the last two, the page sends on viser's own socket,
which keeps the order, `HelicoideFence` after all that was made before a stop, and `HelicoideMadeAt` before each message
of a user action.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic
from typing import get_args

import viser
from viser._messages import Message

FRESH = 1.0


@dataclass
class HelicoideFence(Message, include_in_scene_serialization=False):
    """The user has released everything after the stop with this number; later messages were made after that release."""

    number: int


@dataclass
class HelicoideMadeAt(Message, include_in_scene_serialization=False):
    """The next message was made when this server's clock showed `at`, ms, or later."""

    at: float


@dataclass
class HelicoideFirstLesson(Message, include_in_scene_serialization=False):
    """The user asks for the first lesson, which the hint of a first visit offers."""


@dataclass
class HelicoideFollow(Message, include_in_scene_serialization=False):
    """The user presses a button within the text of a lesson, such as that of "layer:twist"."""

    target: str


@dataclass
class HelicoideUndo(Message, include_in_scene_serialization=False):
    """The user undoes the last change by the keyboard."""


@dataclass
class HelicoideRedo(Message, include_in_scene_serialization=False):
    """The user makes the change again that was undone last, by the keyboard."""


PageMessage = HelicoideFence | HelicoideMadeAt | HelicoideFirstLesson | HelicoideFollow | HelicoideUndo | HelicoideRedo


@dataclass
class Link:
    """The connection to the page of one window.

    key: of the window; channels: number of open control channels of the page; fence: number of the last stop; passed:
    number of the last stop that the page has confirmed; made_at: earliest time at which the current message was made,
    s of `monotonic`.
    """

    key: str
    channels: int = 0
    fence: int = 1
    passed: int = 0
    made_at: float = field(default=float("-inf"))

    @property
    def has_control(self) -> bool:
        """Whether the current message is accepted."""
        return self._is_in_control and self._fresh

    @property
    def late(self) -> bool:
        """Whether the current message is rejected only because it is too old."""
        return self._is_in_control and not self._fresh

    @property
    def _is_in_control(self) -> bool:
        return self.channels > 0 and self.passed == self.fence

    @property
    def _fresh(self) -> bool:
        return monotonic() - self.made_at <= FRESH  # false for NaN

    def close(self) -> int:
        """Accept nothing until the page has passed a new fence; returns the number of that fence."""
        self.fence += 1
        return self.fence

    def hear(self, message: HelicoideFence | HelicoideMadeAt) -> bool:
        """Take a fence or a time from the page; returns whether the page has now passed the current fence."""
        if isinstance(message, HelicoideMadeAt):
            self.made_at = message.at / 1000 if isinstance(message.at, int | float) else float("-inf")
            return False
        if message.number == self.fence != self.passed:
            self.passed = self.fence
            return True
        return False


def connection_of(server: viser.ViserServer, hear: Callable[[int, PageMessage], None]) -> None:
    """Call `hear` with the client number and each of these messages, in the order in which the client sends them."""

    def received(client_id: int, message: Message) -> None:
        assert isinstance(message, PageMessage)
        hear(client_id, message)

    for kind in get_args(PageMessage):
        server._websock_server.register_handler(kind, received)
