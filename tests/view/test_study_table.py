"""The table of a study's panel: every verdict by sign and in words, numbers that can be read, a run beside another."""

from __future__ import annotations

import re

import pytest

from helicoide.studies.desk import Run
from helicoide.studies.study import Figure, Fitted, Result, Row, Statement, Verdict, printed
from helicoide.text import Language, Text, same
from helicoide.view.panels.study import SIGNS, _written

ROWS = (
    Row(Text(en="right", pt_BR="certo"), 6.05262e-14, "mm/s", printed("≤ 1 × 10⁻¹²", "fig. 1")),
    Row(
        Text(en="fitted", pt_BR="ajustado"),
        2.0,
        "",
        printed("< 2,5", "§2"),
        fitted=(Fitted(Text(en="gain <b>", pt_BR="ganho <b>"), 5.5, 4.0, 6.0, "1/s"),),
    ),
    Row(
        Text(en="wrong", pt_BR="errado"), -2.0, "", printed("1,0", "§3"), why=Text(en="not known", pt_BR="não se sabe")
    ),
    Row(Text(en="misprinted", pt_BR="mal impresso"), 3.0, "m", printed("1,0", "§4"), erratum="vargas-2"),
    Row(Text(en="drawn", pt_BR="desenhado"), 3.0, "", Figure("fig. 5")),
    Row(Text(en="alone", pt_BR="sozinho"), 3.0),
)


def run(*rows: Row) -> Run:
    return Run("a study", None, True, Result(rows))


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
    assert ("(holds from 4 to 6)" in table, "(vale de 4 a 6)" in table) == (language == "en", language == "pt_BR")
    assert f"<a href='pages/{language}/sources#vargas-2'" in table


def test_numbers_stand_under_their_heads_in_the_language_of_the_page() -> None:
    heads, quantity, numbers, *_ = lines(_written((run(*ROWS),), "en"))
    assert heads == ["the source prints", "ours"]
    assert quantity == ["✓ right"]
    assert numbers == ["≤ 1 × 10⁻¹² (fig. 1)", "6.0526×10⁻¹⁴ mm/s"]
    assert ["1,0 (§3)", "−2,00"] in lines(_written((run(*ROWS),), "pt_BR"))


def test_what_nobody_printed_stands_at_the_end() -> None:
    said = lines(_written((run(*reversed(ROWS)),), "en"))
    assert [line for line in said if line in (["drawn"], ["alone"], ["✓ right"])] == [["✓ right"], ["drawn"], ["alone"]]


def test_the_run_before_stands_in_the_place_of_the_source() -> None:
    before = run(Row(ROWS[0].quantity, 7e-14), Row(same("gone"), 1.0))
    heads, _, numbers, _, _, others, *_ = lines(_written((run(*ROWS[:2]), before), "en"))
    assert heads == ["ours", "before"]
    assert numbers == ["6.0526×10⁻¹⁴ mm/s", "7×10⁻¹⁴"]
    assert others == ["2", "–"]
