"""The tabs of the panel: on one line, each with its whole name, in both languages, on a desk and on a phone."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser
from tests.browser.conftest import window
from tests.browser.lab import Lab

from helicoide.text import LANGUAGES, Language
from helicoide.view import panels

CUT = """tabs => tabs.filter(tab => tab.getBoundingClientRect().right > innerWidth
  || [...tab.querySelectorAll('span')].some(e => e.clientWidth && e.scrollWidth > e.clientWidth + 1)
).map(tab => tab.innerText)"""


@pytest.fixture
def english_after(lab: Lab) -> Iterator[None]:
    """New windows speak English again."""
    yield
    lab.session.language = "en"


@pytest.mark.usefixtures("english_after")
@pytest.mark.parametrize("size", ["desk", "phone"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_all_tabs_stand_on_one_line_with_their_whole_names(
    lab: Lab, browser: Browser, size: str, language: Language
) -> None:
    lab.session.language = language
    names = [panel.TITLE[language] for panel in panels.found()]
    with window(browser, lab.port, size) as page:
        page.get_by_role("tab", name=names[0]).wait_for()
        tabs = page.get_by_role("tab")
        for name in names:
            page.get_by_role("tab", name=name).click()  # the one that is chosen is written bold, and is wider
            assert [text.strip() for text in tabs.all_inner_texts()] == names
            assert len(set(tabs.evaluate_all("tabs => tabs.map(tab => tab.getBoundingClientRect().y)"))) == 1
            assert tabs.evaluate_all(CUT) == []
