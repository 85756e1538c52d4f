"""The studies: experiments of the sources, one file each; `study.Study` is the contract of such a file.

Files whose names begin with "_" hold what several studies share.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any, cast

from helicoide import content
from helicoide.studies.study import Progress, Result, Study, without_statements
from helicoide.text import Text

NEEDS = ("TITLE", "SOURCE", "ABOUT", "ROBOT", "Options", "run")
_FRAME = ("panel_state", "study")
__path__.append(str(content.user_folder() / "studies"))


@cache
def study_names() -> tuple[str, ...]:
    """The names of all studies, which are the names of their files."""
    return tuple(name for name in content.module_names(__name__, NEEDS) if name not in _FRAME)


@cache
def study_named(name: str) -> Study:
    """The study with a name; raises HelicoideError, which lists the names."""
    return cast(Study, content.module(__name__, name, study_names(), Text(en="study", pt_BR="estudo")))


def run_study(name: str, options: Any, short: bool, progress: Progress) -> Result:
    """Run a study by name; arguments as in `Study.run`.

    With options other than the defaults, the rows are not compared with the source.
    """
    study = study_named(name)
    result = study.run(options, short, progress)
    return result if options == study.Options() else replace(result, rows=without_statements(result.rows))
