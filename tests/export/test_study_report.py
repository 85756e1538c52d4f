"""The report: one page that holds everything, in either language, with every verdict in words."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
from tests.hostile import HARMLESS, NAMES, OUTLINE, Page, result_named, study_named

from helicoide import studies
from helicoide.export.study_report import COLOUR, STYLE, Record, counted, page
from helicoide.export.study_table import cells, number
from helicoide.studies.study import FIGURE_ONLY, Chart, Line, Result, Row, Verdict
from helicoide.text import LANGUAGES, Language, Text, same

ROWS = (
    Row(Text(en="right", pt_BR="certo"), 1.0, 1.0, 0.1, "mm", "1.0"),
    Row(Text(en="doubtful", pt_BR="duvidoso"), 2.0, 1.0, 0.1, "mm", FIGURE_ONLY, doubt="D6"),
    Row(Text(en="assumed", pt_BR="suposto"), 2.0, 1.0, assumed=Text(en="no gains <b>", pt_BR="sem ganhos <b>")),
    Row(Text(en="wrong", pt_BR="errado"), 2.0, 1.0, relation="≤"),
)
LINE = Line(same("line"), np.array([0.0, 1.0]), np.array([1.0, 2.0]))
CHART = Chart(Text(en="a chart", pt_BR="um gráfico"), same("x"), same("y"), (LINE,))
NAME = "cerbaro_orca_convergence"


def record(*rows: Row, failure: Text | None = None) -> Record:
    study = studies.named(NAME)
    result = None if failure else Result(rows, (CHART,))
    return Record(NAME, study, study.Options(), False, result, failure, 1.25)


class Tags(HTMLParser):
    """Whether tags close in order, and what addresses they name."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.addresses: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag != "meta":
            self.open.append(tag)
        self.addresses += [value or "" for name, value in attrs if name in ("href", "src", "xlink:href", "action")]

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_the_page_is_whole_and_asks_for_nothing_from_outside(language: Language) -> None:
    text = page([record(*ROWS)], 3.0, language)
    tags = Tags(text)
    assert tags.open == []
    assert tags.addresses == [f"#{NAME}"]
    assert f'id="{NAME}"' in text
    assert not re.search(r"https?:|//\w|url\(|@import|<script|<link|<img|<iframe", text)
    assert f'lang="{language.replace("_", "-")}"' in text


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_every_verdict_is_there_in_words_and_colour(language: Language) -> None:
    text = page([record(*ROWS)], 3.0, language)
    for row, verdict in zip(ROWS, Verdict, strict=True):
        assert row.verdict is verdict
        assert row.quantity[language] in text
        assert f'<span class="verdict {COLOUR[verdict]}">{verdict.value[language]}' in text
        assert f".{COLOUR[verdict]} {{ color:" in STYLE
    assert "(D6)" in text
    assert "&lt;b&gt;" in text
    assert FIGURE_ONLY[language] in text
    assert CHART.title[language] in text


def test_the_languages_do_not_mix() -> None:
    english, portuguese = (page([record(*ROWS)], 3.0, language) for language in ("en", "pt_BR"))  # type: ignore[arg-type]
    for row in ROWS:
        assert row.quantity.pt_BR not in english
        assert f">{row.quantity.en}<" not in portuguese
    assert studies.named(NAME).ABOUT.en not in portuguese
    assert "verdict</th>" in english
    assert "veredito</th>" in portuguese


def test_it_prints_on_paper() -> None:
    assert "@media print" in STYLE
    assert "print-color-adjust: exact" in STYLE


def test_a_study_that_failed_says_why_and_counts_as_a_difference() -> None:
    failed = record(failure=same("no robot <here>"))
    assert failed.differs
    assert "no robot &lt;here&gt;" in page([failed], 1.0, "en")


@pytest.mark.parametrize(("rows", "differs"), [(ROWS, True), (ROWS[:3], False), ((), False)])
def test_doubt_and_assumption_are_no_difference(rows: tuple[Row, ...], differs: bool) -> None:
    assert record(*rows).differs is differs


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_names_make_no_tags(name: str, language: Language) -> None:
    study = study_named(name)
    ran = Record(name, study, study.Options(), True, result_named(name), None, 1.0)
    failed = replace(ran, result=None, failure=same(name))
    read = Page(page([ran, failed], 1.0, language))
    assert read.tags <= HARMLESS | OUTLINE
    assert not read.active
    assert read.text.count(name) > 20


def test_all_numbers_are_counted() -> None:
    words = counted([record(*ROWS), record(ROWS[0], replace(ROWS[0], digest=None))], 12.3)
    assert words.en.startswith("Studies: 2. Numbers: 6; agrees: 2; ")
    assert "nothing to compare with: 1. " in words.en
    assert "12 s" in words.pt_BR


@pytest.mark.parametrize(
    ("value", "unit", "tolerance", "said"),
    [
        (583.2412, "mm", 5.1e-5, "583.24120 mm"),
        (-10.18, "°", 0.06, "-10.18°"),
        (1.1e-6, "mm", 1e-7, "1.1×10⁻⁶ mm"),
        (0.0, "°", 0.0, "0°"),
        (-0.0, "", 0.0, "0"),
        (17, "", 0.0, "17"),
        (float("nan"), "mm", 0.1, "nan mm"),
    ],
)
def test_numbers_are_written_as_far_as_they_count(value: float, unit: str, tolerance: float, said: str) -> None:
    assert number(value, unit, tolerance) == said


def test_a_row_without_source_or_digest_has_dashes() -> None:
    assert cells(Row(same("q"), 1.5), "en") == ("q", "–", "–", "1.5", "–")
    assert cells(replace(ROWS[3], ours=float("nan"), digest=None), "pt_BR")[2:] == ("–", "nan", "difere")
