"""Texts of the user interface in both languages; a missing translation is a type error."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from string import Formatter
from typing import Literal, get_args

Language = Literal["en", "pt_BR"]
LANGUAGES: tuple[Language, ...] = get_args(Language)


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def power_of_ten(exponent: int) -> str:
    """A power of ten, such as 10⁻⁶."""
    return "10" + str(exponent).translate(_RAISED)


def _with_power_of_ten(shown: str) -> str:
    """A formatted number; an exponent such as e-17 becomes ×10⁻¹⁷."""
    mantissa, e, exponent = shown.partition("e")
    return f"{mantissa}×{power_of_ten(int(exponent))}" if e else mantissa


def significant_digits(value: float, digits: int) -> str:
    """A number of `digits` significant digits; an exponent is written as a power of ten with superscripts."""
    return _with_power_of_ten(f"{value + 0.0:.{digits}g}")  # + 0.0: no -0


class _NumberFormatter(Formatter):
    """Formats as `str.format` does, with this decimal mark in numbers, and powers of ten in place of exponents."""

    def __init__(self, mark: str) -> None:
        self.mark = mark

    def format_field(self, value: object, format_spec: str) -> str:
        shown: str = super().format_field(value, format_spec)
        return _with_power_of_ten(shown).replace(".", self.mark) if isinstance(value, float) else shown


_WITH_POINT, _WITH_COMMA = _NumberFormatter("."), _NumberFormatter(",")


@dataclass(frozen=True)
class Text:
    """A text in both languages. `text["pt_BR"]` selects one; `text.format` fills the fields in braces."""

    en: str
    pt_BR: str

    def __getitem__(self, language: Language) -> str:
        return self.pt_BR if language == "pt_BR" else self.en

    def format(self, **fields: object) -> Text:
        """Fill the fields in both languages; a field may be a `Text`.

        Floats get a decimal comma in Portuguese, and a power of ten in place of an exponent.
        """
        return Text(
            en=_WITH_POINT.format(self.en, **{k: v["en"] if isinstance(v, Text) else v for k, v in fields.items()}),
            pt_BR=_WITH_COMMA.format(
                self.pt_BR, **{k: v["pt_BR"] if isinstance(v, Text) else v for k, v in fields.items()}
            ),
        )


def sentence_case(text: Text) -> Text:
    """The text with a capital at its beginning, as labels have it; a symbol such as x or λ stays."""
    return Text(en=_capitalized(text.en), pt_BR=_capitalized(text.pt_BR))


def _capitalized(words: str) -> str:
    return words[:1].upper() + words[1:] if words[:2].isalpha() and words[:2].islower() else words


def untranslated(word: str) -> Text:
    """A name or symbol that is the same in both languages."""
    return Text(en=word, pt_BR=word)


def with_decimal_comma(shown: str) -> Text:
    """A number that is already formatted; full stops become commas in Portuguese."""
    return Text(en=shown, pt_BR=shown.replace(".", ","))


def number_text(value: float, spec: str = "g") -> Text:
    """A number in a format such as ".3g", with a decimal comma in Portuguese and a power of ten, not an exponent."""
    return with_decimal_comma(_with_power_of_ten(f"{value:{spec}}"))


def significant_text(value: float, digits: int) -> Text:
    """A number of so many significant digits, with a minus sign, ∞ and powers of ten."""
    return with_decimal_comma(significant_digits(value, digits).replace("-", "−").replace("inf", "∞"))


def rounded_text(value: float, decimals: int) -> Text:
    """A number with so many decimals and a minus sign, without one if it is rounded to 0."""
    return with_decimal_comma(f"{round(value, decimals) + 0.0:.{decimals}f}".replace("-", "−"))


def rounded_numbers(values: Iterable[float], decimals: int) -> Text:
    """Several such numbers, separated as in `numbers_text`."""
    return _separated([rounded_text(value, decimals) for value in values])


def numbers_text(values: Iterable[float], spec: str = "g") -> Text:
    """Several numbers: separated by commas in English, by semicolons in Portuguese because of its decimal comma."""
    return _separated([number_text(value, spec) for value in values])


def _separated(numbers: Sequence[Text]) -> Text:
    return Text(en=", ".join(text.en for text in numbers), pt_BR="; ".join(text.pt_BR for text in numbers))


def join_texts(texts: Sequence[Text], by: str = "; ") -> Text:
    """Several texts joined into one."""
    return Text(en=by.join(text.en for text in texts), pt_BR=by.join(text.pt_BR for text in texts))


class HelicoideError(Exception):
    """Wrong input or a broken file. The text says what is wrong, where, and what is valid."""

    def __init__(self, text: Text) -> None:
        super().__init__(text.en)
        self.text = text

    def __reduce__(self) -> tuple[type[HelicoideError], tuple[Text]]:
        return type(self), (self.text,)
