"""The control channel: stop always gets through, words arrive once, nonsense changes nothing."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future

import pytest
import viser
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from websockets.exceptions import ConnectionClosedError
from websockets.sync.client import connect
from websockets.sync.connection import Connection
from websockets.typing import Origin

from helicoide.text import Text
from helicoide.view.channel import PATH, Control, Notice
from helicoide.view.serve import CHANNEL_BYTES, serve

FREE = Notice("pt_BR", Text(en="Free to move", pt_BR="Livre para mover"), "ok")
HELD = Notice("en", Text(en="Stopped", pt_BR="Parado"), "stopped")

Post = Callable[..., None]


@pytest.fixture(scope="module")
def stops() -> list[str]:
    return []


@pytest.fixture(scope="module")
def control(stops: list[str]) -> Control:
    return Control(on_stop=lambda: stops.append(threading.current_thread().name))


@pytest.fixture(scope="module")
def server(control: Control, tmp_path_factory: pytest.TempPathFactory) -> Iterator[viser.ViserServer]:
    served = serve("127.0.0.1", 0, tmp_path_factory.mktemp("static"), {PATH: control.serve})
    yield served
    served.stop()


@pytest.fixture
def post(server: viser.ViserServer) -> Post:
    """Run a call on the server's loop and wait for it."""

    def run(call: Callable[..., object], *args: object) -> None:
        done: Future[object] = Future()
        server.get_event_loop().call_soon_threadsafe(lambda: done.set_result(call(*args)))
        done.result(5)

    return run


@pytest.fixture
def page(server: viser.ViserServer) -> Iterator[Connection]:
    with open_page(server) as opened:
        yield opened


def open_page(server: viser.ViserServer) -> Connection:
    port = server.get_port()
    return connect(f"ws://127.0.0.1:{port}{PATH}", origin=Origin(f"http://127.0.0.1:{port}"), close_timeout=1)


def beat(page: Connection) -> None:
    """Wait until all that was sent before has been read; fails when anything else was answered."""
    page.send('{"beat": true}')
    assert json.loads(page.recv(5)) == {"heard": "beat"}


def test_stop_is_called_and_acknowledged(page: Connection, stops: list[str]) -> None:
    before = len(stops)
    page.send('{"stop": true, "unknown": 1}')
    assert json.loads(page.recv(5)) == {"heard": "stop"}
    assert len(stops) == before + 1


@pytest.mark.parametrize(
    "message",
    [
        "",
        "{",
        "stop",
        "[true]",
        "null",
        "[" * CHANNEL_BYTES,
        '{"stop": "true"}',
        '{"stop": 1}',
        '{"stop": false}',
        '{"Stop": true}',
        '{"seat": 7}',
        '{"beat": 1}',
        '{"released": 1}',
        b"\xff\x00",
        b"",
    ],
)
def test_malformed_messages_are_ignored(page: Connection, stops: list[str], message: str | bytes) -> None:
    before = len(stops)
    page.send(message)
    beat(page)
    assert len(stops) == before


@settings(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(st.one_of(st.text(max_size=500), st.binary(max_size=500)))
def test_no_message_costs_the_page_its_stop(page: Connection, message: str | bytes) -> None:
    page.send(message)
    beat(page)


def test_a_released_pointer_is_told_with_its_seat(server: viser.ViserServer, control: Control) -> None:
    told: list[str] = []
    control.on_release = told.append
    with open_page(server) as page:
        page.send('{"released": true}')
        page.send('{"seat": "a"}')
        page.send('{"released": true}')
        beat(page)
    assert told == ["a"]


def test_an_oversized_message_closes_the_connection(page: Connection, stops: list[str]) -> None:
    before = len(stops)
    page.send(json.dumps({"stop": True, "padding": "x" * CHANNEL_BYTES}))
    with pytest.raises(ConnectionClosedError) as closed:
        page.recv(5)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1009
    assert len(stops) == before


def test_words_arrive_once_and_only_at_their_seat(
    server: viser.ViserServer, page: Connection, control: Control, post: Post
) -> None:
    with open_page(server) as other:
        page.send('{"seat": "a"}')
        other.send('{"seat": "b"}')
        beat(page)
        beat(other)
        post(control.push, "a", FREE)
        assert json.loads(page.recv(5)) == {"language": "pt_BR", "status": "Livre para mover", "tone": "ok"}
        post(control.push, "a", FREE)
        beat(page)
        post(control.push, "a", HELD)
        assert json.loads(page.recv(5)) == {"language": "en", "status": "Stopped", "tone": "stopped"}
        beat(other)


def test_words_wait_for_a_page_that_comes_later(page: Connection, control: Control, post: Post) -> None:
    post(control.push, "late", HELD)
    page.send('{"seat": "late"}')
    assert json.loads(page.recv(5))["status"] == "Stopped"
    post(control.forget, "late")
    page.send('{"seat": "late"}')
    beat(page)


def test_pages_that_left_are_forgotten(server: viser.ViserServer, control: Control, post: Post) -> None:
    with open_page(server) as page:
        page.send('{"seat": "gone"}')
        beat(page)
        assert "gone" in control._seats.values()
    with open_page(server) as page:
        beat(page)
    post(control.push, "gone", FREE)
    assert "gone" not in control._seats.values()
