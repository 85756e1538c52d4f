"""What must hold on any page: Stop can be reached, the status line has the right language, no foreign content."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path
from threading import Event

import latex2mathml.converter
import numpy as np
import pytest
import viser
from playwright.sync_api import Browser, Error, Locator, Page, expect
from tests.browser.conftest import PATIENCE_MS, SIZES, OpenPage, window
from tests.browser.lab import until
from viser import uplot

from helicoide.text import Text, untranslated
from helicoide.view.channel import PATH, ControlChannel, Notice, introduce
from helicoide.view.page import LOST
from helicoide.view.serve import serve

STATIC = Path(__file__).parents[2] / "static"
LABEL = "Helicoide"
OPENED = count()
FREE = Text(en="Free to move", pt_BR="Livre para mover")
LONG = Text(
    en="Blocked: plane 2 (ceiling) is 80 mm from the elbow; move the target down or the plane up to go on.",
    pt_BR="Bloqueado: o plano 2 (teto) está a 80 mm do cotovelo; abaixe o alvo ou suba o plano para continuar.",
)
TALL = r"\left(\begin{matrix}\cos\theta & -\sin\theta \\ \sin\theta & \cos\theta\end{matrix}\right) \sum_{i=1}^n q_i"

# Whether an element and its content lie within the window.
IN_VIEW = """(id) => {
  const outer = document.getElementById(id), box = outer.getBoundingClientRect();
  const fits = (b) => b.left >= 0 && b.top >= 0 && b.right <= innerWidth && b.bottom <= innerHeight;
  return fits(box) && outer.scrollWidth <= outer.clientWidth && outer.scrollHeight <= outer.clientHeight;
}"""

# For points of an element's box: whether the element is on top there, and the tag of what is below it.
LAYERS = """(id) => {
  const box = document.getElementById(id).getBoundingClientRect();
  const at = (x, y) => document.elementsFromPoint(box.left + x * box.width, box.top + y * box.height);
  return [.03, .5, .97].flatMap((x) => [.03, .5, .97].map((y) => {
    const [top, ...under] = at(x, y);
    const beneath = [top, ...under].find((e) => !e.closest(`#${id}`));
    return [Boolean(top.closest(`#${id}`)), beneath.tagName];
  }));
}"""


@pytest.fixture(scope="module")
def stops() -> list[bool]:
    return []


@pytest.fixture(scope="module")
def control(stops: list[bool]) -> ControlChannel:
    """A channel like the lab's: after a stop, every page gets a fence."""

    def stopped(key: str | None, closing: bool) -> None:
        stops.append(True)
        for known in control._lines:
            control.fence(known)

    control = ControlChannel(on_stop=stopped)
    return control


@pytest.fixture(scope="module")
def server(control: ControlChannel) -> Iterator[viser.ViserServer]:
    served = open_lab(control)
    yield served
    served.stop()


def open_lab(control: ControlChannel, port: int = 0) -> viser.ViserServer:
    """Serve a page with a scene and a panel."""
    served = serve("127.0.0.1", port, STATIC, {PATH: control.serve})
    served.gui.set_panel_label(LABEL)
    served.scene.configure_default_lights(cast_shadow=False)
    served.scene.add_grid("/floor")
    served.scene.add_icosphere("/ball", 0.3, (40, 90, 200))
    keys = (f"window-{next(OPENED)}" for _ in count())

    async def furnish(client: viser.ClientHandle) -> None:
        key = next(keys)
        control.open(key)
        introduce(client, key)
        control.push(key, Notice("en", FREE, "ok"))
        client.gui.add_text("Name", "q")
        client.gui.add_html(f'<div class="helicoide-formula">{latex2mathml.converter.convert(TALL)}</div>')
        time = np.linspace(0.0, 1.0, 50)
        series = (uplot.Series(label="t"), uplot.Series(label="q", stroke="blue"))
        client.gui.add_uplot((time, time**2), series)
        for number in range(12):
            client.gui.add_slider(f"Joint {number}", -1.0, 1.0, 0.01, 0.0)
        client.gui.add_button("Question").on_click(ask)

    async def ask(event: viser.GuiEvent[viser.GuiButtonHandle]) -> None:
        assert event.client is not None
        with event.client.gui.add_modal("Question") as modal:

            async def close(_: object) -> None:
                modal.close()

            event.client.gui.add_button("Answer").on_click(close)

    served.on_client_connect(furnish)
    return served


def say(server: viser.ViserServer, control: ControlChannel, notice: Notice) -> None:
    for key in list(control._lines):
        server.get_event_loop().call_soon_threadsafe(control.push, key, notice)


@pytest.fixture(scope="module", params=SIZES)
def page(request: pytest.FixtureRequest, browser: Browser, server: viser.ViserServer) -> Iterator[Page]:
    with window(browser, server.get_port(), request.param) as opened:
        yield opened


def press(page: Page, target: Locator) -> None:
    """Tap on a phone, otherwise click."""
    target.tap() if page.evaluate("navigator.maxTouchPoints") else target.click()


def fold(page: Page) -> None:
    """Fold viser's panel, or unfold it."""
    press(page, page.get_by_text(LABEL, exact=True))
    page.wait_for_timeout(600)


def fires(page: Page, stops: list[bool], act: Callable[[], object]) -> bool:
    """Whether an action called `on_stop` exactly once."""
    before = len(stops)
    act()
    until(page, lambda: len(stops) > before)
    page.wait_for_timeout(200)
    return len(stops) == before + 1


def stays(page: Page, stops: list[bool], act: Callable[[], object]) -> bool:
    """Whether an action did not call `on_stop`."""
    before = len(stops)
    act()
    page.wait_for_timeout(500)
    return len(stops) == before


def test_stop_and_status_are_in_view_and_cover_no_control(
    server: viser.ViserServer, control: ControlChannel, page: Page
) -> None:
    say(server, control, Notice("pt_BR", LONG, "blocked"))
    expect(page.locator("#helicoide-status")).to_have_text(LONG.pt_BR)
    # without pointer events, `elementsFromPoint` skips the status line
    page.add_style_tag(content="#helicoide-status { pointer-events: auto !important }")
    for _ in ("open", "folded"):
        for name in ("helicoide-stop", "helicoide-status"):
            assert page.evaluate(IN_VIEW, name)
            assert page.evaluate(LAYERS, name) == [[True, "CANVAS"]] * 9
        assert page.evaluate("document.scrollingElement.scrollWidth <= innerWidth")
        fold(page)


def test_stop_by_hand(page: Page, stops: list[bool]) -> None:
    stop = page.locator("#helicoide-stop")
    box = stop.bounding_box()
    assert box is not None
    assert min(box["width"], box["height"]) >= 44
    assert fires(page, stops, lambda: press(page, stop))


def test_stop_on_press_rather_than_release(page: Page, stops: list[bool]) -> None:
    page.locator("#helicoide-stop").hover()
    assert fires(page, stops, page.mouse.down)
    assert stays(page, stops, page.mouse.up)


def test_stop_by_key(page: Page, stops: list[bool]) -> None:
    assert fires(page, stops, lambda: page.keyboard.press("Escape"))
    page.locator("input.mantine-TextInput-input:visible").focus()
    assert page.evaluate("document.activeElement.tagName") == "INPUT"
    assert fires(page, stops, lambda: page.keyboard.press("Escape"))
    assert stays(page, stops, lambda: page.keyboard.press("x"))
    page.locator("#helicoide-stop").focus()
    assert fires(page, stops, lambda: page.keyboard.press("Enter"))


def test_stop_over_a_modal(page: Page, stops: list[bool]) -> None:
    page.get_by_role("button", name="Question").click()
    page.locator(".mantine-Modal-content").wait_for()
    assert fires(page, stops, lambda: press(page, page.locator("#helicoide-stop")))
    assert fires(page, stops, lambda: page.keyboard.press("Escape"))
    page.get_by_role("button", name="Answer").click()
    page.locator(".mantine-Modal-content").wait_for(state="detached")


def test_words_are_never_markup(server: viser.ViserServer, control: ControlChannel, page: Page) -> None:
    say(server, control, Notice("en", untranslated("<img src=x onerror=alert(1)>"), "warn"))
    expect(page.locator("#helicoide-status")).to_have_text("<img src=x onerror=alert(1)>")
    assert page.locator("#helicoide-status *").count() == 0


def test_the_window_is_told_anew_when_viser_reconnects_behind_a_folded_panel(
    server: viser.ViserServer, control: ControlChannel, page: Page
) -> None:
    fold(page)
    known = page.evaluate("window.helicoideWindow")
    server._websock_server.disconnect_all_clients()
    page.wait_for_function("(known) => window.helicoideWindow !== known", arg=known)
    say(server, control, Notice("en", LONG, "warn"))
    expect(page.locator("#helicoide-status")).to_have_text(LONG.en)
    fold(page)


def test_each_window_speaks_its_own_language(
    server: viser.ViserServer, control: ControlChannel, open_page: OpenPage
) -> None:
    first, second = open_page(server.get_port()), open_page(server.get_port())
    *_, first_key, second_key = control._lines
    loop = server.get_event_loop()
    loop.call_soon_threadsafe(control.push, first_key, Notice("pt_BR", FREE, "ok"))
    loop.call_soon_threadsafe(control.push, second_key, Notice("en", LONG, "blocked"))
    expect(first.locator("#helicoide-status")).to_have_text(FREE.pt_BR)
    expect(first.locator("#helicoide-stop-label")).to_have_text("Parar o movimento")
    expect(first.locator("html")).to_have_attribute("lang", "pt-BR")
    expect(second.locator("#helicoide-status")).to_have_text(LONG.en)
    expect(second.locator("#helicoide-status")).to_have_attribute("data-tone", "blocked")
    expect(second.locator("#helicoide-stop-label")).to_have_text("Stop motion")
    expect(second.locator("html")).to_have_attribute("lang", "en")


def test_a_lost_server_is_told_and_a_stop_outlives_it(
    control: ControlChannel, open_page: OpenPage, stops: list[bool]
) -> None:
    served = open_lab(control)
    port = served.get_port()
    page = open_page(port)
    served.stop()
    expect(page.locator("#helicoide-status")).to_have_text(LOST.en)
    expect(page.locator("#helicoide-stop")).to_have_css("background-color", "rgb(107, 112, 117)")
    before = len(stops)
    page.keyboard.press("Escape")
    served = open_lab(control, port)
    try:
        page.wait_for_selector("#helicoide-stop[data-link=up]")
        page.wait_for_timeout(300)
        assert len(stops) == before + 1
    finally:
        served.stop()


def test_a_stuck_server_is_told(control: ControlChannel, open_page: OpenPage) -> None:
    """The server is stuck until the page shows it: a slow page might miss a pause of fixed length."""
    served, seen = open_lab(control), Event()
    try:
        page = open_page(served.get_port())
        served.get_event_loop().call_soon_threadsafe(seen.wait, PATIENCE_MS / 1000)
        page.wait_for_selector("#helicoide-stop[data-link=lost]")
        seen.set()
        page.wait_for_selector("#helicoide-stop[data-link=up]")
    finally:
        seen.set()
        served.stop()


def test_before_anyone_said_a_language_the_browsers_counts(control: ControlChannel, browser: Browser) -> None:
    served = serve("127.0.0.1", 0, STATIC, {PATH: control.serve})
    try:
        with browser.new_context(locale="pt-BR") as context:
            page = context.new_page()
            page.goto(f"http://127.0.0.1:{served.get_port()}/")
            expect(page.locator("#helicoide-stop-label")).to_have_text("Parar o movimento")
            expect(page.locator("html")).to_have_attribute("lang", "pt-BR")
    finally:
        served.stop()


def test_nothing_foreign_is_reached_and_all_of_the_page_works(server: viser.ViserServer, open_page: OpenPage) -> None:
    console: list[str] = []
    page = open_page(server.get_port(), log=console)
    page.wait_for_function("() => window.__viserMutable.nodeRefFromName['/ball']")
    page.locator(".uplot canvas").first.wait_for()
    assert page.title() == "Helicoide"
    assert page.evaluate("document.fonts.load('16px \"STIX Two Math\"', '∑').then((faces) => faces.length)") == 1
    assert page.locator("math mo").first.bounding_box()["height"] > 30  # type: ignore[index]
    assert [line for line in console if "policy" in line.lower() or line.startswith(("error", "pageerror"))] == []
    with pytest.raises(Error, match="Failed to fetch"):
        page.evaluate("fetch('http://localhost:9/')")
    assert any("Content Security Policy" in line for line in console)


def test_a_link_to_another_server_is_stripped(server: viser.ViserServer, open_page: OpenPage) -> None:
    page = open_page(server.get_port())
    page.goto(f"http://127.0.0.1:{server.get_port()}/?websocket=ws://127.0.0.1:9")
    page.wait_for_selector("#helicoide-stop[data-link=up]")
    assert "websocket" not in page.url
