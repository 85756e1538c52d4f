"""Secondary objectives, one module each: what redundant joints do besides the task.

`objective.Objective` describes such a module.
"""

from __future__ import annotations

from functools import cache
from typing import cast

from helicoide import content
from helicoide.ik.objective import Objective
from helicoide.text import Text


def names() -> tuple[str, ...]:
    """The names of all objectives, which are their module names."""
    return content.module_names(__name__)


@cache
def named(name: str) -> Objective:
    """The objective with this name. Raises HelicoideError, which lists the known names."""
    return cast(Objective, content.module(__name__, name, names(), Text(en="objective", pt_BR="objetivo")))
