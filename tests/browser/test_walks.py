"""Lessons from the first step to the summary: by the keyboard alone, and by touch on a phone. `make soak` walks all."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Browser, Page
from tests.browser.conftest import window
from tests.browser.lab import Lab, until
from tests.browser.walking import Walk, by_keyboard, by_touch, contact_sheet

from helicoide.lesson import load_lesson


def test_a_lesson_by_the_keyboard_alone(lab: Lab, shared_page: Page, tmp_path: Path) -> None:
    walk = Walk(lab, shared_page, load_lesson("sine_to_motor"), "en", by_keyboard)
    walk.go()
    contact_sheet(walk.pictures).save(tmp_path / "sheet.png")
    assert (walk.faults, walk.without_page) == ([], [])


def test_a_lesson_by_touch(lab: Lab, browser: Browser, tmp_path: Path) -> None:
    with window(browser, lab.port, "phone", "pt-BR") as page:
        until(page, lambda: lab.session.ready, 300)
        walk = Walk(lab, page, load_lesson("drive_the_arm"), "pt_BR", by_touch)
        walk.go()
    contact_sheet(walk.pictures).save(tmp_path / "sheet.png")
    assert walk.faults == []
