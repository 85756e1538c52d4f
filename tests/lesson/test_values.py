"""Values are written in their unit, with a decimal comma in Portuguese."""

from __future__ import annotations

import math

import pytest

from helicoide.lesson import in_unit, measured_text


@pytest.mark.parametrize(
    ("number", "unit", "decimals", "en", "pt_BR"),
    [
        (0.1671, "mm", None, "167\u202fmm", "167\u202fmm"),
        (-math.pi / 2, "°", None, "−90°", "−90°"),
        (0.12345, "rad", None, "0.12\u202frad", "0,12\u202frad"),
        (0.12345, "", 3, "0.123", "0,123"),
        (-1e-9, "mm", None, "0\u202fmm", "0\u202fmm"),
        (math.nan, "mm", None, "–", "–"),
    ],
)
def test_a_number_is_written_in_its_unit(number: float, unit: str, decimals: int | None, en: str, pt_BR: str) -> None:
    shown = measured_text(in_unit(number, unit), unit, decimals)
    assert (shown.en, shown.pt_BR) == (en, pt_BR)
