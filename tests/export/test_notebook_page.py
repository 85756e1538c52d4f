"""The page about notebooks: the same cells in both languages, which run and give what the page states."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from tests.notebooks import ran, shown

import helicoide
from helicoide.content import STATIC
from helicoide.export.errata import text_page
from helicoide.export.notebook import notebook_of_page, page_cells
from helicoide.text import LANGUAGES, Language


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_cell_runs_and_gives_what_the_page_states(language: Language, tmp_path: Path) -> None:
    cells = ran(notebook_of_page(language), tmp_path)
    stated = [result for cell, result in page_cells(language) if cell.kind == "code"]
    assert len(cells) == len(stated) > 15
    for cell, result in zip(cells, stated, strict=True):
        if result is not None:
            assert shown(cell)["text/plain"] == result
    pages = [shown(cell).get("text/html", "") for cell in cells]
    assert any("<iframe" in page for page in pages)
    assert any("text/latex" in shown(cell) for cell in cells)
    assert sum("e<sub>" in page for page in pages) >= 5


def test_both_languages_have_the_same_cells() -> None:
    english, portuguese = (
        [cell.source for cell, _ in page_cells(language) if cell.kind == "code"] for language in LANGUAGES
    )
    swapped = [source.replace('"pt_BR"', '"en"').replace(".name.pt_BR", ".name.en") for source in portuguese]
    assert swapped == english


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_names_every_public_name_and_no_other(language: Language) -> None:
    page = (STATIC / "pages" / language / "notebook.md").read_text("utf-8")
    table = page[page.index("|---|") :]
    assert set(re.findall(r"`(\w+)\([^`]*\)`", table.partition("\n\n")[0])) - {"at", "inverse", "stop", "close"} == set(
        helicoide.__all__
    )
    for name in re.findall(r"helicoide\.(\w+)", page):
        assert name in helicoide.__all__


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_asterisk_is_taken_for_emphasis(language: Language) -> None:
    """But for names of tabs, which are one word each."""
    assert all(re.fullmatch(r"\w+", words) for words in re.findall(r"<em>(.*?)</em>", text_page("notebook", language)))
