"""What is taken home from a page: a picture of the chosen size, and a clip that plays offline. The lab in a frame."""

from __future__ import annotations

import http.server
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import imageio.v3
import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from tests.browser.conftest import HIDE, PATIENCE_MS, SLOW_GL_TOAST, OpenPage
from tests.browser.lab import Lab, pixels, press, tab, until

import helicoide
from helicoide import gate
from helicoide.arrays import Array
from helicoide.text import LANGUAGES, Language
from helicoide.view import picture
from helicoide.view.export_rows import CLIP, NOTEBOOK, PICTURE, PICTURES, SIZE, TITLE
from helicoide.view.panels import study

LOCALES: dict[Language, str] = {"en": "en-US", "pt_BR": "pt-BR"}
PLACE = "name => window.__viserMutable.nodeRefFromName[name].position.toArray()"


def opened_folder(page: Page, language: Language = "en") -> None:
    """Open the folder of what can be taken home."""
    tab(page, study.TITLE[language])
    page.get_by_role("button", name=TITLE[language], exact=True).click()
    page.get_by_role("button", name=PICTURE[language], exact=True).scroll_into_view_if_needed()


def saved(page: Page, button: str, folder: Path) -> Path:
    """Press a button, and save the file that the page offers then."""
    for close in page.locator(".mantine-Notification-closeButton:visible").all():
        close.click()
    page.locator("a[download]").wait_for(state="detached")
    press(page, button)
    with page.expect_download(timeout=PATIENCE_MS) as download:
        page.locator("a[download]").click()
    file = folder / download.value.suggested_filename
    download.value.save_as(file)
    return file


@pytest.fixture(autouse=True)
def patience_with_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """A slow machine must not fail a test."""
    monkeypatch.setattr(picture, "PATIENCE", PATIENCE_MS / 1000)


@pytest.mark.parametrize(("key", "size", "language"), [("small", "desk", "en"), ("upright", "phone", "pt_BR")])
def test_a_picture_has_the_chosen_size_and_shows_the_arm(
    lab: Lab, open_page: OpenPage, tmp_path: Path, key: str, size: str, language: Language
) -> None:
    page = open_page(lab.port, size, LOCALES[language])
    until(page, lambda: lab.session.ready, 300)
    opened_folder(page, language)
    width, height = PICTURES[key]
    page.locator("input[role=combobox]:visible").and_(page.get_by_label(SIZE[language], exact=True)).click()
    page.get_by_role("option", name=f"{width} × {height}").click()
    until(page, lambda: lab.seats[-1].picture == key)
    image = imageio.v3.imread(saved(page, PICTURE[language], tmp_path))
    assert image.shape == (height, width, 4)
    assert 0.05 < np.mean(image[..., 3] > 0) < 0.95
    assert len(np.unique(image[::4, ::4].reshape(-1, 4), axis=0)) > 500


@contextmanager
def offline(browser: Browser, file: Path) -> Iterator[Page]:
    """A page with a file, in a browser without a network; it fails if the page asks for anything else."""
    context = browser.new_context(viewport={"width": 640, "height": 400}, offline=True)
    context.set_default_timeout(PATIENCE_MS)
    asked: list[str] = []
    try:
        page = context.new_page()
        page.on("request", lambda request: asked.append(request.url))
        page.goto(f"{file.as_uri()}?fixedDpr=0.25")
        page.wait_for_function("() => window.__viserMutable?.nodeRefFromName['']")
        yield page
    finally:
        context.close()
    assert [url for url in asked if not url.startswith(("file:", "blob:", "data:"))] == []


def near(shot: Array, place: tuple[float, float]) -> Array:
    """The colours (k, 3) around a place of a screenshot, px."""
    x, y = map(round, place)
    return shot[y - 12 : y + 12, x - 12 : x + 12, :3].reshape(-1, 3)


def test_a_clip_plays_the_last_seconds_without_a_network(
    lab: Lab, browser: Browser, open_page: OpenPage, tmp_path: Path
) -> None:
    page = open_page(lab.port)
    until(page, lambda: lab.session.ready, 300)
    lab.reset(page)
    opened_folder(page)
    for q in (0.2, -0.2):
        lab.cell.ask(gate.set_joint(0, q))
        until(page, lambda q=q: abs(lab.state.arm.q[0] - q) < 1e-3)
    seen = {round(float(one.arm.q[0]), 6) for one in lab.display.recent}
    file = saved(page, CLIP.en, tmp_path)
    assert len(seen) > 3
    page.close()  # it would draw beside the clip
    names = [f"/arm/{shape.name}" for shape in lab.shapes]
    with offline(browser, file) as clip:
        clip.wait_for_function("names => names.every(name => window.__viserMutable.nodeRefFromName[name])", arg=names)
        for toast in clip.locator(SLOW_GL_TOAST).all():
            toast.evaluate(HIDE)
        turned: set[float] = set()
        moving = names[-1]

        def pose() -> float:
            return round(float(clip.evaluate(PLACE, moving)[0]), 4)

        def moves() -> bool:
            turned.add(pose())
            return len(turned) > 2

        until(clip, moves)
        clip.keyboard.press("Space")
        clip.wait_for_timeout(500)
        still = pose()
        clip.wait_for_timeout(500)
        assert pose() == still
        elbow = clip.evaluate(PLACE, names[3])
        shot = np.asarray(imageio.v3.imread(clip.screenshot(timeout=PATIENCE_MS)))
        assert len(np.unique(near(shot, pixels(clip, elbow)), axis=0)) > 10
        assert len(np.unique(near(shot, (600.0, 40.0)), axis=0)) == 1


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_folder_leads_to_the_page_about_notebooks(lab: Lab, open_page: OpenPage, language: Language) -> None:
    page = open_page(lab.port, locale=LOCALES[language])
    until(page, lambda: lab.session.ready, 300)
    opened_folder(page, language)
    with page.context.expect_page() as other:
        page.locator(f"a[href='pages/{language}/notebook']").click()
    other.value.get_by_text("import helicoide").first.wait_for()
    assert page.get_by_role("button", name=NOTEBOOK[language]).is_visible()


@contextmanager
def notebook_page(body: str) -> Iterator[str]:
    """A page of another port of this computer with this body; gives its address."""

    class Answer(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(body.encode())

        def log_message(self, *_: object) -> None:
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Answer)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://localhost:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()


def test_the_lab_runs_in_a_frame_of_a_notebook(browser: Browser) -> None:
    cell = helicoide.lab("movemaster")
    context = browser.new_context()
    try:
        with notebook_page(cell._repr_html_()) as address:
            page = context.new_page()
            page.goto(address)
            page.frame_locator("iframe").locator("#helicoide-stop[data-link=up]").wait_for(timeout=PATIENCE_MS)
            q = cell.q.copy()
            q[0] = 0.3
            cell.q = q
            until(page, lambda: abs(cell.q[0] - 0.3) < 1e-3)
    finally:
        context.close()
        cell.close()


def test_no_other_lab_can_be_framed(lab: Lab, browser: Browser) -> None:
    context = browser.new_context()
    lines: list[str] = []
    try:
        with notebook_page(f'<iframe src="http://127.0.0.1:{lab.port}/"></iframe>') as address:
            page = context.new_page()
            page.on("console", lambda line: lines.append(line.text))
            page.goto(address)
            until(page, lambda: any("frame-ancestors" in line for line in lines))
    finally:
        context.close()
