"""A page without a browser: it exchanges the messages of viser 1.1.1 and of our script with the server."""

from __future__ import annotations

import asyncio
import json
import re
import struct
from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
from contextlib import asynccontextmanager, suppress
from threading import Thread
from time import perf_counter
from typing import Any, TypeVar

import msgspec
import numpy as np
import viser
import zstandard
from numpy.typing import ArrayLike
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed
from websockets.typing import Origin, Subprotocol

from helicoide.view.channel import PATH

WINDOW = re.compile(r'helicoideWindow = "([^"]+)"')
CAMERA = {
    "type": "ViewerCameraMessage",
    "wxyz": (1.0, 0.0, 0.0, 0.0),
    "position": (1.3, -0.95, 0.8),
    "fov": 1.2,
    "near": 0.01,
    "far": 1000.0,
    "image_height": 800,
    "image_width": 1280,
    "look_at": (0.42, 0.0, 0.27),
    "up_direction": (0.0, 0.0, 1.0),
}
SMALL = 64
PATIENCE = 120.0

Point = tuple[float, ...]
Message = dict[str, Any]
Result = TypeVar("Result")


def single(position: ArrayLike) -> Point:
    """A point rounded to single precision, so that sent and received points are equal."""
    return tuple(np.asarray(position, np.float32).tolist())


def _messages(frame: bytes) -> Iterator[tuple[Message, list[bytes]]]:
    """The messages of one websocket frame, and the arrays that follow them."""
    size, packed = struct.unpack_from("<QQ", frame)
    head = msgspec.msgpack.decode(
        zstandard.ZstdDecompressor().decompress(frame[16 : 16 + packed], max_output_size=size)
    )
    arrays, place = [], 16 + packed
    for length in head["binaryBufferLengths"]:
        place += -place % 8
        arrays.append(frame[place : place + length])
        place += length
    for message in head["messages"]:
        yield message, arrays


def _points(message: Message, arrays: list[bytes]) -> Iterator[Point]:
    """The points in a message of the scene: the position of a node, or a few vertices."""
    if message["type"] == "SetPositionMessage":
        yield single(message["position"])
    if message["type"] == "SceneNodeUpdateMessage":
        for value in message["updates"].values():
            if isinstance(value, dict) and value.get("dtype") == "<f4":
                vertices = np.frombuffer(arrays[value["__binary_index"]], "<f4")
                if len(vertices) <= SMALL:
                    yield from map(single, vertices.reshape(-1, 3))


class Page:
    """One connected page, which acts as viser's client and our script, and can send any message.

    shown: called with the time, s, and each point in a scene message; heard: called with each message of viser; made:
    the controls by their first label; labels: the current label of each control; frames: number of frames of messages
    received; notice: the last notice of the status line; told: the notifications of this page alone.
    """

    def __init__(self, socket: ClientConnection, port: int, ahead: float = 0.0) -> None:
        self.socket, self.port, self.ahead = socket, port, ahead
        loop = asyncio.get_running_loop()
        self.owner: asyncio.Future[str] = loop.create_future()
        self.window: asyncio.Future[str] = loop.create_future()
        self.control: asyncio.Future[ClientConnection] = loop.create_future()
        self.may_drive = asyncio.Event()
        self.stop_heard = asyncio.Event()
        self.passes = True
        self.seat: str | None = None
        self.notice: Message = {}
        self.made: dict[str, Message] = {}
        self.labels: dict[str, str] = {}
        self.told: list[str] = []
        self.frames = 0
        self.offset, self.old = float("-inf"), 0.0  # ms; old: age of the actions that it sends
        self.shown: Callable[[float, Point], None] = lambda when, point: None
        self.heard: Callable[[Message], None] = lambda message: None

    @property
    def now(self) -> float:
        """The page's clock, ms, which is not synchronized."""
        return 1000 * (perf_counter() + self.ahead)

    async def hang_up(self) -> None:
        """Close the control channel."""
        await (await self.control).close()

    async def send(self, message: Message) -> None:
        """Send a message without the time at which it was made, unlike our page."""
        await self.socket.send(msgspec.msgpack.encode(message))

    async def say(self, kind: str, **fields: object) -> None:
        """Send a user action, with the time at which it was made."""
        await self.send({"type": "HelicoideMadeAt", "at": self.now + self.offset - self.old})
        await self.send({"type": kind, **fields})

    async def gizmo(self, event: str, name: str = "/target", **pose: object) -> None:
        """An event of a gizmo: Update, DragStart or DragEnd."""
        await self.say(f"TransformControls{event}Message", name=name, owner=await self.owner, **pose)

    async def give(self, label: str, value: object) -> None:
        """Set the value of a control, as soon as the page has the control."""
        while label not in self.made:
            await asyncio.sleep(0.01)
        await self.say("GuiUpdateMessage", uuid=self.made[label]["uuid"], updates={"value": value})

    async def press(self, label: str) -> None:
        """Press a button, as soon as it has this label."""
        while (uuid := next((uuid for uuid, said in self.labels.items() if said == label), None)) is None:
            await asyncio.sleep(0.01)
        await self.say("GuiUpdateMessage", uuid=uuid, updates={"value": True})

    async def stop(self) -> float:
        """Press Stop; returns the time until the server has confirmed it, s."""
        began = perf_counter()
        self.stop_heard.clear()
        await self.tell(stop=True)
        await self.stop_heard.wait()
        return perf_counter() - began

    async def tell(self, **message: object) -> None:
        """Send a message on the control channel."""
        await (await self.control).send(json.dumps(message))

    async def listen(self) -> None:
        with suppress(ConnectionClosed):  # viser closes the connection after an invalid message
            async for frame in self.socket:
                when = perf_counter()
                assert isinstance(frame, bytes)
                for message, arrays in _messages(frame):
                    self.heard(message)
                    for point in _points(message, arrays):
                        self.shown(when, point)
                    await self._answer(message)
                self.frames += 1

    async def _answer(self, message: Message) -> None:
        match message["type"]:
            case "TransformControlsMessage" if not self.owner.done():
                self.owner.set_result(message["owner"])
            case "RunJavascriptMessage" if found := WINDOW.search(message["source"]):
                self.window.set_result(found[1])
            case kind if kind.startswith("Gui") and "label" in message.get("props", {}):
                self.made[message["props"]["label"]] = message
                self.labels[message["uuid"]] = message["props"]["label"]
            case "NotificationShowMessage":
                self.told.append(message["props"]["body"])
            case "GuiUpdateMessage" if "label" in message["updates"]:
                self.labels[message["uuid"]] = message["updates"]["label"]

    async def drive(self, languages: tuple[str, ...] = ()) -> None:
        """Serve the control channel, as our script does."""
        key = await self.window
        address = f"ws://127.0.0.1:{self.port}{PATH}"
        async with connect(address, origin=_origin(self.port)) as control:
            self.control.set_result(control)
            await self.tell(beat=True)
            await self.tell(window=key, seat=self.seat, languages=languages)
            beating = asyncio.create_task(self._beat())
            try:
                async for raw in control:
                    await self._hear(json.loads(raw))
            finally:
                beating.cancel()

    async def _beat(self) -> None:
        """Ask for the server's clock repeatedly, since a slow answer gives a wrong offset."""
        with suppress(ConnectionClosed):
            while True:
                await asyncio.sleep(0.5)
                await self.tell(beat=True)

    async def _hear(self, message: Message) -> None:
        if "at" in message:
            self.offset = max(self.offset, message["at"] - self.now)
        if message.get("heard") == "stop":
            self.stop_heard.set()
        if "fence" in message and self.passes:
            await self.send({"type": "HelicoideFence", "number": message["fence"]})
            self.may_drive.set()
        self.seat = message.get("seat", self.seat)
        if "tone" in message:
            self.notice = message

    async def ready(self) -> None:
        """Wait until the tone of the status line is ok: the kernels are compiled, and the arm is advanced."""
        async with asyncio.timeout(PATIENCE):
            while self.notice.get("tone") != "ok":
                await asyncio.sleep(0.01)


def _origin(port: int) -> Origin:
    return Origin(f"http://127.0.0.1:{port}")


@asynccontextmanager
async def opened(
    port: int, seat: str | None = None, languages: tuple[str, ...] = (), ahead: float = 0.0, silent: bool = False
) -> AsyncIterator[Page]:
    """An open page on a port. silent: it opens no control channel, as if our script were missing."""
    async with connect(
        f"ws://127.0.0.1:{port}/",
        origin=_origin(port),
        subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
        compression=None,
        max_size=None,
    ) as socket:
        page = Page(socket, port, ahead)
        page.seat = seat
        await page.send(CAMERA)
        working = [page.listen()] if silent else [page.listen(), page.drive(languages)]
        tasks = [asyncio.create_task(work) for work in working]
        try:
            yield page
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)


class Hand:
    """A page with blocking calls, for tests that are not coroutines."""

    def __init__(self, port: int, **options: Any) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = Thread(target=self._loop.run_forever, daemon=True)
        self._thread.start()
        self._open = opened(port, **options)
        self.page = self.do(self._open.__aenter__())

    def do(self, work: Coroutine[Any, Any, Result]) -> Result:
        """Run a coroutine of the page, and wait for its result."""
        return asyncio.run_coroutine_threadsafe(work, self._loop).result(PATIENCE)

    def close(self) -> None:
        """Close the page."""
        self.do(self._open.__aexit__(None, None, None))
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()
