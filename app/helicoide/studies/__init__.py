"""The experiments of the sources, a file each; `study.Study` says what such a file holds."""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache
from typing import cast

from helicoide.studies.study import Study
from helicoide.text import HelicoideError, Text

_FRAME = ("desk", "study")


@cache
def names() -> tuple[str, ...]:
    """The names of all studies: those of their files."""
    return tuple(sorted(m.name for m in pkgutil.iter_modules(__path__) if m.name not in _FRAME and not m.ispkg))


@cache
def named(name: str) -> Study:
    """A study by its name; raises HelicoideError, which lists the names."""
    if name not in names():
        raise HelicoideError(
            Text(
                en="There is no study {name!r}; there is: {known}.", pt_BR="Não há estudo {name!r}; há: {known}."
            ).format(name=name, known=", ".join(names()))
        )
    return cast(Study, importlib.import_module(f"{__name__}.{name}"))
