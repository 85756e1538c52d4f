"""Rows and their verdicts."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.studies.study import (
    INPUT_VALUE,
    Figure,
    Fitted,
    Relation,
    Result,
    Row,
    Statement,
    Verdict,
    printed_statement,
    without_statements,
)
from helicoide.text import untranslated

SAID = Statement(untranslated("2"), "§1", 2.0, "=", 0.1)
ROW = Row(untranslated("q"), 1.0)
GAIN = Fitted(untranslated("γ"), 5.0, 4.0, 6.0)
numbers = st.floats(-1e6, 1e6)


@pytest.mark.parametrize(
    ("words", "value", "relation", "within"),
    [
        ("< 1,2", 1.2, "<", 0.0),
        ("≥ 80", 80.0, "≥", 0.0),
        ("0,0246", 0.0246, "=", 5e-5),
        ("8.3 × 10⁻⁴", 8.3e-4, "=", 5e-6),
        ("≈ 9", 9.0, "=", 1.0),
        ("~ 1 × 10⁻³", 1e-3, "~", 0.0),
        ("−1", -1.0, "=", 0.5),
    ],
)
def test_a_printed_number_is_met_to_its_last_digit(words: str, value: float, relation: str, within: float) -> None:
    statement = printed_statement(words, "fig. 1")
    assert (statement.value, statement.relation) == (pytest.approx(value), relation)
    assert statement.within == pytest.approx(within)
    assert ("," in statement.words.en, "." in statement.words.pt_BR) == (False, False)


@pytest.mark.parametrize("words", ["", "small", "1 to 2", "<"])
def test_words_that_are_no_number_are_none(words: str) -> None:
    with pytest.raises(ValueError, match="no number"):
        printed_statement(words, "fig. 1")


@pytest.mark.parametrize(
    ("relation", "ours", "holds"),
    [
        ("=", 2.1, True),
        ("=", 2.11, False),
        ("=", 1.89, False),
        ("~", 2.0, True),
        ("~", 19.9, True),
        ("~", 20.0, False),
        ("~", 1.9, False),
        ("<", 2.0, False),
        ("<", 1.99, True),
        (">", 2.0, False),
        (">", 2.01, True),
        ("≥", 1.91, True),
        ("≥", 1.89, False),
        ("≤", 2.09, True),
        ("≤", 2.11, False),
    ],
)
def test_a_relation_holds_or_not(relation: Relation, ours: float, holds: bool) -> None:
    assert Statement(untranslated("2"), "§1", 2.0, relation, 0.1 + 1e-12).holds(ours) is holds


@given(
    ours=numbers,
    fitted=st.booleans(),
    erratum=st.sampled_from(["", "vargas-1"]),
    why=st.sampled_from([None, untranslated("!")]),
)
def test_the_verdict_is_about_the_statement_alone(ours: float, fitted: bool, erratum: str, why: None) -> None:
    row = Row(untranslated("q"), ours, "", SAID, (GAIN,) if fitted else (), erratum, why)
    if SAID.holds(ours):
        assert row.verdict is (Verdict.FITTED if fitted else Verdict.PRINTED)
    else:
        assert row.verdict is (Verdict.ERRATUM if erratum else Verdict.DIFFERS)
    assert replace(row, source=None).verdict is Verdict.OURS
    assert replace(row, source=Figure("fig. 1")).verdict is Verdict.FIGURE


@pytest.mark.parametrize("ours", [2.0, 5.0])
def test_what_was_put_in_has_no_verdict(ours: float) -> None:
    assert Row(untranslated("q"), ours, "", SAID, given=INPUT_VALUE).verdict is Verdict.OURS


@pytest.mark.parametrize("source", [None, SAID, Figure("fig. 1")])
def test_what_is_no_number_differs_from_everything(source: Statement | Figure | None) -> None:
    row = Row(untranslated("q"), float("nan"), "", source, (GAIN,), "vargas-1")
    assert row.verdict is Verdict.DIFFERS


def test_with_other_settings_every_number_stands_alone() -> None:
    (row,) = without_statements((Row(untranslated("q"), 2.0, "m", SAID, (GAIN,), "vargas-1", untranslated("!")),))
    assert row == Row(untranslated("q"), 2.0, "m")


def test_a_value_that_was_fitted_for_several_statements_counts_once() -> None:
    rows = (
        replace(ROW, fitted=(GAIN,)),
        replace(ROW, computed=2.0, fitted=(GAIN, replace(GAIN, name=untranslated("κ")))),
    )
    assert [value.name.en for value in Result(rows).fitted] == ["γ", "κ"]
