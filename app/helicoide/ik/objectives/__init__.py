"""Secondary objectives, a file each: what the joints do with the freedom that the task leaves them.

`objective.Objective` says what such a file holds.
"""

from __future__ import annotations

from functools import cache
from typing import cast

from helicoide import content
from helicoide.ik.objective import Objective
from helicoide.text import Text


def names() -> tuple[str, ...]:
    """The names of all objectives: those of their files."""
    return content.module_names(__name__)


@cache
def named(name: str) -> Objective:
    """An objective by its name; raises HelicoideError, which lists the names."""
    return cast(Objective, content.module(__name__, name, names(), Text(en="objective", pt_BR="objetivo")))
