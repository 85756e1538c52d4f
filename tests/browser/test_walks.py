"""Lessons from the first step to the summary: by the keyboard alone, by touch on a phone, and by the mouse.

`make soak` walks through all, in both languages. The contact sheets are written to .pytest_cache/lessons/.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from tests.browser.conftest import window
from tests.browser.lab import Lab, until
from tests.browser.pictures import LOCALES
from tests.browser.walking import Reach, Walk, by_keyboard, by_mouse, by_touch, contact_sheet

from helicoide import content
from helicoide.lesson import load_lesson
from helicoide.text import LANGUAGES, Language

SHEETS = Path(__file__).parents[2] / ".pytest_cache" / "lessons"


def walked(lab: Lab, page: Page, name: str, language: Language, reach: Reach) -> Walk:
    """A walk to the end, and its contact sheet."""
    until(page, lambda: lab.session.ready, 300)
    walk = Walk(lab, page, load_lesson(name), language, reach)
    try:
        walk.go()
    finally:
        SHEETS.mkdir(parents=True, exist_ok=True)
        if walk.pictures:
            contact_sheet(walk.pictures).save(SHEETS / f"{name}_{language}.png")
    return walk


def test_a_lesson_by_the_keyboard_alone(lab: Lab, browser: Browser) -> None:
    with window(browser, lab.port) as page:
        walk = walked(lab, page, "sine_to_motor", "en", by_keyboard)
        assert (walk.faults, walk.without_page) == ([], [])


def test_a_lesson_by_touch(lab: Lab, browser: Browser) -> None:
    with window(browser, lab.port, "phone", "pt-BR") as page:
        assert walked(lab, page, "drive_the_arm", "pt_BR", by_touch).faults == []


@pytest.mark.soak
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", sorted(content.content_folders("lessons")))
def test_a_lesson_by_the_mouse(lab: Lab, browser: Browser, name: str, language: Language) -> None:
    with window(browser, lab.port, "desktop", LOCALES[language], resolution=1) as page:
        assert walked(lab, page, name, language, by_mouse).faults == []
