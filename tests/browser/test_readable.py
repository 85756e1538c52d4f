"""Every tab is legible and usable: on a projector, a small laptop and a phone, light and dark, in both languages."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from tests.browser.conftest import window
from tests.browser.lab import Lab, pixels, speak, tab, until

from helicoide import gate
from helicoide.session.postures import to_singular_posture
from helicoide.text import LANGUAGES
from helicoide.view import panels
from helicoide.view.top_rows import LOOK, PROJECTOR, with_dark

FINDINGS = Path(__file__).with_name("readable.js").read_text("utf-8")
IN_VIEW = """element => { const spot = element.getBoundingClientRect();
  return spot.top >= 0 && spot.bottom <= innerHeight && spot.left >= 0 && spot.right <= innerWidth }"""
AT = "([x, y]) => document.elementFromPoint(x, y)?.tagName"


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


def remaining(page: Page, touch: bool) -> list[str]:
    """What is found once the page has fitted its formulas and named its controls, which it does with a delay."""
    for _ in range(20):
        page.wait_for_timeout(300)
        if not (findings := page.evaluate(FINDINGS, touch)):
            break
    return list(findings)


def darken(lab: Lab, page: Page, on: bool) -> None:
    """Give the newest window the dark look or the light one."""
    visitor = list(lab.session.visitors.values())[-1]
    lab.session.loop.call_soon_threadsafe(visitor.reseat, partial(with_dark, on))
    page.wait_for_selector(f"html[data-mantine-color-scheme={'dark' if on else 'light'}]")


def test_every_tab_can_be_read_and_pressed(lab: Lab, page: Page) -> None:
    lab.reset(page)
    lab.post(gate.choose_method("pseudoinverse"))
    lab.post(gate.compare_with("damped"))
    lab.post(to_singular_posture(lab.state))
    until(page, lambda: lab.state.compared is not None and len(lab.state.compared.trace.times) > 1)
    touch = page.viewport_size is not None and page.viewport_size["width"] < 400
    found = {}
    for language in LANGUAGES:
        speak(lab, page, language)
        for panel in panels.all_panels():
            tab(page, panel.TITLE[language])
            if findings := remaining(page, touch):
                found[language, panel.TITLE[language]] = findings
            until(page, lambda: page.evaluate(AT, [*pixels(page, lab.state.T_world_tool[:3, 3])]) == "CANVAS")
            darken(lab, page, True)
            if findings := remaining(page, touch):
                found["dark", language, panel.TITLE[language]] = findings
            darken(lab, page, False)
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
        expect(page.locator(".helicoide-lesson")).to_have_count(0)
