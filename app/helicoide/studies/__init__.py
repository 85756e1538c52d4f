"""The experiments of the sources, a file each; `study.Study` says what such a file holds.

What several of them share is in files whose names begin with "_"; these are no studies.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any, cast

from helicoide import content
from helicoide.studies.study import Progress, Result, Study, unstated
from helicoide.text import Text

_FRAME = ("desk", "study")


@cache
def names() -> tuple[str, ...]:
    """The names of all studies: those of their files."""
    return tuple(name for name in content.module_names(__name__) if name not in _FRAME)


@cache
def named(name: str) -> Study:
    """A study by its name; raises HelicoideError, which lists the names."""
    return cast(Study, content.module(__name__, name, names(), Text(en="study", pt_BR="estudo")))


def run(name: str, options: Any, short: bool, progress: Progress) -> Result:
    """Run a study; with settings that are not its own every number stands alone. Arguments as in `Study.run`."""
    study = named(name)
    result = study.run(options, short, progress)
    return result if options == study.Options() else replace(result, rows=unstated(result.rows))
