"""How the studies of Vargas 2013 hold a number to that of the digest."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from helicoide.studies.vargas.table import Sheet, is_changed, last_digit
from helicoide.text import same

WHAT = same("w")


@pytest.mark.parametrize(
    ("digits", "unit"), [("0.0246", 6e-5), ("8.3e-4", 6e-6), ("726", 0.6), ("-1.001", 6e-4), ("9e-5", 6e-6)]
)
def test_a_printed_number_is_met_to_its_last_digit(digits: str, unit: float) -> None:
    assert last_digit(digits) == pytest.approx(unit)
    value = float(digits)
    sheet = Sheet(short=False)
    assert sheet.row(WHAT, None, value + 0.9 * unit, digits).agrees
    assert not sheet.row(WHAT, None, value + 1.1 * unit, digits).agrees


def test_the_short_form_may_miss_a_share() -> None:
    sheet = Sheet(short=True)
    assert sheet.row(WHAT, None, 2.19, "2.00", coarse=0.1).agrees
    assert not sheet.row(WHAT, None, 2.21, "2.00", coarse=0.1).agrees
    assert sheet.row(WHAT, None, 9.0, "2.00").digest is None


def test_a_bound_has_no_slack_of_its_own() -> None:
    sheet = Sheet(short=False)
    assert sheet.row(WHAT, None, 2.0, "2.00", relation="≤").agrees
    assert not sheet.row(WHAT, None, 2.001, "2.00", relation="≤").agrees
    assert sheet.row(WHAT, None, 2.001, "2.00", relation="≤", within=0.01).agrees


def test_with_other_settings_a_number_stands_alone() -> None:
    row = Sheet(short=False, changed=True).row(WHAT, same("x"), 9.0, "2.00", "rad")
    assert (row.quantity, row.ours, row.digest, row.source, row.unit) == (same("w: x"), 9.0, None, "", "rad")


@dataclass(frozen=True)
class Settings:
    """Settings of a study."""

    gain: float = 1.0
    shown: str = "a"


def test_which_run_is_shown_does_not_count_as_a_change() -> None:
    assert not is_changed(Settings(shown="b"))
    assert is_changed(Settings(gain=2.0))
