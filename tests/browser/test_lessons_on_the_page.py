"""A lesson through the page: by the keyboard alone, with its marker, its reveal, its summary and the way out."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
import pytest
from playwright.sync_api import Page, expect
from tests.browser.furnished import ask
from tests.browser.lab import Lab, press, tab, until

from helicoide import lesson
from helicoide.view.requests import ForSeat

HEADING, VERDICT = ".helicoide-lesson h3", ".helicoide-verdict"
REACHED = """([selector, text]) => { const element = document.activeElement;
  return element.matches(selector) && element.textContent.includes(text) }"""
MOST_STOPS = 120


@pytest.fixture
def page(shared_page: Page, lab: Lab) -> Iterator[Page]:
    """A page with the course map in front, and without a lesson afterwards."""
    lab.reset(shared_page)
    tab(shared_page, "Lesson")
    shared_page.locator(".helicoide-course").wait_for()
    yield shared_page
    ask(lab, ForSeat(lesson.restarted))
    ask(lab, ForSeat(partial(lesson.entered, name=None)))
    tab(shared_page, "Lesson")
    shared_page.locator(".helicoide-course").wait_for()
    assert [seat.lesson for seat in lab.seats] == [None]


def go_by_tab(page: Page, selector: str, text: str = "") -> None:
    """Move the focus by the Tab key to an element."""
    for _ in range(MOST_STOPS):
        if page.evaluate(REACHED, [selector, text]):
            return
        page.keyboard.press("Tab")
    raise AssertionError(f"the Tab key does not lead to {selector} {text}")


def test_a_step_by_the_keyboard_alone(lab: Lab, page: Page) -> None:
    go_by_tab(page, '[data-go="lesson:drive_the_arm"]')
    page.keyboard.press("Enter")
    expect(page.locator(HEADING)).to_contain_text("1.")
    go_by_tab(page, '[data-go="answer:2"]')
    page.keyboard.press("Enter")
    expect(page.locator(".helicoide-prediction", has_text="Your prediction was right")).to_be_visible()
    expect(page.locator('[data-go^="answer"]')).to_have_count(0)
    go_by_tab(page, "input.mantine-NumberInput-input")
    page.keyboard.press("Control+A")
    page.keyboard.type("-100")
    page.keyboard.press("Enter")
    until(page, lambda: abs(np.degrees(lab.state.arm.q[2]) + 100) < 1 and not lab.state.arm.moving)
    expect(page.locator(VERDICT)).to_contain_text("Done")
    go_by_tab(page, "button", "Next step")
    page.keyboard.press("Enter")
    expect(page.locator(HEADING)).to_contain_text("2.")


def test_skipping_all_leads_to_the_summary_and_out(lab: Lab, page: Page) -> None:
    page.locator('[data-go="lesson:drive_the_arm"]').click()
    for step in range(1, 8):
        expect(page.locator(HEADING)).to_contain_text(f"{step}.")
        expect(page.locator(".helicoide-dots .here")).to_be_visible()
        press(page, "Skip step")
    expect(page.locator(".helicoide-summary")).to_contain_text("0 of 7 steps done")


def test_live_values_follow_the_arm(lab: Lab, page: Page) -> None:
    page.locator('[data-go="lesson:drive_the_arm"]').click()
    expect(page.locator(".helicoide-value", has_text="−75°").first).to_be_visible()
    height = page.locator(".helicoide-value", has_text="mm").nth(1)
    before = height.inner_text()
    elbow = page.locator("input.mantine-NumberInput-input:visible")
    elbow.fill("-90")
    elbow.press("Enter")
    until(page, lambda: height.inner_text() != before)
