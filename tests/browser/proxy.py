"""A proxy that serves the lab under a sub-path, as the server of an institution may do."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from threading import Thread

PREFIX = b"/lab/one"


async def _pass_on(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    with suppress(ConnectionError):
        while data := await reader.read(1 << 16):
            writer.write(data)
            await writer.drain()
    writer.close()


@contextmanager
def behind(port: int) -> Iterator[int]:
    """Serve a port under PREFIX on another port, whose number it gives. The Host header is passed on unchanged."""

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with suppress(ConnectionError, asyncio.IncompleteReadError):
            method, path, version = (await reader.readuntil(b"\r\n")).split(b" ", 2)
            beyond, lab = await asyncio.open_connection("127.0.0.1", port)
            lab.write(b" ".join((method, b"/" + path.removeprefix(PREFIX).removeprefix(b"/"), version)))
            await asyncio.gather(_pass_on(reader, lab), _pass_on(beyond, writer))

    loop = asyncio.new_event_loop()
    thread = Thread(target=loop.run_forever, daemon=True)
    thread.start()
    server = asyncio.run_coroutine_threadsafe(asyncio.start_server(serve, "127.0.0.1", 0), loop).result(10)
    try:
        yield server.sockets[0].getsockname()[1]
    finally:
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
