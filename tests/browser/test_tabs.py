"""The tabs of the panel: on one line with their full names, in both languages, on a desktop screen and a phone."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser
from tests.browser.conftest import window
from tests.browser.lab import Lab, speak

from helicoide.text import LANGUAGES
from helicoide.view import panels

CUT = """tabs => tabs.filter(tab => tab.getBoundingClientRect().right > innerWidth
  || [...tab.querySelectorAll('span')].some(e => e.clientWidth && e.scrollWidth > e.clientWidth + 1)
).map(tab => tab.innerText)"""


@pytest.mark.parametrize("size", ["desk", "phone"])
def test_all_tabs_stand_on_one_line_with_their_whole_names(lab: Lab, browser: Browser, size: str) -> None:
    with window(browser, lab.port, size) as page:
        tabs = page.get_by_role("tab")
        for language in LANGUAGES:
            speak(lab, page, language)
            names = [panel.TITLE[language] for panel in panels.all_panels()]
            for name in names:
                page.get_by_role("tab", name=name).click()  # the chosen tab is bold and wider
                assert [text.strip() for text in tabs.all_inner_texts()] == names
                assert len(set(tabs.evaluate_all("tabs => tabs.map(tab => tab.getBoundingClientRect().y)"))) == 1
                assert tabs.evaluate_all(CUT) == []
