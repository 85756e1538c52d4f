"""The control channel: stop always gets through, words arrive once, nonsense changes nothing."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from time import monotonic
from typing import Any

import pytest
import viser
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.session.labs import eventually
from websockets.exceptions import ConnectionClosedError
from websockets.sync.client import connect
from websockets.sync.connection import Connection
from websockets.typing import Origin

from helicoide.text import Text
from helicoide.view.channel import PATH, ControlChannel, Hello, Notice
from helicoide.view.link import HelicoideFence, HelicoideMadeAt
from helicoide.view.serve import CHANNEL_BYTES, serve

FREE = Notice("pt_BR", Text(en="Free to move", pt_BR="Livre para mover"), "ok")
HELD = Notice("en", Text(en="Stopped", pt_BR="Parado"), "stopped")

Post = Callable[..., Any]


@pytest.fixture(scope="module")
def stops() -> list[str]:
    return []


@pytest.fixture(scope="module")
def control(stops: list[str]) -> ControlChannel:
    return ControlChannel(on_stop=lambda key, closing: stops.append(str(key)))


@pytest.fixture(scope="module")
def server(control: ControlChannel, tmp_path_factory: pytest.TempPathFactory) -> Iterator[viser.ViserServer]:
    served = serve("127.0.0.1", 0, tmp_path_factory.mktemp("static"), {PATH: control.serve})
    yield served
    served.stop()


@pytest.fixture
def post(server: viser.ViserServer) -> Post:
    """Run a call on the server's loop and wait for it."""

    def run(call: Callable[..., object], *args: object) -> object:
        done: Future[object] = Future()
        server.get_event_loop().call_soon_threadsafe(lambda: done.set_result(call(*args)))
        return done.result(5)

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
    answer = json.loads(page.recv(5))
    assert answer["heard"] == "beat"
    assert answer["at"] == pytest.approx(1000 * monotonic(), abs=60_000)


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
        '{"window": 7}',
        '{"window": "nobody"}',
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


def meet(page: Connection, key: str, **said: object) -> dict[str, object]:
    """Say which window a page is; returns the fence that it is told of first."""
    page.send(json.dumps({"window": key, **said}))
    told: dict[str, object] = json.loads(page.recv(5))
    assert set(told) == {"fence"}
    return told


def test_a_released_pointer_is_told_with_its_window(
    server: viser.ViserServer, control: ControlChannel, post: Post
) -> None:
    told: list[str] = []
    control.on_release = told.append
    post(control.open, "a")
    with open_page(server) as page:
        page.send('{"released": true}')
        meet(page, "a")
        page.send('{"released": true}')
        beat(page)
        assert told == ["a"]
    assert eventually(lambda: told == ["a", "a"]), "and so is the end of its last channel"


def test_a_stop_is_told_with_its_window(
    page: Connection, stops: list[str], control: ControlChannel, post: Post
) -> None:
    page.send('{"stop": true}')
    assert json.loads(page.recv(5)) == {"heard": "stop"}
    post(control.open, "a")
    meet(page, "a")
    page.send('{"stop": true}')
    assert json.loads(page.recv(5)) == {"heard": "stop"}
    assert stops[-2:] == ["None", "a"]


@pytest.mark.parametrize(
    ("said", "hello"),
    [
        ({}, Hello(None, None)),
        ({"seat": "s", "languages": ["pt-BR", "en"]}, Hello("s", "pt_BR")),
        ({"seat": 3, "languages": ["de", "en-GB", "pt"]}, Hello(None, "en")),
        ({"languages": [7, "de"]}, Hello(None, None)),
        ({"languages": "pt"}, Hello(None, None)),
        ({"link": "sheet=a", "address": "http://a/"}, Hello(None, None, False, "sheet=a", "http://a/")),
        ({"link": 1, "address": ["http://a/"]}, Hello(None, None)),
    ],
)
def test_a_page_says_its_seat_and_its_languages(
    page: Connection, control: ControlChannel, post: Post, said: dict[str, object], hello: Hello
) -> None:
    line = post(control.open, "hello")
    meet(page, "hello", **said)
    assert line.hello.result() == hello


def test_a_window_drives_only_when_its_page_has_passed_the_last_fence(
    server: viser.ViserServer, control: ControlChannel, post: Post
) -> None:
    line = post(control.open, "f")
    with open_page(server) as page:
        number = meet(page, "f")["fence"]
        assert isinstance(number, int)
        line.link.hear(HelicoideMadeAt(1000 * monotonic()))
        assert not line.link.has_control
        assert line.link.hear(HelicoideFence(number))
        assert line.link.has_control
        post(control.fence, "f")
        assert json.loads(page.recv(5)) == {"fence": number + 1}
        assert not line.link.hear(HelicoideFence(number))
        assert not line.link.has_control
        assert line.link.hear(HelicoideFence(number + 1))
        for at in (1000 * (monotonic() - 1.1), float("nan"), "now", None):
            line.link.hear(HelicoideMadeAt(at))  # type: ignore[arg-type]
            assert not line.link.has_control
        line.link.hear(HelicoideMadeAt(1000 * (monotonic() - 0.5)))
        assert line.link.has_control
    assert eventually(lambda: not line.link.has_control)


def test_who_says_too_much_waits_and_nobody_else(server: viser.ViserServer, page: Connection, stops: list[str]) -> None:
    with open_page(server) as loud:
        before = len(stops)
        for _ in range(2000):
            loud.send('{"stop": true}')
        beat(page)
        assert len(stops) - before < 200


def test_an_oversized_message_closes_the_connection(
    page: Connection, control: ControlChannel, post: Post, stops: list[str]
) -> None:
    post(control.open, "wordy")
    meet(page, "wordy")
    page.send(json.dumps({"stop": True, "padding": "x" * CHANNEL_BYTES}))
    with pytest.raises(ConnectionClosedError) as closed:
        page.recv(5)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1009
    assert "wordy" not in stops


def test_words_arrive_once_and_only_at_their_window(
    server: viser.ViserServer, page: Connection, control: ControlChannel, post: Post
) -> None:
    with open_page(server) as other:
        for key, one in (("a", page), ("b", other)):
            post(control.open, key)
            meet(one, key)
        post(control.push, "a", FREE)
        said = {
            "language": "pt_BR",
            "status": "Livre para mover",
            "tone": "ok",
            "everywhere": False,
            "projector": False,
            "transparent": False,
        }
        assert json.loads(page.recv(5)) == said | {"everywhere": False, "projector": False, "transparent": False}
        post(control.push, "a", FREE)
        beat(page)
        post(control.push, "a", HELD)
        said = {"language": "en", "status": "Stopped", "tone": "stopped"}
        assert json.loads(page.recv(5)) == said | {"everywhere": False, "projector": False, "transparent": False}
        beat(other)


def test_words_wait_for_a_page_that_comes_later(page: Connection, control: ControlChannel, post: Post) -> None:
    post(control.open, "late")
    post(control.push, "late", HELD)
    meet(page, "late")
    assert json.loads(page.recv(5))["status"] == "Stopped"
    post(control.close, "late")
    page.send('{"window": "late"}')
    beat(page)


def test_pages_that_left_are_forgotten(server: viser.ViserServer, control: ControlChannel, post: Post) -> None:
    line = post(control.open, "gone")
    with open_page(server) as page:
        meet(page, "gone")
        assert line.pages
    assert eventually(lambda: not line.pages)
    post(control.push, "gone", FREE)
