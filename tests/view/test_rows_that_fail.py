"""A row that raises, whenever it does, is marked in the window's language and told once; the others go on."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
import viser
from markupsafe import Markup

from helicoide.seat import Seat
from helicoide.state import State
from helicoide.text import LANGUAGES, Language, untranslated
from helicoide.view.placed_rows import FAILED, place_rows
from helicoide.view.requests import ForLab, PageRequest
from helicoide.view.rows import (
    Bar,
    Button,
    Checkbox,
    DependentRows,
    Dropdown,
    Folder,
    HtmlRow,
    Plot,
    Row,
    Slider,
    TextEntry,
    VectorRow,
)
from helicoide.view.window_view import View


def fails(*_: Any) -> Any:
    raise ZeroDivisionError("on purpose")


def english(value: Any) -> Any:
    """That value in English; in Portuguese it raises."""
    return lambda view: value if view.seat.language == "en" else fails()


NAME, REQUEST = untranslated("a row"), ForLab("movemaster")
UNREADABLE: dict[str, Row] = {
    "words": HtmlRow(english(Markup("said"))),
    "slider": Slider(NAME, 0.0, 1.0, 0.1, english(0.5), lambda _: REQUEST),
    "slider with a label": Slider(english(NAME), 0.0, 1.0, 0.1, lambda _: 0.5, lambda _: REQUEST),
    "slider that is disabled": Slider(NAME, 0.0, 1.0, 0.1, lambda _: 0.5, lambda _: REQUEST, english(True)),
    "button": Button(english(NAME), lambda _: REQUEST),
    "button that is hidden": Button(lambda _: NAME, lambda _: REQUEST, shown=english(True)),
    "tick": Checkbox(NAME, english(True), lambda _: REQUEST),
    "choice": Dropdown(NAME, [("a", NAME)], english("a"), lambda _: REQUEST),
    "choice of what there is": Dropdown(NAME, english([("a", NAME)]), lambda _: "a", lambda _: REQUEST),
    "triple": VectorRow(NAME, 1.0, english((0.0, 0.0, 0.0)), lambda view, _: REQUEST),
    "entry": TextEntry(NAME, english("typed"), NAME, lambda _: REQUEST),
    "bar": Bar(english(0.5)),
    "plot": Plot(english(()), 0),
    "folder": Folder(NAME, DependentRows(english("key"), lambda key: [])),
    "folder of rows": Folder(
        NAME, DependentRows(lambda view: view.seat.language, lambda key: [] if key == "en" else fails())
    ),
}
FAILING_REQUESTS: dict[str, Row] = {
    "slider": Slider(NAME, 0.0, 1.0, 0.1, lambda _: 0.5, fails),
    "button": Button(lambda _: NAME, fails),
    "tick": Checkbox(NAME, lambda _: True, fails),
    "choice": Dropdown(NAME, [("a", NAME)], lambda _: "a", fails),
    "triple": VectorRow(NAME, 1.0, lambda _: (0.0, 0.0, 0.0), fails),
    "entry": TextEntry(NAME, lambda _: "typed", NAME, fails),
}


@pytest.fixture(scope="module")
def server() -> Iterator[viser.ViserServer]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield server
    server.stop()


@pytest.fixture
def views(state: State) -> dict[Language, View]:
    return {language: View(state, Seat("", language)) for language in LANGUAGES}


def elements(gui: viser.GuiApi) -> list[Any]:
    """Everything that can be seen in the panel."""
    containers = list(gui._container_handle_from_uuid.values())
    return [handle for container in containers for handle in container._children.values() if handle.visible]


def read(gui: viser.GuiApi) -> list[str]:
    """The HTML that can be seen, from above to below."""
    shown = [handle for handle in elements(gui) if isinstance(handle, viser.GuiHtmlHandle) and handle.content]
    return [handle.content for handle in sorted(shown, key=lambda handle: handle.order)]


def mark(language: Language) -> str:
    return f"<p class='helicoide-note'>{FAILED[language]}</p>"


def among_others(row: Row) -> list[Row]:
    """The row between two that say which language the view has."""
    says = HtmlRow(lambda view: Markup("{}").format(view.seat.language))
    return [says, row, says]


@pytest.mark.parametrize("row", UNREADABLE.values(), ids=UNREADABLE)
def test_a_row_that_cannot_be_built_leaves_a_mark_in_its_place(
    server: viser.ViserServer, views: dict[Language, View], row: Row, caplog: pytest.LogCaptureFixture
) -> None:
    server.gui.reset()
    placed = place_rows(server.gui, among_others(row), views["pt_BR"], fails)
    for _ in range(3):
        for one in placed:
            one.refresh(views["pt_BR"])
    assert read(server.gui) == ["pt_BR", mark("pt_BR"), "pt_BR"]
    assert len(elements(server.gui)) == 3
    assert told(caplog) == [f"A row of a panel failed: {type(row).__name__}."]
    for one in placed:
        one.remove()
    assert elements(server.gui) == []


def told(caplog: pytest.LogCaptureFixture) -> list[str]:
    assert all(record.exc_info for record in caplog.records)
    return [record.getMessage() for record in caplog.records]


@pytest.mark.parametrize("row", UNREADABLE.values(), ids=UNREADABLE)
def test_a_row_that_cannot_be_refreshed_is_marked(
    server: viser.ViserServer, views: dict[Language, View], row: Row, caplog: pytest.LogCaptureFixture
) -> None:
    server.gui.reset()
    placed = place_rows(server.gui, among_others(row), views["en"], fails)
    assert mark("en") not in read(server.gui)
    assert told(caplog) == []
    for _ in range(3):
        for one in placed:
            one.refresh(views["pt_BR"])
    assert read(server.gui)[0] == read(server.gui)[-1] == "pt_BR"
    assert mark("en") in read(server.gui)
    assert told(caplog) == [f"A row of a panel failed: {type(row).__name__}."]


@pytest.mark.parametrize("row", FAILING_REQUESTS.values(), ids=FAILING_REQUESTS)
def test_a_row_whose_request_cannot_be_made_is_marked(
    server: viser.ViserServer, views: dict[Language, View], row: Row, caplog: pytest.LogCaptureFixture
) -> None:
    server.gui.reset()
    place_rows(server.gui, [row], views["en"], fails)
    (handle, *_) = [each for each in elements(server.gui) if getattr(each._impl, "update_cb", None)]
    for _ in range(3):
        touch(handle)
    assert read(server.gui) == [mark("en")]
    assert told(caplog) == [f"A row of a panel failed: {type(row).__name__}."]


def touch(handle: Any) -> None:
    """What viser does when a page changes a control."""
    for callback in handle._impl.update_cb:
        event = viser.GuiEvent(client=handle, client_id=0, target=handle)
        asyncio.run_coroutine_threadsafe(callback(event), handle._impl.gui_api._event_loop).result(60)


def test_a_request_that_cannot_be_granted_marks_its_row(
    server: viser.ViserServer, views: dict[Language, View], caplog: pytest.LogCaptureFixture
) -> None:
    server.gui.reset()
    requests: list[PageRequest] = []
    placed = place_rows(server.gui, [Button(lambda _: NAME, lambda _: REQUEST)], views["en"], requests.append)
    (button,) = [each for each in elements(server.gui) if isinstance(each, viser.GuiButtonHandle)]
    touch(button)
    assert requests == [REQUEST]
    placed[0].refresh(views["pt_BR"])
    assert told(caplog) == []
    server.gui.reset()
    place_rows(server.gui, [Button(lambda _: NAME, lambda _: REQUEST)], views["en"], fails)
    (button,) = [each for each in elements(server.gui) if isinstance(each, viser.GuiButtonHandle)]
    touch(button)
    assert read(server.gui) == [mark("en")]


def test_rows_come_back_when_their_key_can_be_read_again(
    server: viser.ViserServer, views: dict[Language, View], caplog: pytest.LogCaptureFixture
) -> None:
    """Rows that hang on a key that failed are gone, so that nobody presses what stands for something else."""
    server.gui.reset()

    def rows(lesson: str | None) -> list[Row]:
        return fails() if lesson == "bad" else [HtmlRow(lambda _: Markup("{}").format(lesson))]

    view = views["en"]
    (folder,) = place_rows(server.gui, [Folder(NAME, DependentRows(lambda view: view.seat.lesson, rows))], view, fails)
    for lesson, shown in (("a b", ["a b"]), ("bad", []), ("a", ["a"])):
        for _ in range(2):
            folder.refresh(replace(view, seat=replace(view.seat, lesson=lesson)))
        assert [page for page in read(server.gui) if page != mark("en")] == shown
    assert len(told(caplog)) == 1


def test_two_that_are_called_alike_can_be_told_apart(server: viser.ViserServer, views: dict[Language, View]) -> None:
    """The page refuses a list with the same words twice."""
    server.gui.reset()
    requests: list[PageRequest] = []
    alike = Dropdown(NAME, [(key, NAME) for key in "abc"], lambda _: "a", ForLab)
    (placed,) = place_rows(server.gui, [alike], views["en"], requests.append)
    (handle,) = [each for each in elements(server.gui) if isinstance(each, viser.GuiDropdownHandle)]
    assert len(set(handle.options)) == 3
    for option in handle.options:
        handle.value = option
        touch(handle)
        placed.refresh(views["en"])
    assert requests == [ForLab("a"), ForLab("b"), ForLab("c")]
