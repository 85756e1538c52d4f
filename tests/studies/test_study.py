"""Rows and their verdicts."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from helicoide.studies.study import Row, Verdict
from helicoide.text import same

ROW = Row(same("q"), 1.0)
numbers = st.floats(-1e6, 1e6)
widths = st.floats(0, 10)
relations = st.sampled_from(["=", "≥", "≤"])


def test_without_a_digest_a_number_stands_alone() -> None:
    assert ROW.verdict is Verdict.AGREES
    assert replace(ROW, ours=float("nan")).verdict is Verdict.DIFFERS


@pytest.mark.parametrize(
    ("relation", "ours", "agrees"),
    [
        ("=", 2.1, True),
        ("=", 2.11, False),
        ("=", 1.89, False),
        ("≥", 9, True),
        ("≥", 1.91, True),
        ("≥", 1.89, False),
        ("≤", -9, True),
        ("≤", 2.09, True),
        ("≤", 2.11, False),
    ],
)
def test_a_relation_holds_to_within_its_tolerance(relation: str, ours: float, agrees: bool) -> None:
    row = Row(same("q"), ours, 2.0, 0.1 + 1e-12, relation=relation)  # type: ignore[arg-type]
    assert row.agrees is agrees


@given(ours=numbers, digest=numbers, tolerance=widths)
def test_equal_is_both_at_least_and_at_most(ours: float, digest: float, tolerance: float) -> None:
    equal, least, most = (Row(same("q"), ours, digest, tolerance, relation=r).agrees for r in ("=", "≥", "≤"))
    assert equal == (least and most)
    assert least or most


@given(ours=numbers, digest=numbers, relation=relations)
def test_an_excuse_counts_only_for_a_difference_and_a_doubt_first(ours: float, digest: float, relation: str) -> None:
    plain = Row(same("q"), ours, digest, relation=relation)  # type: ignore[arg-type]
    doubted, assumed = replace(plain, doubt="D6"), replace(plain, assumed=same("gains"))
    both = replace(doubted, assumed=same("gains"))
    if plain.agrees:
        assert {row.verdict for row in (plain, doubted, assumed, both)} == {Verdict.AGREES}
    else:
        found = [row.verdict for row in (plain, doubted, assumed, both)]
        assert found == [Verdict.DIFFERS, Verdict.DOUBT, Verdict.ASSUMED, Verdict.DOUBT]


@pytest.mark.parametrize("excuse", [{"doubt": "D6"}, {"assumed": same("gains")}])
def test_what_is_no_number_agrees_with_nothing(excuse: dict[str, object]) -> None:
    row = replace(ROW, ours=float("nan"), digest=1.0, tolerance=9.0)
    assert row.verdict is Verdict.DIFFERS
    assert replace(row, **excuse).verdict is not Verdict.AGREES  # type: ignore[arg-type]
