"""Sentences that people read, in both languages; a missing translation is a type error."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from string import Formatter
from typing import Literal, get_args

Language = Literal["en", "pt_BR"]
LANGUAGES: tuple[Language, ...] = get_args(Language)


class _DecimalCommaFormatter(Formatter):
    """Formats as `str.format` does, with a decimal comma in numbers."""

    def format_field(self, value: object, format_spec: str) -> str:
        shown: str = super().format_field(value, format_spec)
        return shown.replace(".", ",") if isinstance(value, float) else shown


_WITH_COMMA = _DecimalCommaFormatter()


@dataclass(frozen=True)
class Text:
    """One sentence in both languages. `text["pt_BR"]` picks one; fields in braces are filled by `text.format`."""

    en: str
    pt_BR: str

    def __getitem__(self, language: Language) -> str:
        return self.pt_BR if language == "pt_BR" else self.en

    def format(self, **fields: object) -> Text:
        """Fill the fields in both languages; a field may be a `Text`; floats get a decimal comma in Portuguese."""
        return Text(
            en=self.en.format(**{k: v["en"] if isinstance(v, Text) else v for k, v in fields.items()}),
            pt_BR=_WITH_COMMA.format(
                self.pt_BR, **{k: v["pt_BR"] if isinstance(v, Text) else v for k, v in fields.items()}
            ),
        )


def untranslated(word: str) -> Text:
    """A name or symbol that is the same in both languages."""
    return Text(en=word, pt_BR=word)


def join_texts(texts: Sequence[Text], by: str = "; ") -> Text:
    """Several texts joined into one."""
    return Text(en=by.join(text.en for text in texts), pt_BR=by.join(text.pt_BR for text in texts))


class HelicoideError(Exception):
    """Wrong input or a broken file: says what is wrong, where, and what would have been valid."""

    def __init__(self, text: Text) -> None:
        super().__init__(text.en)
        self.text = text

    def __reduce__(self) -> tuple[type[HelicoideError], tuple[Text]]:
        return type(self), (self.text,)
