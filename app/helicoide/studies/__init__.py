"""The experiments of the sources, a file each; `study.Study` says what such a file holds.

What several of them share is in files whose names begin with "_"; these are no studies.
"""

from __future__ import annotations

import importlib
from dataclasses import replace
from functools import cache
from typing import Any, cast

from helicoide import content
from helicoide.studies.study import Progress, Result, Study, unstated
from helicoide.text import HelicoideError, Text

NEEDS = ("TITLE", "SOURCE", "ABOUT", "ROBOT", "Options", "run")
_FRAME = ("desk", "study")
__path__.append(str(content.user_folder() / "studies"))


@cache
def names() -> tuple[str, ...]:
    """The names of all studies: those of their files."""
    modules = content.modules(__name__, __path__, NEEDS)
    return tuple(name for name in modules if name not in _FRAME and not name.startswith("_"))


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


def run(name: str, options: Any, short: bool, progress: Progress) -> Result:
    """Run a study; with settings that are not its own every number stands alone. Arguments as in `Study.run`."""
    study = named(name)
    result = study.run(options, short, progress)
    return result if options == study.Options() else replace(result, rows=unstated(result.rows))
