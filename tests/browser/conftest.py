"""A headless Chromium, and windows of a served Helicoide in it."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager

import pytest
from playwright.sync_api import Browser, Page, ViewportSize, expect, sync_playwright
from tests.browser.lab import Lab, opened, until

from helicoide.view import link

CHROMIUMS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
)
SIZES = {
    "desk": (1280, 800),
    "desktop": (1366, 768),
    "laptop": (1366, 600),
    "phone": (390, 844),
    "projector": (1920, 1080),
}
PATIENCE_MS = 300_000  # a slow machine must not fail a test
expect.set_options(timeout=PATIENCE_MS)
SLOW_GL_TOAST = "text=Software WebGL rendering detected"

HIDE = "toast => { toast.closest('.mantine-Notification-root').style.display = 'none' }"

OpenPage = Callable[..., Page]


@pytest.fixture(scope="session", autouse=True)
def patience() -> Iterator[None]:
    """Accept old messages: on a slow machine a click may take more than a second. `tests/session` tests stale ones."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(link, "FRESH", PATIENCE_MS / 1000)
        yield


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    found = next(filter(None, map(shutil.which, CHROMIUMS)), None)
    if found is None:
        pytest.fail(f"No Chromium on this machine: install the package chromium (looked for {', '.join(CHROMIUMS)}).")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=found, headless=True, args=FLAGS)
        yield chromium
        chromium.close()


@contextmanager
def window(
    browser: Browser,
    port: int,
    size: str = "desk",
    locale: str = "en-US",
    log: list[str] | None = None,
    path: str = "/",
    first: bool = False,
    resolution: float = 0.25,
) -> Iterator[Page]:
    """Open a window on a port, with one of SIZES; it is drawn, may drive, and is without notifications.

    A phone has touch. first: whether this is the browser's first visit, so that the hint is shown; log: gets the lines
    of the page's console, including errors; resolution: pixels that the scene is drawn with, per pixel of the page.
    """
    lines = [] if log is None else log
    width, height = SIZES[size]
    view: ViewportSize = {"width": width, "height": height}
    touch = size == "phone"
    context = browser.new_context(viewport=view, has_touch=touch, is_mobile=touch, locale=locale)
    context.set_default_timeout(PATIENCE_MS)
    if not first:
        context.add_init_script("localStorage.setItem('helicoide-hint-closed', 'yes')")
    context.add_init_script("window.addEventListener('helicoide-drives', () => { window.drives = true; })")
    try:
        page = context.new_page()
        page.on("console", lambda line: lines.append(f"{line.type}: {line.text}"))
        page.on("pageerror", lambda error: lines.append(f"pageerror: {error}"))
        page.goto(f"http://127.0.0.1:{port}{path}?fixedDpr={resolution}")
        page.wait_for_function("() => window.__viserMutable?.nodeRefFromName['']")
        page.wait_for_selector("#helicoide-stop[data-link=up]")
        page.wait_for_function("() => window.drives")
        page.locator(SLOW_GL_TOAST).evaluate(HIDE)
        yield page
    finally:
        context.close()


@pytest.fixture
def open_page(browser: Browser) -> Iterator[OpenPage]:
    """Opens windows that are closed at the end of the test."""
    with ExitStack() as windows:
        yield lambda *args, **options: windows.enter_context(window(browser, *args, **options))


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    """A running lab for the tests of a file."""
    lab = opened()
    yield lab
    lab.session.close()


@pytest.fixture(scope="module")
def shared_page(browser: Browser, lab: Lab) -> Iterator[Page]:
    """One window of the lab, after the kernels are compiled."""
    with window(browser, lab.port) as page:
        until(page, lambda: lab.session.ready, 300)
        yield page
