"""The page's own channel: Stop comes in past every queue, and so does that a pointer has been let go; the words of the
status line go out when they change.
"""

from __future__ import annotations

import contextlib
import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import viser
from viser._messages import RunJavascriptMessage
from websockets.asyncio.server import ServerConnection, broadcast
from websockets.exceptions import ConnectionClosed

from helicoide.text import Language, Text

PATH = "/helicoide/control"

Tone = Literal["ok", "warn", "blocked", "stopped"]


@dataclass(frozen=True)
class Notice:
    """What the status line of one window says, and how it looks."""

    language: Language
    status: Text
    tone: Tone

    def json(self) -> str:
        """Write it as the page reads it."""
        return json.dumps({"language": self.language, "status": self.status[self.language], "tone": self.tone})


@dataclass
class Control:
    """The control channels of all windows. Its methods run on the event loop of the server, and so do the callbacks.

    on_release: told the seat whose pointer was let go.
    """

    on_stop: Callable[[], None]
    on_release: Callable[[str], None] = lambda seat: None
    _seats: dict[ServerConnection, str] = field(default_factory=dict)
    _notices: dict[str, Notice] = field(default_factory=dict)

    async def serve(self, connection: ServerConnection) -> None:
        """Listen to one page until it leaves: stop, its seat, and the beat by which it knows that we still listen."""
        try:
            with contextlib.suppress(ConnectionClosed):
                async for raw in connection:
                    for answer in self._hear(connection, raw):
                        await connection.send(answer)
        finally:
            self._seats.pop(connection, None)

    def push(self, seat: str, notice: Notice) -> None:
        """Show a notice in the windows of a seat, at once and in those that come later; a repeated one is not sent."""
        if self._notices.get(seat) != notice:
            self._notices[seat] = notice
            broadcast([page for page, name in self._seats.items() if name == seat], notice.json())

    def forget(self, seat: str) -> None:
        """Drop the notice of a seat whose window is gone."""
        self._notices.pop(seat, None)

    def _hear(self, connection: ServerConnection, raw: str | bytes) -> list[str]:
        message = _parse(raw)
        if message.get("stop") is True:
            self.on_stop()
            return ['{"heard": "stop"}']
        if message.get("beat") is True:
            return ['{"heard": "beat"}']
        if message.get("released") is True:
            if connection in self._seats:
                self.on_release(self._seats[connection])
            return []
        seat = message.get("seat")
        if not isinstance(seat, str):
            return []
        self._seats[connection] = seat
        return [self._notices[seat].json()] if seat in self._notices else []


def introduce(client: viser.ClientHandle, seat: str) -> None:
    """Tell the page of this viser client which seat is its own.

    This is a private message of viser: an element of the GUI would be missing while its panel is folded.
    """
    source = f'window.helicoideSeat = {json.dumps(seat)}; window.dispatchEvent(new Event("helicoide-seat"));'
    client.gui._websock_interface.queue_message(RunJavascriptMessage(source=source))


def _parse(raw: str | bytes) -> dict[str, object]:
    """Read the object a page sent, or an empty one: a malformed message must not cost the page its Stop button."""
    try:
        message = json.loads(raw)
    except (ValueError, RecursionError):
        return {}
    return message if isinstance(message, dict) else {}
