"""Check that a text exists in both languages."""

from __future__ import annotations

from collections.abc import Iterator

from helicoide.text import LANGUAGES, Text

NO_TEXT = Text(en="{what} is no Text(en=…, pt_BR=…)", pt_BR="{what} não é um Text(en=…, pt_BR=…)")
EMPTY = Text(en="{what} is empty in {language}", pt_BR="{what} está vazio em {language}")
ALIKE = Text(en="{what} is the same in English and Portuguese", pt_BR="{what} é igual em inglês e em português")


def missing_words(what: Text, text: object, differ: bool = False) -> Iterator[Text]:
    """The faults of a text that must exist in both languages. differ: the two must not be the same."""
    if not isinstance(text, Text):
        yield NO_TEXT.format(what=what)
        return
    for language in LANGUAGES:
        if not text[language].strip():
            yield EMPTY.format(what=what, language=language)
    if differ and text.en == text.pt_BR:
        yield ALIKE.format(what=what)
