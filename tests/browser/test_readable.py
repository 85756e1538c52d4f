"""Every tab is legible and usable: on a projector, a small laptop and a phone, light and dark, in both languages."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
import pytest
from markupsafe import Markup
from playwright.sync_api import Browser, Page, expect
from tests.browser.conftest import window
from tests.browser.furnished import furnish, reseat, unfold
from tests.browser.lab import Lab, pixels, speak, tab, until
from tests.browser.readable import remaining

from helicoide import content
from helicoide.readout.matrices import NamedMatrix
from helicoide.text import LANGUAGES, Language, untranslated
from helicoide.view import panels
from helicoide.view.matrix_rows import written_matrix
from helicoide.view.top_rows import LOOK, PROJECTOR, with_dark

IN_VIEW = """element => { const spot = element.getBoundingClientRect();
  return spot.top >= 0 && spot.bottom <= innerHeight && spot.left >= 0 && spot.right <= innerWidth }"""
WRITE = "html => { document.querySelector('.helicoide-matrix').outerHTML = html }"
AT = "([x, y]) => document.elementFromPoint(x, y)?.tagName"


@pytest.fixture(scope="module", autouse=True)
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """A folder of the user for the recordings."""
    tmp_path = tmp_path_factory.mktemp("user")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(content, "user_folder", lambda: tmp_path)
        yield


@pytest.fixture(params=["projector", "laptop", "phone"])
def page(browser: Browser, lab: Lab, request: pytest.FixtureRequest) -> Iterator[Page]:
    with window(browser, lab.port, request.param) as page:
        until(page, lambda: lab.session.ready, 300)
        if request.param == "projector":
            page.get_by_text(LOOK.en, exact=True).click()
            page.get_by_label(PROJECTOR.en).check()
            page.wait_for_selector("html[data-projector]")
            page.get_by_text(LOOK.en, exact=True).click()
        yield page


def widest(columns: int, language: Language) -> Markup:
    """A matrix with the longest names and numbers that a Jacobian or an inverse has."""
    rows, names = [untranslated("ωx [rad/s]")] * 6, [untranslated("q̇₈ [rad/s]")] * columns
    values = np.resize([-8.8888, -0.8888, -8888.8, -88.888], (6, columns))
    return written_matrix(NamedMatrix(values, tuple(rows), tuple(names), untranslated("")), language)


def darken(lab: Lab, page: Page, on: bool) -> None:
    """Give the newest window the dark look or the light one."""
    reseat(lab, partial(with_dark, on))
    page.wait_for_selector(f"html[data-mantine-color-scheme={'dark' if on else 'light'}]")


def test_every_tab_can_be_read_and_pressed(lab: Lab, page: Page) -> None:
    """With all folders open; the dark look is measured in one size, since the others have the same colours."""
    lab.reset(page)
    furnish(lab, page)
    width = page.viewport_size["width"] if page.viewport_size else 0
    found = {}
    for language in LANGUAGES:
        speak(lab, page, language)
        for panel in panels.all_panels():
            tab(page, panel.TITLE[language])
            unfold(page)
            if findings := remaining(page, width < 400):
                found[language, panel.TITLE[language]] = findings
            until(page, lambda: page.evaluate(AT, [*pixels(page, lab.state.T_world_tool[:3, 3])]) == "CANVAS")
            if width == 1366:
                darken(lab, page, True)
                if findings := remaining(page, False):
                    found["dark", language, panel.TITLE[language]] = findings
                darken(lab, page, False)
        page.evaluate(WRITE, "".join(widest(columns, language) for columns in range(1, 9)))
        if findings := remaining(page, False):
            found[language, "matrices"] = findings
        tab(page, panels.all_panels()[0].TITLE[language])  # one without charts, which take long to be built again
    assert not found


def test_what_a_lesson_needs_is_in_view_without_scrolling(lab: Lab, browser: Browser) -> None:
    with window(browser, lab.port, "laptop") as page:
        until(page, lambda: lab.session.ready, 300)
        tab(page, "Lesson")
        page.get_by_role("combobox").nth(1).click()
        page.get_by_role("option", name="Drive the arm").click()
        expect(page.locator(".helicoide-verdict")).to_be_visible()
        tab(page, "Method")
        for wanted in ("#helicoide-stop", "#helicoide-status", ".helicoide-lesson h3", ".helicoide-verdict"):
            assert page.locator(wanted).evaluate(IN_VIEW), wanted
        until(page, lambda: page.evaluate(AT, [*pixels(page, lab.state.T_world_tool[:3, 3])]) == "CANVAS")
        tab(page, "Lesson")
        page.get_by_role("combobox").nth(1).click()
        page.get_by_role("option", name="Explore freely").click()
        expect(page.locator(".helicoide-lesson h3")).to_have_count(0)
