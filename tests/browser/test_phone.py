"""Touch on a phone: lists open within the screen, options can be chosen, and Stop stays in view."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Locator, Page
from tests.browser.conftest import SIZES, window
from tests.browser.lab import Lab, until


@pytest.fixture
def page(browser: Browser, lab: Lab) -> Iterator[Page]:
    with window(browser, lab.port, "phone") as page:
        until(page, lambda: lab.session.ready, 300)
        yield page


def in_view(element: Locator) -> bool:
    """Whether an element is entirely within the screen size, even if the page is wider than the screen."""
    spot = element.bounding_box()
    width, height = SIZES["phone"]
    if spot is None:
        return False
    right, bottom = spot["x"] + spot["width"], spot["y"] + spot["height"]
    return 0 <= spot["x"] < right <= width and 0 <= spot["y"] < bottom <= height


def choose(page: Page, label: str, option: str) -> None:
    """Open a list and choose an option, and check that Stop stays in view."""
    page.locator("input[role=combobox]:visible").and_(page.get_by_label(label, exact=True)).tap()
    wanted = page.get_by_role("option", name=option, exact=True)
    wanted.wait_for()
    page.wait_for_timeout(300)
    assert in_view(wanted)
    assert in_view(page.locator("#helicoide-stop"))
    wanted.tap()


def test_a_lesson_is_chosen_by_finger(page: Page) -> None:
    choose(page, "Lesson", "Drive the arm")
    page.locator(".helicoide-lesson h3").wait_for()
    page.get_by_role("button", name="Hint", exact=True).tap()
    page.locator(".helicoide-lesson blockquote").wait_for()


def test_a_multivector_is_chosen_by_finger(page: Page) -> None:
    page.get_by_role("tab", name="Algebra").tap()
    choose(page, "Highlight", "end-effector motor")
    page.locator(".helicoide-lit").wait_for()
    until(page, lambda: bool(page.evaluate("window.__viserMutable.nodeRefFromName['/lit/frame'].visible")))


def test_the_language_is_chosen_by_finger(page: Page) -> None:
    choose(page, "Language · Idioma", "Português (Brasil)")
    page.get_by_role("tab", name="Robô").wait_for()
