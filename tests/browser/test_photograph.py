"""No picture of the README is taken of a page with an error, a notification or unfinished work on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PIL import Image
from playwright.sync_api import Page
from tests.browser.conftest import SIZES
from tests.browser.lab import Lab, tab, until
from tests.browser.pictures import UnfitPictureError, flaws, photograph

from helicoide import gate
from helicoide.seat import Seat
from helicoide.session.arms import COMPUTING
from helicoide.sheet import Sheet, SheetLine
from helicoide.text import Text
from helicoide.view import console_rows

REFUSED = Text(en="That is out of reach.", pt_BR="Isso está fora do alcance.")


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Page:
    lab.reset(shared_page)
    until(shared_page, lambda: flaws(shared_page) == [])
    return shared_page


def reseat(lab: Lab, update: Callable[[Seat], Seat]) -> None:
    visitor = list(lab.session.visitors.values())[-1]
    lab.session.loop.call_soon_threadsafe(visitor.reseat, update)


def refused(page: Page, path: Path, words: str) -> None:
    """Check that no picture is taken once the page shows these words."""
    page.get_by_text(words).first.wait_for()
    with pytest.raises(UnfitPictureError, match=words):
        photograph(page, path)
    assert not path.exists()


def test_a_page_without_flaws_is_photographed_whole(page: Page, tmp_path: Path) -> None:
    photograph(page, tmp_path / "fit.png")
    with Image.open(tmp_path / "fit.png") as picture:
        assert picture.size == SIZES["desk"]


def test_a_notification_is_refused(lab: Lab, page: Page, tmp_path: Path) -> None:
    lab.session.loop.call_soon_threadsafe(lab.windows[-1].tell, REFUSED)
    refused(page, tmp_path / "unfit.png", REFUSED.en)
    page.locator(".mantine-Notification-closeButton:visible").click()


@pytest.mark.parametrize("said", [REFUSED, COMPUTING])
def test_a_warning_and_unfinished_work_in_the_status_line_are_refused(
    lab: Lab, page: Page, tmp_path: Path, said: Text
) -> None:
    lab.post(gate.say(said))
    refused(page, tmp_path / "unfit.png", said.en)


def test_an_error_of_the_console_is_refused(lab: Lab, page: Page, tmp_path: Path) -> None:
    tab(page, "Algebra")
    heading = page.get_by_role("button", name=console_rows.TITLE_OF_CONSOLE.en, exact=True)
    heading.click()
    reseat(lab, lambda seat: replace(seat, sheet=Sheet((SheetLine("jion(elbow, tool)"),))))
    refused(page, tmp_path / "unfit.png", "there is no function jion")
    reseat(lab, lambda seat: replace(seat, sheet=Sheet()))
    heading.click()
