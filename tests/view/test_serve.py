"""The door, the page and the files, over real sockets on loopback."""

from __future__ import annotations

import contextlib
import gzip
import http.client
import inspect
import json
import logging
import queue
import socket
import struct
import time
from collections.abc import Callable, Iterator
from http.client import HTTPMessage
from pathlib import Path
from typing import NamedTuple

import pytest
import viser
import websockets.asyncio.server
from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosedError, InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin, Subprotocol

from helicoide.text import LANGUAGES, HelicoideError, Language
from helicoide.view import serve as door
from helicoide.view.page import POLICY
from helicoide.view.serve import serve

STATIC = Path(__file__).parents[2] / "static"


class Answer(NamedTuple):
    status: int
    headers: HTTPMessage
    body: bytes


async def echo(connection: ServerConnection) -> None:
    async for message in connection:
        await connection.send(message)


async def broken(connection: ServerConnection) -> None:
    raise ValueError("a mistake of ours")


async def unplugged(connection: ServerConnection) -> None:
    raise ConnectionResetError("the robot's wire")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    (folder / "secret.txt").write_text("outside")
    (folder / "static" / "pages" / "pt_BR").mkdir(parents=True)
    (folder / "static" / "pages" / "pt_BR" / "página.html").write_text("<p>olá</p>", "utf-8")
    for file in filter(Path.is_file, STATIC.iterdir()):
        (folder / "static" / file.name).write_bytes(file.read_bytes())
    return folder / "static"


@pytest.fixture(scope="module")
def server(site: Path) -> Iterator[viser.ViserServer]:
    served = serve("127.0.0.1", 0, site, {"/echo": echo, "/broken": broken, "/unplugged": unplugged})
    yield served
    served.stop()


@pytest.fixture
def port(server: viser.ViserServer) -> int:
    return server.get_port()


def get(port: int, path: str, **headers: str) -> Answer:
    with contextlib.closing(http.client.HTTPConnection("127.0.0.1", port, timeout=5)) as client:
        client.request("GET", path, headers={name.replace("_", "-"): value for name, value in headers.items()})
        response = client.getresponse()
        return Answer(response.status, response.headers, response.read())


def handshake_status(port: int, path: str, origin: str | None, **headers: str) -> int:
    """Open a socket as a page of that origin would: 101, or the status with which it is refused."""
    given = None if origin is None else Origin(origin)
    try:
        with connect(f"ws://127.0.0.1:{port}{path}", origin=given, additional_headers=headers, close_timeout=1):
            return 101
    except InvalidStatus as refusal:
        return refusal.response.status_code


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost"])
def test_a_page_of_this_host_gets_viser_and_the_channels(port: int, name: str) -> None:
    origin, protocol = Origin(f"http://{name}:{port}"), Subprotocol(f"viser-v{viser.__version__}")
    with connect(f"ws://{name}:{port}/", origin=origin, subprotocols=[protocol], close_timeout=1) as page:
        assert page.subprotocol == protocol
    with connect(f"ws://{name}:{port}/echo?a=b", origin=origin, close_timeout=1) as page:
        page.send("hello")
        assert page.recv(5) == "hello"


@pytest.mark.parametrize("path", ["/", "/echo"])
@pytest.mark.parametrize(
    "origin", [None, "null", "http://foreign.invalid", "http://127.0.0.1:1", "http://localhost:{}"]
)
def test_a_page_of_another_origin_is_refused(port: int, path: str, origin: str | None) -> None:
    assert handshake_status(port, path, origin and origin.format(port)) == 403


def test_an_unknown_channel_is_not_found(port: int) -> None:
    assert handshake_status(port, "/nothing", f"http://127.0.0.1:{port}") == 404


@pytest.mark.parametrize("host", ["foreign.invalid", "127.0.0.1", "127.0.0.1:1", "foreign.invalid:{}", ""])
def test_a_host_that_is_not_ours_is_misdirected(port: int, host: str) -> None:
    answer = get(port, "/", Host=host.format(port))
    assert answer.status == 421
    assert f"http://127.0.0.1:{port}/".encode() in answer.body


def test_a_rebound_name_gets_no_socket(port: int) -> None:
    with socket.create_connection(("127.0.0.1", port), timeout=5) as page:
        page.sendall(
            f"GET / HTTP/1.1\r\nHost: evil.invalid:{port}\r\nOrigin: http://evil.invalid:{port}\r\n"
            "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
            "Sec-WebSocket-Key: aGVsaWNvaWRlIGRvb3IhIQ==\r\n\r\n".encode()
        )
        assert page.recv(64).startswith(b"HTTP/1.1 421 ")


def test_the_page_is_visers_with_our_tags_and_policy(port: int) -> None:
    answer = get(port, "/?fixedDpr=1")
    head, _, rest = gzip.decompress(answer.body).decode().partition("</head>")
    assert answer.headers["Content-Security-Policy"] == POLICY
    assert "<title>Helicoide</title>" in head
    assert '<link rel="stylesheet" href="static/helicoide.css" />' in head
    assert '<script src="static/helicoide.js" data-words="' in head
    assert "Stop motion" in head
    assert "Parar o movimento" in head
    assert '<div id="root">' in rest


@pytest.mark.parametrize("query", ["websocket=ws://foreign.invalid", "a=1&websocket", "%77ebsocket=x"])
def test_a_link_cannot_name_another_server(port: int, query: str) -> None:
    answer = get(port, f"/?{query}")
    assert (answer.status, answer.headers["Location"]) == (302, "./")


def test_healthz_is_ok(port: int) -> None:
    assert get(port, "/healthz")[::2] == (200, b"ok")


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_of_the_sources_is_served_in_each_language(port: int, language: Language) -> None:
    status, headers, body = get(port, f"/pages/{language}/sources")
    assert (status, headers["Content-Type"]) == (200, "text/html; charset=utf-8")
    assert b'id="vargas-2013"' in body
    assert b"static/page.css" in body


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_about_notebooks_is_served_as_a_page_and_as_a_notebook(port: int, language: Language) -> None:
    page = get(port, f"/pages/{language}/notebook")
    assert (page.status, page.headers["Content-Type"]) == (200, "text/html; charset=utf-8")
    assert b"import helicoide" in page.body
    assert b'href="notebook.ipynb"' in page.body
    file = get(port, f"/pages/{language}/notebook.ipynb")
    assert (file.status, file.headers["Content-Disposition"]) == (200, "attachment")
    assert json.loads(file.body)["nbformat"] == 4


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("helicoide.css", "text/css; charset=utf-8"),
        ("helicoide.js", "text/javascript; charset=utf-8"),
        ("stix-two-math.woff2", "font/woff2"),
        ("stix-two-math.LICENSE.txt", "text/plain; charset=utf-8"),
        ("pages/pt_BR/p%C3%A1gina.html", "text/html; charset=utf-8"),
    ],
)
def test_static_files_are_served_and_revalidated(port: int, name: str, kind: str) -> None:
    answer = get(port, f"/static/{name}?v=1")
    assert (answer.status, answer.headers["Content-Type"]) == (200, kind)
    assert answer.body
    again = get(port, f"/static/{name}", If_None_Match=answer.headers["ETag"])
    assert again[::2] == (304, b"")


@pytest.mark.parametrize(
    "path",
    [
        "/static/../secret.txt",
        "/static/%2e%2e/secret.txt",
        "/static/..%2fsecret.txt",
        "/static/..\\secret.txt",
        "/static//etc/passwd",
        "/static/%00",
        "/static/",
        "/static/pages",
        "/secret.txt",
        "/index.html",
        "//",
        "/..",
    ],
)
def test_nothing_outside_the_static_folder_is_found(port: int, path: str) -> None:
    assert get(port, path).status == 404


def test_a_taken_port_is_an_error_and_not_another_port(port: int, site: Path) -> None:
    with pytest.raises(HelicoideError) as error:
        serve("127.0.0.1", port, site, {})
    for sentence in (error.value.text.en, error.value.text.pt_BR):
        assert str(port) in sentence
        assert "--port" in sentence


@pytest.mark.parametrize(
    ("host", "port", "said"),
    [
        ("127.0.0.1", 70000, "no port 70000"),
        ("127.0.0.1", -1, "no port -1"),
        ("no.such.name.invalid", 0, "port 0: there is no host of that name"),
        ("a" * 300, 0, "port 0: there is no host of that name"),
        ("203.0.113.1", 0, "port 0: this machine has no such address"),
    ],
)
def test_an_impossible_address_is_an_error(site: Path, host: str, port: int, said: str) -> None:
    with pytest.raises(HelicoideError, match=said) as refused:
        serve(host, port, site, {})
    assert "porta" in refused.value.text.pt_BR


def test_an_address_in_brackets_that_is_none_is_no_origin(site: Path) -> None:
    with pytest.raises(HelicoideError, match=r"http://\[lab is no origin"):
        serve("127.0.0.1", 0, site, {}, ["http://[lab"])


def test_the_port_is_ours_whatever_visers_environment_says(
    site: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("_VISER_PORT_OVERRIDE", "1")
    served = serve("127.0.0.1", 0, site, {})
    try:
        assert get(served.get_port(), "/healthz").status == 200
        assert capsys.readouterr().out == ""
    finally:
        served.stop()


def test_the_wrap_is_undone(server: viser.ViserServer) -> None:
    assert inspect.isclass(websockets.asyncio.server.serve)


def test_a_viser_that_escapes_the_checks_is_refused(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(door, "_door", lambda *_: lambda *_: None)
    with pytest.raises(HelicoideError, match=r"install viser 1\.1\.1"):
        serve("127.0.0.1", 0, site, {})


REQUEST = "GET {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n"
UPGRADE = (
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: aGVsaWNvaWRlIGRvb3IhIQ==\r\nOrigin: http://127.0.0.1:{}\r\n\r\n"
)
TLS_HELLO = bytes.fromhex("16030100c8010000c40303") + bytes(range(194))
MESSAGE = b"\x81\x85\x00\x00\x00\x00hello"


def closes(page: socket.socket) -> None:
    page.close()


def says_no_more(page: socket.socket) -> None:
    page.shutdown(socket.SHUT_WR)
    while page.recv(4096):
        pass
    page.close()


def resets(page: socket.socket) -> None:
    page.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    page.close()


def resets_later(page: socket.socket) -> None:
    page.recv(4096)
    resets(page)


@pytest.fixture
def logged(monkeypatch: pytest.MonkeyPatch) -> queue.Queue[logging.LogRecord]:
    """The errors that websockets has told, whether they were dropped or not."""
    found: queue.Queue[logging.LogRecord] = queue.Queue()
    logger = logging.getLogger("websockets.server")
    handle = logger.handle

    def heard(record: logging.LogRecord) -> None:
        handle(record)
        if record.levelno >= logging.ERROR:
            found.put(record)

    monkeypatch.setattr(logger, "handle", heard)
    return found


@pytest.mark.parametrize(
    ("said", "leaves"),
    [
        (b"", closes),
        (b"", resets),
        (b"GET / HT", closes),
        (b"GET / HTTP/1.1\r\nHost: there", resets),
        (b"\x00\xff no http at all\r\n\r\n", says_no_more),
        (b"GET / HTTP/1.1\r\nno header\r\n\r\n", closes),
        (b"POST / HTTP/1.1\r\n\r\n", closes),
        (TLS_HELLO, closes),
        (TLS_HELLO, resets),
        (f"{REQUEST}\r\n", closes),
        (REQUEST + UPGRADE, closes),
        (REQUEST + UPGRADE, resets_later),
        (REQUEST + UPGRADE, says_no_more),
    ],
)
def test_who_talks_nonsense_or_leaves_is_no_news(
    port: int,
    logged: queue.Queue[logging.LogRecord],
    caplog: pytest.LogCaptureFixture,
    said: bytes | str,
    leaves: Callable[[socket.socket], None],
) -> None:
    words = said if isinstance(said, bytes) else said.format("/echo", port, port).encode()
    while logged.empty():  # who leaves may have had the answer before
        page = socket.create_connection(("127.0.0.1", port), timeout=30)
        page.sendall(words)
        leaves(page)
        time.sleep(0.01)
    assert logged.get().exc_info is not None
    assert caplog.records == []


def test_who_leaves_in_the_middle_of_a_channel_is_no_news(
    port: int, logged: queue.Queue[logging.LogRecord], caplog: pytest.LogCaptureFixture
) -> None:
    page = socket.create_connection(("127.0.0.1", port), timeout=30)
    page.sendall((REQUEST + UPGRADE).format("/echo", port, port).encode() + 500 * MESSAGE)
    resets_later(page)
    assert logged.get(timeout=30).getMessage() == "connection handler failed"
    assert caplog.records == []


@pytest.mark.parametrize("path", ["/broken", "/unplugged"])
def test_errors_of_our_own_are_news(port: int, caplog: pytest.LogCaptureFixture, path: str) -> None:
    with (
        connect(f"ws://127.0.0.1:{port}{path}", origin=Origin(f"http://127.0.0.1:{port}")) as page,
        pytest.raises(ConnectionClosedError),
    ):
        page.recv(30)
    assert [record.getMessage() for record in caplog.records] == ["connection handler failed"]


def test_an_error_of_the_door_is_news(
    port: int, logged: queue.Queue[logging.LogRecord], caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(request: object) -> str:
        raise OSError("no such file")

    monkeypatch.setattr(door, "_path", fails)
    assert handshake_status(port, "/echo", f"http://127.0.0.1:{port}") == 500
    logged.get(timeout=30)
    assert [record.getMessage() for record in caplog.records] == ["opening handshake failed"]
