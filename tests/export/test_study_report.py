"""The report: one page that holds everything, in either language, with every verdict in words."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
from markupsafe import escape
from tests.hostile import HARMLESS, NAMES, OUTLINE, Page, result_named, study_named

from helicoide import studies
from helicoide.export.study_report import STYLE, Record, differences, report_page, source_counts, verdict_counts
from helicoide.export.study_table import format_number, row_cells
from helicoide.studies.study import Chart, ChartLine, Figure, Fitted, Result, Row, Verdict, printed_statement
from helicoide.text import LANGUAGES, Language, Text, untranslated

GAIN = Fitted(Text(en="gain <b>", pt_BR="ganho <b>"), 5.5, 4.0, 6.0, "1/s")
ROWS = (
    Row(Text(en="right", pt_BR="certo"), 1.0, "mm", printed_statement("1,0", "fig. 1")),
    Row(Text(en="chosen", pt_BR="escolhido"), 2.0, "", printed_statement("< 2,5", "§2"), fitted=(GAIN,)),
    Row(
        Text(en="wrong", pt_BR="errado"),
        2.0,
        "",
        printed_statement("≤ 1", "§3"),
        why=Text(en="the step", pt_BR="o passo"),
    ),
    Row(Text(en="misprinted", pt_BR="mal impresso"), 3.0, "m", printed_statement("1,0", "§4"), erratum="vargas-2"),
    Row(Text(en="drawn", pt_BR="desenhado"), 3.0, "", Figure("fig. 5")),
    Row(Text(en="alone", pt_BR="sozinho"), 3.0),
)
LINE = ChartLine(untranslated("line"), np.array([0.0, 1.0]), np.array([1.0, 2.0]))
CHART = Chart(Text(en="a chart", pt_BR="um gráfico"), untranslated("x"), untranslated("y"), (LINE,))
NAME = "cerbaro_orca_convergence"


def record(*rows: Row, failure: Text | None = None) -> Record:
    study = studies.study_named(NAME)
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
    text = report_page([record(*ROWS)], 3.0, language)
    tags = Tags(text)
    assert tags.open == []
    assert tags.addresses == [f"#{NAME}", "#vargas-2"]
    assert f'id="{NAME}"' in text
    assert not re.search(r"https?:|//\w|url\(|@import|<script|<link|<img|<iframe", text)
    assert f'lang="{language.replace("_", "-")}"' in text


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_every_verdict_is_there_in_words_and_colour(language: Language) -> None:
    text = report_page([record(*ROWS)], 3.0, language)
    for row, verdict in zip(ROWS, Verdict, strict=True):
        assert row.verdict is verdict
        assert row.quantity[language] in text
        kind = verdict.name.lower()
        assert re.search(f'<span class="verdict {kind}">(<a [^>]+>)?{verdict.value[language]}', text)
        assert re.search(rf"\.{kind}\b[^}}]*{{ color:", STYLE)
    assert "&lt;b&gt;" in text
    assert CHART.title[language] in text


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_what_differs_is_listed_at_the_end_with_what_is_printed_and_why(language: Language) -> None:
    (said,) = differences([record(*ROWS)])
    assert str(escape(said[language])) in report_page([record(*ROWS)], 3.0, language).partition('id="differs"')[2]
    for part in (ROWS[2].quantity, untranslated("≤ 1 (§3)"), untranslated("2"), ROWS[2].why):
        assert part is not None
        assert part[language] in said[language]


def test_statements_and_fitted_values_are_counted_by_source() -> None:
    (said,) = source_counts([record(*ROWS), record(*ROWS)])
    assert said.en == (
        "Cerbaro 2022: rows compared: 8; different statements of the source in them: 4; values fitted for them: 1; "
        "readings chosen: 0"
    )


def test_the_languages_do_not_mix() -> None:
    english, portuguese = (report_page([record(*ROWS)], 3.0, language) for language in ("en", "pt_BR"))  # type: ignore[arg-type]
    for row in ROWS:
        assert row.quantity.pt_BR not in english
        assert f">{row.quantity.en}<" not in portuguese
    assert studies.study_named(NAME).ABOUT.en not in portuguese
    assert "verdict</th>" in english
    assert "veredito</th>" in portuguese


def test_it_prints_on_paper() -> None:
    assert "@media print" in STYLE
    assert "print-color-adjust: exact" in STYLE


def test_a_study_that_failed_says_why_and_is_unexplained() -> None:
    failed = record(failure=untranslated("no robot <here>"))
    assert failed.unexplained
    assert "no robot &lt;here&gt;" in report_page([failed], 1.0, "en")


@pytest.mark.parametrize(("rows", "unexplained"), [(ROWS, False), ((replace(ROWS[2], why=None),), True), ((), False)])
def test_a_difference_whose_cause_is_known_is_explained(rows: tuple[Row, ...], unexplained: bool) -> None:
    assert record(*rows).unexplained is unexplained


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_names_make_no_tags(name: str, language: Language) -> None:
    study = study_named(name)
    ran = Record(name, study, study.Options(), True, result_named(name), None, 1.0)
    failed = replace(ran, result=None, failure=untranslated(name))
    read = Page(report_page([ran, failed], 1.0, language))
    assert read.tags <= HARMLESS | OUTLINE
    assert not read.active
    assert read.text.count(name) > 20


def test_all_rows_are_counted() -> None:
    words = verdict_counts([record(*ROWS), record(ROWS[0])], 12.3)
    assert words.en.startswith("Studies: 2. Rows: 7; as printed: 2; ")
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
        (8.0, "", 0.5, "8"),
        (float("nan"), "mm", 0.1, "nan mm"),
    ],
)
def test_numbers_are_written_as_far_as_they_count(value: float, unit: str, tolerance: float, said: str) -> None:
    assert format_number(value, unit, tolerance) == said


def test_a_row_without_source_has_a_dash() -> None:
    assert [cell.en for cell in row_cells(Row(untranslated("q"), 1.5))] == ["q", "–", "1.5", "here"]
    assert [cell.pt_BR for cell in row_cells(replace(ROWS[2], computed=float("nan"), why=None))][2:] == [
        "nan",
        "difere",
    ]
