"""The page of the sources: the same entries in both languages, each with what shows it."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from helicoide import content, studies
from helicoide.export import errata
from helicoide.kinematics.library import robot_names as robots
from helicoide.text import LANGUAGES, Language

ROOT = Path(__file__).parents[2]
SEARCH = re.compile(r"`python -m (tests\.studies\.fits\.\w+)[^`]*`")
RIGHT_ASTERISK = re.compile(r"`[^`]*`|\\\*|\*\w[^*]*[\w)]\*")
COMMAND, TEST = re.compile(r"`helicoide ([^`]+)`"), re.compile(r"`(tests/[\w/]+\.py)(?:::\w+)?`")


def entries(language: Language) -> dict[str, str]:
    """The entries by their name, such as "Vargas 2"."""
    text = (content.STATIC / "pages" / language / "sources.md").read_text("utf-8")
    parts = re.split(r"^#{2,3} ", text, flags=re.MULTILINE)
    return {part.partition(":")[0]: part for part in parts if re.match(r"\w+ \d+:", part)}


def test_both_languages_have_the_same_entries_in_the_same_order() -> None:
    english, portuguese = entries("en"), entries("pt_BR")
    assert list(english) == list(portuguese)
    assert english
    for name in english:
        assert re.findall(r"`[^`]+`", english[name]) == re.findall(r"`[^`]+`", portuguese[name]), name


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_has_an_anchor_for_each_entry_and_each_source_with_entries(language: Language) -> None:
    """A study may cite any other source, which the page does not have."""
    page, sources = (
        errata.sources_page(language),
        {studies.study_named(name).SOURCE.partition(",")[0] for name in studies.study_names()},
    )
    authors = {entry.partition(" ")[0] for entry in entries(language)}
    described = [source for source in sources if source.partition(" ")[0] in authors]
    assert len(described) >= 4
    for anchor in (*entries(language), *described):
        assert f'id="{anchor.lower().replace(" ", "-")}"' in page


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_asterisk_of_a_formula_is_taken_for_emphasis(language: Language) -> None:
    """One stands in code, has a backslash before it, or is one of the two around words."""
    lost = {name: RIGHT_ASTERISK.sub("", entry).count("*") for name, entry in entries(language).items()}
    assert not any(lost.values()), lost
    assert "h p h*; " in errata.sources_page(language)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_drawing_stands_in_the_page_with_its_words(language: Language) -> None:
    page, drawings = errata.sources_page(language), list((content.STATIC / "pages" / "drawings").glob("*.svg"))
    assert drawings
    assert page.count('<svg role="img" aria-label="') == len(drawings)
    for drawing in drawings:
        assert drawing.read_text("utf-8").partition("\n")[2] in page
    assert "<img" not in page


@pytest.mark.parametrize("name", entries("en"))
def test_an_entry_names_a_command_a_study_or_a_test_that_is_there(name: str) -> None:
    entry = entries("en")[name]
    tests = [*TEST.findall(entry), *(f"{name.replace('.', '/')}.py" for name in SEARCH.findall(entry))]
    commands = [shlex.split(command) for command in COMMAND.findall(entry)]
    shown = [study for study in studies.study_names() if f"`{study}`" in entry]
    assert tests or commands or shown
    assert [test for test in tests if not (ROOT / test).is_file()] == []
    known = {"study": studies.study_names(), "fk": robots(), "ik": robots(), "workspace": robots()}
    for command, *arguments in commands:
        assert command in known or command in ("robots", "check")
        assert not arguments or command not in known or arguments[0] in known[command]
