"""The table of a study's panel: every verdict by sign and in words, numbers that can be read, a run beside another."""

from __future__ import annotations

import re

import pytest

from helicoide.studies.desk import Run
from helicoide.studies.study import FIGURE_ONLY, Result, Row, Verdict
from helicoide.text import Language, Text, same
from helicoide.view.panels.study import SIGNS, _written

ROWS = (
    Row(Text(en="right", pt_BR="certo"), 6.05262e-14, 1e-12, 0.0, "mm/s", FIGURE_ONLY, relation="≤"),
    Row(Text(en="doubtful", pt_BR="duvidoso"), 2.0, 1.0, 0.1, doubt="D6"),
    Row(Text(en="assumed", pt_BR="suposto"), 2.0, 1.0, assumed=Text(en="no gains <b>", pt_BR="sem ganhos <b>")),
    Row(Text(en="wrong", pt_BR="errado"), -2.0, 1.0, 0.1),
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
def test_each_verdict_has_its_sign_and_a_difference_its_words(language: Language) -> None:
    table = _written((run(*ROWS),), language)
    said = lines(table)
    for row, verdict in zip(ROWS[:4], Verdict, strict=True):
        assert row.verdict is verdict
        assert any(line[0].startswith(f"{SIGNS[verdict]} {row.quantity[language]}") for line in said)
        assert f"{SIGNS[verdict]} {verdict.value[language]}: 1" in table
        assert any(line[0].startswith(verdict.value[language]) for line in said) == (verdict is not Verdict.AGREES)
    assert "(D6)" in table
    assert "&lt;b&gt;" in table
    assert [ROWS[4].quantity[language]] in said


def test_numbers_stand_under_their_heads_without_their_unit() -> None:
    heads, quantity, numbers, *_ = lines(_written((run(*ROWS),), "en"))
    assert heads == ["source", "digest", "ours"]
    assert quantity == ["✓ right mm/s"]
    assert numbers == ["figure only", "≤ 1×10⁻¹²", "6.0526×10⁻¹⁴"]
    assert ["–", "1.0", "−2.0"] in lines(_written((run(*ROWS),), "en"))


def test_the_run_before_stands_in_the_place_of_the_source() -> None:
    before = run(Row(ROWS[0].quantity, 7e-14), Row(same("gone"), 1.0))
    heads, _, numbers, _, others, *_ = lines(_written((run(*ROWS[:2]), before), "en"))
    assert heads == ["digest", "ours", "before"]
    assert numbers == ["≤ 1×10⁻¹²", "6.0526×10⁻¹⁴", "7×10⁻¹⁴"]
    assert others == ["1.0", "2.0", "–"]
