"""The page's own channel: Stop comes in past every queue, and so does that a pointer has been let go; the words of the
status line go out when they change.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic
from typing import Literal

import viser
from viser._messages import RunJavascriptMessage
from websockets.asyncio.server import ServerConnection, broadcast
from websockets.exceptions import ConnectionClosed

from helicoide.text import Language, Text
from helicoide.view.link import Link

PATH = "/helicoide/control"

Tone = Literal["ok", "warn", "blocked", "stopped"]


@dataclass(frozen=True)
class Notice:
    """What the status line of one window says, and how it looks; everywhere: whether its Stop stops a real arm too;
    projector: whether its words are large."""

    language: Language
    status: Text
    tone: Tone
    everywhere: bool = False
    projector: bool = False

    def json(self) -> str:
        """Write it as the page reads it."""
        return json.dumps(
            {
                "language": self.language,
                "status": self.status[self.language],
                "tone": self.tone,
                "everywhere": self.everywhere,
                "projector": self.projector,
            }
        )


@dataclass(frozen=True)
class Hello:
    """What a page says of itself first: the seat that its browser remembers, and the language that it asks for."""

    seat: str | None
    language: Language | None


@dataclass(eq=False)
class WindowChannel:
    """The control channels of one window: its link, what its page said first, and what it was told last."""

    link: Link
    hello: asyncio.Future[Hello]
    pages: set[ServerConnection] = field(default_factory=set)
    notice: Notice | None = None

    def tell(self, **message: object) -> None:
        """Say something to the page."""
        broadcast(self.pages, json.dumps(message))


@dataclass
class ControlChannel:
    """The control channels of all windows. Its methods run on the event loop of the server, and so do the callbacks.

    on_stop: told the key of the window that stops, None before a page has said which it is, and whether the same key
    closes something on the page; on_release: told the key of the window whose pointer was let go, or whose last channel
    has closed; on_tab: told the number of the tab in front.
    """

    on_stop: Callable[[str | None, bool], None]
    on_release: Callable[[str], None] = lambda key: None
    on_tab: Callable[[str, int], None] = lambda key, tab: None
    _lines: dict[str, WindowChannel] = field(default_factory=dict)

    def open(self, key: str) -> WindowChannel:
        """A line for the window of that key, on which its page may now speak."""
        self._lines[key] = line = WindowChannel(Link(key), asyncio.get_running_loop().create_future())
        return line

    def close(self, key: str) -> None:
        """Forget the line of a window that is gone."""
        line = self._lines.pop(key, None)
        if line is not None:
            line.hello.cancel()

    def fence(self, key: str) -> None:
        """Let nothing of a window count that its page made before it knows of this."""
        line = self._lines[key]
        line.tell(fence=line.link.close())

    def push(self, key: str, notice: Notice) -> None:
        """Show a notice in a window, at once and when its page comes later; a repeated one is not sent."""
        line = self._lines.get(key)
        if line is not None and line.notice != notice:
            line.notice = notice
            broadcast(line.pages, notice.json())

    async def serve(self, connection: ServerConnection) -> None:
        """Listen to one page until it leaves: stop, its window, and the beat by which it knows that we still listen."""
        here: list[str] = []
        try:
            with contextlib.suppress(ConnectionClosed):
                while True:
                    for answer in self._hear(connection, await connection.recv(), here):
                        await connection.send(answer)
        finally:
            self._left(connection, here)

    def _left(self, connection: ServerConnection, here: list[str]) -> None:
        line = self._lines.get(here[-1]) if here else None
        if line is not None:
            line.pages.discard(connection)
            line.link.channels = len(line.pages)
            if not line.pages:
                self.on_release(line.link.key)

    def _hear(self, connection: ServerConnection, raw: str | bytes, here: list[str]) -> list[str]:
        """What to answer; here: the key of the page's window, once it is known."""
        message = _parse(raw)
        if message.get("stop") is True:
            self.on_stop(here[-1] if here else None, message.get("closing") is True)
            return ['{"heard": "stop"}']
        if message.get("beat") is True:
            return [json.dumps({"heard": "beat", "at": 1000 * monotonic()})]
        if message.get("released") is True:
            if here:
                self.on_release(here[-1])
            return []
        if (tab := message.get("tab")) is not None:
            if here and isinstance(tab, int):
                self.on_tab(here[-1], tab)
            return []
        key = message.get("window")
        line = self._lines.get(key) if isinstance(key, str) else None
        if line is None:
            return []
        self._left(connection, here)
        here[:] = [line.link.key]
        return self._met(connection, line, message)

    def _met(self, connection: ServerConnection, line: WindowChannel, message: dict[str, object]) -> list[str]:
        """The page of a window is there: it may drive once it has passed a fence, and hears what was said last."""
        line.pages.add(connection)
        line.link.channels = len(line.pages)
        if not line.hello.done():
            line.hello.set_result(_hello(message))
        said = [] if line.notice is None else [line.notice.json()]
        return [json.dumps({"fence": line.link.close()}), *said]


def introduce(client: viser.ClientHandle, key: str) -> None:
    """Tell the page of this viser client which window it is.

    This is a private message of viser: an element of the GUI would be missing while its panel is folded.
    """
    source = (
        f"window.helicoideClient = {json.dumps(str(client.client_id))}; window.helicoideWindow = {json.dumps(key)}; "
        'window.dispatchEvent(new Event("helicoide-window"));'
    )
    client.gui._websock_interface.queue_message(RunJavascriptMessage(source=source))


def show_tab(client: viser.ClientHandle, index: int) -> None:
    """Bring a tab of the panel to the front: viser has no message for that."""
    client.gui._websock_interface.queue_message(RunJavascriptMessage(source=f"window.helicoideShowTab?.({index})"))


def _hello(message: dict[str, object]) -> Hello:
    seat, languages = message.get("seat"), message.get("languages")
    wanted = [one for one in languages if isinstance(one, str)] if isinstance(languages, list) else []
    spoken = next((one for one in wanted if one[:2] in ("pt", "en")), None)
    language: Language | None = None if spoken is None else "pt_BR" if spoken.startswith("pt") else "en"
    return Hello(seat if isinstance(seat, str) else None, language)


def _parse(raw: str | bytes) -> dict[str, object]:
    """Read the object a page sent, or an empty one: a malformed message must not cost the page its Stop button."""
    try:
        message = json.loads(raw)
    except (ValueError, RecursionError):
        return {}
    return message if isinstance(message, dict) else {}
