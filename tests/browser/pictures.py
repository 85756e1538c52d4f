"""The pictures of the README, taken from the running app: `make docs-pictures` writes static/pictures/."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Page, sync_playwright
from tests.browser import sheet
from tests.browser.conftest import CHROMIUMS, FLAGS, SIZES, SLOW_GL_TOAST

from helicoide import content

PICTURE = content.STATIC / "pictures" / "lab.png"
ABOVE_THE_CEILING = (680, 60, 690)
COMPILING_MS = 300_000
SETTLING_MS = 2_500  # software rendering draws a few frames a second


@contextmanager
def served() -> Iterator[str]:
    """Start a lab in another process; gives its address."""
    command = [sys.executable, "-m", "helicoide", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, encoding="utf-8") as server:
        assert server.stdout is not None
        try:
            yield server.stdout.readline().split()[-1]
        finally:
            server.terminate()


@contextmanager
def opened(address: str) -> Iterator[Page]:
    """A window of size `desk`, without notifications, with the arm ready."""
    found = next(filter(None, map(shutil.which, CHROMIUMS)), None)
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=found, headless=True, args=FLAGS)
        width, height = SIZES["desk"]
        page = chromium.new_page(viewport={"width": width, "height": height}, locale="en-US")
        page.goto(address)
        page.get_by_role("status").get_by_text("Ready:").wait_for(timeout=COMPILING_MS)
        page.locator(SLOW_GL_TOAST).wait_for()
        page.locator(".mantine-Notification-closeButton").first.click()
        yield page
        chromium.close()


def tab(page: Page, name: str) -> None:
    """Bring a panel to the front."""
    page.get_by_role("tab", name=name).click()


def ask_for(page: Page, millimetres: tuple[int, int, int]) -> None:
    """Type the position of the target, mm, into the three boxes of the Robot tab."""
    boxes = page.get_by_text("x y z [mm]", exact=True).locator("xpath=following::input[@inputmode='decimal']")
    for box, value in enumerate(millimetres):
        boxes.nth(box).fill(str(value))
        boxes.nth(box).press("Enter")


def light_up(page: Page, reading: str) -> None:
    """Choose the multivector that the Algebra tab and the scene highlight."""
    page.get_by_label("Highlight", exact=True).click()
    page.get_by_role("option", name=reading).click()


def take_the_lab() -> None:
    """The target above the ceiling: the arm stops 80 mm below it, the status says why, the plane is highlighted."""
    PICTURE.parent.mkdir(exist_ok=True)
    with served() as address, opened(address) as page:
        tab(page, "Robot")
        ask_for(page, ABOVE_THE_CEILING)
        tab(page, "Algebra")
        light_up(page, "ceiling")
        page.get_by_role("status").get_by_text("Blocked by plane").wait_for()
        page.wait_for_timeout(SETTLING_MS)
        page.screenshot(path=PICTURE)
    print(f"{PICTURE.relative_to(Path.cwd())}: {PICTURE.stat().st_size // 1024} kB")


if __name__ == "__main__":
    take_the_lab()
    sheet.main()
