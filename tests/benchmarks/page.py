"""What a browser page says to the server and hears from it, without a browser: viser 1.1.1's messages by hand."""

from __future__ import annotations

import asyncio
import json
import re
import struct
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from time import perf_counter
from typing import Any

import msgspec
import numpy as np
import viser
import zstandard
from numpy.typing import ArrayLike
from websockets.asyncio.client import ClientConnection, connect
from websockets.typing import Origin, Subprotocol

from helicoide.view.channel import PATH

SEAT = re.compile(r'helicoideSeat = "([^"]+)"')
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


def single(position: ArrayLike) -> Point:
    """A point as it is after a journey in single precision, so that the sent and the shown one are the same."""
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
    """The points that a change of the scene carries: the position of a node, or a few vertices."""
    if message["type"] == "SetPositionMessage":
        yield single(message["position"])
    if message["type"] == "SceneNodeUpdateMessage":
        for value in message["updates"].values():
            if isinstance(value, dict) and value.get("dtype") == "<f4":
                vertices = np.frombuffer(arrays[value["__binary_index"]], "<f4")
                if len(vertices) <= SMALL:
                    yield from map(single, vertices.reshape(-1, 3))


class Page:
    """One connected client; `shown` is called with the time and each point that a scene message carries."""

    def __init__(self, socket: ClientConnection, port: int) -> None:
        self.socket, self.port = socket, port
        loop = asyncio.get_running_loop()
        self.owner: asyncio.Future[str] = loop.create_future()
        self.seat: asyncio.Future[str] = loop.create_future()
        self.shown: Callable[[float, Point], None] = lambda when, point: None

    async def say(self, kind: str, **fields: object) -> None:
        await self.socket.send(msgspec.msgpack.encode({"type": kind, **fields}))

    async def gizmo(self, event: str, **pose: Point) -> None:
        """An event of the target's gizmo: Update, DragStart or DragEnd."""
        await self.say(f"TransformControls{event}Message", name="/target", owner=await self.owner, **pose)

    async def listen(self) -> None:
        async for frame in self.socket:
            when = perf_counter()
            assert isinstance(frame, bytes)
            for message, arrays in _messages(frame):
                for point in _points(message, arrays):
                    self.shown(when, point)
                await self._answer(message)

    async def _answer(self, message: Message) -> None:
        match message["type"]:
            case "LocalStorageGetItemRequestMessage":
                uuid = message["request_uuid"]
                await self.say("LocalStorageGetItemResponseMessage", value=None, error=None, request_uuid=uuid)
            case "TransformControlsMessage" if message["name"] == "/target" and not self.owner.done():
                self.owner.set_result(message["owner"])
            case "RunJavascriptMessage" if found := SEAT.search(message["source"]):
                self.seat.set_result(found[1])

    async def ready(self) -> None:
        """Wait until the status line says that all is well: every kernel is there, and the arm runs."""
        address = f"ws://127.0.0.1:{self.port}{PATH}"
        async with asyncio.timeout(PATIENCE), connect(address, origin=_origin(self.port)) as control:
            await control.send(json.dumps({"seat": await self.seat}))
            async for notice in control:
                if json.loads(notice)["tone"] == "ok":
                    return


def _origin(port: int) -> Origin:
    return Origin(f"http://127.0.0.1:{port}")


@asynccontextmanager
async def opened(port: int) -> AsyncIterator[Page]:
    """A page on a port, listening while it is open."""
    async with connect(
        f"ws://127.0.0.1:{port}/",
        origin=_origin(port),
        subprotocols=[Subprotocol(f"viser-v{viser.__version__}")],
        compression=None,
        max_size=None,
    ) as socket:
        page = Page(socket, port)
        await socket.send(msgspec.msgpack.encode(CAMERA))
        listening = asyncio.create_task(page.listen())
        try:
            yield page
        finally:
            listening.cancel()
