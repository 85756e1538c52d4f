"""Start viser's server with our own checks of connections, our answers to GET, and our channels beside viser's."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import http.client
import io
import socket
import threading
from collections.abc import Awaitable, Callable, Collection, Iterator, Mapping
from http import HTTPStatus
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import viser
import websockets.asyncio.server
from viser._messages import ShareUrlRequest
from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

from helicoide.files.os_errors import NO_HOST, os_error_reason
from helicoide.text import HelicoideError, Text
from helicoide.view.limits import slowed
from helicoide.view.news import tell_once
from helicoide.view.page import reply, site

Channel = Callable[[ServerConnection], Awaitable[None]]

Door = Callable[[ServerConnection, Request], Response | None]

CHANNEL_BYTES = 65536  # the longest message a page may send on a channel; a link of `share.LONGEST_LINK` fits
PAGE_BYTES = 1 << 20  # and on viser's own socket, which takes files in parts of half that size
CHANNEL_RATE, PAGE_RATE = 50.0, 500.0  # messages read per second; further ones wait

TAKEN = Text(
    en="Port {port} of {host} is already taken: choose another with --port.",
    pt_BR="A porta {port} de {host} já está em uso: escolha outra com --port.",
)
NO_PORT = Text(
    en="There is no port {port}: choose one from 1024 to 65535 with --port.",
    pt_BR="A porta {port} não existe: escolha uma de 1024 a 65535 com --port.",
)
RESERVED = Text(
    en="Port {port} of {host} is reserved for administrators: choose one from 1024 to 65535 with --port.",
    pt_BR="A porta {port} de {host} é reservada a administradores: escolha uma de 1024 a 65535 com --port.",
)
CLOSED = Text(
    en="Cannot serve on {host}, port {port}: {reason}. Choose an address of this machine with --host, such as "
    "127.0.0.1, and a free port with --port.",
    pt_BR="Não dá para servir em {host}, porta {port}: {reason}. Escolha um endereço desta máquina com --host, como "
    "127.0.0.1, e uma porta livre com --port.",
)
NO_ORIGIN = Text(
    en="{address} is no origin: give scheme, host and port, such as --origin https://lab.example.org:8443.",
    pt_BR="{address} não é uma origem: dê esquema, host e porta, como em --origin https://lab.example.org:8443.",
)
UNKNOWN = Text(
    en="Helicoide does not know this page's address, {origin}. Open http://{name}/, or, behind a proxy or a tunnel, "
    "start it with --origin {origin}.",
    pt_BR="O Helicoide não conhece o endereço desta página, {origin}. Abra http://{name}/ ou, atrás de um proxy ou "
    "túnel, inicie-o com --origin {origin}.",
)
UNGUARDED = Text(
    en="viser {version} lets pages of other sites connect, past Helicoide's checks: install viser 1.1.1.",
    pt_BR="O viser {version} deixa páginas de outros sites conectarem sem passar pelas verificações do Helicoide: "
    "instale o viser 1.1.1.",
)


def serve(
    host: str,
    port: int,
    static: Path,
    channels: Mapping[str, Channel],
    origins: Collection[str] = (),
    framed: bool = False,
) -> viser.ViserServer:
    """Open viser on exactly this port (0: any free one), with our page, the static files and the channels by path.

    origins: further addresses under which the page is opened, such as that of a proxy; framed: whether notebooks on
    this computer may show the page in a frame.
    Raises HelicoideError if the port is not available, if an origin is not valid, or if viser serves in a way that our
    checks do not cover.
    """
    known = frozenset(map(_origin, origins))
    tell_once()
    listener = _listen(host, port)
    address, port = listener.getsockname()
    banner = io.StringIO()  # viser prints a banner even if not verbose
    with (
        _guarded(listener, _door(port, site(static, framed), channels, known), channels),
        contextlib.redirect_stdout(banner),
    ):
        server = viser.ViserServer(host=host, port=port, verbose=False)
    if not _refuses_foreign_pages(address, server.get_port()):
        server.stop()
        listener.close()
        raise HelicoideError(UNGUARDED.format(version=viser.__version__))
    _woken_once(server.get_event_loop())
    server._websock_server.unregister_handler(ShareUrlRequest)  # any page could ask for a tunnel to a public host
    set_theme(server.gui, dark=False)
    return server


def set_theme(gui: viser.GuiApi, dark: bool) -> None:
    """Show viser's panels and the background of the scene dark or light, without viser's own share button."""
    gui.configure_theme(show_share_button=False, control_width="large", dark_mode=dark)


def _woken_once(loop: asyncio.AbstractEventLoop) -> None:
    """Keep the loop from waking itself: viser makes it do so at every message, which switches threads each time."""
    from_elsewhere = loop.call_soon_threadsafe

    def call(*args: Any, **options: Any) -> asyncio.Handle:
        here = threading.get_ident() == getattr(loop, "_thread_id", None)
        return (loop.call_soon if here else from_elsewhere)(*args, **options)

    loop.call_soon_threadsafe = call  # type: ignore[method-assign, assignment]


def _listen(host: str, port: int) -> socket.socket:
    """Open the port here: viser would silently take the next free one, or the one in its environment variable."""
    if port not in range(65536):
        raise HelicoideError(NO_PORT.format(port=port))
    try:
        listener = socket.create_server((socket.gethostbyname(host), port))  # create_server hides the name error
    except OSError as error:
        text = {errno.EADDRINUSE: TAKEN, errno.EACCES: RESERVED}.get(error.errno or 0, CLOSED)
        raise HelicoideError(text.format(host=host, port=port, reason=os_error_reason(error))) from error
    except UnicodeError as error:  # a name that no host can have
        raise HelicoideError(CLOSED.format(host=host, port=port, reason=NO_HOST)) from error
    # asyncio sets this only for sockets with a named protocol; without it, small messages wait for acknowledgements
    listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return listener


def _origin(address: str) -> str:
    """The origin of an address, such as https://lab.example.org."""
    try:
        parts = urlsplit(address)
    except ValueError as error:  # brackets that hold no IPv6 address
        raise HelicoideError(NO_ORIGIN.format(address=address)) from error
    if parts.scheme not in ("http", "https") or not parts.netloc or parts.path.strip("/") or parts.query:
        raise HelicoideError(NO_ORIGIN.format(address=address))
    return f"{parts.scheme}://{parts.netloc}"


def _door(
    port: int, answer: Callable[[Request], Response], channels: Mapping[str, Channel], origins: Collection[str]
) -> Door:
    """The check of each request: a page of this host gets its socket, a GET its answer, anything else a refusal.

    Unknown host names are refused, since a foreign name may be made to point here (DNS rebinding).
    """
    beyond = {urlsplit(origin).netloc for origin in origins}

    def check(connection: ServerConnection, request: Request) -> Response | None:
        host = request.headers.get("Host", "")
        names = [f"{name}:{port}" for name in ("localhost", "127.0.0.1", connection.local_address[0])]
        if host not in names and host not in beyond:
            return reply(HTTPStatus.MISDIRECTED_REQUEST, _refusal(f"http://{host}", names[-1]))
        if "Upgrade" not in request.headers:
            return answer(request)
        origin = request.headers.get("Origin") or ""
        if origin not in origins and not (host in names and origin in (f"http://{host}", f"https://{host}")):
            return reply(HTTPStatus.FORBIDDEN, _refusal(origin, names[-1]))
        path = _path(request)
        connection.protocol.max_message_size = CHANNEL_BYTES if path in channels else PAGE_BYTES
        return None if path == "/" or path in channels else reply(HTTPStatus.NOT_FOUND, b"no such channel")

    return check


def _refusal(origin: str, name: str) -> bytes:
    """The answer to a page of an unknown origin, in both languages."""
    words = UNKNOWN.format(origin=origin or "?", name=name)
    return f"{words.en}\n\n{words.pt_BR}\n".encode(errors="replace")


@contextlib.contextmanager
def _guarded(listener: socket.socket, check: Door, channels: Mapping[str, Channel]) -> Iterator[None]:
    """Replace `websockets.asyncio.server.serve`, which viser calls once, while viser starts."""
    real = websockets.asyncio.server.serve

    def guarded(handler: Channel, *_: object, **options: Any) -> websockets.asyncio.server.serve:
        async def route(connection: ServerConnection) -> None:
            assert connection.request is not None
            channel = channels.get(_path(connection.request))
            slowed(connection, PAGE_RATE if channel is None else CHANNEL_RATE)
            await (channel or handler)(connection)

        return real(route, sock=listener, **{**options, "process_request": check})

    websockets.asyncio.server.serve = guarded  # type: ignore[assignment, misc]
    try:
        yield
    finally:
        websockets.asyncio.server.serve = real  # type: ignore[misc]


def _path(request: Request) -> str:
    return request.path.partition("?")[0]


def _refuses_foreign_pages(address: str, port: int) -> bool:
    """Whether a page of another site is refused, by trying it: a new viser might serve without our checks."""
    handshake = {
        "Connection": "Upgrade",
        "Upgrade": "websocket",
        "Sec-WebSocket-Version": "13",
        "Sec-WebSocket-Key": "aGVsaWNvaWRlIGRvb3IhIQ==",
        "Origin": "http://foreign.invalid",
    }
    reachable = "127.0.0.1" if address == "0.0.0.0" else address
    with contextlib.closing(http.client.HTTPConnection(reachable, port, timeout=5)) as page:
        page.request("GET", "/", headers=handshake)
        return page.getresponse().status == HTTPStatus.FORBIDDEN
