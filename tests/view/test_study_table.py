"""The table of a study's panel: every verdict by sign and in words, numbers that can be read, a run beside another."""

from __future__ import annotations

import re

import pytest

from helicoide.export import study_table
from helicoide.studies.panel_state import CompletedRun
from helicoide.studies.study import (
    INPUT_VALUE,
    Figure,
    Fitted,
    Interpretation,
    Result,
    Row,
    Statement,
    Verdict,
    printed_statement,
)
from helicoide.text import Language, Text, untranslated
from helicoide.view.panels.study import SIGNS, _written

ROWS = (
    Row(Text(en="right", pt_BR="certo"), 6.05262e-14, "mm/s", printed_statement("≤ 1 × 10⁻¹²", "fig. 1")),
    Row(
        Text(en="fitted", pt_BR="ajustado"),
        2.0,
        "",
        printed_statement("< 2,5", "§2"),
        fitted=(Fitted(Text(en="gain <b>", pt_BR="ganho <b>"), 5.5, 4.0, 6.0, "1/s"),),
    ),
    Row(
        Text(en="wrong", pt_BR="errado"),
        -2.0,
        "",
        printed_statement("1,0", "§3"),
        why=Text(en="not known", pt_BR="não se sabe"),
    ),
    Row(Text(en="misprinted", pt_BR="mal impresso"), 3.0, "m", printed_statement("1,0", "§4"), erratum="vargas-2"),
    Row(Text(en="drawn", pt_BR="desenhado"), 3.0, "", Figure("fig. 5")),
    Row(Text(en="alone", pt_BR="sozinho"), 3.0),
)


NEAR = Text(en="near zero", pt_BR="perto de zero")
TAKEN = Interpretation(Text(en="the instant", pt_BR="o instante"), Text(en="3.1", pt_BR="3,1"))


def run(*rows: Row) -> CompletedRun:
    return CompletedRun("a study", None, True, Result(rows))


def lines(table: str) -> list[list[str]]:
    """The words of each row of the table."""
    return [
        [re.sub("<[^>]+>", "", cell).strip() for cell in re.findall(r"<t[dh].*?</t[dh]>", line)]
        for line in re.findall(r"<tr.*?</tr>", table)
    ]


@pytest.mark.parametrize("language", ["en", "pt_BR"])
def test_each_verdict_has_its_sign_and_what_is_compared_its_words(language: Language) -> None:
    table = _written((run(*ROWS),), language)
    said = lines(table)
    for row, verdict in zip(ROWS, Verdict, strict=True):
        assert row.verdict is verdict
        assert [f"{SIGNS[verdict]} {row.quantity[language]}".strip()] in said
        assert f"{verdict.value[language]}: 1" in table
        compared = isinstance(row.source, Statement)
        assert any(line[0].startswith(verdict.value[language]) for line in said) == compared
    assert "&lt;b&gt;" in table
    assert ("holds at least from 4 to 6" in table, "vale ao menos de 4 a 6" in table) == (
        language == "en",
        language == "pt_BR",
    )
    assert f"<a href='pages/{language}/sources#vargas-2'" in table


def test_numbers_stand_under_their_heads_in_the_language_of_the_page() -> None:
    heads, quantity, numbers, *_ = lines(_written((run(*ROWS),), "en"))
    assert heads == ["the source says", "here"]
    assert quantity == ["✓ right"]
    assert numbers == ["≤ 1 × 10⁻¹² mm/s (fig. 1)", "6.0526×10⁻¹⁴ mm/s"]
    assert ["1,0 (§3)", "−2,00"] in lines(_written((run(*ROWS),), "pt_BR"))


def test_what_nobody_printed_stands_at_the_end() -> None:
    said = lines(_written((run(*reversed(ROWS)),), "en"))
    assert [line for line in said if line in (["drawn"], ["alone"], ["✓ right"])] == [["✓ right"], ["drawn"], ["alone"]]


def test_the_run_before_stands_in_the_place_of_the_source() -> None:
    before = run(Row(ROWS[0].quantity, 7e-14), Row(untranslated("gone"), 1.0))
    heads, _, numbers, _, _, others, *_ = lines(_written((run(*ROWS[:2]), before), "en"))
    assert heads == ["here", "previous"]
    assert numbers == ["6.0526×10⁻¹⁴ mm/s", "7×10⁻¹⁴"]
    assert others == ["2", "–"]


@pytest.mark.parametrize(
    ("row", "said", "verdict"),
    [
        (
            Row(NEAR, 55.9, "mm", Statement(NEAR, "fig. 2", 60.0, "≤")),
            "near zero (fig. 2), read as ≤ 60 mm",
            "as printed",
        ),
        (Row(NEAR, 4.0, "", Statement(NEAR, "§1", 4.2, "=", 0.5)), "near zero (§1), read as 4.2 ± 0.5", "as printed"),
        (Row(NEAR, 5e-3, "", Statement(NEAR, "§1", 1e-3, "~")), "near zero (§1), read as 0.001 to 0.01", "as printed"),
        (
            Row(NEAR, 2.0, "cm/s", printed_statement("2,0", "§4"), given=INPUT_VALUE),
            "2.0 cm/s (§4)",
            "here: it was put in",
        ),
        (
            Row(NEAR, 2.0, "", printed_statement("2,0", "§4"), (TAKEN,)),
            "2.0 (§4)",
            "as printed, with a fitted value or reading: the instant",
        ),
    ],
)
def test_how_words_are_read_and_what_was_chosen_is_said(row: Row, said: str, verdict: str) -> None:
    assert study_table.source_cell(row).en == said
    assert study_table.verdict_cell(row).en == verdict


def test_a_reading_is_told_with_what_comes_out_otherwise() -> None:
    chosen = study_table.fitted_line(Result((Row(NEAR, 2.0, "", printed_statement("2,0", "§4"), (TAKEN,)),)))
    assert chosen is not None
    assert chosen.en == "Chosen, each varied alone: the instant (otherwise 3.1)."
