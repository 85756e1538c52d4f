"""A study on a real page: chosen, run, read beside the source, compared, played on the arm with its charts."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page
from tests.browser.lab import Lab, status, tab, until
from tests.browser.test_methods import choose

from helicoide import studies
from helicoide.state import Replay
from helicoide.studies.desk import Desk

NAME = "cerbaro_orca_circle"


@pytest.fixture
def page(shared_page: Page) -> Iterator[Page]:
    tab(shared_page, "Study")
    yield shared_page
    tab(shared_page, "Robot")


def desk(lab: Lab) -> Desk:
    (token,) = {window.view.seat.token for window in lab.session.windows.values()}
    return lab.session.studies.desk(token)


def test_a_study_is_run_read_compared_and_played(lab: Lab, page: Page) -> None:
    choose(page, "Study", studies.named(NAME).TITLE.en)
    until(page, lambda: desk(lab).study == NAME)
    page.get_by_role("button", name="Run", exact=True).click()
    until(page, lambda: desk(lab).last is not None, 300)
    rows = page.locator(".helicoide-study tr")
    until(page, lambda: rows.count() > 1)
    assert "✗" not in page.locator(".helicoide-study").inner_text()
    until(page, lambda: page.locator(".uplot").count() >= 1)
    page.get_by_role("button", name="Run", exact=True).click()
    until(page, lambda: desk(lab).before is not None, 300)
    page.get_by_label("beside the run before").click()
    until(page, lambda: "before" in page.locator(".helicoide-study").inner_text())
    page.get_by_role("button", name="Play it on the arm").click()
    until(page, lambda: lab.state.robot.name == studies.named(NAME).ROBOT)
    until(page, lambda: isinstance(lab.state.command, Replay) and lab.state.command.s > 0.3)
    until(page, lambda: "Playing the study" in status(page))
    assert page.locator(".uplot").count() >= 1
    page.keyboard.press("Escape")
    until(page, lambda: not isinstance(lab.state.command, Replay))


def test_a_run_can_be_ended(lab: Lab, page: Page) -> None:
    choose(page, "Study", studies.named("cerbaro_confined_circle").TITLE.en)
    page.get_by_label("short form").click()
    until(page, lambda: not desk(lab).short)
    page.get_by_role("button", name="Run", exact=True).click()
    until(page, lambda: desk(lab).progress is not None)
    page.get_by_role("button", name="End the run").click()
    until(page, lambda: desk(lab).progress is None)
    page.get_by_label("short form").click()
    until(page, lambda: desk(lab).short)
    assert desk(lab).last is None or desk(lab).last.study == NAME  # type: ignore[union-attr]
