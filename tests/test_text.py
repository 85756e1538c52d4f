"""Texts in both languages."""

from __future__ import annotations

import numpy as np
import pytest

from helicoide.text import Text, number_text, numbers_text, significant_text, untranslated

FOUND = Text(en="{a:.2f} m, {n} of {b}", pt_BR="{a:.2f} m, {n} de {b}")


@pytest.mark.parametrize(
    ("value", "en", "pt_BR"), [(0.5, "0.50", "0,50"), (-1234.5, "-1234.50", "-1234,50"), (float("nan"), "nan", "nan")]
)
def test_numbers_have_the_comma_of_their_language(value: float, en: str, pt_BR: str) -> None:
    text = FOUND.format(a=value, n=3, b="v1.2")
    assert text == Text(en=f"{en} m, 3 of v1.2", pt_BR=f"{pt_BR} m, 3 de v1.2")


def test_a_field_that_is_a_text_is_filled_in_its_own_language() -> None:
    said = untranslated("({of})").format(of=FOUND.format(a=1.0, n=1, b=2))
    assert said == Text(en="(1.00 m, 1 of 2)", pt_BR="(1,00 m, 1 de 2)")


def test_several_numbers_stay_apart_from_their_decimal_commas() -> None:
    assert number_text(-0.25, ".3f") == Text(en="-0.250", pt_BR="-0,250")
    assert numbers_text([0.5, 2.0]) == Text(en="0.5, 2", pt_BR="0,5; 2")


@pytest.mark.parametrize(
    ("value", "en", "pt_BR"),
    [
        (1.106e-17, "1.11×10⁻¹⁷", "1,11×10⁻¹⁷"),
        (-1.02e32, "−1.02×10³²", "−1,02×10³²"),
        (np.inf, "∞", "∞"),
        (-0.0, "0", "0"),
    ],
)
def test_a_number_has_a_power_of_ten_and_no_exponent(value: float, en: str, pt_BR: str) -> None:
    assert significant_text(value, 3) == Text(en=en, pt_BR=pt_BR)
    filled = untranslated("{x:.3g}").format(x=value)
    assert number_text(value, ".3g") == filled
    assert "e" not in filled.en + filled.pt_BR
