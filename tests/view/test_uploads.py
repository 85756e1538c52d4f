"""Files of a window, sent in viser's own wire format: what is taken, what is refused, and that memory returns."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import viser
from tests.view.test_forged_messages import Page, eventually

from helicoide.text import Text
from helicoide.view import bind, uploads
from helicoide.view.serve import serve
from helicoide.view.uploads import BROKEN, BUSY, MOST_BYTES, MOST_PARTS, STALLED, Uploads

STATIC = Path(__file__).parents[2] / "static"
PART = 512 * 1024


class Sender(Page):
    """A page that sends files, and keeps all that it hears."""

    def __init__(self, port: int) -> None:
        self.heard: list[dict[str, Any]] = []
        super().__init__(port)
        self.page.heard = self.heard.append
        assert eventually(lambda: {"Send", "Height"} <= set(self.made))

    def announce(self, transfer: object, size: object, parts: object, label: str = "Send", **other: object) -> None:
        start = {
            "source_component_uuid": self.made[label]["uuid"],
            "transfer_uuid": transfer,
            "filename": "cloud.xyz",
            "mime_type": "",
            "part_count": parts,
            "size_bytes": size,
        }
        self.send({"type": "FileTransferStartUpload", **start, **other})

    def part(self, transfer: str, index: object, content: object, label: str = "Send") -> None:
        of = {"source_component_uuid": self.made[label]["uuid"], "transfer_uuid": transfer}
        self.send({"type": "FileTransferPart", **of, "part_index": index, "content": content})

    def file(self, transfer: str, content: bytes) -> None:
        """Send a file as viser's page does."""
        parts = [content[i : i + PART] for i in range(0, len(content), PART)]
        self.announce(transfer, len(content), len(parts))
        for index, part in enumerate(parts):
            self.part(transfer, index, part)

    def is_free(self, transfer: str) -> bool:
        """Whether the page was told that this file is over, and to take its bar away."""
        acks = [m for m in self.heard if m["type"] == "FileTransferPartAck" and m["transfer_uuid"] == transfer]
        gone = [m["uuid"] for m in self.heard if m["type"] == "RemoveNotificationMessage"]
        return any(m["transferred_bytes"] == m["total_bytes"] for m in acks) and f"upload-{transfer}" in gone


class Desk:
    """The windows of a server, each with a button for files, and what came of them."""

    def __init__(self, server: viser.ViserServer) -> None:
        self.server = server
        self.taken: list[bytes] = []
        self.refused: list[Text] = []
        self.windows: dict[int, tuple[viser.ClientHandle, Uploads]] = {}
        server.on_client_connect(self.enter)
        server.on_client_disconnect(self.leave)

    async def enter(self, client: viser.ClientHandle) -> None:
        self.slider = client.gui.add_slider("Height", min=0.0, max=2.0, step=0.1, initial_value=1.0)
        self.button = client.gui.add_upload_button("Send")
        bind.on_upload(self.button, lambda name, content: self.taken.append(content))
        self.windows[client.client_id] = (client, Uploads(client, self.refused.append))

    async def leave(self, client: viser.ClientHandle) -> None:
        self.windows.pop(client.client_id)[1].close()

    @property
    def gui(self) -> viser.GuiApi:
        [(client, _)] = self.windows.values()
        return client.gui

    @property
    def on_the_way(self) -> dict[str, Any]:
        return dict(self.gui._current_file_upload_states)

    @property
    def holds_nothing(self) -> bool:
        """Whether no content is left of any file, neither gathered nor with the button."""
        return not self.on_the_way and not self.button.value.content


@pytest.fixture(scope="module")
def server() -> Iterator[viser.ViserServer]:
    server = serve("127.0.0.1", 0, STATIC, {})
    yield server
    server.stop()


@pytest.fixture(scope="module")
def windows(server: viser.ViserServer) -> Desk:
    return Desk(server)


@pytest.fixture
def desk(windows: Desk) -> Desk:
    windows.taken.clear()
    windows.refused.clear()
    return windows


@pytest.fixture
def page(server: viser.ViserServer, desk: Desk, caplog: pytest.LogCaptureFixture) -> Iterator[Sender]:
    page = Sender(server.get_port())
    yield page
    page.close()
    assert eventually(lambda: not desk.windows)
    assert caplog.records == []


def takes_another(desk: Desk, page: Sender) -> bool:
    """Whether the window still works: a good file arrives, and nothing of it stays."""
    before = len(desk.taken)
    page.file("good", b"1 2 3")
    return eventually(lambda: len(desk.taken) == before + 1) and eventually(lambda: desk.holds_nothing)


@pytest.mark.parametrize("size", [0, 1, PART, 3 * PART + 17])
def test_a_file_arrives_whole_and_is_let_go(desk: Desk, page: Sender, size: int) -> None:
    content = bytes(k % 251 for k in range(size))
    page.file("one", content)
    assert eventually(lambda: desk.taken == [content])
    assert eventually(lambda: desk.holds_nothing)
    assert eventually(lambda: page.is_free("one"))
    assert desk.refused == []
    assert takes_another(desk, page)


def test_parts_may_come_in_any_order(desk: Desk, page: Sender) -> None:
    page.announce("one", 6, 3)
    for index, content in ((2, b"c"), (0, b"aaa"), (1, b"bb")):
        page.part("one", index, content)
    assert eventually(lambda: desk.taken == [b"aaabbc"])
    assert eventually(lambda: desk.holds_nothing)


def test_a_file_that_is_too_big_is_refused_at_its_first_message(desk: Desk, page: Sender) -> None:
    page.announce("one", MOST_BYTES + 1, 123)
    page.part("one", 0, b"x" * PART)
    assert eventually(lambda: len(desk.refused) == 1)
    assert "64 MB" in desk.refused[0].en
    assert "64 MB" in desk.refused[0].pt_BR
    assert eventually(lambda: page.is_free("one"))
    assert desk.holds_nothing
    assert takes_another(desk, page)


def test_the_biggest_file_is_taken(desk: Desk, page: Sender) -> None:
    page.announce("one", MOST_BYTES, MOST_PARTS)
    assert eventually(lambda: "one" in desk.on_the_way)
    assert desk.refused == []


WRONG = [
    ("many parts", 10_000, MOST_PARTS + 1),
    ("no parts", 10, 0),
    ("parts of nothing", 0, 3),
    ("less than nothing", -1, 1),
    ("fewer parts than none", 10, -1),
]


@pytest.mark.parametrize(("size", "parts"), [wrong[1:] for wrong in WRONG], ids=[wrong[0] for wrong in WRONG])
def test_an_announcement_that_cannot_be_true_is_refused(desk: Desk, page: Sender, size: object, parts: object) -> None:
    page.announce("one", size, parts)
    assert eventually(lambda: desk.refused == [BROKEN])
    assert eventually(lambda: page.is_free("one"))
    assert takes_another(desk, page)


def test_one_file_at_a_time(desk: Desk, page: Sender) -> None:
    page.announce("one", 4, 2)
    page.part("one", 0, b"ab")
    page.announce("two", 4, 1)
    page.part("two", 0, b"wxyz")
    assert eventually(lambda: desk.refused == [BUSY])
    assert eventually(lambda: page.is_free("two"))
    assert list(desk.on_the_way) == ["one"]
    page.part("one", 1, b"cd")
    assert eventually(lambda: desk.taken == [b"abcd"])
    assert takes_another(desk, page)


@pytest.mark.parametrize(
    "parts",
    [
        [(0, b"abcde")],
        [(0, b"abc"), (1, b"de")],
        [(0, b"a"), (1, b"b")],
        [(0, b"ab"), (0, b"cd")],
        [(2, b"ab")],
        [(-1, b"ab")],
        [(0, "ab")],
        [(0, None)],
    ],
)
def test_what_was_not_announced_ends_the_file(desk: Desk, page: Sender, parts: list[tuple[object, object]]) -> None:
    page.announce("one", 4, 2)
    for part in parts:
        page.part("one", *part)
    assert eventually(lambda: desk.refused == [BROKEN])
    assert eventually(lambda: page.is_free("one"))
    assert desk.holds_nothing
    page.part("one", 1, b"late")
    assert takes_another(desk, page)
    assert desk.taken == [b"1 2 3"]


def test_a_file_that_stalls_is_dropped(desk: Desk, page: Sender, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(uploads, "PATIENCE", 0.2)
    page.announce("one", 4, 2)
    page.part("one", 0, b"ab")
    assert eventually(lambda: desk.refused == [STALLED])
    assert eventually(lambda: page.is_free("one"))
    assert desk.holds_nothing
    monkeypatch.setattr(uploads, "PATIENCE", 60.0)
    assert takes_another(desk, page)


def test_each_part_gets_its_own_time(desk: Desk, page: Sender, monkeypatch: pytest.MonkeyPatch) -> None:
    page.announce("one", 4, 4)
    assert eventually(lambda: "one" in desk.on_the_way)
    [(_, of_window)] = desk.windows.values()
    ends = []
    for index in range(3):
        assert of_window._deadline is not None
        ends.append(of_window._deadline.when())
        page.part("one", index, b"x")
        assert eventually(lambda n=index: len(desk.on_the_way["one"]["parts"]) == n + 1)  # type: ignore[misc]
    assert ends == sorted(ends)
    assert len(set(ends)) == 3
    page.part("one", 3, b"x")
    assert eventually(lambda: desk.taken == [b"xxxx"])
    assert of_window._deadline is None


def test_what_is_on_its_way_leaves_with_its_window(server: viser.ViserServer, desk: Desk) -> None:
    page = Sender(server.get_port())
    page.announce("one", 4, 2)
    page.part("one", 0, b"ab")
    assert eventually(lambda: "one" in desk.on_the_way)
    [(client, of_window)] = desk.windows.values()
    page.close()
    assert eventually(lambda: not desk.windows)
    assert client.gui._current_file_upload_states == {}
    assert of_window._deadline is None
    assert desk.refused == []


def test_other_controls_take_no_files(desk: Desk, page: Sender) -> None:
    page.announce("one", 2, 1, label="Height")
    page.part("one", 0, b"ab", label="Height")
    page.announce("two", 2, 1, source_component_uuid="no such control")
    page.announce("three", 2, 1, source_component_uuid=["no", "name"])
    page.announce(["no", "name"], 2, 1)
    assert takes_another(desk, page)
    assert desk.slider.value == 1.0
    assert desk.refused == []


def test_a_part_that_names_another_control_stays_with_its_button(desk: Desk, page: Sender) -> None:
    page.announce("one", 2, 1)
    page.part("one", 0, b"ab", label="Height")
    assert eventually(lambda: desk.taken == [b"ab"])
    assert desk.slider.value == 1.0
    assert eventually(lambda: desk.holds_nothing)


def test_a_disabled_button_takes_no_file(desk: Desk, page: Sender) -> None:
    in_loop(desk, lambda: setattr(desk.button, "disabled", True))
    page.file("one", b"ab")
    page.give("Height", 1.5)
    assert eventually(lambda: desk.slider.value == 1.5)
    in_loop(desk, lambda: setattr(desk.button, "disabled", False))
    assert takes_another(desk, page)
    assert desk.taken == [b"1 2 3"]


def in_loop(desk: Desk, act: Callable[[], None]) -> None:
    """Do something on the event loop of the server."""

    async def acting() -> None:
        act()

    asyncio.run_coroutine_threadsafe(acting(), desk.server.get_event_loop()).result(60)
