"""Faults of the settings of a method or a study."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from typing import Any

from helicoide.contributions.words import missing_words
from helicoide.ik.method import OneOf, changed, settings
from helicoide.text import HelicoideError, Text, untranslated

NO_SETTING = Text(
    en="option {name} is annotated with none of Quantity, OneOf, YesNo",
    pt_BR="a opção {name} não é anotada com Quantity, OneOf nem YesNo",
)
DEFAULT = Text(en="the default of option {name} is not valid: {why}", pt_BR="o padrão da opção {name} não vale: {why}")


def option_faults(options: type) -> Iterator[Text]:
    """The faults of a class of options: titles missing in a language, and defaults that are not valid."""
    known, default = settings(options), options()
    for field in fields(default):
        if field.name not in known:
            yield NO_SETTING.format(name=field.name)
    for name, setting in known.items():
        titles = [setting.title, *(setting.choices.values() if isinstance(setting, OneOf) else ())]
        yield from (fault for title in titles for fault in missing_words(untranslated(name), title))
        yield from _default(default, name)


def _default(default: Any, name: str) -> Iterator[Text]:
    try:
        changed(default, name, getattr(default, name))
    except HelicoideError as error:
        yield DEFAULT.format(name=name, why=error.text)
