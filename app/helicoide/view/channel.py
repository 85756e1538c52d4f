"""The control channel of a page. Stop and the release of a pointer come in ahead of every queue; the status line goes
out when it changes.
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

PATH, LONGEST_ADDRESS = "/helicoide/control", 2000

Tone = Literal["ok", "warn", "blocked", "stopped"]


@dataclass(frozen=True)
class Notice:
    """The status line of one window. everywhere: whether its Stop also stops a real arm; projector: whether the text
    is large; transparent: whether the arm is transparent."""

    language: Language
    status: Text
    tone: Tone
    everywhere: bool = False
    projector: bool = False
    transparent: bool = False

    def json(self) -> str:
        """The notice as the JSON text that the page reads."""
        return json.dumps(
            {
                "language": self.language,
                "status": self.status[self.language],
                "tone": self.tone,
                "everywhere": self.everywhere,
                "projector": self.projector,
                "transparent": self.transparent,
            }
        )


@dataclass(frozen=True)
class Hello:
    """The first message of a page: the seat that its browser has stored, and the language that it asks for.

    dark: whether the browser prefers a dark page; link: the fragment of the page's address, empty without one;
    address: the rest of the address, to which links to share are added.
    """

    seat: str | None
    language: Language | None
    dark: bool = False
    link: str = ""
    address: str = ""


@dataclass(eq=False)
class WindowChannel:
    """The control channels of one window: its link, the first message of its page, and the last notice sent to it."""

    link: Link
    hello: asyncio.Future[Hello]
    pages: set[ServerConnection] = field(default_factory=set)
    notice: Notice | None = None

    def tell(self, **message: object) -> None:
        """Send a message to the page."""
        broadcast(self.pages, json.dumps(message))


@dataclass
class ControlChannel:
    """The control channels of all windows. Methods and callbacks run on the event loop of the server.

    on_stop: takes the key of the window that stops, None before the page has named its window, and whether the same
    keystroke also closes something on the page; on_release: takes the key of a window whose pointer was released, or
    whose last channel has closed; on_tab: takes the key of a window and the number of the tab in front; on_press:
    takes the key of a window in which a pointer or a key goes down while no other is down.
    """

    on_stop: Callable[[str | None, bool], None]
    on_release: Callable[[str], None] = lambda key: None
    on_tab: Callable[[str, int], None] = lambda key, tab: None
    on_press: Callable[[str], None] = lambda key: None
    _lines: dict[str, WindowChannel] = field(default_factory=dict)

    def open(self, key: str) -> WindowChannel:
        """Open the channel of a window, so that its page can connect."""
        self._lines[key] = line = WindowChannel(Link(key), asyncio.get_running_loop().create_future())
        return line

    def close(self, key: str) -> None:
        """Remove the channel of a window that has closed."""
        line = self._lines.pop(key, None)
        if line is not None:
            line.hello.cancel()

    def fence(self, key: str) -> None:
        """Reject every message of a window that its page makes before it knows of this call."""
        line = self._lines[key]
        line.tell(fence=line.link.close())

    def push(self, key: str, notice: Notice) -> None:
        """Show a notice in a window, now or as soon as its page connects; an unchanged notice is not sent again."""
        line = self._lines.get(key)
        if line is not None and line.notice != notice:
            line.notice = notice
            broadcast(line.pages, notice.json())

    async def serve(self, connection: ServerConnection) -> None:
        """Read the messages of one page until it disconnects. Answers to heartbeats show that the server is there."""
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
        """The answers to a message. here: the key of the page's window, once it is known."""
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
        if message.get("pressed") is True:
            if here:
                self.on_press(here[-1])
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
        """Register the page of a window. The answers are a fence, to pass before it may drive, and the notice."""
        line.pages.add(connection)
        line.link.channels = len(line.pages)
        if not line.hello.done():
            line.hello.set_result(_hello(message))
        said = [] if line.notice is None else [line.notice.json()]
        return [json.dumps({"fence": line.link.close()}), *said]


def introduce(client: viser.ClientHandle, key: str) -> None:
    """Tell the page of this viser client the key of its window.

    This uses a private message of viser: a GUI element would not exist on the page while its panel is folded.
    """
    source = (
        f"window.helicoideClient = {json.dumps(str(client.client_id))}; window.helicoideWindow = {json.dumps(key)}; "
        'window.dispatchEvent(new Event("helicoide-window"));'
    )
    client.gui._websock_interface.queue_message(RunJavascriptMessage(source=source))


def show_tab(client: viser.ClientHandle, index: int) -> None:
    """Bring a tab of the panel to the front; viser has no message for this."""
    _call(client, "helicoideShowTab", index)


def share_link(client: viser.ClientHandle, fragment: str) -> None:
    """Put a link into the address of the page, and on the clipboard if the browser allows it; "" removes it."""
    _call(client, "helicoideShare", fragment)


def _call(client: viser.ClientHandle, function: str, value: int | str) -> None:
    """Call a function of our scripts on the page with a value."""
    source = f"window.{function}?.({json.dumps(value)})"
    client.gui._websock_interface.queue_message(RunJavascriptMessage(source=source))


def _hello(message: dict[str, object]) -> Hello:
    seat, languages = message.get("seat"), message.get("languages")
    wanted = [one for one in languages if isinstance(one, str)] if isinstance(languages, list) else []
    spoken = next((one for one in wanted if one[:2] in ("pt", "en")), None)
    language: Language | None = None if spoken is None else "pt_BR" if spoken.startswith("pt") else "en"
    link, address = message.get("link"), message.get("address")
    return Hello(
        seat if isinstance(seat, str) else None,
        language,
        message.get("dark") is True,
        link if isinstance(link, str) else "",
        address[:LONGEST_ADDRESS] if isinstance(address, str) else "",
    )


def _parse(raw: str | bytes) -> dict[str, object]:
    """The JSON object that a page sent, empty if it is malformed: Stop must work after any message."""
    try:
        message = json.loads(raw)
    except (ValueError, RecursionError):
        return {}
    return message if isinstance(message, dict) else {}
