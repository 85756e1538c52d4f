"""What is added with `helicoide new` appears in the lists of the page, in both languages."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser
from tests.browser.conftest import window
from tests.contributions.added import ADDED, with_additions

from helicoide.kinematics.library import load_robot
from helicoide.text import LANGUAGES, Language
from helicoide.view import panels
from helicoide.view.rows import Dropdown

LOCALES = {"en": "en-US", "pt_BR": "pt-BR"}
TITLES: dict[str, dict[Language, str]] = {
    "robot": {"en": "New arm ({})", "pt_BR": "Braço novo ({})"},
    "method": {"en": "new method ({})", "pt_BR": "método novo ({})"},
    "lesson": {"en": "New lesson ({})", "pt_BR": "Lição nova ({})"},
    "study": {"en": "New study ({})", "pt_BR": "Estudo novo ({})"},
}


@pytest.fixture(scope="module")
def port(tmp_path_factory: pytest.TempPathFactory) -> Iterator[int]:
    """The port of a server that runs a copy with all additions, with the arm from outside the repository."""
    copy = with_additions(tmp_path_factory.mktemp("copy"))
    command = copy.command("serve", "--robot", "stranger_outside", "--port", "0")
    with subprocess.Popen(command, cwd=copy.root, env=copy.environment, stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout is not None
        try:
            yield int(server.stdout.readline().rpartition(":")[2])
        finally:
            server.terminate()


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_additions_are_in_the_lists(browser: Browser, port: int, language: Language) -> None:
    found = {panel.__name__.rpartition(".")[2]: panel for panel in panels.all_panels()}
    with window(browser, port, locale=LOCALES[language]) as page:
        for kind, name, _ in ADDED:
            first = next(row for row in found[kind].rows(load_robot("movemaster")) if isinstance(row, Dropdown))
            page.get_by_role("tab", name=found[kind].TITLE[language]).click()
            label = page.get_by_label(first.label[language], exact=True)
            page.locator("input[role=combobox]:visible").and_(label).click()
            title = TITLES[kind][language].format(name)  # the title of a study follows its source
            page.get_by_role("option", name=re.compile(f"{re.escape(title)}$")).wait_for()
            page.keyboard.press("Escape")
