"""The pictures of the README, taken from the running app: `make docs-pictures` writes static/pictures/."""

from __future__ import annotations

import io
import shutil
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

from PIL import Image
from playwright.sync_api import Browser, Page, sync_playwright
from tests.browser import sheet
from tests.browser.conftest import CHROMIUMS, FLAGS, PATIENCE_MS, window
from tests.browser.gallery import GALLERY, Picture
from tests.browser.lab import Lab, opened, until
from tests.browser.studio import Studio

from helicoide import content
from helicoide.view import link
from helicoide.view.top_rows import with_dark, with_projector

FOLDER = content.STATIC / "pictures"
SETTLING_MS = 2_500  # software rendering draws a few frames a second
LOCALES = {"en": "en-US", "pt_BR": "pt-BR"}
FAILURES = ".mantine-Notification-root, [role=alert], #helicoide-stop:not([data-link=up])"
REFUSALS = ".helicoide-wrong, #helicoide-status[data-tone=warn], #helicoide-status[data-tone=lost]"
FLAWS = """(wrong) => {
  const seen = (element) => element.checkVisibility({ opacityProperty: true, visibilityProperty: true });
  const unfinished = /\\p{L}…|Traceback|\\bNaN\\b/u;
  const found = [...document.querySelectorAll(wrong)].filter(seen)
    .map((one) => (one.closest(".helicoide-line") ?? one).innerText);
  const lines = document.body.innerText.split("\\n").filter((line) => unfinished.test(line));
  return [...found, ...lines];
}"""


class UnfitPictureError(Exception):
    """A page that shows something that no picture may show."""


def flaws(page: Page, kinds: str = f"{FAILURES}, {REFUSALS}") -> list[str]:
    """The words on the page that a picture may not show: of these kinds, errors, and what is still being computed."""
    return list(page.evaluate(FLAWS, kinds))


def photograph(page: Page, path: Path) -> None:
    """Save what the page shows, with few colours. Raises UnfitPictureError, and saves nothing, if it is unfit."""
    found = flaws(page)
    shot = page.screenshot()
    found += flaws(page)
    if found:
        raise UnfitPictureError(f"{path.name} is not taken, since the page shows: {'; '.join(dict.fromkeys(found))}")
    sheet.save_light(Image.open(io.BytesIO(shot)).convert("RGB"), path)


def take(lab: Lab, browser: Browser, picture: Picture) -> None:
    """Take one picture of the gallery, in a window of its own."""
    with window(browser, lab.port, picture.size, LOCALES[picture.language], resolution=1) as page:
        until(page, lambda: lab.session.ready, 300)
        studio = Studio(lab, page, picture.language)
        studio.load("movemaster")
        lab.reset(page)
        studio.sit(lambda seat: with_projector(picture.size == "projector", with_dark(picture.dark, seat)))
        page.wait_for_selector(f"html[data-mantine-color-scheme={'dark' if picture.dark else 'light'}]")
        page.wait_for_timeout(SETTLING_MS)
        picture.set_up(studio)
        page.mouse.move(1, 1)
        page.wait_for_timeout(SETTLING_MS)
        photograph(page, FOLDER / f"{picture.name}.png")


def take_gallery(pictures: Sequence[Picture]) -> None:
    """Take pictures of the gallery. Recordings made for them are thrown away."""
    found = next(filter(None, map(shutil.which, CHROMIUMS)), None)
    with (
        TemporaryDirectory() as mine,
        patch.object(content, "user_folder", lambda: Path(mine)),
        patch.object(link, "FRESH", PATIENCE_MS / 1000),
        sync_playwright() as playwright,
    ):
        lab = opened()
        chromium = playwright.chromium.launch(executable_path=found, headless=True, args=FLAGS)
        for picture in pictures:
            take(lab, chromium, picture)
            print(f"{picture.name}: {(FOLDER / f'{picture.name}.png').stat().st_size // 1000} kB", flush=True)
        chromium.close()
        lab.session.close()


def main(asked: Sequence[str]) -> None:
    """Take the pictures of these names, or all."""
    known = [*(picture.name for picture in GALLERY), sheet.PICTURE.stem]
    if unknown := set(asked).difference(known):
        sys.exit(f"There is no picture {', '.join(unknown)}; there are {', '.join(known)}.")
    wanted = asked or known
    take_gallery([picture for picture in GALLERY if picture.name in wanted])
    if sheet.PICTURE.stem in wanted:
        sheet.main()


if __name__ == "__main__":
    main(sys.argv[1:])
